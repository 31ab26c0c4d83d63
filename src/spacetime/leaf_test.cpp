#include "spacetime/leaf_test.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/budget.hpp"
#include "numeric/quadratic_bound.hpp"

namespace taut::internal::spacetime {
namespace {

double below(double x) { return std::nextafter(x, -INFINITY); }
double above(double x) { return std::nextafter(x, INFINITY); }

/// In units of checkpoint().
constexpr std::uint64_t work_of_step = 2;

/// Steps shorter than this share of the window make no progress.
constexpr double least_step = 0x1p-36;
/// The number of steps that usually reach the end of a window. After that, the rest is left to a search from a singular
/// end if one is near.
constexpr int few_steps = 16;
/// More steps would cost more than a search in multi-precision, which recognizes tangencies of higher order from afar.
constexpr int many_steps = 96;
/// The first stride that multi-precision searches, as a share of the window, and its growth.
constexpr double first_stride = 0x1p-16, stride_growth = 32;

/// The sign over all of [lo, hi], if certain: first order about the middle, second order beyond.
int sign_between(const FastFunction& f, FrameWindow& window, double lo, double hi) {
  const double middle = lo + (hi - lo) / 2;
  const LocalExpansion c(f, window, middle, 1);
  const double reach = std::max(hi - middle, middle - lo) * (1 + 0x1p-40) + 0x1p-1000;
  const double steep = std::fabs(c.slope.value) + c.slope.error;
  const double bent = std::fabs(c.second.value) + c.second.error;
  const Bounded wide{c.value.value, (c.value.error + reach * (steep + reach * bent)) * (1 + 0x1p-40)};
  return wide.sign();
}

}  // namespace

LeafTest::Functions LeafTest::functions(const VertexEdge& pair) const {
  const auto of = [this](const CertificateFunction& function) {
    return FastFunction::undisplaced(segment_, geometry_, function);
  };
  const auto sliding = first_orders_.find(pair.number());
  const bool slides = sliding != first_orders_.end() && sliding->second;
  return {slides ? *sliding->second : of(pair.line(geometry_)), of(pair.from_start(geometry_)),
          of(pair.from_end(geometry_))};
}

const FastFunction* LeafTest::first_order(const VertexEdge& pair) {
  const auto [at, is_new] = first_orders_.try_emplace(pair.number());
  std::optional<FastFunction>& function = at->second;
  if (is_new && !FastFunction::displacement_gradient(segment_, geometry_, pair.line(geometry_), function.emplace()))
    function.reset();
  if (is_new && function) stages_.add(Stage::first_order);
  return function ? &*function : nullptr;
}

bool LeafTest::excluded_in_range(const FrameWindow& window, const VertexEdge& pair) const {
  const Functions f = functions(pair);
  const FrameSample& s = window.range(f.line.pp);
  return f.line.value(s).sign() != 0 || f.from_start.value(s).sign() < 0 || f.from_end.value(s).sign() < 0;
}

/// Encloses the next root of the line's function, which has `sign` at t, if a root certainly exists.
bool LeafTest::isolate(FrameWindow& window, const Functions& f, double t, double limit, int sign, Crossing& root,
                       double& falls_until) {
  const LocalExpansion c(f.line, window, t, sign);
  const double after = c.negative_from(limit - t, falls_until);
  if (!(after < limit - t)) return false;
  root.lo = std::max(t, below(t + c.positive_until(limit - t)));
  root.hi = std::min(above(t + after), window.end());
  falls_until = std::max(root.hi, below(t + falls_until));
  ++roots_;
  newton(window, f.line, sign, root);
  return true;
}

/// Interval Newton, with bounds of the slope over the current enclosure.
void LeafTest::newton(FrameWindow& window, const FastFunction& line, int sign, Crossing& root) const {
  for (int step = 0; step < 6; ++step) {
    const double width = root.hi - root.lo, m = root.lo + width / 2;
    if (!(width > 0x1p-50 * std::fabs(m))) return;
    const LocalExpansion c(line, window, m, sign);
    const double spread = c.slope.error + (std::fabs(c.second.value) + c.second.error) *
                                              std::max(root.hi - m, m - root.lo) * (1 + 0x1p-40);
    const double steep = -c.slope.value + spread, flat = -c.slope.value - spread;
    if (!(flat > 0)) return;
    const double least = c.value.lower(), most = c.value.upper();
    const double lo = m + least / (least > 0 ? steep : flat), hi = m + most / (most > 0 ? flat : steep);
    const double slack = 0x1p-51 * (std::fabs(lo) + std::fabs(hi)) + 0x1p-50 * (std::fabs(lo - m) + std::fabs(hi - m));
    root.lo = std::max(root.lo, lo - slack);
    root.hi = std::min(root.hi, hi + slack);
    if (!(root.hi - root.lo < 0.5 * width)) return;
  }
}

OnEdge LeafTest::on_edge(FrameWindow& window, const Functions& f, const Crossing& root) const {
  const int a = sign_between(f.from_start, window, root.lo, root.hi);
  const int b = sign_between(f.from_end, window, root.lo, root.hi);
  if (a < 0 || b < 0) return OnEdge::no;
  return a > 0 && b > 0 ? OnEdge::yes : OnEdge::unknown;
}

/// Is the next root of the line's function, which has `sign` at t, isolated, and a crossing? If it is not a crossing, t
/// moves past it.
LeafTest::Ahead LeafTest::look_ahead(FrameWindow& window, const Functions& f, double limit, int sign, double& t,
                                     Crossing& root) {
  double falls_until = 0;
  if (!isolate(window, f, t, limit, sign, root, falls_until)) return Ahead::unknown;
  OnEdge at_root = on_edge(window, f, root);
  if (at_root == OnEdge::unknown) at_root = precise_.on_edge(root, sign);
  root.out = sign > 0;
  if (at_root == OnEdge::yes && (sign < 0 || directions_ == CrossingDirections::both)) return Ahead::crossing;
  // After the root, the line's function keeps its new sign until it may have an extremum.
  t = std::max(root.hi, falls_until);
  return Ahead::passed;
}

/// The time for which the vertex is certainly beyond one of the edge's ends from t on.
double LeafTest::beyond_ends(FrameWindow& window, const Functions& f, double t, double limit) const {
  return std::max(LocalExpansion(f.from_start, window, t, -1).positive_until(limit),
                  LocalExpansion(f.from_end, window, t, -1).positive_until(limit));
}

/// Where doubles have no sign of the value at t, but of the slope, one sign at high precision determines the direction
/// in which the function leaves zero, and doubles do the rest. `unknown` if the slope has no sign either, or doubles
/// would soon fail again.
LeafTest::Ahead LeafTest::leave_zero(FrameWindow& window, const Functions& f, double limit, double& t, Crossing& root) {
  if (LocalExpansion(f.line, window, t, 1).slope.sign() == 0) return Ahead::unknown;
  const int sign = precise_.side(root.pair, t);
  const LocalExpansion c(f.line, window, t, sign);
  if (c.slope.value < 0) return look_ahead(window, f, limit, sign, t, root);
  const double step = internal::positive_until(0, c.slope.lower(), c.second.lower(), limit - t);
  if (step >= limit - t) {
    t = limit;
    return Ahead::passed;
  }
  const double next = below(t + step);
  const bool rises = c.slope.lower() * step > 8 * c.value.error;
  if (!rises || !(step > least_step * window.length() && next > t)) return Ahead::unknown;
  t = next;
  return Ahead::passed;
}

/// Moves on past zero, or at high precision for a growing stride.
LeafTest::Ahead LeafTest::leave_short_steps(FrameWindow& window, const Functions& f, double limit, int sign, double& t,
                                            double& stride, Crossing& root) {
  const Ahead beyond = sign == 0 ? leave_zero(window, f, limit, t, root) : Ahead::unknown;
  if (beyond != Ahead::unknown) return beyond;
  const double to = std::min(limit, std::max(above(t), t + stride));
  if (auto found = precise_.first(root.pair, t, to)) {
    root = *found;
    return Ahead::crossing;
  }
  t = to;
  stride *= stride_growth;
  return Ahead::passed;
}

std::optional<Crossing> LeafTest::first(FrameWindow& window, const VertexEdge& pair, double t, double limit) {
  if (!window.smooth()) {
    if (excluded_in_range(window, pair)) return std::nullopt;
    return near_end_.first(pair, t, limit);
  }
  if (near_end_.covers(pair, t)) return near_end_.first(pair, t, limit);
  Functions f = functions(pair);
  int steps = 0;
  double stride = window.length() * first_stride;
  // There is no crossing before t.
  while (t < limit) {
    checkpoint(work_of_step);
    if (++steps > few_steps && near_end_.is_near(t)) return near_end_.first(pair, t, limit);
    const double left = limit - t;
    // The vertex is beyond one of the edge's ends, or on one side of its line. The longest of these certainties counts.
    double step = beyond_ends(window, f, t, left);
    if (step >= left) return std::nullopt;
    const int sign = f.line.value(window.at(t, f.line.pp)).sign();
    const double on_side = sign ? LocalExpansion(f.line, window, t, sign).positive_until(left) : 0;
    if (on_side >= left) return std::nullopt;
    Crossing root;
    root.pair = pair;
    if (on_side > step) {
      step = on_side;
      const Ahead ahead = look_ahead(window, f, limit, sign, t, root);
      if (ahead == Ahead::crossing) return root;
      if (ahead == Ahead::passed) continue;
    }
    const double next = below(t + step);
    if (steps <= many_steps && step > least_step * window.length() && next > t) {
      t = next;
      continue;
    }
    if (const FastFunction* sliding = f.line.level1 ? nullptr : first_order(pair)) {
      f.line = *sliding;
      continue;
    }
    if (near_end_.is_near(t)) return near_end_.first(pair, t, limit);
    if (leave_short_steps(window, f, limit, sign, t, stride, root) == Ahead::crossing) return root;
  }
  return std::nullopt;
}

LocalExpansion::LocalExpansion(const FastFunction& f, FrameWindow& window, double t, int sign)
    : value(f.value(window.at(t, f.pp))), slope(f.slope(window.at(t, f.pp))), second(f.curvature(window.second(f.pp))) {
  value.value *= sign;
  slope.value *= sign;
  second.value *= sign;
}

double LocalExpansion::positive_until(double limit) const {
  return value.lower() > 0 ? internal::positive_until(value.lower(), slope.lower(), second.lower(), limit) : 0;
}

double LocalExpansion::negative_from(double limit, double& falls_until) const {
  const double b = slope.upper(), c = second.upper();
  falls_until = 0;
  if (!(b < 0)) return std::numeric_limits<double>::infinity();
  falls_until = c > 0 ? std::fmin(limit, -b / c * (1 - 0x1p-48)) : limit;
  const double h = internal::negative_from(value.upper(), b, c);
  return h < falls_until ? h : std::numeric_limits<double>::infinity();
}

}  // namespace taut::internal::spacetime
