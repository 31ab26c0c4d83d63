#include "prove/separations_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "proof/bytes.hpp"
#include "proof/separation.hpp"
#include "proof/verify_separations.hpp"
#include "prove/apart_writer.hpp"
#include "prove/window_writer.hpp"
#include "spacetime/margin.hpp"
#include "taut/proof.hpp"

namespace taut::internal {
namespace {

using proof::Claim;
using proof::WorldTime;

void put_u32(std::string& out, std::uint32_t x) {
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(x >> (8 * i) & 0xff));
}
void put_f64(std::string& out, double x) {
  const std::uint64_t bits = proof::bits_of(x);
  for (int i = 0; i < 8; ++i) out.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
}

/// The contact as the verifier will find it, and an instant shortly before it, since which the vertex is outside.
std::pair<proof::FineInstant, Instant> instant(const proof::VerifierPair& pair, proof::Lifetimes& lifetimes,
                                               const FoundContact& found, double about) {
  const auto first_since = [&](const proof::FineInstant& since) -> std::optional<Instant> {
    try {
      const VertexId end = pair.geometry.next(found.edge);
      return lifetimes.failure({found.edge, end, found.vertex, -1, proof::instant_at(since)}, about);
    } catch (const ProofError&) {
      // The instant is too close to the root for a sign, or not close enough for the root to be the first.
    } catch (const Undecidable&) {
    }
    return std::nullopt;
  };
  const MotionSegment& segment = lifetimes.segment();
  std::optional<std::pair<proof::FineInstant, Instant>> any;
  for (double share = 0x1p-48; share <= 0x1p-8; share *= 0x1p8) {
    const proof::FineInstant since{std::max(segment.start, found.lo - share * (segment.end - segment.start)), 0, 0};
    const auto now = first_since(since);
    if (!now && any) break;
    if (now) any = {since, *now};
    // Doubles show that one is before the other.
    if (now && since[0] < now->lo) break;
  }
  if (any) return *any;
  // The vertex may have come to the outside between the same two doubles.
  for (double step = 0x1p-200; found.at && step <= 0x1p-48; step *= 0x1p4) {
    const proof::FineInstant since = proof::nearest_instant(found.at->lo() - step);
    if (!proof::is_within(since, segment.start, segment.end)) break;
    if (const auto now = first_since(since)) return {since, *now};
  }
  throw Undecidable{"the instant of a contact, for a proof"};
}

template <class IsIt>
VertexId id_where(const proof::VerifierPair& pair, BodyId body, const IsIt& is_it) {
  const bool p = pair.bodies.rings[0]->body() == body;
  const RingSet& rings = *pair.bodies.rings[p ? 0 : 1];
  std::uint32_t k = 0;
  while (!is_it(rings, k)) ++k;
  return VertexId(p ? k : pair.geometry.np + k);
}

/// The vertex of the pair with this name in the scene, and the edge.
VertexId id_of(const proof::VerifierPair& pair, const VertexRef& ref) {
  return id_where(pair, ref.body, [&](const RingSet& rings, std::uint32_t k) { return rings.vertex(k) == ref; });
}
VertexId id_of_edge(const proof::VerifierPair& pair, const EdgeRef& ref) {
  return id_where(pair, ref.body, [&](const RingSet& rings, std::uint32_t k) { return rings.edge(k) == ref; });
}

template <class IsCloser>
std::optional<proof::FineInstant> instant_between_doubles(const proof::VerifierPair& pair, const MotionSegment& segment,
                                                          const proof::Incidence& close, bool is_edge, double margin,
                                                          const TimeInterval& about, const IsCloser& is_closer) {
  const spacetime::PreciseApproaches approaches(pair.geometry, segment, constant_margin(margin));
  const double from = std::max(segment.start, about.lo);
  const double to = std::min(segment.end, std::nextafter(about.hi, std::numeric_limits<double>::infinity()));
  const auto found = approaches.first({close.vertex, close.edge, is_edge}, from, to);
  if (!found) return std::nullopt;
  const RealMax root = found->precise.hi();
  for (double step = 0x1p-150; step < 0x1p-48; step *= 2) {
    const proof::FineInstant at = proof::nearest_instant(root + step);
    if (is_closer(at)) return at;
  }
  return std::nullopt;
}

constexpr int most_steps = 30;

}  // namespace

