#include "prove/apart_writer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "proof/separation.hpp"

namespace taut::internal {
namespace {

using proof::SeparationReason;

/// Ranges that move farther than this share of their size are deferred to shorter time windows.
constexpr double subdivision_threshold_of_proofs = 0.75;
/// So are ranges whose motion is known less accurately than this share: a window half as long leaves an eighth of the
/// uncertainty.
constexpr double share_of_doubt = 0.0625;
/// If half a window left this share of the uncertainty, and that is a large part of the motion, it is due to the
/// rounding of doubles. Shorter windows do not reduce it.
constexpr double share_of_rounding = 0.875;
/// A margin as small as this, relative to the coordinates, is left to multi-precision.
constexpr double doubtful = 0x1p-44;

/// The approximate margin by which this reason separates a vertex from an edge in the middle of the window.
double margin_by(const PairGeometry& g, const proof::Incidence& i, const proof::WindowModel& model,
                 SeparationReason why) {
  const Vector v = model.shift + model.rotation * proof::place(g, i.vertex);
  const proof::HalfPlane side = proof::half_plane(proof::place(g, i.edge), proof::place(g, g.next(i.edge)), why);
  return dot(side.normal, v - side.from);
}

/// The margins for the reasons by which a vertex may be off the edge itself, the largest first.
std::array<std::pair<double, SeparationReason>, 4> margins(const PairGeometry& g, const proof::Incidence& i,
                                                           const proof::WindowModel& model) {
  std::array<std::pair<double, SeparationReason>, 4> all{{{0, SeparationReason::left},
                                                          {0, SeparationReason::right},
                                                          {0, SeparationReason::behind_first},
                                                          {0, SeparationReason::behind_second}}};
  for (auto& [margin, why] : all) margin = margin_by(g, i, model, why);
  std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.first > y.first; });
  return all;
}

/// Is the other side of the edge farther away than the vertex moves within the window? Near an infinite speed, this may
/// be known where no window is so short that doubles decide signs in it.
bool is_far(double margin, const PairGeometry& g, const proof::Incidence& i, const proof::WindowModel& model,
            double half) {
  const Vector v = proof::place(g, i.vertex), edge = proof::place(g, g.next(i.edge)) - proof::place(g, i.edge);
  const double way = half * (l1_norm(model.shift_rate + model.rotation_rate * v) +
                             half / 2 * l1_norm(model.shift_second + model.rotation_second * v));
  return margin > 2 * l1_norm(edge) * (way + model.shift_error + model.rotation_error * l1_norm(v));
}

/// The uncertainty of the motion.
double doubt(const proof::MotionWindow& window, const proof::EdgeRange& q) {
  const proof::WindowModel& model = window.from_p();
  return model.shift_error + model.rotation_error * (l1_norm(q.centre) + q.radius());
}

}  // namespace

void ApartWriter::visit(const proof::RangePair& ranges, const proof::HalvedTime& time, double doubt_before) {
  checkpoint();
  if (until_ && time.from >= until_->hi) return step(proof::step::later);
  const proof::EdgeRange &p = pair_.p[ranges.p], &q = pair_.q[ranges.q];
  const proof::MotionWindow& window = windows_.at(time);
  if (const auto named = proof::separating_step(window, p, q, margin_)) return step(*named);
  const double radii = p.radius() + q.radius(), moved = proof::motion_in(window, q), unknown = doubt(window, q);
  const bool far = moved > subdivision_threshold_of_proofs * radii || unknown > share_of_doubt * radii;
  if (far && time.divisible()) return halve_time(ranges, time, unknown);
  if (!pair_.single(ranges)) return halve_range(ranges, time, doubt_before);
  const bool rounded = unknown > moved / 4 && unknown > share_of_rounding * doubt_before;
  const bool halves_help = time.divisible() && !rounded;
  if (const auto why = margin_ > 0 ? margin_kept(ranges, time) : ends_apart(ranges, time, halves_help)) {
    step(proof::step::ends_apart);
    return step(*why);
  }
  if (!time.divisible()) throw Undecidable{"what keeps two edges apart"};
  halve_time(ranges, time, unknown);
}

void ApartWriter::halve_time(const proof::RangePair& ranges, const proof::HalvedTime& time, double doubt) {
  step(proof::step::halve_time);
  const std::size_t begin = out_.size();
  visit(ranges, time.first(), doubt);
  if (ranges.is_whole() && time.from == from_) note_written(time.first(), begin);
  visit(ranges, time.second(), doubt);
}

