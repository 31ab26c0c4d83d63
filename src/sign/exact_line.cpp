#include "sign/exact_line.hpp"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

/// Adds a b exactly; false if that is so small that its rounding may be lost.
template <std::size_t Terms>
bool add_product(ExactSum<Terms>& sum, double a, double b) {
  if (a == 0 || b == 0) return true;
  const double size = std::fabs(a * b);
  if (!(size > 0x1p-900 && size < 0x1p900)) return false;
  sum.add_product(a, b);
  return true;
}

/// Adds sign * a * b.
template <std::size_t Terms, std::size_t A, std::size_t B>
bool add_product(ExactSum<Terms>& sum, const ExactSum<A>& a, const ExactSum<B>& b, double sign) {
  bool exact = true;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) exact = add_product(sum, a.term(i), sign * b.term(k)) && exact;
  }
  return exact;
}

/// A coordinate of a vertex, with the sign given.
template <std::size_t Terms>
void add_coordinate(ExactSum<Terms>& sum, double x, double dx, double sign) {
  sum.add(sign * dx);
  sum.add(sign * x);
}

}  // namespace

ExactLine::ExactLine(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, Measure measure) {
  const DisplacedPoint &a = g.point(triple.a), &b = g.point(triple.b), &c = g.point(triple.c);
  ExactSum<4> ex, ey;
  add_coordinate(ex, b.x, b.dx, 1);
  add_coordinate(ex, a.x, a.dx, -1);
  add_coordinate(ey, b.y, b.dy, 1);
  add_coordinate(ey, a.y, a.dy, -1);
  // From a to c: the leg shifts P, so that the motion is zero at time 0.
  ExactSum<6> rx, ry;
  add_coordinate(rx, c.x, c.dx, 1);
  add_coordinate(rx, a.x, a.dx, -1);
  add_coordinate(ry, c.y, c.dy, 1);
  add_coordinate(ry, a.y, a.dy, -1);
  const ExactVector& shift = leg.offset(true);
  const double side = triple.pp ? -1 : 1;
  add_coordinate(rx, shift.x, shift.x_low, side);
  add_coordinate(ry, shift.y, shift.y_low, side);
  // Q moves against P; where a and b are Q's, c moves the other way.
  ExactSum<2> vx, vy;
  vx.add(coefficient(leg.q.x, 1));
  vx.add(-coefficient(leg.p.x, 1));
  vy.add(coefficient(leg.q.y, 1));
  vy.add(-coefficient(leg.p.y, 1));
  if (measure == Measure::orientation) {
    exact_ = add_product(start_, ex, ry, 1) && add_product(start_, ey, rx, -1) && add_product(slope_, ex, vy, -side) &&
             add_product(slope_, ey, vx, side);
  } else {
    exact_ = add_product(start_, ex, rx, 1) && add_product(start_, ey, ry, 1) && add_product(slope_, ex, vx, -side) &&
             add_product(slope_, ey, vy, -side);
  }
}

/// Adds slope * time: exactly as far as it matters at this precision. False if that is not possible.
template <std::size_t Terms>
bool ExactLine::add_change(NearlyExact<Terms>& value, double time) const {
  for (std::size_t i = slope_.size(); i-- > 0;) {
    const double product = slope_.term(i) * time;
    if (std::fabs(product) < value.negligible) {
      value.error += std::fabs(product);
    } else if (!add_product(value.sum, slope_.term(i), time)) {
      return false;
    }
  }
  return true;
}

template <std::size_t Terms>
void ExactLine::begin(NearlyExact<Terms>& value, double sign) const {
  value.sum.assign(start_, sign);
  value.negligible = std::max(0x1p-300 * std::fabs(start_.approximate()), 0x1p-1000);
}

int ExactLine::sign_over(const PreciseTime& t) const {
  NearlyExact<start_terms + 2 * slope_terms * FineNumber::capacity> value;
  begin(value, 1);
  const double slope = std::fabs(slope_.approximate()), width = t.fine_width();
  const FineNumber& first = t.fine_lo();
  for (std::size_t k = first.size();; --k) {
    // Parts from k on are in; what the others add to the instant is less than twice the largest of them.
    const double open = k > 0 ? 2 * std::fabs(first.part(k - 1)) : 0;
    if (std::fabs(value.sum.approximate()) > (value.error + slope * (open + width)) * (1 + 0x1p-40)) {
      return value.sum.sign();
    }
    if (k == 0 || !add_change(value, first.part(k - 1))) return 0;
  }
}

std::optional<PreciseTime> ExactLine::root(int stage, double enough) const {
  constexpr std::size_t digits = 5;
  NearlyExact<start_terms + 2 * slope_terms * digits> rest;  // -start - slope * quotient
  begin(rest, -1);
  const double slope = slope_.approximate();
  ExactSum<digits + 1> quotient;
  double digit = rest.sum.approximate() / slope, error = INFINITY;
  for (std::size_t k = 0; k < digits && error > enough; ++k) {
    if (digit != 0) {
      if (!(std::fabs(digit) > 0x1p-900 && std::fabs(digit) < 0x1p900)) return std::nullopt;
      quotient.add(digit);
      if (!add_change(rest, -digit)) return std::nullopt;
    }
    // The root is at the quotient plus rest / slope.
    digit = rest.sum.approximate() / slope;
    error = (std::fabs(digit) + rest.error / std::fabs(slope)) * (1 + 0x1p-40);
  }
  if (!(error <= std::max(enough, 0x1p-200 * (1 + std::fabs(quotient.approximate()))))) return std::nullopt;
  ExactSum<digits + 1> lo = quotient, hi = quotient;
  lo.add(-error);
  hi.add(error);
  return PreciseTime(FineNumber::of(lo), FineNumber::of(hi), stage);
}

}  // namespace taut
