// The lines of sight from a base through a sequence of gates.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/predicates.hpp"

namespace taut::internal {

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
