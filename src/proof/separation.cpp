#include "proof/separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "certificate/margin_function.hpp"
#include "certificate/precise_root.hpp"

namespace taut::internal::proof {
namespace {

/// How far a rectangle reaches from its centre in direction n, where `along` is its side's direction seen from there.
double reach(const EdgeRange& r, Vector along, Vector n) {
  return r.half_length * std::fabs(dot(n, along)) + r.half_width * std::fabs(dot(n, turned(along)));
}

/// The least that lo + (hi - lo) (1 + h / r) / 2 + bend (h^2 - r^2) / 2 is for |h| <= r: what is at least a chord from
/// lo to hi, and a parabola that is zero at its ends.
double least_above_chord(double lo, double hi, double second, double r) {
  const double slope = (hi - lo) / (2 * r), least = std::fmin(lo, hi);
  if (!(second > 0)) return least;
  // Else the lowest point is not between the ends.
  if (!(std::fabs(slope) < second * r)) return least;
  return (lo + hi) / 2 - second * r * r / 2 - slope * slope / (2 * second);
}

/// Is the moving range beyond the fixed one, by more than a margin, seen along n in the fixed one's frame? Its centre
/// goes along a parabola, up to the errors. Of a rectangle, a corner is nearest: to first order that is farther in
/// between than on the chord between the window's ends, and the second order adds no more than at an end. n is longer
/// than 1 by rounding only.
bool beyond(const WindowModel& model, double half, Vector n, const EdgeRange& fixed, const EdgeRange& moving,
            double margin) {
  const double edge = dot(n, fixed.centre) + reach(fixed, fixed.along, n), most = half * half / 2;
  const auto gap_at = [&](double h) {
    const Vector rotation{model.rotation.x + h * model.rotation_rate.x, model.rotation.y + h * model.rotation_rate.y};
    const Vector shift{model.shift.x + h * model.shift_rate.x, model.shift.y + h * model.shift_rate.y};
    return dot(n, shift + rotation * moving.centre) - reach(moving, rotation * moving.along, n) - edge;
  };
  // Most directions are none in the middle already.
  if (!(gap_at(0) > margin)) return false;
  const double second = dot(n, model.shift_second + model.rotation_second * moving.centre);
  const double at_ends = most * (second - reach(moving, model.rotation_second * moving.along, n));
  const double gap = least_above_chord(gap_at(-half) + at_ends, gap_at(half) + at_ends, second, half);
  const double far_fixed = l1_norm(fixed.centre) + fixed.radius(),
               far_moving = l1_norm(moving.centre) + moving.radius();
  const double error = model.shift_error + model.rotation_error * far_moving + model.scale_error * far_fixed;
  const double added = model.size * (1 + far_moving) + far_fixed;
  return gap > (error + margin) * (1 + 0x1p-40) + 0x1p-44 * added + underflow_slack;
}

/// One of `step::directions` directions, evenly but not equally spaced: by the tangent of half the angle in each
/// quadrant, so that no other functions are needed.
Vector direction_number(std::uint8_t k) {
  constexpr int quarter = step::directions / 4;
  const double t = static_cast<double>(k % quarter) / quarter, square = t * t;
  Vector n{(1 - square) / (1 + square), 2 * t / (1 + square)};
  for (int rotation = k / quarter; rotation > 0; --rotation) n = turned(n);
  return n;
}

/// One of a rectangle's four sides' outward directions.
Vector side_number(const EdgeRange& r, int k) {
  const Vector n = k & 1 ? turned(r.along) : r.along;
  return k & 2 ? -n : n;
}

/// About the number of the direction closest to v.
std::uint8_t number_near(Vector v) {
  constexpr int quarter = step::directions / 4;
  int turns = 0;
  while (!(v.x > 0 && v.y >= 0) && turns < 4) {
    v = -turned(v);
    ++turns;
  }
  const double t = v.y / (v.x + std::sqrt(dot(v, v)));
  const int k = std::isfinite(t) ? std::min(quarter - 1, static_cast<int>(t * quarter + 0.5)) : 0;
  return static_cast<std::uint8_t>((turns % 4) * quarter + k);
}

}  // namespace

namespace {

/// The orientation of an edge's two vertices and a vertex of the other body.
CertificateFunction orientation_function(const PairGeometry& g, VertexId first, VertexId vertex) {
  return {first, g.next(first), vertex, g.in_p(first)};
}

/// The vertex on the other side of a neighbour's line than the edge's far end.
KeptFunctions beyond_line(const PairGeometry& g, VertexId line, VertexId far_end, VertexId vertex) {
  const int side = g.rigid_orientation(line, g.next(line), far_end);
  return {{{{orientation_function(g, line, vertex), -side}, {}}}, side == 0 ? 0 : 1};
}

/// Both ends of the edge on one side of a line through the vertex.
KeptFunctions beside_line(const PairGeometry& g, VertexId line, VertexId edge, int side) {
  return {{{{orientation_function(g, line, edge), side}, {orientation_function(g, line, g.next(edge)), side}}}, 2};
}

/// Is it the form of the instant?
bool is_own(const CertificateFunction& function, const Instant& until) {
  return function.measure == Measure::orientation && until.concerns(function.a, function.b, function.c);
}

template <class Holds>
bool all_kept(const KeptFunctions& kept, double from, const Holds& holds) {
  for (int i = 0; i < kept.count; ++i) {
    const KeptFunction& f = kept.functions[static_cast<std::size_t>(i)];
    if (!holds(SignedFunction{f.function, f.sign, Instant::exactly(from)})) return false;
  }
  return kept.count > 0;
}

}  // namespace

HalfPlane half_plane(Vector a, Vector b, SeparationReason why) {
  const Vector edge = b - a;
  switch (why) {
    case SeparationReason::left:
      return {turned(edge), a};
    case SeparationReason::right:
      return {-turned(edge), a};
    case SeparationReason::behind_first:
      return {-edge, a};
    default:
      return {edge, b};
  }
}

KeptFunctions kept_functions(const PairGeometry& g, const Incidence& i, SeparationReason why) {
  const CertificateFunction line = i.line(g);
  switch (why) {
    case SeparationReason::left:
      return {{{{line, 1}, {}}}, 1};
    case SeparationReason::right:
      return {{{{line, -1}, {}}}, 1};
    case SeparationReason::behind_first:
      return {{{{line.along(), -1}, {}}}, 1};
    case SeparationReason::behind_second:
      return {{{{line.back(), -1}, {}}}, 1};
    case SeparationReason::beyond_line_before:
      return beyond_line(g, g.previous(i.edge), g.next(i.edge), i.vertex);
    case SeparationReason::beyond_line_after:
      return beyond_line(g, g.next(i.edge), i.edge, i.vertex);
    case SeparationReason::right_of_arriving:
      return beside_line(g, g.previous(i.vertex), i.edge, -1);
    case SeparationReason::right_of_leaving:
      return beside_line(g, i.vertex, i.edge, -1);
    case SeparationReason::left_of_arriving:
      return beside_line(g, g.previous(i.vertex), i.edge, 1);
    case SeparationReason::left_of_leaving:
      return beside_line(g, i.vertex, i.edge, 1);
    case SeparationReason::behind_when_on_line:  // keeps none
      break;
  }
  return {};
}

bool stays_separated(const PairGeometry& g, Lifetimes& lifetimes, const Incidence& i, SeparationReason why, double from,
                     const Instant& until) {
  if (why == SeparationReason::behind_when_on_line) {
    return lifetimes.behind_at_roots(i.line(g), from, until);
  }
  return all_kept(kept_functions(g, i, why), from, [&](const SignedFunction& function) {
    return lifetimes.holds(function, until, is_own(function.function, until));
  });
}

SeparationInWindow stays_separated_in_window(const PairGeometry& g, const Incidence& i, SeparationReason why,
                                             const MotionWindow& window) {
  const WindowModel& model = g.in_p(i.edge) ? window.from_p() : window.from_q();
  const Vector a = place(g, i.edge), b = place(g, g.next(i.edge)), v = place(g, i.vertex);
  const auto [n, from] = half_plane(a, b, why);
  const double half = window.half(), most = half * half / 2;
  const Vector at = model.shift + model.rotation * v - from;
  const double middle = dot(n, at), change = half * dot(n, model.shift_rate + model.rotation_rate * v);
  const double second = dot(n, model.shift_second + model.rotation_second * v);
  const double least =
      least_above_chord(middle - change + most * second, middle + change + most * second, second, half);
  // What is added to the vertices' coordinates is less than the room; it turns the edge, and moves all three.
  const double added = model.size * (1 + l1_norm(v)) + l1_norm(a) + l1_norm(b);
  const double error =
      model.shift_error + model.rotation_error * l1_norm(v) + model.scale_error * (l1_norm(a) + l1_norm(b));
  const double rounding = l1_norm(n) * (0x1p-44 * added) + 16 * displacement_room * (1 + added) + underflow_slack;
  const double doubt = l1_norm(n) * (error * (1 + 0x1p-40)) + rounding;
  if (least > doubt) return SeparationInWindow::yes;
  if (middle < -doubt) return SeparationInWindow::no;
  return std::fabs(middle) + std::fabs(change) + most * std::fabs(second) <= rounding ? SeparationInWindow::even
                                                                                      : SeparationInWindow::open;
}

bool stays_separated_in_doubles(const PairGeometry& g, Lifetimes& lifetimes, const Incidence& i, SeparationReason why,
                                double from, const Instant& until) {
  if (why == SeparationReason::behind_when_on_line) return false;
  return all_kept(kept_functions(g, i, why), from, [&](const SignedFunction& function) {
    return lifetimes.holds_in_doubles(function, until, is_own(function.function, until));
  });
}

bool separates(std::uint8_t named, const MotionWindow& window, const EdgeRange& p, const EdgeRange& q, double margin) {
  if (named >= step::direction && named < step::direction + step::directions) {
    const Vector n = direction_number(static_cast<std::uint8_t>(named - step::direction));
    return beyond(window.from_p(), window.half(), n, p, q, margin);
  }
  if (named >= step::along_q && named < step::along_q + 4)
    return beyond(window.from_q(), window.half(), side_number(q, named - step::along_q), q, p, margin);
  if (named >= step::along_p && named < step::along_p + 4)
    return beyond(window.from_p(), window.half(), side_number(p, named - step::along_p), p, q, margin);
  return false;
}

std::optional<std::uint8_t> separating_step(const MotionWindow& window, const EdgeRange& p, const EdgeRange& q,
                                            double margin) {
  const Vector to_q = window.from_p().shift + window.from_p().rotation * q.centre - p.centre;
  const Vector to_p = window.from_q().shift + window.from_q().rotation * p.centre - q.centre;
  const auto facing = [](const EdgeRange& r, Vector to, int axis) {
    return static_cast<std::uint8_t>(axis | (dot(side_number(r, axis), to) < 0 ? 2 : 0));
  };
  // A long rectangle is thin across: that side first.
  const std::array<std::uint8_t, 5> candidates{static_cast<std::uint8_t>(step::along_p + facing(p, to_q, 1)),
                                               static_cast<std::uint8_t>(step::along_q + facing(q, to_p, 1)),
                                               static_cast<std::uint8_t>(step::along_p + facing(p, to_q, 0)),
                                               static_cast<std::uint8_t>(step::along_q + facing(q, to_p, 0)),
                                               static_cast<std::uint8_t>(step::direction + number_near(to_q))};
  for (const std::uint8_t named : candidates) {
    if (separates(named, window, p, q, margin)) return named;
  }
  return std::nullopt;
}

double motion_in(const MotionWindow& window, const EdgeRange& q) {
  const WindowModel& s = window.from_p();
  const double r = window.half();
  const auto effect = [&](Vector shift, Vector rotation) {
    return l1_norm(shift + rotation * q.centre) + l1_norm(rotation) * q.radius();
  };
  return r * (effect(s.shift_rate, s.rotation_rate) + r / 2 * effect(s.shift_second, s.rotation_second)) +
         s.shift_error + s.rotation_error * (l1_norm(q.centre) + q.radius());
}

namespace {

/// Is a function negative at all times of [from, to]? Throws PrecisionExhausted.
template <class Real, class Function>
bool stays_negative(const MotionSegment& segment, const Function& f, double from, double to, Stage stage) {
  const int sign = f.value(Ball<Real>::exact(from)).sign();
  if (sign == 0) throw PrecisionExhausted{};
  if (sign > 0 || !(from < to)) return sign < 0;
  return !first_change<Real>(segment, f, -1, PreciseTime::between(from, from), to, stage);
}

/// ask(zero, stage) as at_some_stage() has it, in doubles first, which nearly always decide. False if none does.
template <class Ask>
bool holds_at_some_stage(const Ask& ask) {
  try {
    return ask(double{}, Stage::doubles);
  } catch (const PrecisionExhausted&) {
    return at_some_stage(ask).value_or(false);
  }
}

}  // namespace

bool KeptMargin::vertices(const RangePair& edges, double from, double to) const {
  const VertexId a = pair_.onto_q(edges).vertex, c = pair_.onto_p(edges).vertex;
  return holds_at_some_stage([&](auto zero, Stage stage) {
    using Real = decltype(zero);
    const VertexMargin<Real> f(segment_, pair_.geometry, a, c, margin_, &models_);
    return stays_negative<Real>(segment_, f, from, to, stage);
  });
}

bool KeptMargin::separated(Lifetimes& lifetimes, const Incidence& incidence, SeparationReason why, double from,
                           double to) const {
  if (why > SeparationReason::behind_second) return false;
  if (why != SeparationReason::right)
    return stays_separated(pair_.geometry, lifetimes, incidence, why, from, Instant::exactly(to));
  return holds_at_some_stage([&](auto zero, Stage stage) {
    using Real = decltype(zero);
    const LineMargin<Real> f(segment_, pair_.geometry, incidence.line(pair_.geometry), margin_, &models_);
    return stays_negative<Real>(segment_, f, from, to, stage);
  });
}

bool closer_at(const PairGeometry& g, const MotionSegment& segment, double margin, const Incidence& pair, bool is_edge,
               const FineInstant& at) {
  return at_some_stage([&](auto zero, Stage) {
           using Real = decltype(zero);
           using B = Ball<Real>;
           const B t = B::exact(at[0]) + B::exact(at[1]) + B::exact(at[2]);
           const auto positive = [&](const auto& f) {
             const int sign = f.value(t).sign();
             if (sign == 0) throw PrecisionExhausted{};
             return sign > 0;
           };
           if (!is_edge) return positive(VertexMargin<Real>(segment, g, pair.vertex, pair.edge, margin));
           const CertificateFunction line = pair.line(g);
           const LineMargin<Real> margin_function(segment, g, line, margin);
           return positive(margin_function) && margin_function.not_behind(t) &&
                  positive(PreciseFunction<Real>(segment, g, line.along())) &&
                  positive(PreciseFunction<Real>(segment, g, line.back()));
         })
      .value_or(false);
}

}  // namespace taut::internal::proof
