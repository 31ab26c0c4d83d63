// Which bodies of a world come near each other at all, as far as bounding boxes show?
#pragma once

#include <utility>
#include <vector>

#include "scene/swept_box.hpp"

namespace taut::internal {

/// The boxes of all bodies over the coarse windows of a world's time.
class CoarseBoxes {
 public:
  explicit CoarseBoxes(const Instance& instance);

  /// In order, all pairs a < b that are asked about and whose boxes are within `reach` of each other in some window,
  /// and perhaps a few more. No other pair that is asked about ever comes closer than `reach`, in internal units.
  std::vector<std::pair<int, int>> pairs_within(double reach) const;
  /// The same with a reach for each pair: the sum of its bodies' shares.
  std::vector<std::pair<int, int>> pairs_within(const std::vector<double>& shares) const;
  /// A lower bound of the distance of two bodies at all times, in internal units.
  double distance(int a, int b) const;

 private:
  const Instance& instance_;
  std::vector<std::vector<AxisBox>> windows_;  ///< of each window, the boxes of all bodies; of a layout, one window
};

}  // namespace taut::internal
