// What is behind a Simulation: two polygons with their tiling, or a world.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "base/budget.hpp"
#include "kinetic/session.hpp"
#include "numeric/undecided.hpp"
#include "pair/validate_scene.hpp"
#include "simulation/world_simulation.hpp"
#include "taut/error.hpp"
#include "taut/simulation.hpp"

namespace taut {
using namespace internal;

struct Simulation::Impl : private EngineObserver, private Tracer {
  Impl(const Scene& scene, const SimulationOptions& given) : options(given), free_until(scene.start) {
    changing([&] {
      if (!is_ring_pair(scene)) {
        if (options.tracer)
          throw InputError("tracer", "events of a world are not traced", "trace two of its bodies alone");
        world = std::make_unique<WorldSimulation>(scene, options.touch, options.max_events);
        return;
      }
      Tracer* const tracer = options.tracer ? static_cast<Tracer*>(this) : nullptr;
      session.emplace(scene, options.touch, tracer, static_cast<EngineObserver*>(this));
    });
  }

  // The repair changes records of the corners it names, of the half-edges after them, and of the edge it removes
  // (src/kinetic/repair_*.cpp).
  void on_event(const EngineEvent& event) override { last = event.report; }
  /// An event whose tracer throws has changed the map and is not finished.
  void on_event(const TraceEvent& event) override {
    try {
      options.tracer->on_event(event);
    } catch (...) {
      broken = true;
      throw;
    }
  }

  /// What changes the simulation, within its limits: where one of them ends it, or precision, it is undecided from then
  /// on. Refused input changes nothing; any other exception leaves an event half done.
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

  /// The next event before t, or nothing where that many are not allowed.
  bool step(double t) {
    if (session->finished() || session->engine().events() < options.max_events) return session->step(t);
    give_up("the limit of " + std::to_string(options.max_events) + " events was reached",
            session->engine().proved_until());
    return false;
  }

  /// In the middle of an event, perhaps.
  void give_up(const std::string& why) {
    if (world) return give_up(why, world->time());
    give_up(why, session ? session->engine().reached() : free_until);
  }
  void give_up(const std::string& why, double proved_until) {
    if ((session && session->contact()) || (world && world->over())) return;
    reason = why;
    if (world) free_until = proved_until;
    if (session) free_until = std::clamp(proved_until, session->start(), session->end());
  }
  bool undecided() const { return !reason.empty() || (world && world->answer().outcome == Outcome::undecided); }
  const std::string& why_undecided() const { return reason.empty() && world ? world->answer().reason : reason; }
  bool ended() const {
    if (undecided()) return true;
    return world ? world->over() || world->time() >= world->end() : session->finished();
  }
  void expect_decided() const {
    if (undecided()) throw UndecidedError(why_undecided());
  }
  /// For questions that an event half done cannot answer, and that are about a tiling.
  const Session& decided_session() const {
    expect_decided();
    if (!world) return *session;
    throw InputError("bodies", "a world has no tiling: each two rings that are near have one of their own",
                     "simulate two of its bodies, each one polygon in the world's frame");
  }

  SimulationOptions options;
  bool broken = false;
  std::string reason;  ///< why it is undecided, or empty
  double free_until;   ///< if it is
  RepairReport last;   ///< before the session, which may report to it from its constructor
  std::optional<Session> session;
  std::unique_ptr<WorldSimulation> world;  ///< in its place
};

}  // namespace taut
