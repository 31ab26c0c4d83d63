#include "scene/pairs_in_reach.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/box_tree.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// A lower bound of the distance of two boxes.
double distance_of(const AxisBox& a, const AxisBox& b) { return a.distance_to(b) * (1 - 0x1p-45); }

bool all_rest(const Instance& instance) {
  return std::all_of(instance.bodies().begin(), instance.bodies().end(),
                     [](const InstanceBody& body) { return body.motions.empty(); });
}

}  // namespace

CoarseBoxes::CoarseBoxes(const Instance& instance)
    : instance_(instance), windows_(all_rest(instance) ? 1 : coarse_windows) {
  for (std::size_t k = 0; k < windows_.size(); ++k) {
    const int window = static_cast<int>(k);
    for (const InstanceBody& body : instance.bodies()) {
      checkpoint();
      windows_[k].push_back(swept_box(body, coarse_boundary(instance, window), coarse_boundary(instance, window + 1)));
    }
  }
}

std::vector<std::pair<int, int>> CoarseBoxes::pairs_within(double reach) const {
  return pairs_within(std::vector<double>(instance_.bodies().size(), reach / 2));
}

std::vector<std::pair<int, int>> CoarseBoxes::pairs_within(const std::vector<double>& shares) const {
  std::vector<int> groups;
  if (!instance_.tests_groups()) {
    for (const InstanceBody& body : instance_.bodies()) groups.push_back(body.group);
  }
  std::vector<std::pair<int, int>> pairs;
  for (const std::vector<AxisBox>& boxes : windows_) {
    std::vector<AxisBox> in_reach;
    for (std::size_t k = 0; k < boxes.size(); ++k) in_reach.push_back(grown(boxes[k], shares[k]));
    BoxTree(in_reach, groups).each_two([&](int i, int j) {
      if (instance_.asked(i, j)) pairs.emplace_back(std::minmax(i, j));
    });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

double CoarseBoxes::distance(int a, int b) const {
  double least = INFINITY;
  for (const std::vector<AxisBox>& boxes : windows_)
    least = std::min(least, distance_of(boxes[static_cast<std::size_t>(a)], boxes[static_cast<std::size_t>(b)]));
  return least;
}

}  // namespace taut::internal
