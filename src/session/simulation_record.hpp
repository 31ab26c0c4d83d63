// All motions of a simulation, as ordinary scenes.
#pragma once

#include <vector>

#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Grows by the pieces of every change. A body that is added or removed, or a pair that is ignored, begins a new scene.
class MotionRecord {
 public:
  /// `removed`: bodies of the scene that are not there.
  void begin(const Scene& scene, const std::vector<bool>& removed);
  /// The body of the current scene moves in another way from t on.
  void change(BodyId body, const Motion& motion, double t);
  /// The current scene ends at t.
  void end(double t);
  /// With the current scene up to t.
  std::vector<Scene> scenes(double t) const;

 private:
  std::vector<Scene> ended_;
  Scene current_;
  std::vector<int> places_;  ///< of the simulation's bodies in the current scene; -1 for those that are not there
};

}  // namespace taut::internal
