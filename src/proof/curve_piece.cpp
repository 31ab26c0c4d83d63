#include "proof/curve_piece.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "geometry/segment_numbers.hpp"
#include "numeric/overloaded.hpp"
#include "taut/error.hpp"

namespace taut::internal::proof {
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
