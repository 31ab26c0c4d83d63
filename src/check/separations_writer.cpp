#include "check/separations_writer.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "check/apart_writer.hpp"
#include "check/prove_curves.hpp"
#include "check/window_writer.hpp"
#include "check/world_run.hpp"
#include "numeric/undecided.hpp"
#include "pair/curved_world.hpp"
#include "proof/header.hpp"
#include "proof/kept_margin.hpp"
#include "proof/proved_world.hpp"
#include "sign/contact_bracket.hpp"
#include "spacetime/approach.hpp"
#include "taut/proof.hpp"

namespace taut {
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

/// What comes after the header, for an answer that is known.
class SeparationsWriter {
 public:
  SeparationsWriter(const proof::ProvedScene& scene, Claim claim, bool inwards, double margin = 0)
      : scene_(scene), claim_(claim), world_(scene, inwards, margin) {}

  /// Nothing meets before `until`.
  std::string apart_until(double until) {
    if (claim_ == Claim::free_until) put_f64(out_, until);
    all_windows(until);
    return std::move(out_);
  }

  std::string touching(const PairResult& result) {
    const auto [crossing, e, f, inside] = *result.touching;
    put_pair(result);
    out_.push_back(crossing ? 0 : 1);
    put_u32(out_, crossing ? e.value : inside.value);
    put_u32(out_, crossing ? f.value : inside.value);
    all_windows(scene_.start());
    return std::move(out_);
  }

  /// Two features come closer than the margin at about the end of that time, and nothing does before its beginning.
  std::string closer(const std::array<BodyId, 2>& bodies, const CloseFeatures& features, const TimeInterval& time) {
    const proof::ProvedPair& pair = world_.pair(bodies[0], bodies[1]);
    const proof::Incidence close{id_of(pair, features.vertex),
                                 features.edge ? id_of_edge(pair, *features.edge) : id_of(pair, *features.other)};
    const auto [leg, at] = instant_of_closeness(pair, close, features.edge.has_value(), time);
    for (const int body : bodies) put_u32(out_, static_cast<std::uint32_t>(body));
    put_u32(out_, static_cast<std::uint32_t>(leg));
    put_u32(out_, close.vertex.value);
    put_u32(out_, close.edge.value);
    out_.push_back(features.edge ? 1 : 0);
    for (const double part : at) put_f64(out_, part);
    put_f64(out_, time.lo);
    all_windows(time.lo);
    return std::move(out_);
  }

  /// `until`: the earliest instant at which anything may happen.
  std::pair<Claim, std::string> contact(const PairResult& result, double until) {
    contact_pair_ = {result.a, result.b};
    const proof::ProvedPair& pair = world_.pair(result.a, result.b);
    const FoundContact& found = *result.found;
    const Leg& leg = pair.legs[result.leg];
    const double about = found.lo + (found.hi - found.lo) / 2;
    proof::Lifetimes lifetimes(pair.geometry);
    lifetimes.enter(leg);
    const auto [since, now] = instant(pair, lifetimes, found, about);
    const double end = std::clamp(now.hi, leg.start, leg.end);
    put_pair(result);
    put_u32(out_, static_cast<std::uint32_t>(result.leg));
    put_u32(out_, found.vertex.value);
    put_u32(out_, found.edge.value);
    const bool fine = since[1] != 0 || since[2] != 0;
    for (std::size_t k = 0; k < (fine ? since.size() : 1); ++k) put_f64(out_, since[k]);
    for (const double t : {about, end, until}) put_f64(out_, t);
    std::vector<proof::LegStretch> way;
    for (std::size_t i = 0; i < result.leg; ++i) way.push_back({i, pair.legs[i].start, pair.legs[i].end});
    way.push_back({result.leg, leg.start, end});
    section(pair, way, now);
    all_windows(until);
    return {fine ? Claim::fine_contact : Claim::contact, std::move(out_)};
  }

