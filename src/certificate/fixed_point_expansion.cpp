#include "certificate/fixed_point_expansion.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// In units of checkpoint(), as measured.
constexpr std::uint64_t work_of_expansion = 22, work_of_root_by_expansion = 30, work_of_sign_by_expansion = 10;
constexpr double rounded_up = 1 + 0x1p-45;
/// One more step costs little. After it, outward rounding to doubles costs one unit in the last place at most.
constexpr double much_less = 0x1p-8;

/// The time between `about` and a sum of doubles, in units of 2^exponent.
FixedBall since(double about, int exponent, const ShortSum& t) {
  FixedBall h = -FixedBall::exact(about);
  for (std::size_t i = t.size(); i-- > 0;) h = h + FixedBall::exact(t.part(i));
  return h.tightened().scaled(-exponent);
}

/// The correction to subtract from h, where the value is v. Division by the slope to twice the digits of a double gains
/// nearly as many digits in a step.
Fixed newton_step(const Fixed& v, const Fixed& slope) {
  const double steep = slope.approximate(), first = v.approximate() / steep;
  if (!(std::fabs(first) < 1)) return Fixed(std::copysign(1.0, first));
  return Fixed(first) + Fixed((v - Fixed(first) * slope).approximate() / steep);
}

/// The ball of exactly this number.
FixedBall chosen(const Fixed& h) { return {h, 0, std::fabs(h.approximate()) * rounded_up}; }

}  // namespace

FixedPointExpansion::FixedPointExpansion(const FrameExpansion& frame, const MotionSegment& segment,
                                         const PairGeometry& g, const CertificateFunction& function)
    : about_(frame.about), exponent_(frame.exponent) {
  count_work(work_of_expansion);
  const FunctionPoints<FixedBall> points = points_of<FixedBall>(segment, g, function, Shape::displaced);
  const std::array<FixedBall, 5> a = coefficients_on(segment, function.pp, points, FixedBall());
  const auto& functions = frame.functions(function.pp);
  for (std::size_t i = 0; i < 5; ++i) {
    if (a[i].is_zero()) continue;
    for (std::size_t k = 0; k < FrameExpansion::terms; ++k) {
      if (functions[i][k].is_zero()) continue;
      c_[k] = c_[k] + functions[i][k] * a[i];
      terms_ = std::max(terms_, k + 1);
    }
    rest_ = (rest_ + a[i].most() * frame.rest(function.pp)[i]) * rounded_up;
  }
  c_[0].widen(rest_);
  set_steepness();
}

/// Derives bounds of the slope within reach from the slope at the instant.
void FixedPointExpansion::set_steepness() {
  const double slope = c_[1].about();
  double change = 0;
  for (std::size_t k = 2; k < terms_; ++k) change += static_cast<double>(k) * c_[k].most();
  change += static_cast<double>(FrameExpansion::terms) * rest_;
  change = (change + c_[1].error_of(slope)) * rounded_up;
  steep_ = {(std::fabs(slope) - change) / rounded_up, (std::fabs(slope) + change) * rounded_up, slope};
}

/// Each product has a row for each nonzero word of the first factor, and steps are short.
FixedBall FixedPointExpansion::value(const FixedBall& h) const {
  FixedBall sum;
  for (std::size_t k = terms_; k-- > 0;) sum = h * sum + c_[k];
  return sum;
}

int FixedPointExpansion::sign_over(const PreciseTime& t) const {
  count_work(work_of_sign_by_expansion);
  const double width = t.width_of_sums() / power_of_two(exponent_);
  const FixedBall from = since(about_, exponent_, t.sum_lo());
  if (!(from.most() + width <= 1)) return 0;
  const FixedBall v = value(from);
  const double about = v.about(), sure = std::fabs(about) - v.error_of(about) - width * steep_.most * rounded_up;
  if (!(sure > 0)) return 0;
  return about > 0 ? 1 : -1;
}

/// The slope, to about the digits of a double, where the function is monotone within reach.
Fixed FixedPointExpansion::slope_near(const Fixed& h) const {
  const double since = h.approximate();
  double second = 0;
  for (std::size_t k = terms_; k-- > 2;) second = second * since + static_cast<double>(k) * c_[k].about();
  return c_[1].mid() + Fixed(std::clamp(second * since, -1.0, 1.0));
}

