// What is behind a Simulation: the world that goes on, its limits, its record, and the tracer.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "scene/untested.hpp"
#include "session/world_simulation.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/feature.hpp"
#include "taut/scene.hpp"
#include "taut/simulation.hpp"

namespace taut::internal {

// How often bodies came into contact, so that a loop of contacts in no time ends.

/// Counts contacts by pairs of bodies. For each pair only those within a stretch of time count that begins with a
/// contact.
class ContactCount {
 public:
  ContactCount(std::uint64_t most, double stretch) : most_(most), stretch_(stretch) {}

  /// Returns whether that is one too many.
  bool add(const std::array<BodyId, 2>& pair, double time) {
    if (pairs_.size() > room_) forget_before(time - stretch_);
    Stretch& own = pairs_[pair];
    if (own.count == 0 || time - own.from > stretch_) own = {time, 0};
    return ++own.count > most_;
  }
  /// In a stretch of time.
  std::uint64_t most() const { return most_; }
  double stretch() const { return stretch_; }
  /// All contacts at all times.
  std::uint64_t total = 0;

 private:
  struct Stretch {
    double from = 0;
    std::uint64_t count = 0;
  };

  void forget_before(double time) {
    std::erase_if(pairs_, [time](const auto& entry) { return entry.second.from < time; });
    room_ = 2 * pairs_.size() + 1024;
  }

  std::uint64_t most_;
  double stretch_;
  std::size_t room_ = 1024;
  std::map<std::array<BodyId, 2>, Stretch> pairs_;
};

// All motions of a simulation, as ordinary scenes.

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

namespace taut {

using namespace internal;

struct Simulation::Impl final : KineticObserver {
  Impl(const Scene& given_scene, const SimulationOptions& given);

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

  /// The world of that scene, after the events that there have been.
  std::unique_ptr<WorldSimulation> make_world(const Scene& from_now);
  /// Changes which bodies there are, what they are attached to, or which pairs are tested, from the present on: the
  /// world if `in_place()` does so, and does not return false, or else in a new world. `edit(scene, removed)` does the
  /// same to the scene. Throws InputError, and changes nothing, if bodies would overlap.
  void change(const std::function<bool()>& in_place,
              const std::function<void(Scene& scene, std::vector<bool>& removed)>& edit);
  /// Goes on with another scene from the present on. Throws InputError if bodies overlap in it.
  void begin_anew(Scene next, std::vector<bool> gone);
  /// The scene as it is now, from the present on, if there is a record.
  void begin_record();
  void check_body(BodyId body) const;
  void check_named(BodyId body) const;
  void set_motion(BodyId body, const Motion& motion);
  /// Counts the contacts at which it stands, if it has just come to them.
  void note_contact();
  /// The contact is one from which it was resumed.
  bool is_again() const;
  bool in_contact() const { return world->answer().outcome == Outcome::contact; }
  std::uint64_t events() const { return events_before + (world ? world->events() : 0); }

  void give_up(const std::string& why) {
    if (!world || !world->over()) reason = why;
  }
  bool ends_undecided() const { return world && world->finished() && at_end == Outcome::undecided; }
  bool undecided() const {
    if (!reason.empty() || (world && world->answer().outcome == Outcome::undecided)) return true;
    return world && !world->over() && ends_undecided();
  }
  const std::string& why_undecided() const {
    if (!reason.empty() || !world || world->over()) return reason.empty() && world ? world->answer().reason : reason;
    return ends_undecided() ? reason_at_end : reason;
  }
  bool ended() const { return undecided() || world->over() || world->finished(); }
  void expect_decided() const {
    if (undecided()) throw UndecidedError(why_undecided());
  }

  /// Throws unless it runs, or stands at a contact, or at the end.
  void expect_changeable() const {
    expect_decided();
    if (world->over() && !in_contact())
      throw InputError("", "bodies overlap, and nothing goes on from there", "make a simulation in which they do not");
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
  Scene scene;                ///< with the motions of now
  std::vector<bool> removed;  ///< bodies of the scene that are no longer there
  Outcome at_end;             ///< of a motion that is free to the end
  std::string reason_at_end;
  MotionRecord record;
  ContactCount contacts;
  std::vector<PairAnswer> resumed;  ///< the contacts from which it was resumed last
  std::uint64_t events_before = 0;  ///< of worlds before this one
  std::uint64_t certificates_max_before = 0;
  std::uint64_t traced = 0;
  /// When begin_anew() was called last, or a body came or was attached: some pairs have nothing before.
  double began = std::numeric_limits<double>::quiet_NaN();
  bool changed_since_contact = false;  ///< a motion, by set_motion()
  bool broken = false;
  std::string reason;  ///< why it is undecided, or empty
  double start;
  Coverage unreached;  ///< without a world
  RepairReport last;
  std::unique_ptr<WorldSimulation> world;  ///< null if a limit ended its construction
};

}  // namespace taut