 private:
  void put_pair(const PairResult& result) {
    put_u32(out_, static_cast<std::uint32_t>(result.a));
    put_u32(out_, static_cast<std::uint32_t>(result.b));
  }
  void all_windows(double until) {
    WindowWriter(scene_, world_.room(), contact_pair_, out_, [this](const auto& pair, const WorldTime& time) {
      const proof::ProvedPair& met = world_.pair(pair.first, pair.second);
      section(met, proof::stretches(met.legs, time), {});
    }).write(until);
  }

  void section(const proof::ProvedPair& pair, const std::vector<proof::LegStretch>& stretches,
               const std::optional<Instant>& until) {
    proof::Lifetimes lifetimes(pair.geometry);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      lifetimes.enter(pair.legs[stretches[i].leg]);
      const std::optional<Instant> last = i + 1 == stretches.size() ? until : std::nullopt;
      const double margin = lifetimes.leg().bridge ? 0 : world_.margin();
      ApartWriter(pair.ranges, lifetimes, last, out_, margin).write(stretches[i].from, stretches[i].to);
    }
  }

  /// The contact as the verifier will find it, and an instant shortly before it since which the vertex is outside.
  static std::pair<proof::FineInstant, Instant> instant(const proof::ProvedPair& pair, proof::Lifetimes& lifetimes,
                                                        const FoundContact& found, double about) {
    const auto first_since = [&](const proof::FineInstant& since) -> std::optional<Instant> {
      try {
        const VertexId end = pair.geometry.next(found.edge);
        return lifetimes.failure({found.edge, end, found.vertex, -1, proof::instant_at(since)}, about);
      } catch (const ProofError&) {
        // Too close to the root for a sign, or not close enough for it to be the first.
      } catch (const Undecidable&) {
      }
      return std::nullopt;
    };
    const Leg& leg = lifetimes.leg();
    for (double share = 0x1p-48; share <= 0x1p-8; share *= 0x1p8) {
      const proof::FineInstant since{std::max(leg.start, found.lo - share * (leg.end - leg.start)), 0, 0};
      if (const auto now = first_since(since)) return {since, *now};
    }
    // It may have come to the outside between the same two doubles.
    for (double step = 0x1p-200; found.at && step <= 0x1p-48; step *= 0x1p4) {
      const proof::FineInstant since = proof::nearest_instant(found.at->lo() - step);
      if (!proof::is_within(since, leg.start, leg.end)) break;
      if (const auto now = first_since(since)) return {since, *now};
    }
    throw Undecidable{"the instant of a contact, for a proof"};
  }

  /// The vertex of the pair that the scene calls so, and the edge.
  static VertexId id_of(const proof::ProvedPair& pair, const VertexRef& ref) {
    return id_where(pair, ref.body, [&](const RingSet& rings, std::uint32_t k) { return rings.vertex(k) == ref; });
  }
  static VertexId id_of_edge(const proof::ProvedPair& pair, const EdgeRef& ref) {
    return id_where(pair, ref.body, [&](const RingSet& rings, std::uint32_t k) { return rings.edge(k) == ref; });
  }
  template <class IsIt>
  static VertexId id_where(const proof::ProvedPair& pair, BodyId body, const IsIt& is_it) {
    const bool p = pair.plan.rings[0]->body() == body;
    const RingSet& rings = *pair.plan.rings[p ? 0 : 1];
    std::uint32_t k = 0;
    while (!is_it(rings, k)) ++k;
    return VertexId(p ? k : pair.geometry.np + k);
  }
  /// The bracket's end is not always one at which they are closer: where they graze, steps that grow lead to one, and
  /// where they come to the margin and no closer, it is between doubles.
  std::pair<std::size_t, proof::FineInstant> instant_of_closeness(const proof::ProvedPair& pair,
                                                                  const proof::Incidence& close, bool is_edge,
                                                                  const TimeInterval& about) const {
    for (std::size_t i = 0; i < pair.legs.size(); ++i) {
      const Leg& leg = pair.legs[i];
      if (leg.bridge || about.hi < leg.start || about.hi > leg.end) continue;
      const auto is_closer = [&](const proof::FineInstant& at) {
        return proof::closer_at(pair.geometry, leg, world_.margin(), close, is_edge, at);
      };
      double step = 0x1p-53 * std::max(std::fabs(about.hi), 0x1p-20 * (leg.end - leg.start));
      for (int k = 0; k < most_steps && about.hi + step <= leg.end; ++k, step *= 2) {
        for (const double at : {about.hi, about.hi + step}) {
          if (is_closer({at, 0, 0})) return {i, {at, 0, 0}};
        }
      }
      if (const auto at = instant_between_doubles(pair, leg, close, is_edge, about, is_closer)) return {i, *at};
    }
    throw Undecidable{"an instant at which bodies are closer than the clearance"};
  }
  template <class IsCloser>
  std::optional<proof::FineInstant> instant_between_doubles(const proof::ProvedPair& pair, const Leg& leg,
                                                            const proof::Incidence& close, bool is_edge,
                                                            const TimeInterval& about,
                                                            const IsCloser& is_closer) const {
    const spacetime::PreciseApproaches approaches(pair.geometry, leg, world_.margin());
    const double from = std::max(leg.start, about.lo);
    const double to = std::min(leg.end, std::nextafter(about.hi, std::numeric_limits<double>::infinity()));
    const auto found = approaches.first({close.vertex, close.edge, is_edge}, from, to);
    if (!found) return std::nullopt;
    const RealMax root = found->precise.hi();
    for (double step = 0x1p-150; step < 0x1p-48; step *= 2) {
      const proof::FineInstant at = proof::nearest_instant(root + step);
      if (is_closer(at)) return at;
    }
    return std::nullopt;
  }