template <class Write>
SeparationsBody SeparationsWriter::as_far_as_written(const Write& write) {
  try {
    return write();
  } catch (const Undecidable& limit) {
    if (!unfinished_) throw;
    return unfinished(not_decided(limit));
  } catch (const Interrupted& limit) {
    if (!unfinished_) throw;
    return unfinished(limit.reason);
  }
}

/// The log of two bodies: one window, in which no box is worth its bytes, and the pair's separations.
SeparationsBody SeparationsWriter::unfinished(const std::string& why) const {
  const WrittenUntil& last = unfinished_->of_stretch;
  std::string bytes;
  put_f64(bytes, last.time);
  bytes.push_back(1);
  for (int body = 0; body < scene_.size(); ++body) {
    if (!scene_[body].rests()) bytes.push_back(0);
  }
  bytes.push_back(1);
  bytes.append(out_, unfinished_->begin, unfinished_->end - unfinished_->begin);
  bytes.append(out_, last.begin, last.end - last.begin);
  SeparationsBody body{Claim::free_until, std::move(bytes), last.time};
  body.stopped = why;
  return body;
}

/// `found` is in the stretch of that number. A verifier must find the same stretches up to that time.
void SeparationsWriter::note_written(const proof::VerifierPair& pair, std::size_t stretches, const Unfinished& found) {
  const double until = found.of_stretch.time;
  const std::vector<proof::SegmentStretch> to_check = proof::stretches(pair.segments, {scene_.start(), until, true});
  if (scene_.size() == 2 && to_check.size() == stretches && to_check.back().to == until) unfinished_ = found;
}

SeparationsBody SeparationsWriter::free() {
  return as_far_as_written([&]() -> SeparationsBody {
    all_windows(scene_.end());
    return {Claim::free, std::move(out_), scene_.end()};
  });
}

SeparationsBody SeparationsWriter::free_until(double until) {
  return as_far_as_written([&]() -> SeparationsBody {
    put_f64(out_, until);
    all_windows(until);
    return {Claim::free_until, std::move(out_), until};
  });
}

SeparationsBody SeparationsWriter::touching(const PairResult& result) {
  const auto [crossing, e, f, inside] = *result.touching;
  put_pair(result);
  out_.push_back(crossing ? 0 : 1);
  put_u32(out_, crossing ? e.value : inside.value);
  put_u32(out_, crossing ? f.value : inside.value);
  all_windows(scene_.start());
  return {Claim::touching, std::move(out_), scene_.start()};
}

SeparationsBody SeparationsWriter::close_at_start(const std::array<BodyId, 2>& bodies, const CloseFeatures& features) {
  const proof::VerifierPair& pair = world_.pair(bodies[0], bodies[1]);
  for (const int body : bodies) put_u32(out_, static_cast<std::uint32_t>(body));
  put_u32(out_, id_of(pair, features.vertex).value);
  put_u32(out_, (features.edge ? id_of_edge(pair, *features.edge) : id_of(pair, *features.other)).value);
  out_.push_back(features.edge ? 1 : 0);
  all_windows(scene_.start());
  return {Claim::touching, std::move(out_), scene_.start()};
}

SeparationsBody SeparationsWriter::closer(const std::array<BodyId, 2>& bodies, const CloseFeatures& features,
                                          const TimeInterval& time) {
  const proof::VerifierPair& pair = world_.pair(bodies[0], bodies[1]);
  const proof::Incidence close{id_of(pair, features.vertex),
                               features.edge ? id_of_edge(pair, *features.edge) : id_of(pair, *features.other)};
  const auto [segment, at] = instant_of_margin(pair, close, features.edge.has_value(), time);
  for (const int body : bodies) put_u32(out_, static_cast<std::uint32_t>(body));
  put_u32(out_, static_cast<std::uint32_t>(segment));
  put_u32(out_, close.vertex.value);
  put_u32(out_, close.edge.value);
  out_.push_back(features.edge ? 1 : 0);
  for (const double part : at) put_f64(out_, part);
  put_f64(out_, time.lo);
  all_windows(time.lo);
  SeparationsBody body{Claim::contact, std::move(out_), time.lo};
  body.closer = TimeInterval{time.lo, proof::rounded_up(at)};
  return body;
}

SeparationsBody SeparationsWriter::contact(const PairResult& result, double until) {
  return as_far_as_written([&] { return contact_on(result, until); });
}