/// Finds the root by Newton steps from the middle, where the value is v.
template <class SlopeAt>
std::optional<PreciseTime> FixedPointExpansion::root_within(const Bracket& bracket, FixedBall v,
                                                            const SlopeAt& slope_at, Stage stage, double enough) const {
  Fixed h = bracket.middle;
  double error = INFINITY;
  for (int left = 12;; --left) {
    const double about = v.about(), noise = v.error_of(about), before = error;
    // By the mean value theorem.
    error = ((std::fabs(about) + noise) / bracket.steep.least + Fixed::unit) * rounded_up;
    if (left == 0 || !(error < before) || error <= much_less * enough || !(std::fabs(about) > 4 * noise)) break;
    h = h - newton_step(v.mid(), slope_at(h));
    v = value(chosen(h));
  }
  const double away = std::fabs((h - bracket.middle).approximate());
  if (!((away + error) * rounded_up < bracket.half)) return std::nullopt;
  return around(h, error, stage);
}

std::optional<PreciseTime> FixedPointExpansion::root(int sign, Stage stage, double enough) const {
  count_work(work_of_root_by_expansion);
  enough /= power_of_two(exponent_);
  const auto falls_from_sign = [&](const Steepness& s) { return s.least > 0 && (s.signed_about > 0) == (sign < 0); };
  if (steep_.least > 0) {
    if (!falls_from_sign(steep_)) return std::nullopt;
    return root_within(
        {Fixed(), 1, steep_}, c_[0], [&](const Fixed& h) { return slope_near(h); }, stage, enough);
  }
  const auto extremum = this->extremum();
  // Beyond the reach, nothing bounds the slope. The extremum itself is in the inner half of the reach.
  if (!extremum || extremum->value_sign == extremum->second_sign || !(extremum->half_gap < 0.5)) return std::nullopt;
  // Before the first of the two roots, the function has the sign of its second derivative.
  const Bracket bracket = bracket_near(*extremum, sign == extremum->second_sign ? -1 : 1);
  if (!falls_from_sign(bracket.steep)) return std::nullopt;
  const auto slope_at = [&](const Fixed& h) { return slope(chosen(h)).mid(); };
  return root_within(bracket, value(chosen(bracket.middle)), slope_at, stage, enough);
}

/// A bracket around an approximate root that does not extend to the extremum.
FixedPointExpansion::Bracket FixedPointExpansion::bracket_near(const Extremum& extremum, int side) const {
  const Fixed middle = extremum.at + Fixed(side * extremum.half_gap);
  const double half = extremum.half_gap / 4;
  const FixedBall there = slope(chosen(middle));
  const double about = there.about(), change = (there.error_of(about) + extremum.second_most * half) * rounded_up;
  return {middle, half, {(std::fabs(about) - change) / rounded_up, (std::fabs(about) + change) * rounded_up, about}};
}

/// The enclosure of all instants within `error` of h.
std::optional<PreciseTime> FixedPointExpansion::around(const Fixed& h, double error, Stage stage) const {
  if (!(std::fabs(h.approximate()) * rounded_up + error < 1)) return std::nullopt;
  const FixedBall about = FixedBall::exact(about_);
  if (about.rad() > 0) return std::nullopt;
  const Fixed at = about.mid() + h.scaled(exponent_);
  const Fixed spread = Fixed(error * power_of_two(exponent_) * rounded_up) + Fixed(2 * Fixed::unit);
  return PreciseTime(ShortSum(at - spread), ShortSum(at + spread), stage);
}

FixedBall FixedPointExpansion::slope(const FixedBall& h) const {
  FixedBall sum;
  for (std::size_t k = terms_; k-- > 1;) sum = sum * h + c_[k] * FixedBall::exact(static_cast<double>(k));
  // Covers the slope of the omitted terms.
  sum.widen(static_cast<double>(FrameExpansion::terms) * rest_ * rounded_up);
  return sum;
}

std::optional<FixedPointExpansion::Extremum> FixedPointExpansion::extremum() const {
  const double second = 2 * c_[2].about();
  double change = 2 * c_[2].error_of(second);
  for (std::size_t k = 3; k < terms_; ++k) change += static_cast<double>(k * (k - 1)) * c_[k].most();
  constexpr double last = FrameExpansion::terms * (FrameExpansion::terms - 1.0);
  change = (change + last * rest_) * rounded_up;
  const double least = std::fabs(second) - change;
  if (!(least > 0)) return std::nullopt;
  Fixed h;
  double steep = 0, noise = 0;
  for (int left = 8;; --left) {
    const FixedBall s = slope(chosen(h));
    steep = s.about();
    noise = s.error_of(steep);
    if (left == 0 || !(std::fabs(steep) > 4 * noise)) break;
    h = h + Fixed(std::clamp(-steep / second, -1.0, 1.0));
    if (!(std::fabs(h.approximate()) < 0.5)) return std::nullopt;
  }
  // The extreme value differs from the value here by a bound that follows from the remaining slope.
  FixedBall v = value(chosen(h));
  const double open = std::fabs(steep) + noise;
  if (!(open < 0.25 * least)) return std::nullopt;
  v.widen(open * open / least);
  if (v.sign() == 0) return std::nullopt;
  const double half_gap = std::sqrt(2 * std::fabs(v.about() / second));
  return Extremum{h, v.sign(), second > 0 ? 1 : -1, half_gap, (std::fabs(second) + change) * rounded_up};
}

