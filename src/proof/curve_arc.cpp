#include "proof/curve_arc.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "geometry/segment_numbers.hpp"
#include "numeric/dyadic.hpp"
#include "numeric/overloaded.hpp"
#include "numeric/trig.hpp"
#include "taut/error.hpp"

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

namespace {

void require_numbers(const Outline& outline, const std::string& name) {
  const auto require = [&](double x) {
    if (in_range(x)) return;
    throw InputError(name, "an outline has a number that is not 0 or of magnitude between 2^-400 and 2^400",
                     "choose another unit of length");
  };
  require(outline.start.x);
  require(outline.start.y);
  for (const CurveSegment& segment : outline.segments) for_each_number(segment, require);
}

CurvePiece bezier(const std::vector<Point>& points, int segment) {
  const Point &a = points.front(), &b = points.back();
  // All on the line between the ends: the curve is that line.
  const bool straight = a != b && std::all_of(points.begin(), points.end(), [&](const Point& p) {
                          return orientation(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                                 std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
                        });
  CurvePiece piece;
  piece.segment = segment;
  const std::vector<Point> kept = straight ? std::vector<Point>{a, b} : points;
  piece.size = static_cast<int>(kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i) piece.control[i] = CurvePoint::of(kept[i]);
  return piece;
}

/// Where the tangents of the ends meet. At the end of an axis, it is on the same level, exactly.
CurvePoint corner_of(const CurvePiece& piece) {
  const CurvePoint &u = piece.first, &v = piece.last;
  const CurveNumber below = CurveNumber::exact(1) + (u.x * v.x + u.y * v.y);
  CurvePoint corner = piece.ellipse->at({(u.x + v.x) / below, (u.y + v.y) / below});
  if (!piece.ellipse->exact) return corner;
  for (const auto& [unit, p] : {std::pair(&u, &piece.control[0]), std::pair(&v, &piece.control[2])}) {
    if (is_zero(unit->x)) corner.y = p->y;
    if (is_zero(unit->y)) corner.x = p->x;
  }
  return corner;
}

/// The angle between directions at most a right angle apart, about.
double angle_between(const CurvePoint& u, const CurvePoint& v) {
  const Point a = u.rounded(), b = v.rounded();
  double chord = std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
  for (int i = 0; i < 24; ++i) chord /= std::sqrt(2 + std::sqrt(std::max(0.0, 4 - chord * chord)));
  return std::ldexp(chord, 24);
}

/// The directions at which an arc is cut, all on it and in order, less than half a turn apart.
///
/// Of an arc of at most half a turn from u to v, counterclockwise, the directions on it but its ends are those to the
/// left of u of which v is to the left. Of a longer one, they are all that are not on the rest of the circle, and of
/// that u is to the left, or in line: so those to the left of u are on the arc. Either way those which are to the left
/// of u, and have v to their left, are on the arc, and less than half a turn away from both. Clockwise is the mirror
/// image.
class ArcCuts {
 public:
  /// Ends of axes matter where they are known to the last bit, so that a polygon may touch the arc there.
  ArcCuts(const EllipseArc& arc, bool counterclockwise) : counterclockwise_(counterclockwise), cuts_{arc.first} {
    CurvePoint cut = middle_of_arc(arc.first, arc.last, counterclockwise_);
    for (const CurvePoint& e : axis_ends()) {
      if (arc.ellipse.exact && between(arc.first, e, arc.last)) cut = e;
    }
    for (const auto& [u, v] : {std::pair(arc.first, cut), std::pair(cut, arc.last)}) {
      if (arc.ellipse.exact) {
        add(u, v);
      } else {
        cuts_.push_back(middle_of_arc(u, v, counterclockwise_));
        cuts_.push_back(v);
      }
    }
  }
  const std::vector<CurvePoint>& get() const { return cuts_; }

 private:
  static std::array<CurvePoint, 4> axis_ends() {
    return {CurvePoint::of({1, 0}), CurvePoint::of({0, 1}), CurvePoint::of({-1, 0}), CurvePoint::of({0, -1})};
  }
  bool is_left(const CurvePoint& u, const CurvePoint& v) const {
    const int sign = (u.x * v.y - u.y * v.x).sign();
    return counterclockwise_ ? sign > 0 : sign < 0;
  }
  bool between(const CurvePoint& u, const CurvePoint& e, const CurvePoint& v) const {
    return is_left(u, e) && is_left(e, v);
  }
  /// Of less than half a turn.
  void add(const CurvePoint& u, const CurvePoint& v) {
    for (const CurvePoint& e : axis_ends()) {
      if (!between(u, e, v)) continue;
      add(u, e);
      return add(e, v);
    }
    cuts_.push_back(v);
  }

  bool counterclockwise_;
  std::vector<CurvePoint> cuts_;
};

void add_arc(const Point& from, const ArcTo& arc, int segment, std::vector<CurvePiece>& pieces) {
  const EllipseArc found = ellipse_arc(from, arc);
  const auto ellipse = std::make_shared<const Ellipse>(found.ellipse);
  const std::vector<CurvePoint> cuts = ArcCuts(found, arc.sweep).get();
  const std::size_t begin = pieces.size();
  double angle = 0;
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    CurvePiece piece;
    piece.segment = segment;
    piece.size = 3;
    piece.ellipse = ellipse;
    piece.first = cuts[k];
    piece.last = cuts[k + 1];
    piece.control[0] = k == 0 ? CurvePoint::of(from) : pieces.back().end();
    piece.control[2] = k + 2 == cuts.size() ? CurvePoint::of(arc.to) : ellipse->at(piece.last);
    piece.control[1] = corner_of(piece);
    piece.from = angle;
    angle += angle_between(piece.first, piece.last);
    piece.to = angle;
    pieces.push_back(std::move(piece));
  }
  for (std::size_t k = begin; k < pieces.size(); ++k) {
    pieces[k].from /= angle;
    pieces[k].to /= angle;
  }
}

void add_segment(const Point& from, const CurveSegment& segment, int index, std::vector<CurvePiece>& pieces) {
  const auto add = [&](const std::vector<Point>& points) {
    const bool moves = std::any_of(points.begin(), points.end(), [&](const Point& p) { return p != from; });
    if (moves) pieces.push_back(bezier(points, index));
  };
  std::visit(Overloaded{[&](const LineTo& line) {
                          add({from, line.to});
                        },
                        [&](const ArcTo& arc) {
                          const bool bends = from != arc.to && arc.rx != 0 && arc.ry != 0;
                          bends ? add_arc(from, arc, index, pieces) : add({from, arc.to});
                        },
                        [&](const QuadraticTo& q) {
                          add({from, q.control, q.to});
                        },
                        [&](const CubicTo& c) {
                          add({from, c.first, c.second, c.to});
                        }},
             segment);
}

}  // namespace

