// A simulation of two polygons in the terms of its engine.
#pragma once

#include "numeric/budget.hpp"
#include "session/world_simulation.hpp"

namespace taut::testing {

/// The bodies must not overlap where the engine is asked for.
class TilingRun {
 public:
  explicit TilingRun(const Scene& scene, Touch touch = Touch::open, internal::KineticObserver* observer = nullptr)
      : world_(scene, touch, UINT64_MAX, observer) {}

  /// Throws Interrupted where a limit came while the engine was made: then there is none.
  internal::Engine& engine() {
    internal::RingEngines* const engines = world_.single_pair()->engines();
    if (!engines) throw internal::Interrupted{"there is no engine"};
    return engines->engine(0);
  }
  double end() const { return world_.end(); }
  bool finished() const { return world_.over() || world_.finished(); }
  bool step(double t) { return world_.step(t); }
  void set_motion(BodyId body, const Motion& motion) { world_.set_motion(body, motion); }
  const Answer& answer() const { return world_.answer(); }

 private:
  internal::WorldSimulation world_;
};

}  // namespace taut::testing
