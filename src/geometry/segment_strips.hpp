// Which of many segments are near each other, or near a box? Found by horizontal strips.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/axis_box.hpp"

namespace taut::internal {

/// Boxes sorted into strips of equal height, and in each strip by their left ends. A box is in every strip that it
/// meets. Short segments spread over the plane cost about the same whatever their number.
class SegmentStrips {
 public:
  explicit SegmentStrips(std::vector<AxisBox> boxes) : boxes_(std::move(boxes)) {
    if (boxes_.empty()) return;
    around_ = boxes_.front();
    for (const AxisBox& box : boxes_) around_.include(box);
    const double count = std::clamp(std::sqrt(static_cast<double>(boxes_.size())), 1.0, 1024.0);
    strips_.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      for (std::size_t s = strip_of(boxes_[i].lo_y); s <= strip_of(boxes_[i].hi_y); ++s) strips_[s].push_back(i);
    for (std::vector<std::size_t>& strip : strips_)
      std::stable_sort(strip.begin(), strip.end(),
                       [this](std::size_t i, std::size_t j) { return boxes_[i].lo_x < boxes_[j].lo_x; });
    for (const std::vector<std::size_t>& strip : strips_) {
      reach_.emplace_back();
      for (const std::size_t i : strip)
        reach_.back().push_back(reach_.back().empty() ? boxes_[i].hi_x
                                                      : std::max(reach_.back().back(), boxes_[i].hi_x));
    }
  }

  /// Calls visit(i, j) once for each two boxes that meet.
  template <class Visit>
  void each_pair(const Visit& visit) const {
    for (std::size_t s = 0; s < strips_.size(); ++s) {
      const std::vector<std::size_t>& strip = strips_[s];
      for (std::size_t k = 0; k < strip.size(); ++k) {
        const AxisBox& box = boxes_[strip[k]];
        for (std::size_t m = k + 1; m < strip.size() && boxes_[strip[m]].lo_x <= box.hi_x; ++m) {
          const AxisBox& other = boxes_[strip[m]];
          // Two boxes share several strips: the first of these counts.
          if (box.meets(other) && strip_of(std::max(box.lo_y, other.lo_y)) == s) visit(strip[k], strip[m]);
        }
      }
    }
  }

  /// Calls visit(i) for boxes that reach the height of p and begin at or left of it, from right to left. It returns the
  /// x left of which boxes may end to be left out.
  template <class Visit>
  void each_to_the_left(const Point& p, const Visit& visit) const {
    if (strips_.empty() || p.y < around_.lo_y || p.y > around_.hi_y) return;
    const std::vector<std::size_t>& strip = strips_[strip_of(p.y)];
    const std::vector<double>& reach = reach_[strip_of(p.y)];
    std::size_t k =
        static_cast<std::size_t>(std::upper_bound(strip.begin(), strip.end(), p.x,
                                                  [this](double x, std::size_t i) { return x < boxes_[i].lo_x; }) -
                                 strip.begin());
    for (double bound = -INFINITY; k > 0 && reach[k - 1] >= bound; --k) {
      const AxisBox& box = boxes_[strip[k - 1]];
      if (box.lo_y <= p.y && p.y <= box.hi_y) bound = visit(strip[k - 1]);
    }
  }

  /// Calls visit(i) once for each box that meets `box`.
  template <class Visit>
  void each_near(const AxisBox& box, const Visit& visit) const {
    if (strips_.empty()) return;
    for (std::size_t s = strip_of(box.lo_y); s <= strip_of(box.hi_y); ++s) {
      // Those before end left of the box.
      const auto first = std::lower_bound(reach_[s].begin(), reach_[s].end(), box.lo_x) - reach_[s].begin();
      for (auto k = static_cast<std::size_t>(first); k < strips_[s].size(); ++k) {
        const std::size_t i = strips_[s][k];
        if (boxes_[i].lo_x > box.hi_x) break;
        if (boxes_[i].meets(box) && strip_of(std::max(box.lo_y, boxes_[i].lo_y)) == s) visit(i);
      }
    }
  }

 private:
  std::size_t strip_of(double y) const {
    const double height = around_.hi_y - around_.lo_y, last = static_cast<double>(strips_.size() - 1);
    if (!(height > 0)) return 0;
    return static_cast<std::size_t>(std::clamp(std::floor((y - around_.lo_y) / height * (last + 1)), 0.0, last));
  }

  std::vector<AxisBox> boxes_;
  AxisBox around_;
  std::vector<std::vector<std::size_t>> strips_;
  std::vector<std::vector<double>> reach_;  ///< how far right the boxes of a strip reach, up to each of them
};

}  // namespace taut::internal
