// Two polygons at rest, triangulated; the gates that every curve of one class must pass, in order; and the lines of
// sight from a base through them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/predicates.hpp"
#include "scene/body_pair.hpp"
#include "tiling/free_triangulation.hpp"

namespace taut::internal {

// Two polygons at rest, triangulated: where separators are searched.

/// Two disjoint polygons at rest. Coordinates are scaled as in BodyPair; the free space is triangulated inside a box,
/// whose corners are vertices size() .. size()+3.
struct Arena {
  BodyPair bodies;
  PairGeometry geometry;
  std::vector<Point> points;  ///< of P, of Q, and of the box
  FreeTriangulation triangulation;
  /// RCH(P) and RCH(Q): the vertices in order, the polygon on the left; each first vertex once.
  std::array<std::vector<VertexId>, 2> hulls;

  std::uint32_t size() const { return geometry.size(); }
  bool in_box(VertexId v) const { return v.value >= size(); }
  /// 0: P, 1: Q, 2: the box.
  int owner(VertexId v) const { return in_box(v) ? 2 : (geometry.in_p(v) ? 0 : 1); }
  const Point& at(VertexId v) const { return points[v.value]; }

  VertexId origin(std::uint32_t h) const { return triangulation.origin[h]; }
  VertexId target(std::uint32_t h) const { return triangulation.target(h); }
  std::uint32_t twin(std::uint32_t h) const { return triangulation.twin[h]; }
  /// The third vertex of the triangle of h.
  VertexId apex(std::uint32_t h) const { return origin(FreeTriangulation::previous(h)); }
};

/// Empty if the polygons overlap, or one of them crosses itself.
std::optional<Arena> make_arena(const Polygon& a, const Polygon& b);

/// A gate is a half-edge of the triangle that is entered through it: its origin is the left end, its target the right
/// end. Two gates in a row have one end in common; the apex of the first one's triangle is the other end of the second.
using Gate = std::uint32_t;

/// Does the step from gate `a` to the next gate `b` bring a new left end (or a new right one)?
inline bool new_left_end(const Arena& arena, Gate a, Gate b) { return arena.twin(b) == FreeTriangulation::next(a); }
/// The edge of the triangle behind gate `a` that is passed by if the step from `a` brings a new left (right) end; as a
/// half-edge of that triangle.
inline std::uint32_t side_edge(Gate a, bool new_left) {
  return new_left ? FreeTriangulation::previous(a) : FreeTriangulation::next(a);
}
/// The same gates from the other end.
std::vector<Gate> reversed(const Arena& arena, const std::vector<Gate>& gates);

/// The gates of a loop around polygon `owner` (0 or 1), that polygon on the left: all edges that leave it, counter-
/// clockwise. Empty if part of the other polygon or of the box is shut in a pocket of this one.
std::vector<Gate> loop_gates(const Arena& arena, int owner);

/// A way for curves from infinity to infinity that separate the polygons, P on the left. All of them pass `core`; what
/// lies before and behind winds around the polygons in either direction, and the box can be left (entered) on the way.
struct OpenSleeve {
  std::vector<Gate> core;
  /// Where the box can be left behind the core, turning left or right. At a gate with `exit`, the side edge of its
  /// triangle joins two corners of the box.
  struct Tail {
    std::vector<Gate> gates;
    std::vector<bool> exit;
  };
  std::vector<Tail> tails;
  /// Ways from an edge of the box to the core, the box's edge included.
  std::vector<std::vector<Gate>> heads;
};
OpenSleeve open_sleeve(const Arena& arena);

// The lines of sight from a base through a sequence of gates.

/// A directed line through two points.
struct DirectedLine {
  Point from, to;
  /// +1 if p is on the left.
  int side(const Point& p) const { return orientation(from, to, p); }
};

/// What bounds the lines that cross a base and then a sequence of gates, each from its right to its left end's side.
///
/// The left ends of the gates pull a string taut from the base's left end, which turns left, and likewise on the
/// right; a line of sight passes between the two. The extreme ones touch both: `clockwise` first the left string, then
/// the right one, `counterclockwise` first the right one. (Imai and Iri's method for polygonal lines in a corridor.)
class Hourglass {
 public:
  enum class Blocked : unsigned char { no, by_left, by_right };

  /// The points on either side between the base and the first gate, which the base sees, base and gate included.
  Hourglass(std::vector<Point> left, std::vector<Point> right);

  /// The next gate has a new left (right) end p. If no line of sight is left, says so and changes nothing: the string
  /// that turned furthest before is then `clockwise` if the left blocks, `counterclockwise` if the right does.
  Blocked add_left(const Point& p);
  Blocked add_right(const Point& p);

  DirectedLine clockwise() const { return {left_point(clockwise_left_), right_point(clockwise_right_)}; }
  DirectedLine counterclockwise() const { return {right_point(counter_right_), left_point(counter_left_)}; }
  /// Everything that was added from where clockwise() touches the right side on; likewise on the left.
  std::vector<Point> right_from_clockwise() const { return tail(right_, right_string_[clockwise_right_]); }
  std::vector<Point> left_from_counterclockwise() const { return tail(left_, left_string_[counter_left_]); }

  /// Would there be a line of sight through a last gate behind these points? If so, they are added.
  bool finish(const std::vector<Point>& left, const std::vector<Point>& right);
  /// A line of sight between the extreme ones.
  DirectedLine middle() const;

 private:
  const Point& left_point(std::size_t i) const { return left_[left_string_[i]]; }
  const Point& right_point(std::size_t i) const { return right_[right_string_[i]]; }
  static std::vector<Point> tail(const std::vector<Point>& all, std::size_t from) {
    return {all.begin() + static_cast<std::ptrdiff_t>(from), all.end()};
  }
  void push_left(const Point& p, std::size_t keep);
  void push_right(const Point& p, std::size_t keep);
  void find_extremes();
  bool open() const;

  std::vector<Point> left_, right_;                      ///< all points added
  std::vector<std::size_t> left_string_, right_string_;  ///< those on the taut strings
  std::size_t clockwise_left_ = 0, clockwise_right_ = 0, counter_left_ = 0, counter_right_ = 0;
};

}  // namespace taut::internal
