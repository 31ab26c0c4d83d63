// What is behind a Simulation: the world that goes on, its limits, and the tracer.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "numeric/budget.hpp"
#include "numeric/undecided.hpp"
#include "scene/untested.hpp"
#include "session/world_simulation.hpp"
#include "taut/error.hpp"
#include "taut/simulation.hpp"

namespace taut {
using namespace internal;

struct Simulation::Impl final : KineticObserver {
  Impl(const Scene& scene, const SimulationOptions& given) : options(given), start(scene.start) {
    changing([&] {
      world = std::make_unique<WorldSimulation>(scene, options.touch, options.max_events, this);
      if (options.tracer) only_pair();
    });
    if (!world) unreached = coverage_before_search(scene);
  }

  void on_event(const KineticSolver& solver, const EngineEvent& event) override;

  /// Runs what changes the simulation, within its limits. If one of them ends it, or precision does, it is undecided
  /// from then on. Refused input changes nothing; any other exception leaves an event half done.
  template <class Work>
  void changing(const Work& work) {
    try {
      const Budget scope(options.limits);
      scope.check();
      work();
    } catch (const Undecidable& limit) {
      give_up(not_decided(limit));
    } catch (const Interrupted& limit) {
      give_up(limit.reason);
    } catch (const InputError&) {
      throw;
    } catch (...) {
      broken = true;
      throw;
    }
  }

  void give_up(const std::string& why) {
    if (!world || !world->over()) reason = why;
  }
  bool undecided() const { return !reason.empty() || (world && world->answer().outcome == Outcome::undecided); }
  const std::string& why_undecided() const { return reason.empty() && world ? world->answer().reason : reason; }
  bool ended() const { return undecided() || world->over() || world->finished(); }
  void expect_decided() const {
    if (undecided()) throw UndecidedError(why_undecided());
  }

  /// The tiling of the single pair of rings.
  struct OnlyTiling {
    const KineticSolver& solver;
    const Engine& engine;

    VertexRef input_vertex(VertexId v) const { return solver.features().vertex(v); }
    BodyId body(ChainNode n) const { return solver.bodies().body(node::in_p(n) ? Role::p : Role::q); }
  };
  /// Throws UndecidedError, and InputError if there is no such pair.
  const KineticSolver& only_pair() const;
  /// Also throws InputError if the pair has no tiling, because the bodies overlap.
  OnlyTiling tiling() const;

  SimulationOptions options;
  bool broken = false;
  std::string reason;  ///< why it is undecided, or empty
  double start;
  Coverage unreached;  ///< without a world
  RepairReport last;
  std::unique_ptr<WorldSimulation> world;  ///< null if a limit ended its construction
};

}  // namespace taut
