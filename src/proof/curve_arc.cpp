#include "proof/curve_arc.hpp"

#include <cmath>

#include "numeric/dyadic.hpp"
#include "numeric/trig.hpp"

namespace taut::internal::proof {
namespace {

CurveNumber number(double x) { return CurveNumber::exact(x); }

/// Of half-axes that are not turned, or by quarters, which exchanges them.
struct Axes {
  double rx = 0, ry = 0;
  bool straight = true;
  CurvePoint turned = CurvePoint::of({1, 0});  ///< where the first one points
};

CurveNumber narrowed(const Ball<Real320>& x) {
  const CurveReal mid(x.mid);
  return CurveNumber(mid, detail::inflate(x.rad + 2 * detail::rounding(mid)));
}

Axes axes_of(const ArcTo& arc) {
  Axes axes{std::fabs(arc.rx), std::fabs(arc.ry)};
  const double degrees = std::fmod(arc.rotation_deg, 180);
  if (axes.rx == axes.ry || degrees == 0) return axes;
  if (std::fabs(degrees) == 90) {
    std::swap(axes.rx, axes.ry);
    return axes;
  }
  const Ball<Real320> half_turn(pi<Real320>(), 4 * unit_roundoff<Real320>());
  const auto both = sin_cos(Ball<Real320>::exact(degrees) * half_turn / Ball<Real320>::exact(180));
  axes.straight = false;
  axes.turned = {narrowed(both.cos), narrowed(both.sin)};
  return axes;
}

/// The members up to 1, of numbers that are known not to be more.
CurveNumber at_most_one(const CurveNumber& x) {
  if (!(x.upper() > 1)) return x;
  return x.lower() > 1 ? number(1) : CurveNumber::between(x.lower(), CurveReal(1));
}

/// Is p on the ellipse around c with half-axes rx, ry along x and y? Without any rounding.
bool is_on(const Point& p, const Point& c, double rx, double ry) {
  const Dyadic a = Dyadic::exact(rx), b = Dyadic::exact(ry);
  const Dyadic x = (Dyadic::exact(p.x) - Dyadic::exact(c.x)) * b, y = (Dyadic::exact(p.y) - Dyadic::exact(c.y)) * a;
  return x * x + y * y == (a * b) * (a * b);
}

bool may_be(const CurveNumber& x, const Dyadic& value) { return (x - ball_of<CurveReal>(value)).sign() == 0; }

/// The direction from the centre to a point of the ellipse, exact at the ends of axes.
CurvePoint direction_to(const Point& p, const Point& c, double rx, double ry) {
  if (p.x == c.x) return CurvePoint::of({0, p.y > c.y ? 1.0 : -1.0});
  if (p.y == c.y) return CurvePoint::of({p.x > c.x ? 1.0 : -1.0, 0});
  return {(number(p.x) - number(c.x)) / number(rx), (number(p.y) - number(c.y)) / number(ry)};
}

/// Where centre and half-axes are doubles, the arc is known exactly. Two ellipses with these half-axes pass through
/// both ends, images of each other about the middle between these: so the centre is the double near to it if that is
/// the centre of one of them, and that of the other one is farther away than the error, or the same.
void decide_exactly(const Point& from, const Point& to, const Axes& axes, EllipseArc& arc) {
  const auto near = [](const CurveNumber& x) { return x.sign() == 0 ? 0 : x.mid.to_double(); };
  const Point c{near(arc.ellipse.centre.x), near(arc.ellipse.centre.y)};
  if (!std::isfinite(c.x) || !std::isfinite(c.y)) return;
  if (!is_on(from, c, axes.rx, axes.ry) || !is_on(to, c, axes.rx, axes.ry)) return;
  const auto exact = [](double x) { return Dyadic::exact(x); };
  const Dyadic other_x = exact(from.x) + exact(to.x) - exact(c.x), other_y = exact(from.y) + exact(to.y) - exact(c.y);
  const CurvePoint& found = arc.ellipse.centre;
  if (!may_be(found.x, exact(c.x)) || !may_be(found.y, exact(c.y))) return;
  const bool one = other_x == exact(c.x) && other_y == exact(c.y);
  if (!one && may_be(found.x, other_x) && may_be(found.y, other_y)) return;
  arc.ellipse = {CurvePoint::of(c), CurvePoint::of({axes.rx, 0}), CurvePoint::of({0, axes.ry}), true};
  arc.first = direction_to(from, c, axes.rx, axes.ry);
  arc.last = direction_to(to, c, axes.rx, axes.ry);
}

}  // namespace

CurvePoint Ellipse::at(const CurvePoint& u) const {
  if (exact && is_zero(u.x) && is_exact(u.y)) return {centre.x, sum_of(centre.y, u.y.mid < 0 ? -b.y : b.y)};
  if (exact && is_zero(u.y) && is_exact(u.x)) return {sum_of(centre.x, u.x.mid < 0 ? -a.x : a.x), centre.y};
  return {centre.x + a.x * u.x + b.x * u.y, centre.y + a.y * u.x + b.y * u.y};
}

CurvePoint middle_of_arc(const CurvePoint& u, const CurvePoint& v, bool counterclockwise) {
  const CurveNumber x = v.x - u.x, y = v.y - u.y, length = sqrt(x * x + y * y);
  const CurvePoint right{y / length, -(x / length)};
  return counterclockwise ? right : CurvePoint{-right.x, -right.y};
}

EllipseArc ellipse_arc(const Point& from, const ArcTo& arc) {
  const Axes axes = axes_of(arc);
  const CurveNumber &c = axes.turned.x, &s = axes.turned.y, rx = number(axes.rx), ry = number(axes.ry);
  const CurveNumber dx = number(arc.to.x) - number(from.x), dy = number(arc.to.y) - number(from.y);
  // The chord, in units of the half-axes and along them.
  const CurveNumber x = (c * dx + s * dy) / rx, y = (c * dy - s * dx) / ry;
  const CurveNumber length = sqrt(x * x + y * y), half = length * 0.5;
  const CurvePoint e{x / length, y / length};
  const CurvePoint n = arc.sweep ? CurvePoint{e.y, -e.x} : CurvePoint{-e.y, e.x};
  const CurveNumber sine = at_most_one(half);
  // Radii grow where the chord is longer than two of them.
  const CurveNumber grown = half.upper() > 1 ? (half.lower() > 1 ? half : hull(number(1), half)) : number(1);
  const CurveNumber root = sqrt(number(1) - sine * sine), cosine = arc.large ? -root : root;
  const CurvePoint in{cosine * n.x, cosine * n.y};
  EllipseArc found;
  Ellipse& ellipse = found.ellipse;
  ellipse.a = {c * rx * grown, s * rx * grown};
  ellipse.b = {-(s * ry * grown), c * ry * grown};
  const CurvePoint middle = middle_of(CurvePoint::of(from), CurvePoint::of(arc.to));
  ellipse.centre = {middle.x - (ellipse.a.x * in.x + ellipse.b.x * in.y),
                    middle.y - (ellipse.a.y * in.x + ellipse.b.y * in.y)};
  found.first = {in.x - sine * e.x, in.y - sine * e.y};
  found.last = {in.x + sine * e.x, in.y + sine * e.y};
  if (axes.straight) decide_exactly(from, arc.to, axes, found);
  return found;
}

namespace {

CurveNumber half_of(const CurveNumber& x) {
  return CurveNumber(ldexp(x.mid, -1), x.rad == 0 ? 0 : detail::inflate(x.rad / 2));
}

CertainSign certain(int sign) { return sign == 0 ? CertainSign() : CertainSign(sign); }

Dyadic dyadic_of(const CurveNumber& x) {
  if (x.mid.is_zero()) return {};
  return Dyadic::of_limbs(x.mid.mantissa(), x.mid.is_negative(),
                          static_cast<int>(x.mid.exponent()) - RealTraits<CurveReal>::bits + 1);
}

bool is_point(const CurvePoint& p) { return is_exact(p.x) && is_exact(p.y); }
bool same(const CurvePoint& a, const CurvePoint& b) {
  return is_point(a) && is_point(b) && a.x.mid == b.x.mid && a.y.mid == b.y.mid;
}
bool same(const CurveNumber& a, const CurveNumber& b) { return is_exact(a) && is_exact(b) && a.mid == b.mid; }

CertainSign product(CertainSign a, CertainSign b) {
  if ((a && *a == 0) || (b && *b == 0)) return 0;
  return a && b ? CertainSign(*a * *b) : CertainSign();
}

}  // namespace

CurveNumber sum_of(const CurveNumber& a, const CurveNumber& b) {
  CurveNumber sum = a + b;
  if (!is_exact(a) || !is_exact(b)) return sum;
  // What rounding to nearest has lost, exactly (Knuth).
  const CurveReal of_b = sum.mid - a.mid;
  const CurveReal lost = (a.mid - (sum.mid - of_b)) + (b.mid - of_b);
  if (lost.is_zero()) sum.rad = 0;
  return sum;
}

CertainSign order_of(const CurveNumber& a, const CurveNumber& b) {
  if (is_exact(a) && is_exact(b)) return a.mid == b.mid ? 0 : a.mid < b.mid ? -1 : 1;
  return certain((a - b).sign());
}

CurvePoint middle_of(const CurvePoint& a, const CurvePoint& b) {
  return {half_of(sum_of(a.x, b.x)), half_of(sum_of(a.y, b.y))};
}

CertainSign side_of(const CurvePoint& a, const CurvePoint& b, const CurvePoint& c) {
  if (same(a, b) || same(b, c) || same(a, c)) return 0;
  // Along an axis, one coordinate decides, and may do so exactly where the other one is not known so well.
  if (same(a.y, b.y)) return product(order_of(b.x, a.x), order_of(c.y, a.y));
  if (same(a.x, b.x)) return product(order_of(b.y, a.y), order_of(a.x, c.x));
  const int sign = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).sign();
  if (sign != 0) return sign;
  if (!is_point(a) || !is_point(b) || !is_point(c)) return std::nullopt;
  const Dyadic ax = dyadic_of(a.x), ay = dyadic_of(a.y);
  return ((dyadic_of(b.x) - ax) * (dyadic_of(c.y) - ay) - (dyadic_of(b.y) - ay) * (dyadic_of(c.x) - ax)).sign();
}

}  // namespace taut::internal::proof
