// Which members of lists have boxes that are near each other.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::internal {

/// A rectangle along the axes; empty at first.
struct AxisBox {
  double lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;

  void add(const AxisBox& b) {
    lo_x = std::min(lo_x, b.lo_x);
    lo_y = std::min(lo_y, b.lo_y);
    hi_x = std::max(hi_x, b.hi_x);
    hi_y = std::max(hi_y, b.hi_y);
  }
  void add(const Point& p) { add(AxisBox{p.x, p.y, p.x, p.y}); }
  /// 0 if and only if they meet; else rounded.
  double distance_to(const AxisBox& b) const {
    const double x = std::max({0.0, lo_x - b.hi_x, b.lo_x - hi_x}), y = std::max({0.0, lo_y - b.hi_y, b.lo_y - hi_y});
    return std::sqrt(x * x + y * y);
  }
};

/// Boxes of a list in which neighbours tend to be neighbours in the plane, as cells along a curve are: so a box around
/// each half of the list, each half of these, and so on shows most of what is far away.
class BoxList {
 public:
  BoxList() = default;
  explicit BoxList(const std::vector<AxisBox>& boxes) : size_(boxes.size()), around_(4 * boxes.size()) {
    if (size_ > 0) build(boxes, whole());
  }

  /// Visits each i of this list and k of the other one whose boxes are no farther apart than `reach`.
  template <class Visit>
  void near(const BoxList& other, double reach, const Visit& visit) const {
    if (size_ > 0 && other.size_ > 0) across(whole(), other, other.whole(), reach, visit);
  }
  /// Visits each i < k whose boxes meet.
  template <class Visit>
  void meeting(const Visit& visit) const {
    if (size_ > 0) within(whole(), visit);
  }

 private:
  struct Run {
    std::size_t node, lo, hi;

    std::size_t size() const { return hi - lo; }
    std::size_t middle() const { return (lo + hi) / 2; }
    Run first() const { return {2 * node, lo, middle()}; }
    Run second() const { return {2 * node + 1, middle(), hi}; }
  };
  Run whole() const { return {1, 0, size_}; }

  const AxisBox& build(const std::vector<AxisBox>& boxes, const Run& run) {
    if (run.size() == 1) return around_[run.node] = boxes[run.lo];
    AxisBox box = build(boxes, run.first());
    box.add(build(boxes, run.second()));
    return around_[run.node] = box;
  }
  template <class Visit>
  void across(const Run& i, const BoxList& other, const Run& k, double reach, const Visit& visit) const {
    if (around_[i.node].distance_to(other.around_[k.node]) > reach) return;
    if (i.size() == 1 && k.size() == 1) return visit(i.lo, k.lo);
    if (i.size() >= k.size()) {
      across(i.first(), other, k, reach, visit);
      across(i.second(), other, k, reach, visit);
    } else {
      across(i, other, k.first(), reach, visit);
      across(i, other, k.second(), reach, visit);
    }
  }
  template <class Visit>
  void within(const Run& run, const Visit& visit) const {
    if (run.size() == 1) return;
    within(run.first(), visit);
    within(run.second(), visit);
    across(run.first(), *this, run.second(), 0, visit);
  }

  std::size_t size_ = 0;
  std::vector<AxisBox> around_;
};

}  // namespace taut::internal