/// Verifiers take models of the motion from the longest windows that have good ones. As the first window of a log of
/// its own, this one must not have been checked by the model of a longer one.
void ApartWriter::note_written(const proof::HalvedTime& half, std::size_t begin) {
  if (!windows_.has_model_above(half)) written_ = {half.to, begin, out_.size()};
}

void ApartWriter::halve_range(const proof::RangePair& ranges, const proof::HalvedTime& time, double doubt) {
  const proof::EdgeRange &p = pair_.p[ranges.p], &q = pair_.q[ranges.q];
  const bool of_p = q.single() || (!p.single() && p.radius() >= q.radius());
  step(of_p ? proof::step::halve_p : proof::step::halve_q);
  for (const std::uint32_t half : of_p ? p.halves : q.halves)
    visit(of_p ? proof::RangePair{half, ranges.q} : proof::RangePair{ranges.p, half}, time, doubt);
}

/// Tests the reasons that hold approximately in the middle of the window, the one with the largest margin first.
std::optional<SeparationReason> ApartWriter::reason_for_margin(const proof::Incidence& i,
                                                               const proof::WindowModel& model,
                                                               const proof::HalvedTime& time) {
  const PairGeometry& g = pair_.geometry;
  const DisplacedPoint &a = g.point(i.edge), &b = g.point(g.next(i.edge));
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const proof::KeptMargin kept(pair_, lifetimes_.segment(), margin_);
  auto candidates = margins(g, i, model);
  for (auto& [room, why] : candidates) room = room / length - (why == SeparationReason::right ? margin_ : 0);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& x, const auto& y) { return x.first > y.first; });
  const double doubt = doubtful * (1 + model.size) + model.shift_error + model.rotation_error;
  for (const auto& [room, why] : candidates) {
    try {
      if (room >= -doubt && kept.separated(lifetimes_, i, why, time.from, time.to)) return why;
    } catch (const Undecidable&) {
    }
  }
  return std::nullopt;
}

std::optional<std::uint8_t> ApartWriter::margin_kept(const proof::RangePair& ranges, const proof::HalvedTime& time) {
  const proof::MotionWindow window = windows_.at(time);
  const auto onto_p = reason_for_margin(pair_.onto_p(ranges), window.from_p(), time);
  if (!onto_p) return std::nullopt;
  const auto onto_q = reason_for_margin(pair_.onto_q(ranges), window.from_q(), time);
  if (!onto_q) return std::nullopt;
  if (!proof::KeptMargin(pair_, lifetimes_.segment(), margin_).vertices(ranges, time.from, time.to))
    return std::nullopt;
  return static_cast<std::uint8_t>(static_cast<unsigned>(*onto_p) | static_cast<unsigned>(*onto_q) << 4);
}

/// Long numbers are not used for one edge if the other one requires the window to be halved anyway.
std::optional<std::uint8_t> ApartWriter::ends_apart(const proof::RangePair& ranges, const proof::HalvedTime& time,
                                                    bool halves_help) {
  const proof::MotionWindow window = windows_.at(time);
  Evaluation onto_p = evaluate(pair_.onto_p(ranges), window, time, halves_help);
  if (onto_p.left_to_halves) return std::nullopt;
  Evaluation onto_q = evaluate(pair_.onto_q(ranges), window, time, halves_help);
  if (onto_q.left_to_halves) return std::nullopt;
  for (Evaluation* one : {&onto_p, &onto_q}) {
    if (!one->why) one->why = precise_reason(*one, time, halves_help);
    if (!one->why) return std::nullopt;
  }
  return static_cast<std::uint8_t>(static_cast<unsigned>(*onto_p.why) | static_cast<unsigned>(*onto_q.why) << 4);
}

ApartWriter::Evaluation ApartWriter::evaluate(const proof::Incidence& incidence, const proof::MotionWindow& window,
                                              const proof::HalvedTime& time, bool halves_help) {
  const proof::WindowModel& model = pair_.geometry.in_p(incidence.edge) ? window.from_p() : window.from_q();
  Evaluation seen{incidence, margins(pair_.geometry, incidence, model), doubtful * (1 + model.size)};
  seen.doubt = seen.none + model.shift_error + model.rotation_error;
  seen.why = reason_in_doubles(seen, time);
  seen.far = is_far(seen.candidates[0].first, pair_.geometry, incidence, model, window.half());
  seen.left_to_halves = !seen.why && halves_help && seen.some_room() && !seen.far && !lifetimes_.segment().translation;
  return seen;
}