SeparationsBody SeparationsWriter::contact_on(const PairResult& result, double until) {
  contact_pair_ = {result.a, result.b};
  const proof::VerifierPair& pair = world_.pair(result.a, result.b);
  const FoundContact& found = *result.found;
  const std::shared_ptr<const MotionSegment> held = pair.segments.hold(result.segment);
  const MotionSegment& segment = *held;
  const double about = found.lo + (found.hi - found.lo) / 2;
  proof::Lifetimes lifetimes(pair.geometry);
  lifetimes.enter(segment);
  const auto [since, now] = instant(pair, lifetimes, found, about);
  const double end = std::clamp(now.hi, segment.start, segment.end);
  put_pair(result);
  put_u32(out_, static_cast<std::uint32_t>(result.segment));
  put_u32(out_, found.vertex.value);
  put_u32(out_, found.edge.value);
  const bool fine = since[1] != 0 || since[2] != 0;
  for (std::size_t k = 0; k < (fine ? since.size() : 1); ++k) put_f64(out_, since[k]);
  for (const double t : {about, end, until}) put_f64(out_, t);
  std::vector<proof::SegmentStretch> way;
  proof::add_stretches_before(pair.segments, result.segment, way);
  way.push_back({result.segment, segment.start, end});
  section(pair, way, now);
  const proof::ProvedContact proved =
      proof::proved_contact({pair.bodies, pair.geometry, world_.offset()}, {found.vertex, found.edge}, segment,
                            lifetimes.tightened(now), scene_.start(), until);
  all_windows(until);
  SeparationsBody body{fine ? Claim::fine_contact : Claim::contact, std::move(out_), proved.free_until};
  body.contact = proved.contact;
  return body;
}

void SeparationsWriter::put_pair(const PairResult& result) {
  put_u32(out_, static_cast<std::uint32_t>(result.a));
  put_u32(out_, static_cast<std::uint32_t>(result.b));
}

void SeparationsWriter::all_windows(double until) {
  WindowWriter(scene_, world_.room(), contact_pair_, out_, [this](const auto& pair, const WorldTime& time) {
    const proof::VerifierPair& met = world_.pair(pair.first, pair.second);
    section(met, proof::stretches(met.segments, time), {});
  }).write(until);
}

void SeparationsWriter::section(const proof::VerifierPair& pair, const std::vector<proof::SegmentStretch>& stretches,
                                const std::optional<Instant>& until) {
  proof::Lifetimes lifetimes(pair.geometry);
  const std::size_t begin = out_.size();
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const std::shared_ptr<const MotionSegment> segment = pair.segments.hold(stretches[i].segment);
    lifetimes.enter(*segment);
    const std::optional<Instant> last = i + 1 == stretches.size() ? until : std::nullopt;
    const double margin = lifetimes.segment().bridge ? 0 : world_.margin();
    ApartWriter writer(pair.ranges, lifetimes, last, out_, margin);
    const std::size_t end = out_.size();
    const auto note = [&] {
      if (writer.written() && !segment->bridge) note_written(pair, i + 1, {begin, end, *writer.written()});
    };
    try {
      writer.write(stretches[i].from, stretches[i].to);
    } catch (...) {
      note();
      throw;
    }
    note();
  }
}

/// The bodies are not always closer at the end of the bracket. Where they graze, growing steps lead to an instant at
/// which they are. Where they come to the margin and no closer, the instant is between doubles.
std::pair<std::size_t, proof::FineInstant> SeparationsWriter::instant_of_margin(const proof::VerifierPair& pair,
                                                                                const proof::Incidence& close,
                                                                                bool is_edge,
                                                                                const TimeInterval& about) const {
  for (std::size_t i = pair.segments.first_until(about.hi); i < pair.segments.size(); ++i) {
    const std::shared_ptr<const MotionSegment> held = pair.segments.hold(i);
    const MotionSegment& segment = *held;
    if (!segment.bridge && about.hi < segment.start) break;
    if (segment.bridge) continue;
    const auto is_closer = [&](const proof::FineInstant& at) {
      return proof::closer_at(pair.geometry, segment, world_.margin(), close, is_edge, at);
    };
    double step = 0x1p-53 * std::max(std::fabs(about.hi), 0x1p-20 * (segment.end - segment.start));
    for (int k = 0; k < most_steps && about.hi + step <= segment.end; ++k, step *= 2) {
      for (const double at : {about.hi, about.hi + step}) {
        if (is_closer({at, 0, 0})) return {i, {at, 0, 0}};
      }
    }
    if (const auto at = instant_between_doubles(pair, segment, close, is_edge, world_.margin(), about, is_closer))
      return {i, *at};
  }
  throw Undecidable{"an instant at which bodies are closer than the clearance"};
}

}  // namespace taut::internal