std::optional<PreciseTime> FixedPointExpansion::root_near(const Extremum& extremum, int side, Stage stage) const {
  const double error = 0x1p-24 * extremum.half_gap;
  const Fixed root = extremum.at + Fixed(side * extremum.half_gap);
  // The value has the sign of the extreme value on the near side of the root, and the opposite sign beyond.
  const auto sign_at = [&](double h) { return value(chosen(root + Fixed(h))).sign(); };
  if (sign_at(-side * error) != extremum.value_sign || sign_at(side * error) != -extremum.value_sign)
    return std::nullopt;
  return around(root, error, stage);
}

namespace {

std::size_t mixed(const CertificateFunction& function) {
  const std::size_t all = function.a.value * std::size_t{0x9e3779b1} + function.b.value * std::size_t{0x85ebca77} +
                          function.c.value * std::size_t{0xc2b2ae3d} + static_cast<std::size_t>(function.measure);
  return all >> 8 ^ all >> 16 ^ all;
}

}  // namespace

ExpansionCache::Place& ExpansionCache::place_of(const FrameExpansion& frame, const CertificateFunction& function) {
  reserve();
  if (is_stale_) {
    for (Place& place : kept_->places) place.used = false;
    is_stale_ = false;
  }
  Place& place = kept_->places[mixed(function) % kept_->places.size()];
  if (place.used && place.about == frame.about && place.function == function) return place;
  place.has_expansion = place.has_near = false;
  place.root.reset();
  place.roots_seen = 0;
  place.function = function;
  place.about = frame.about;
  place.used = true;
  return place;
}

const FixedPointExpansion& ExpansionCache::of(const FrameExpansion& frame, const MotionSegment& segment,
                                              const PairGeometry& g, const CertificateFunction& function) {
  Place& place = place_of(frame, function);
  if (!place.has_expansion) {
    place.expansion = FixedPointExpansion(frame, segment, g, function);
    place.has_expansion = true;
  }
  return place.expansion;
}

const RelativeRoot& ExpansionCache::near_of(Place& place, const FrameExpansion& frame, const MotionSegment& segment,
                                            const PairGeometry& g) {
  if (!place.has_near) {
    place.near = RelativeRoot(frame, segment, g, place.function);
    place.has_near = true;
  }
  return place.near;
}

const RootOfExpansion* ExpansionCache::root_near(const FrameExpansion& frame, const MotionSegment& segment,
                                                 const PairGeometry& g, const CertificateFunction& function,
                                                 double enough) {
  if (roots_noted_ == 0) return nullptr;
  Place& place = place_of(frame, function);
  if (place.root && place.root->error < enough) return &*place.root;
  const RelativeRoot& near = near_of(place, frame, segment, g);
  if (near.slope_sign() == 0) return nullptr;
  // None of the roots examined gave an error below the one requested then; or there is none at all.
  const bool seen_in_vain = place.enough == enough || (place.enough > enough && !place.root);
  const std::uint64_t most = kept_->roots.size(), seen = seen_in_vain ? place.roots_seen : 0;
  place.roots_seen = roots_noted_;
  place.enough = enough;
  // The root noted last is the nearest.
  for (std::uint64_t k = roots_noted_; k-- > std::max(seen, roots_noted_ - std::min(roots_noted_, most));) {
    const KnownRoot& known = kept_->roots[static_cast<std::size_t>(k % most)];
    if (!near.has_same_reference(known.function)) continue;
    const auto distance = near.distance_from(frame, segment, known);
    if (!distance || !(distance->error < enough)) continue;
    place.root = RootOfExpansion{known.at_distance(*distance), near.slope_sign(), distance->error};
    return &*place.root;
  }
  return nullptr;
}

void ExpansionCache::note_root(const FrameExpansion& frame, const MotionSegment& segment, const PairGeometry& g,
                               const CertificateFunction& function, const PreciseTime& root) {
  const RelativeRoot& near = near_of(place_of(frame, function), frame, segment, g);
  if (near.slope_sign() == 0) return;
  const std::uint64_t place = roots_noted_++ % kept_->roots.size();
  kept_->roots[static_cast<std::size_t>(place)] = KnownRoot(near, frame, root);
}

}  // namespace taut::internal
