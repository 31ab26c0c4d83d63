#include "geometry/piece.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "numeric/exact_sum.hpp"
#include "numeric/overloaded.hpp"
#include "numeric/trig.hpp"

namespace taut::internal::curve {
namespace {

/// The angle between two directions at most a quarter apart: 2^24 times the chord of its 2^-24th part. The C library's
/// arc tangent has other bits elsewhere.
double angle_between(const WidePoint& u, const WidePoint& v) {
  const Point a = u.rounded(), b = v.rounded();
  double chord = std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
  for (int i = 0; i < 24; ++i) chord /= std::sqrt(2 + std::sqrt(std::max(0.0, 4 - chord * chord)));
  return std::ldexp(chord, 24);
}

/// Of eight: the ends of the axes have even numbers, the quarters between them odd ones. What is as good as an end
/// counts as one, so that no piece is too short for its gates; its neighbour is longer than a quarter by as little.
int octant_of(const WidePoint& u) {
  const auto side = [](const WideBall& x) { return x.magnitude() < 0x1p-20 ? 0 : x.sign(); };
  const int x = side(u.x), y = side(u.y);
  constexpr int octants[3][3] = {{5, 4, 3}, {6, -1, 2}, {7, 0, 1}};
  return octants[x + 1][y + 1];
}

WidePoint axis_end(int octant) {
  constexpr double x[4] = {1, 0, -1, 0};
  const std::size_t k = at(octant / 2 % 4);
  return WidePoint::of({x[k], x[(k + 3) % 4]});
}

/// The directions between which the pieces run, both ends included.
std::vector<WidePoint> cuts_of(const CentredArc& arc, bool large, bool sweep) {
  const int from = octant_of(arc.unit[0]), to = octant_of(arc.unit[1]), step = sweep ? 1 : 7;
  std::vector<WidePoint> cuts{arc.unit[0]};
  int k = from;
  // Where both ends are in one quarter, the arc is either within it or nearly all of the ellipse.
  if (from != to || large) {
    do {
      k = (k + step) % 8;
      if (k % 2 == 0 && k != to) cuts.push_back(axis_end(k));
    } while (k != to);
  }
  cuts.push_back(arc.unit[1]);
  return cuts;
}

/// Of an exact frame: the point at the end of an axis, if it is one of doubles.
WidePoint point_of(const ArcFrame& frame, const WidePoint& u) {
  if (frame.exact && u.is_exact()) {
    const Point c = frame.centre.rounded(), e = u.rounded();
    const TwoDoubles x = two_sum(c.x, e.x * frame.a.rounded().x), y = two_sum(c.y, e.y * frame.b.rounded().y);
    if (x.lo == 0 && y.lo == 0) return WidePoint::of({x.hi, y.hi});
  }
  return frame.at(u);
}

Level level_of(const ArcFrame& frame, const WidePoint& u, const WidePoint& p) {
  if (!frame.exact || !u.is_exact() || !p.is_exact()) return Level::unknown;
  return u.y.mid == 0 ? Level::vertical : Level::horizontal;
}

/// What is exactly level at an end stays so in the control point next to it.
void keep_level(Piece& piece) {
  for (const int end : {0, 1}) {
    WidePoint& inner = piece.control[at(end == 0 ? 1 : piece.size - 2)];
    const WidePoint& outer = end == 0 ? piece.first() : piece.last();
    if (piece.still[at(end)]) inner = outer;
    if (piece.level[at(end)] == Level::horizontal) inner.y = outer.y;
    if (piece.level[at(end)] == Level::vertical) inner.x = outer.x;
  }
}

/// Where the tangents of an arc's ends meet.
WidePoint corner_of(const ArcFrame& frame, const WidePoint& u, const WidePoint& v) {
  const WideBall below = WideBall::exact(1) + dot(u, v);
  const WidePoint sum = u + v;
  return frame.at({sum.x / below, sum.y / below});
}

std::vector<Piece> pieces_of_arc(const Point& from, const ArcTo& arc, int index) {
  const CentredArc found = centred(from, arc);
  const auto frame = std::make_shared<const ArcFrame>(found.frame);
  const std::vector<WidePoint> cuts = cuts_of(found, arc.large, arc.sweep);
  std::vector<Piece> pieces;
  std::vector<double> angles{0};
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    Piece piece;
    piece.segment = index;
    piece.size = 3;
    piece.frame = frame;
    piece.unit = {cuts[k], cuts[k + 1]};
    const bool begins = k == 0, ends = k + 2 == cuts.size();
    piece.control[0] = begins ? WidePoint::of(from) : pieces.back().last();
    piece.control[2] = ends ? WidePoint::of(arc.to) : point_of(*frame, cuts[k + 1]);
    piece.control[1] = corner_of(*frame, cuts[k], cuts[k + 1]);
    piece.level = {level_of(*frame, cuts[k], piece.first()), level_of(*frame, cuts[k + 1], piece.last())};
    keep_level(piece);
    angles.push_back(angles.back() + angle_between(cuts[k], cuts[k + 1]));
    pieces.push_back(std::move(piece));
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    pieces[k].from = angles[k] / angles.back();
    pieces[k].to = k + 1 == pieces.size() ? 1 : angles[k + 1] / angles.back();
  }
  return pieces;
}

/// Is p exactly on the segment?
bool on_segment(const Point& p, const Point& a, const Point& b) {
  return orientation(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

Level level_between(const Point& a, const Point& b) {
  if (a == b) return Level::unknown;
  return a.y == b.y ? Level::horizontal : a.x == b.x ? Level::vertical : Level::unknown;
}

Piece bezier(const std::vector<Point>& points, int index) {
  Piece piece;
  piece.segment = index;
  const Point &a = points.front(), &b = points.back();
  const bool straight =
      a != b && std::all_of(points.begin(), points.end(), [&](const Point& p) { return on_segment(p, a, b); });
  if (straight) {
    piece.control[0] = WidePoint::of(a);
    piece.control[1] = WidePoint::of(b);
    return piece;
  }
  piece.size = static_cast<int>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) piece.control[i] = WidePoint::of(points[i]);
  const Point &c = points[1], &d = points[points.size() - 2];
  piece.still = {piece.size == 4 && a == c, piece.size == 4 && b == d};
  piece.level = {level_between(a, c), level_between(d, b)};
  return piece;
}

WidePoint middle(const WidePoint& a, const WidePoint& b) { return (a + b) * 0.5; }

}  // namespace

WidePoint ArcFrame::at(const WidePoint& u) const {
  return {centre.x + a.x * u.x + b.x * u.y, centre.y + a.y * u.x + b.y * u.y};
}

std::vector<Piece> pieces_of(const Point& from, const CurveSegment& segment, int index) {
  using Pieces = std::vector<Piece>;
  const auto through = [&](const std::vector<Point>& points) -> Pieces {
    if (std::all_of(points.begin(), points.end(), [&](const Point& p) { return p == from; })) return {};
    return {bezier(points, index)};
  };
  return std::visit(Overloaded{[&](const LineTo& line) {
                                 return through({from, line.to});
                               },
                               [&](ArcTo arc) {
                                 arc.rx = std::fabs(arc.rx);
                                 arc.ry = std::fabs(arc.ry);
                                 const bool bends = from != arc.to && arc.rx > 0 && arc.ry > 0;
                                 return bends ? pieces_of_arc(from, arc, index) : through({from, arc.to});
                               },
                               [&](const QuadraticTo& q) {
                                 return through({from, q.control, q.to});
                               },
                               [&](const CubicTo& c) {
                                 return through({from, c.first, c.second, c.to});
                               }},
                    segment);
}

std::array<Piece, 2> halves(const Piece& piece) {
  std::array<Piece, 2> half{piece, piece};
  half[0].to = half[1].from = piece.from + (piece.to - piece.from) / 2;
  half[0].level[1] = half[1].level[0] = Level::unknown;
  half[0].still[1] = half[1].still[0] = false;
  if (piece.frame) {
    const WidePoint sum = piece.unit[0] + piece.unit[1];
    const WideBall length = sqrt(dot(sum, sum));
    const WidePoint unit{sum.x / length, sum.y / length};
    half[0].unit[1] = half[1].unit[0] = unit;
    half[0].control[2] = half[1].control[0] = piece.frame->at(unit);
    for (Piece& h : half) h.control[1] = corner_of(*piece.frame, h.unit[0], h.unit[1]);
  } else {
    // De Casteljau: the first half's control points are found as the others shrink to the second half's.
    for (int n = piece.size; n > 1; --n) {
      for (int i = 0; i + 1 < n; ++i)
        half[1].control[at(i)] = middle(half[1].control[at(i)], half[1].control[at(i + 1)]);
      half[0].control[at(piece.size - n + 1)] = half[1].control[0];
    }
  }
  for (Piece& h : half) keep_level(h);
  return half;
}

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
