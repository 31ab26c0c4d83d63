#include "tiling/hourglass.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal {
Hourglass::Hourglass(std::vector<Point> left, std::vector<Point> right) {
  for (const Point& p : left) push_left(p, 0);
  for (const Point& p : right) push_right(p, 0);
  find_extremes();
}

/// String points up to `keep` stay.
void Hourglass::push_left(const Point& p, std::size_t keep) {
  if (!left_.empty() && left_.back() == p) return;
  while (left_string_.size() > keep + 1 && left_string_.size() > 1 &&
         orientation(left_point(left_string_.size() - 2), left_point(left_string_.size() - 1), p) < 0) {
    left_string_.pop_back();
  }
  left_string_.push_back(left_.size());
  left_.push_back(p);
}

void Hourglass::push_right(const Point& p, std::size_t keep) {
  if (!right_.empty() && right_.back() == p) return;
  while (right_string_.size() > keep + 1 && right_string_.size() > 1 &&
         orientation(right_point(right_string_.size() - 2), right_point(right_string_.size() - 1), p) > 0) {
    right_string_.pop_back();
  }
  right_string_.push_back(right_.size());
  right_.push_back(p);
}

/// Moves the ends of either line along the strings, in turn, as long as a neighbour is on the wrong side.
void Hourglass::find_extremes() {
  const std::size_t nl = left_string_.size(), nr = right_string_.size();
  std::size_t a = 0, b = 0, c = 0, d = 0;
  // Each move turns the line one way only, so a line comes back only where points coincide.
  std::size_t moves = 4 * (nl + nr) + 16;
  const auto on_wrong_side = [&](const Point& from, const Point& to, const Point& p, int wrong) {
    return orientation(from, to, p) == wrong && moves > 0;
  };
  for (bool moved = true; moved;) {
    moved = false;
    const auto right_wrong = [&](std::size_t i) {
      return on_wrong_side(left_point(a), right_point(b), right_point(i), 1);
    };
    while (b + 1 < nr && right_wrong(b + 1)) ++b, --moves, moved = true;
    while (b > 0 && right_wrong(b - 1)) --b, --moves, moved = true;
    const auto left_wrong = [&](std::size_t i) {
      return on_wrong_side(left_point(a), right_point(b), left_point(i), -1);
    };
    while (a + 1 < nl && left_wrong(a + 1)) ++a, --moves, moved = true;
    while (a > 0 && left_wrong(a - 1)) --a, --moves, moved = true;
  }
  moves = 4 * (nl + nr) + 16;
  for (bool moved = true; moved;) {
    moved = false;
    const auto left_wrong = [&](std::size_t i) {
      return on_wrong_side(right_point(c), left_point(d), left_point(i), -1);
    };
    while (d + 1 < nl && left_wrong(d + 1)) ++d, --moves, moved = true;
    while (d > 0 && left_wrong(d - 1)) --d, --moves, moved = true;
    const auto right_wrong = [&](std::size_t i) {
      return on_wrong_side(right_point(c), left_point(d), right_point(i), 1);
    };
    while (c + 1 < nr && right_wrong(c + 1)) ++c, --moves, moved = true;
    while (c > 0 && right_wrong(c - 1)) --c, --moves, moved = true;
  }
  clockwise_left_ = a;
  clockwise_right_ = b;
  counter_right_ = c;
  counter_left_ = d;
}

Hourglass::Blocked Hourglass::add_left(const Point& p) {
  if (clockwise().side(p) < 0) return Blocked::by_left;
  const bool tighter = counterclockwise().side(p) < 0;
  push_left(p, tighter ? clockwise_left_ : std::max(clockwise_left_, counter_left_));
  if (!tighter) return Blocked::no;
  counter_left_ = left_string_.size() - 1;
  while (counter_right_ + 1 < right_string_.size() && counterclockwise().side(right_point(counter_right_ + 1)) > 0) {
    ++counter_right_;
  }
  return Blocked::no;
}

Hourglass::Blocked Hourglass::add_right(const Point& p) {
  if (counterclockwise().side(p) > 0) return Blocked::by_right;
  const bool tighter = clockwise().side(p) > 0;
  push_right(p, tighter ? counter_right_ : std::max(counter_right_, clockwise_right_));
  if (!tighter) return Blocked::no;
  clockwise_right_ = right_string_.size() - 1;
  while (clockwise_left_ + 1 < left_string_.size() && clockwise().side(left_point(clockwise_left_ + 1)) < 0) {
    ++clockwise_left_;
  }
  return Blocked::no;
}

bool Hourglass::open() const {
  const DirectedLine line = clockwise();
  for (std::size_t i = 0; i < left_string_.size(); ++i) {
    if (line.side(left_point(i)) < 0) return false;
  }
  for (std::size_t i = 0; i < right_string_.size(); ++i) {
    if (line.side(right_point(i)) > 0) return false;
  }
  return true;
}

bool Hourglass::finish(const std::vector<Point>& left, const std::vector<Point>& right) {
  Hourglass next = *this;
  for (const Point& p : left) next.push_left(p, 0);
  for (const Point& p : right) next.push_right(p, 0);
  next.find_extremes();
  if (!next.open()) return false;
  *this = std::move(next);
  return true;
}

DirectedLine Hourglass::middle() const {
  const DirectedLine a = clockwise(), b = counterclockwise();
  const double ax = a.to.x - a.from.x, ay = a.to.y - a.from.y, bx = b.to.x - b.from.x, by = b.to.y - b.from.y;
  const double la = std::sqrt(ax * ax + ay * ay), lb = std::sqrt(bx * bx + by * by), cross = ax * by - ay * bx;
  // Nearly one line, or opposite ones (a base that sees its gate from very near): either will do.
  if (!(std::fabs(cross) > 1e-9 * la * lb)) return a;
  const double share = ((b.from.x - a.from.x) * by - (b.from.y - a.from.y) * bx) / cross;
  const Point meet{a.from.x + share * ax, a.from.y + share * ay};
  const double dx = ax / la + bx / lb, dy = ay / la + by / lb;
  return {{meet.x - dx, meet.y - dy}, {meet.x + dx, meet.y + dy}};
}

}  // namespace taut::internal
