// Observes a run of the kinetic engine from its first tiling to its answer.
#pragma once

#include "check/run.hpp"
#include "kinetic/session.hpp"

namespace taut::internal {

class RunWatcher : public EngineObserver {
 public:
  virtual void started(const Session& session) = 0;
  virtual void ended(const Session& session, const Answer& answer) = 0;
};

}  // namespace taut::internal