  static constexpr int most_steps = 30;

  const proof::ProvedScene& scene_;
  Claim claim_;
  proof::ProvedWorld world_;
  std::pair<int, int> contact_pair_{-1, -1};
  std::string out_;
};

/// Writes the whole log: the header, the clearance if there is one, and what comes after.
void write_log(std::ostream& log, const Scene& scene, Touch touch, Claim claim, const std::string& body,
               double clearance = 0) {
  const std::uint8_t kind = static_cast<std::uint8_t>(claim) | (clearance > 0 ? proof::with_clearance : 0);
  proof::ByteWriter out(log);
  proof::write_header(out, {proof::of_separations, scene_fingerprint(scene, touch), touch, kind});
  if (clearance > 0) out.f64(clearance);
  for (const char c : body) out.u8(static_cast<std::uint8_t>(c));
  out.close();
}

/// The pair that the answer names.
const PairResult* headline(const Answer& answer, const std::vector<PairResult>& results) {
  const std::array<int, 2> named = answer.pair.value_or(std::array<int, 2>{0, 1});
  const auto found = std::find_if(results.begin(), results.end(),
                                  [&](const PairResult& r) { return r.a == named[0] && r.b == named[1]; });
  return found == results.end() ? nullptr : &*found;
}

/// The answer, if `write()` proves it; else it is undecided from the start on.
template <class AnyAnswer, class Write>
AnyAnswer if_proved(const AnyAnswer& answer, double start, const Write& write) {
  const std::string stopped = what_stops(write);
  if (stopped.empty()) return answer;
  AnyAnswer undecided;
  if constexpr (std::is_same_v<AnyAnswer, Answer>) undecided.engine = answer.engine;
  undecided.outcome = Outcome::undecided;
  undecided.coverage = answer.coverage;
  undecided.free_until = start;
  undecided.reason =
      std::string("the answer is ") + to_string(answer.outcome) + ", but its proof was not finished: " + stopped;
  return undecided;
}

/// Up to where windows can go if nothing happens before `until`: at a joint they have all of its bridges, and on one of
/// these it may happen, so they end at the double before.
double end_of_windows(const proof::ProvedScene& scene, double until) {
  const double t = std::clamp(until, scene.start(), scene.end());
  for (int body = 0; body < scene.size(); ++body) {
    for (const std::vector<MotionPiece>& motion : scene[body].motions) {
      const auto ends_at_t = [t](const MotionPiece& piece) { return piece.until == t; };
      if (t > scene.start() && std::any_of(motion.begin(), motion.end(), ends_at_t))
        return std::nextafter(t, scene.start());
    }
  }
  return t;
}