std::optional<SeparationReason> ApartWriter::reason_in_doubles(const Evaluation& seen, const proof::HalvedTime& time) {
  const Instant end = proof::end_of(time, until_);
  const auto& candidates = seen.candidates;
  std::array<bool, std::tuple_size_v<Candidates>> open{};
  for (std::size_t k = 0; k < candidates.size() && candidates[k].first >= -seen.doubt; ++k) {
    const auto& [margin, why] = candidates[k];
    const auto decided = proof::stays_separated_in_windows(pair_.geometry, seen.incidence, why, windows_, time, end);
    if (decided == proof::SeparationInWindow::yes) return why;
    // Up to a contact, it may hold nevertheless. A margin that is zero in doubles may be positive due to the
    // displacement.
    open[k] = end.event || (decided != proof::SeparationInWindow::no && (margin < seen.none || !time.divisible()));
  }
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const SeparationReason why = candidates[k].second;
    if (open[k] && proof::stays_separated_in_doubles(pair_.geometry, lifetimes_, seen.incidence, why, time.from, end))
      return why;
  }
  return std::nullopt;
}

/// Shorter windows make doubles more accurate. That is no alternative where halving does not help, or the largest
/// margin is zero in doubles, or is evident already.
std::optional<SeparationReason> ApartWriter::precise_reason(const Evaluation& seen, const proof::HalvedTime& time,
                                                            bool halves_help) {
  const Instant end = proof::end_of(time, until_);
  const proof::Incidence& incidence = seen.incidence;
  const SeparationReason plain = seen.candidates[0].second;
  if (seen.far && stays_separated(incidence, plain, time, end)) return plain;
  for (const auto& [margin, why] : seen.candidates) {
    const bool tie = margin > seen.none && lifetimes_.segment().translation && is_new_tie(incidence, why, time);
    if (tie && stays_separated(incidence, why, time, end)) return why;
  }
  if (seen.some_room() && halves_help) return std::nullopt;
  for (const auto& [margin, why] : seen.candidates) {
    if (margin >= -seen.doubt && stays_separated(incidence, why, time, end)) return why;
  }
  for (int why = static_cast<int>(SeparationReason::beyond_line_before); why < proof::reasons; ++why) {
    // The last reason costs most and proves least: it is for stretches that cannot be halved.
    if (static_cast<SeparationReason>(why) == SeparationReason::behind_when_on_line && time.divisible()) continue;
    if (stays_separated(incidence, static_cast<SeparationReason>(why), time, end))
      return static_cast<SeparationReason>(why);
  }
  return std::nullopt;
}

/// Is the margin zero, except for the displacement, at an end of the stretch? Then windows would be halved down to that
/// end, whereas exact certificate functions decide for the whole window.
bool ApartWriter::is_new_tie(const proof::Incidence& incidence, SeparationReason why, const proof::HalvedTime& time) {
  const auto is_gone = [&](double at, std::optional<proof::MotionWindow>& window) {
    if (!window) window.emplace(lifetimes_.segment(), at, at);
    const proof::WindowModel& model = pair_.geometry.in_p(incidence.edge) ? window->from_p() : window->from_q();
    return std::fabs(margin_by(pair_.geometry, incidence, model, why)) <=
           doubtful * (1 + model.size) + model.shift_error + model.rotation_error;
  };
  const bool gone = (time.from == from_ && is_gone(from_, at_start_)) || (time.to == to_ && is_gone(to_, at_end_));
  return gone && ties_.insert({incidence.vertex.value, incidence.edge.value, why}).second;
}

/// If it cannot be decided, another reason may suffice, or a shorter time window.
bool ApartWriter::stays_separated(const proof::Incidence& incidence, SeparationReason why,
                                  const proof::HalvedTime& time, const Instant& end) {
  try {
    return proof::stays_separated(pair_.geometry, lifetimes_, incidence, why, time.from, end);
  } catch (const Undecidable&) {
    return false;
  }
}

}  // namespace taut::internal
