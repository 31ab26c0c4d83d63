// When may two bodies of a world meet at all, as far as boxes show?
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "scene/instance.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// For each pair the stretches of time outside of which the two bodies' boxes are apart: what has to look at all of a
/// scene's time, and not only up to a first contact, need not follow a pair through the rest. The world's time is
/// divided into the coarse windows, and these are halved as long as that makes boxes much shorter.
class NearStretches {
 public:
  explicit NearStretches(const Instance& instance);

  /// Of each pair a < b that is asked about, the stretches in order and apart from each other; none if boxes over the
  /// halves of windows separate the two throughout. Pairs that boxes over the coarse windows separate are left out.
  const std::map<std::pair<int, int>, std::vector<TimeInterval>>& pairs() const { return stretches_; }

 private:
  void cover(const std::vector<int>& bodies, double from, double to, int depth);

  const Instance& instance_;
  std::map<std::pair<int, int>, std::vector<TimeInterval>> stretches_;
};

}  // namespace taut::internal