/// That nothing happens up to where the answer says; nothing of other answers.
template <class AnyAnswer>
std::optional<std::pair<Claim, std::string>> freedom(const AnyAnswer& answer, const proof::ProvedScene& proved,
                                                     bool inwards, double margin) {
  const bool all = answer.outcome == Outcome::free;
  const double until = all ? proved.end() : end_of_windows(proved, answer.free_until);
  if (!all && (answer.outcome != Outcome::undecided || until <= proved.start())) return std::nullopt;
  const Claim claim = all ? Claim::free : Claim::free_until;
  return std::pair(claim, SeparationsWriter(proved, claim, inwards, margin).apart_until(until));
}

/// What the answer comes to in a log, without its header; nothing where there is nothing to prove.
std::optional<std::pair<Claim, std::string>> body_of_log(const WorldRun& run, const proof::ProvedScene& proved,
                                                         const Answer& answer, Touch touch) {
  const bool inwards = touch == Touch::open;
  if (answer.outcome != Outcome::contact) return freedom(answer, proved, inwards, 0);
  // Of two bodies, the only pair has its own section.
  const double until = proved.size() == 2 ? std::clamp(answer.free_until, proved.start(), proved.end())
                                          : end_of_windows(proved, answer.free_until);
  const std::vector<PairResult> results = run.search()->results();
  const PairResult* named = headline(answer, results);
  if (named->touching)
    return std::pair(Claim::touching, SeparationsWriter(proved, Claim::touching, true).touching(*named));
  return SeparationsWriter(proved, Claim::contact, inwards).contact(*named, until);
}

}  // namespace

Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& given) {
  CheckOptions options = given;
  options.all_pairs = false;
  WorldRun run(scene, options);
  run.work(UINT64_MAX);
  Answer answer = with_touching(run, scene, options, run_world);
  if (!run.search()) return answer;
  return if_proved(answer, scene.start, [&] {
    if (const auto body = body_of_log(run, proof::ProvedScene(scene), answer, options.touch))
      write_log(log, scene, options.touch, body->first, body->second);
  });
}

Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options, const Answer& known) {
  if (known.outcome == Outcome::free) {
    const InterruptionScope scope(options.stop, options.max_seconds);
    const std::string stopped = what_stops([&] {
      const auto body = freedom(known, proof::ProvedScene(scene), options.touch == Touch::open, 0);
      write_log(log, scene, options.touch, body->first, body->second);
    });
    if (stopped.empty()) return known;
  }
  // Bodies that overlap by about as much as they are displaced may be free as engines see them, and not in the log.
  return prove_by_separations(scene, log, options);
}

namespace {

/// What an answer about a clearance comes to in a log.
std::optional<std::pair<Claim, std::string>> body_about_clearance(const Scene& scene, const MarginAnswer& answer,
                                                                  double clearance, Touch touch) {
  const proof::ProvedScene proved(scene);
  const bool inwards = touch == Touch::open;
  const double margin = std::ldexp(clearance, proved.exponent());
  if (answer.outcome != Outcome::contact) return freedom(answer, proved, inwards, margin);
  const double until = end_of_windows(proved, answer.free_until);
  const PairMargin& first = *answer.first;
  return std::pair(Claim::contact, SeparationsWriter(proved, Claim::contact, inwards, margin)
                                       .closer(first.bodies, *first.features, {until, first.time.hi}));
}

}  // namespace

MarginAnswer prove_clearance(const Scene& scene, double clearance, std::ostream& log, const CheckOptions& given) {
  if (has_curves(scene)) return prove_clearance_of_curves(scene, clearance, log, given);
  CheckOptions options = given;
  options.all_pairs = false;
  const MarginAnswer answer = check_clearance(scene, clearance, options);
  return if_proved(answer, scene.start, [&] {
    const InterruptionScope scope(options.stop, options.max_seconds);
    if (const auto body = body_about_clearance(scene, answer, clearance, options.touch))
      write_log(log, scene, options.touch, body->first, body->second, clearance);
  });
}

}  // namespace taut
