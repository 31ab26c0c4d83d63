#include "proof/separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace taut::proof {
namespace {

/// How far a rectangle reaches from its centre in direction n, where `along` is its side's direction seen from there.
double reach(const EdgeRange& r, Vector along, Vector n) {
  return r.half_length * std::fabs(dot(n, along)) + r.half_width * std::fabs(dot(n, turned(along)));
}

/// Is the moving range beyond the fixed one, by more than a margin, seen along n in the fixed one's frame? Each of its
/// points moves straight, up to the errors, so that it is nearest at an end of the window; and of a rectangle, a corner
/// is nearest. n is longer than 1 by rounding only.
bool beyond(const Sight& sight, double half, Vector n, const EdgeRange& fixed, const EdgeRange& moving, double margin) {
  const double edge = dot(n, fixed.centre) + reach(fixed, fixed.along, n);
  double gap = INFINITY;
  for (const double h : {-half, half}) {
    const Vector turn{sight.turn.x + h * sight.turn_rate.x, sight.turn.y + h * sight.turn_rate.y};
    const Vector shift{sight.shift.x + h * sight.shift_rate.x, sight.shift.y + h * sight.shift_rate.y};
    gap = std::fmin(gap, dot(n, shift + turn * moving.centre) - reach(moving, turn * moving.along, n) - edge);
  }
  const double far_fixed = size(fixed.centre) + fixed.radius(), far_moving = size(moving.centre) + moving.radius();
  const double error = sight.shift_error + sight.turn_error * far_moving + sight.scale_error * far_fixed;
  const double added = sight.size * (1 + far_moving) + far_fixed;
  return gap > (error + margin) * (1 + 0x1p-40) + 0x1p-44 * added + underflow_slack;
}

/// One of `step::directions` directions, evenly but not equally spaced: by the tangent of half the angle in each
/// quadrant, so that no other functions are needed.
Vector direction_number(std::uint8_t k) {
  constexpr int quarter = step::directions / 4;
  const double t = static_cast<double>(k % quarter) / quarter, square = t * t;
  Vector n{(1 - square) / (1 + square), 2 * t / (1 + square)};
  for (int turn = k / quarter; turn > 0; --turn) n = turned(n);
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
Form orientation_form(const PairGeometry& g, VertexId first, VertexId vertex) {
  return {first, g.next(first), vertex, g.in_p(first)};
}

/// The vertex on the other side of a neighbour's line than the edge's far end.
KeptForms beyond_line(const PairGeometry& g, VertexId line, VertexId far_end, VertexId vertex) {
  const int side = g.rigid_orientation(line, g.next(line), far_end);
  return {{{{orientation_form(g, line, vertex), -side}, {}}}, side == 0 ? 0 : 1};
}

/// Both ends of the edge on one side of a line through the vertex.
KeptForms beside_line(const PairGeometry& g, VertexId line, VertexId edge, int side) {
  return {{{{orientation_form(g, line, edge), side}, {orientation_form(g, line, g.next(edge)), side}}}, 2};
}

/// Is it the form of the instant?
bool is_own(const Form& form, const Instant& until) {
  return form.measure == Measure::orientation && until.concerns(form.a, form.b, form.c);
}

template <class Holds>
bool all_kept(const KeptForms& kept, double from, const Holds& holds) {
  for (int i = 0; i < kept.count; ++i) {
    const KeptForm& f = kept.forms[static_cast<std::size_t>(i)];
    if (!holds(SignedForm{f.form, f.sign, Instant::exactly(from)})) return false;
  }
  return kept.count > 0;
}

}  // namespace

KeptForms kept_forms(const PairGeometry& g, const Incidence& i, Aside why) {
  const Form line = i.line(g);
  switch (why) {
    case Aside::left:
      return {{{{line, 1}, {}}}, 1};
    case Aside::right:
      return {{{{line, -1}, {}}}, 1};
    case Aside::behind_first:
      return {{{{line.along(), -1}, {}}}, 1};
    case Aside::behind_second:
      return {{{{line.back(), -1}, {}}}, 1};
    case Aside::beyond_line_before:
      return beyond_line(g, g.previous(i.edge), g.next(i.edge), i.vertex);
    case Aside::beyond_line_after:
      return beyond_line(g, g.next(i.edge), i.edge, i.vertex);
    case Aside::right_of_arriving:
      return beside_line(g, g.previous(i.vertex), i.edge, -1);
    case Aside::right_of_leaving:
      return beside_line(g, i.vertex, i.edge, -1);
    case Aside::left_of_arriving:
      return beside_line(g, g.previous(i.vertex), i.edge, 1);
    case Aside::left_of_leaving:
      return beside_line(g, i.vertex, i.edge, 1);
    case Aside::behind_when_on_line:  // keeps none
      break;
  }
  return {};
}

bool stays_aside(const PairGeometry& g, Lifetimes& lifetimes, const Incidence& i, Aside why, double from,
                 const Instant& until) {
  if (why == Aside::behind_when_on_line) {
    return !is_own(i.line(g), until) && lifetimes.behind_at_roots(i.line(g), from, until.hi);
  }
  return all_kept(kept_forms(g, i, why), from,
                  [&](const SignedForm& form) { return lifetimes.holds(form, until, is_own(form.form, until)); });
}

bool stays_aside_in_doubles(const PairGeometry& g, Lifetimes& lifetimes, const Incidence& i, Aside why, double from,
                            const Instant& until) {
  if (why == Aside::behind_when_on_line) return false;
  return all_kept(kept_forms(g, i, why), from, [&](const SignedForm& form) {
    return lifetimes.holds_in_doubles(form, until, is_own(form.form, until));
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
  const Vector to_q = window.from_p().shift + window.from_p().turn * q.centre - p.centre;
  const Vector to_p = window.from_q().shift + window.from_q().turn * p.centre - q.centre;
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
  const Sight& s = window.from_p();
  return window.half() * (size(s.shift_rate + s.turn_rate * q.centre) + size(s.turn_rate) * q.radius()) +
         s.shift_error + s.turn_error * (size(q.centre) + q.radius());
}

}  // namespace taut::proof
