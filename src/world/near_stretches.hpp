// When may two bodies of a world meet at all, as far as boxes tell?
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "taut/check.hpp"
#include "world/world_plan.hpp"

namespace taut {

/// For each pair the stretches of time outside of which the two bodies' boxes are apart: what has to look at all of a
/// scene's time, and not only up to a first contact, need not follow a pair through the rest. The world's time is
/// divided into the coarse windows, and these are halved as long as that makes boxes much shorter.
class NearStretches {
 public:
  explicit NearStretches(const WorldPlan& plan);

  /// In order and apart from each other; none if boxes over the halves of windows tell them apart throughout. nullptr:
  /// boxes over the coarse windows do so already, or the pair is not asked about.
  const std::vector<TimeInterval>* of(int a, int b) const;

 private:
  void cover(const std::vector<int>& bodies, double from, double to, int depth);

  const WorldPlan& plan_;
  std::unordered_map<std::uint64_t, std::vector<TimeInterval>> stretches_;
};

}  // namespace taut
