#include "geometry/piece.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/trig.hpp"

namespace taut::internal::curve {
namespace {

WideBall narrowed(const Ball<Real320>& x) {
  const Wide mid(x.mid);
  return WideBall(mid, x.rad + 2 * RealTraits<Wide>::magnitude(mid) * unit_roundoff<Wide>());
}

/// (cos, sin) of an angle in degrees, exact for multiples of 90.
WidePoint direction_of(double degrees) {
  const double turns = std::fmod(degrees, 360);
  const double quarters = turns / 90;
  if (quarters == std::floor(quarters)) {
    const int k = (static_cast<int>(quarters) + 4) % 4;
    return WidePoint::of({k == 0 ? 1.0 : k == 2 ? -1.0 : 0.0, k == 1 ? 1.0 : k == 3 ? -1.0 : 0.0});
  }
  const Ball<Real320> half_turn(pi<Real320>(), 4 * unit_roundoff<Real320>());
  const auto s = sin_cos(Ball<Real320>::exact(turns) * half_turn / Ball<Real320>::exact(180));
  return {narrowed(s.cos), narrowed(s.sin)};
}

/// The members that are at least `least`, of a ball with some.
WideBall at_least(const WideBall& x, double least) {
  if (x.lower() >= least) return x;
  return WideBall::between(Wide(least), std::max<Wide>(x.upper(), Wide(least)));
}

/// All bits of the doubles lie so close that products of four differences of two of them are exact in 960 bits.
bool multiply_exactly(std::initializer_list<double> numbers) {
  int most = -2000, least = 2000;
  for (const double x : numbers) {
    if (x == 0) continue;
    int e = 0;
    std::frexp(x, &e);
    most = std::max(most, e);
    least = std::min(least, e);
  }
  return most - least < 150;
}

/// Is the point exactly on the ellipse around `centre` with half-axes rx, ry along x and y?
bool on_ellipse(const Point& p, const Point& centre, double rx, double ry) {
  if (!multiply_exactly({p.x, p.y, centre.x, centre.y, rx, ry})) return false;
  using Exact = Real960;
  const auto number = RealTraits<Exact>::from_double;
  const Exact x = (number(p.x) - number(centre.x)) * number(ry), y = (number(p.y) - number(centre.y)) * number(rx);
  const Exact r = number(rx) * number(ry);
  return x * x + y * y == r * r;
}

/// Zero, if it may be that: what is left of it by rounding is no coordinate that anybody has drawn.
double nearest_double(const WideBall& x) { return x.sign() == 0 ? 0 : RealTraits<Wide>::to_double(x.mid); }

/// The frame in doubles, if it is that exactly. Of the two centres of ellipses through both ends, mirror images, it is
/// the one that was computed, up to its error.
void decide_exactly(const Point& from, const ArcTo& arc, double rx, double ry, CentredArc& found) {
  const Point centre{nearest_double(found.frame.centre.x), nearest_double(found.frame.centre.y)};
  if (!on_ellipse(from, centre, rx, ry) || !on_ellipse(arc.to, centre, rx, ry)) return;
  const auto is_near = [](const WideBall& x, double value) {
    return !(abs(Wide(x.mid - RealTraits<Wide>::from_double(value))) > x.rad);
  };
  if (!is_near(found.frame.centre.x, centre.x) || !is_near(found.frame.centre.y, centre.y)) return;
  found.frame = {WidePoint::of(centre), WidePoint::of({rx, 0}), WidePoint::of({0, ry}), true};
  const auto unit = [&](const Point& p) {
    const WidePoint away = WidePoint::of(p) - WidePoint::of(centre);
    WidePoint u{away.x / WideBall::exact(rx), away.y / WideBall::exact(ry)};
    if (p.x == centre.x) u = WidePoint::of({0, p.y > centre.y ? 1.0 : -1.0});
    if (p.y == centre.y) u = WidePoint::of({p.x > centre.x ? 1.0 : -1.0, 0});
    return u;
  };
  found.unit = {unit(from), unit(arc.to)};
}

}  // namespace

CentredArc centred(const Point& from, const ArcTo& arc) {
  const bool circle = arc.rx == arc.ry;
  const WidePoint turned = circle ? WidePoint::of({1, 0}) : direction_of(arc.rotation_deg);
  const WideBall& c = turned.x;
  const WideBall& s = turned.y;
  const WidePoint p = WidePoint::of(from), q = WidePoint::of(arc.to);
  // In the frame of the axes, half the way from the end to the start.
  const WidePoint half = (p - q) * 0.5;
  const WideBall x = c * half.x + s * half.y, y = c * half.y - s * half.x;
  const WideBall rx = WideBall::exact(arc.rx), ry = WideBall::exact(arc.ry);
  const WideBall ux = x / rx, uy = y / ry;
  const WideBall reach = ux * ux + uy * uy;
  // In units of the half-axes, which are enlarged by `scale`, the centre has this distance from the middle of the
  // chord.
  const WideBall one = WideBall::exact(1);
  const WideBall scale = sqrt(at_least(reach, 1));
  const WideBall offset = sqrt(at_least(one / reach - one, 0)) * (arc.large == arc.sweep ? -1.0 : 1.0);
  const WideBall cx = offset * uy, cy = -(offset * ux);
  const WideBall ax = cx * rx, ay = cy * ry;
  const WidePoint middle = (p + q) * 0.5;
  CentredArc found;
  found.frame.centre = {middle.x + c * ax - s * ay, middle.y + s * ax + c * ay};
  found.frame.a = {c * rx * scale, s * rx * scale};
  found.frame.b = {-(s * ry * scale), c * ry * scale};
  found.unit = {WidePoint{(ux - cx) / scale, (uy - cy) / scale}, WidePoint{(-ux - cx) / scale, (-uy - cy) / scale}};
  if (turned.is_exact() && (c.mid == 0 || s.mid == 0)) {
    const bool swapped = c.mid == 0;
    decide_exactly(from, arc, swapped ? arc.ry : arc.rx, swapped ? arc.rx : arc.ry, found);
  }
  return found;
}

}  // namespace taut::internal::curve