std::vector<CurvePiece> pieces_of(const Outline& outline, const std::string& name) {
  require_numbers(outline, name);
  std::vector<CurvePiece> pieces;
  Point from = outline.start;
  int index = 0;
  for (const CurveSegment& segment : outline.segments) {
    add_segment(from, segment, index++, pieces);
    from = end_of(segment);
  }
  add_segment(from, LineTo{outline.start}, index, pieces);
  return pieces;
}

std::array<CurvePiece, 2> halves_of(const CurvePiece& piece) {
  std::array<CurvePiece, 2> half{piece, piece};
  half[0].to = half[1].from = piece.from + (piece.to - piece.from) / 2;
  if (piece.ellipse) {
    // Along the sum of the ends' directions: across the chord, errors would grow with each halving.
    const CurveNumber x = piece.first.x + piece.last.x, y = piece.first.y + piece.last.y, length = sqrt(x * x + y * y);
    half[0].last = half[1].first = {x / length, y / length};
    half[0].control[2] = half[1].control[0] = piece.ellipse->at(half[0].last);
    for (CurvePiece& h : half) h.control[1] = corner_of(h);
    return half;
  }
  std::array<CurvePoint, 4> row = piece.control;
  for (int n = piece.size; n > 0; --n) {
    half[0].control[static_cast<std::size_t>(piece.size - n)] = row[0];
    half[1].control[static_cast<std::size_t>(n - 1)] = row[static_cast<std::size_t>(n - 1)];
    for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(n); ++i) row[i] = middle_of(row[i], row[i + 1]);
  }
  return half;
}

}  // namespace taut::internal::proof
