#include "proof/apart_checker.hpp"

#include <bit>

#include "numeric/budget.hpp"
#include "proof/separation.hpp"
#include "taut/error.hpp"

namespace taut::internal::proof {

const MotionWindow& HalvedWindows::at(const HalvedTime& time) {
  if (windows_.size() >= most) windows_.clear();
  const auto known = windows_.find(time.number);
  return known != windows_.end() ? known->second : windows_.emplace(time.number, made(time)).first->second;
}

/// That over the longest window above it that has one.
const FrameModel* HalvedWindows::sharp_model_above(const HalvedTime& time) {
  HalvedTime above = whole_;
  for (int half = static_cast<int>(std::bit_width(time.number)) - 2; half >= 0; --half) {
    if (const FrameModel* sharp = sharp_model_over(above)) return sharp;
    above = (time.number >> half & 1) != 0 ? above.second() : above.first();
  }
  return nullptr;
}

const FrameModel* HalvedWindows::sharp_model_over(const HalvedTime& time) {
  auto known = models_.find(time.number);
  if (known == models_.end()) {
    const bool promising = at(time).may_be_sharp();
    if (models_.size() >= most_models) models_.clear();
    known = models_.try_emplace(time.number).first;
    const FrameModel model = promising ? FrameModel::over(segment_, time.from, time.to) : FrameModel();
    if (promising && model.sharp()) known->second = model;
  }
  return known->second ? &*known->second : nullptr;
}

MotionWindow HalvedWindows::made(const HalvedTime& time) {
  if (const FrameModel* sharp = segment_.bridge ? nullptr : sharp_model_above(time))
    return {segment_, *sharp, time.from, time.to};
  return {segment_, time.from, time.to};
}

namespace {

SeparationInWindow separated_in_halves(const PairGeometry& geometry, const Incidence& incidence, SeparationReason why,
                                       HalvedWindows& windows, const HalvedTime& time, int halvings) {
  const SeparationInWindow seen = stays_separated_in_window(geometry, incidence, why, windows.at(time));
  if (seen != SeparationInWindow::open || halvings == 0 || !time.divisible()) return seen;
  const SeparationInWindow first = separated_in_halves(geometry, incidence, why, windows, time.first(), halvings - 1);
  if (first == SeparationInWindow::no) return first;
  const SeparationInWindow second = separated_in_halves(geometry, incidence, why, windows, time.second(), halvings - 1);
  if (second == SeparationInWindow::no || first == second) return second;
  return first == SeparationInWindow::yes ? second : first;
}

}  // namespace

SeparationInWindow stays_separated_in_windows(const PairGeometry& geometry, const Incidence& incidence,
                                              SeparationReason why, HalvedWindows& windows, const HalvedTime& time,
                                              const Instant& end) {
  constexpr int most_halvings = 6;
  return separated_in_halves(geometry, incidence, why, windows, time, end.event ? 0 : most_halvings);
}

Instant end_of(const HalvedTime& time, const std::optional<Instant>& until) {
  return until && until->lo <= time.to ? *until : Instant::exactly(time.to);
}

void ApartChecker::visit(const RangePair& ranges, const HalvedTime& time) {
  checkpoint();
  const EdgeRange &p = pair_.p[ranges.p], &q = pair_.q[ranges.q];
  const std::uint8_t named = in_.u8();
  switch (named) {
    case step::halve_time:
      if (!time.divisible()) throw ProofError("time is halved too often");
      visit(ranges, time.first());
      visit(ranges, time.second());
      return;
    case step::halve_p:
      if (p.single()) throw ProofError("a single edge is halved");
      for (const std::uint32_t half : p.halves) visit({half, ranges.q}, time);
      return;
    case step::halve_q:
      if (q.single()) throw ProofError("a single edge is halved");
      for (const std::uint32_t half : q.halves) visit({ranges.p, half}, time);
      return;
    case step::later:
      if (!until_ || time.from < until_->hi) throw ProofError("a stretch of time before the contact is left out");
      return;
    case step::ends_apart:
      check_ends(ranges, time);
      break;
    default:
      if (!separates(named, windows_.at(time), p, q, margin_))
        throw ProofError("two ranges of edges are not separated as the log says");
  }
  ++separations_;
}

void ApartChecker::check_ends(const RangePair& ranges, const HalvedTime& time) {
  if (!pair_.single(ranges)) throw ProofError("single edges are spoken of where there are several");
  const std::uint8_t why = in_.u8();
  if (margin_ > 0) return check_margin(ranges, why, time);
  check_incidence(pair_.onto_p(ranges), why & 15, time);
  check_incidence(pair_.onto_q(ranges), why >> 4, time);
}

void ApartChecker::check_margin(const RangePair& ranges, std::uint8_t why, const HalvedTime& time) {
  const KeptMargin kept(pair_, lifetimes_.segment(), margin_);
  if (!kept.separated(lifetimes_, pair_.onto_p(ranges), static_cast<SeparationReason>(why & 15), time.from, time.to) ||
      !kept.separated(lifetimes_, pair_.onto_q(ranges), static_cast<SeparationReason>(why >> 4), time.from, time.to))
    throw ProofError("a vertex does not keep the clearance from an edge");
  if (!kept.vertices(ranges, time.from, time.to)) throw ProofError("two vertices do not keep the clearance");
}

void ApartChecker::check_incidence(const Incidence& incidence, int why, const HalvedTime& time) {
  if (why >= reasons) throw ProofError("an unknown reason why two edges stay apart");
  const Instant end = end_of(time, until_);
  const auto as_said = static_cast<SeparationReason>(why);
  if (as_said <= SeparationReason::behind_second &&
      stays_separated_in_windows(pair_.geometry, incidence, as_said, windows_, time, end) == SeparationInWindow::yes)
    return;
  if (!stays_separated(pair_.geometry, lifetimes_, incidence, as_said, time.from, end))
    throw ProofError("a vertex does not stay off an edge");
}

}  // namespace taut::internal::proof
