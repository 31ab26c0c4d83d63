// Translates the events of the kinetic engine to the user's terms, for a tracer.
#pragma once

#include "solver/kinetic_solver.hpp"
#include "taut/tracer.hpp"

namespace taut::internal {

class TraceWriter final : public KineticObserver {
 public:
  explicit TraceWriter(Tracer& tracer) : tracer_(tracer) {}
  void on_event(const KineticSolver& solver, const EngineEvent& event) override;

 private:
  Tracer& tracer_;
  std::uint64_t number_ = 0;
};

}  // namespace taut::internal
