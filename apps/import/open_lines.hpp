// Lines that enclose nothing, and what they would enclose if they were closed.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "import/line_graph.hpp"

namespace taut::drawing {

/// A line that stays open: from one end, or place where it meets others, to the next.
struct OpenLine {
  std::vector<Point> points;
  std::size_t source = 0;                     ///< index of the chain that it begins with
  bool free_start = false, free_end = false;  ///< does the end meet no other line?
  Point nearest_start, nearest_end;           ///< of free ends: the nearest other free end
  double gap_start = -1, gap_end = -1;        ///< how far away that is; below 0 if there is none
  double next_start = 0, next_end = 0;        ///< how far away the one after it is

  double length() const;
  bool is_straight() const;
};

/// A ring of open lines and of the straight gaps between their free ends.
struct Closure {
  std::vector<std::size_t> lines;  ///< indices, in order
  std::vector<std::pair<Point, Point>> gaps;
  Polygon ring;
  double gap_length = 0, line_length = 0;
  /// Of any gap: how many times farther away than its two ends are from each other the next free end is, at least.
  double clearness = 0;
  std::optional<std::size_t> encloses = {};  ///< a chain of something closed that lies within, if that is why it counts
  bool partly = false;                       ///< a part of that lies within
};

/// The lines that those edges make which are in `removed`; `all` of the graph's edges say where lines meet others.
std::vector<OpenLine> open_lines(const LineGraph& graph, const std::vector<bool>& all,
                                 const std::vector<bool>& removed);

/// Fills in the nearest free ends.
void find_nearest_ends(std::vector<OpenLine>& lines);

/// Pairs free ends, nearest first, and finds the rings that come of it; of several lines only, if it is said. The
/// nearest ends are known.
std::vector<Closure> find_closures(const std::vector<OpenLine>& lines, bool of_several = false);

/// Bent lines that nearly close by themselves, where other open lines cross the gap: these do not go on from its ends,
/// however near they are. The next free end, for `clearness`, is not of one of them.
std::vector<Closure> closures_across_lines(const std::vector<OpenLine>& lines);

/// Lines that meet each other, as if straight lines between two of their ends closed them. Two groups of them that have
/// a free end each, the nearest ones, are one: other lines cross what they are parts of. Only of these `clearness` is
/// known. The nearest ends are known.
std::vector<Closure> closures_of_groups(const std::vector<OpenLine>& lines);

/// Rounded.
double distance_to_segment(const Point& p, const Point& a, const Point& b);
/// Does the ray from p to the right cross the segment? In doubles.
inline bool is_left_of(const Point& p, const Point& a, const Point& b) {
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x);
}
/// Is p inside of a ring that may cross itself, by the even-odd rule? In doubles: near the ring it may err.
bool roughly_inside(const Polygon& ring, const Point& p);
/// Is p in the part, and in none of its holes?
bool roughly_inside(const Part& part, const Point& p);
/// A point inside of the part, as far as doubles show: the middle of the widest stretch of a horizontal line.
Point inner_point(const Part& part);

}  // namespace taut::drawing
