// Solves a pair of a world by the kinetic engine.
#pragma once

#include <memory>

#include "kinetic/ring_engines.hpp"
#include "scene/instance.hpp"
#include "solver/pair_solver.hpp"
#include "taut/simulation.hpp"
#include "taut/tracer.hpp"

namespace taut::internal {

/// The number of events that all pairs of a world may process together.
struct EventBudget {
  std::uint64_t most = UINT64_MAX;
  std::uint64_t left = UINT64_MAX;

  explicit EventBudget(std::uint64_t limit) : most(limit), left(limit) {}
};

class KineticSolver;

/// Observes how a solver follows a pair that has one tiling: two bodies of one ring each.
class KineticObserver {
 public:
  virtual ~KineticObserver() = default;
  /// The start is decided: there is a tiling, or the solver has a result.
  virtual void started(const KineticSolver&) {}
  virtual void on_event(const KineticSolver& solver, const EngineEvent& event) = 0;
};

/// The tilings of the pair's rings are built where its first window begins, and followed through consecutive windows.
/// After a gap, in which the bounding boxes show the bodies to be disjoint, they are rebuilt.
class KineticSolver final : public PairSolver, private EngineObserver {
 public:
  /// The world, the budget, and the observer of events, which may be null, must outlive this object. Throws InputError
  /// if a body has features that are finer than the displacement.
  KineticSolver(const Instance& world, int a, int b, Offset offset, EventBudget& budget,
                KineticObserver* observer = nullptr);

  void ask_start() override;
  /// Stops between two events, and builds no tiling that takes more work.
  bool work(double from, double to, std::uint64_t effort) override;
  /// For callers that process events one by one, in the order of all pairs. Builds the tilings at that time.
  void start_at(double from);
  /// An enclosure of the time of the next event up to t. Nothing if there is none, or it is undecided: see result().
  std::optional<TimeInterval> next_event(double t);
  /// Processes the next event up to t, if there is one.
  void step(double t);
  /// Stands at t: there must be no event up to then.
  void stand_at(double t);
  /// The world has changed the motions from now on. The tilings stay, and their certificates are computed anew. Returns
  /// false where tilings must be built anew: they correspond to a later time, or there are none.
  bool replan(double now);
  const PairResult& result() const override { return result_; }
  std::optional<ContactInstant> instant() const override { return instant_of(result_, segments_, geometry_); }
  StageCounts stages() const override;
  KineticCounts counts() const override;
  const BodyPair& bodies() const { return bodies_; }
  const PairGeometry& geometry() const { return geometry_; }
  const MotionSegments& segments() const { return segments_; }
  FeatureMap features() const { return {bodies_, geometry_, offset_}; }
  /// The time up to which the current tilings have been followed.
  double at() const { return at_; }
  /// The current tilings; null before the first window, and where the bodies overlap.
  RingEngines* engines() { return engines_.get(); }
  const RingEngines* engines() const { return engines_.get(); }
  /// See Engine::put_aside().
  void put_aside() {
    segments_.give_back();
    if (engines_) engines_->put_aside();
  }
  /// The tilings in the user's terms.
  std::vector<NearTiling> tilings() const;

 private:
  void on_event(const EngineEvent& event) override { observer_->on_event(*this, event); }
  EngineObserver* engine_observer() { return observer_ ? this : nullptr; }
  /// From when on both bodies are there.
  double start() const { return world_.start_of(a_, b_); }
  void resolve_start();
  void begin(double from);
  bool needs_tilings(double from) const { return !engines_ || (at_ != from && window_ != from); }
  void enter(double from);
  void leave();
  template <class Work>
  bool guarded(double from, const Work& work);
  bool advance(double to, std::uint64_t events);
  void note_contact();
  void give_up(const std::string& reason, double until);

  const Instance& world_;
  int a_, b_;  ///< the bodies, in the order that decides their roles
  Offset offset_;
  EventBudget& budget_;
  KineticObserver* observer_;
  BodyPair bodies_;
  PairGeometry geometry_;
  MotionSegments segments_;  ///< from the world's start
  std::unique_ptr<RingEngines> engines_;
  double at_ = 0;         ///< the time up to which the current engines have been followed
  double window_ = 0;     ///< the beginning of their current window
  KineticCounts before_;  ///< of discarded engines
  StageCounts stages_;    ///< of discarded engines
  PairResult result_;
};

// Translates the events of the kinetic engine to the user's terms, for a tracer.

class TraceWriter final : public KineticObserver {
 public:
  explicit TraceWriter(Tracer& tracer) : tracer_(tracer) {}
  void on_event(const KineticSolver& solver, const EngineEvent& event) override;

 private:
  Tracer& tracer_;
  std::uint64_t number_ = 0;
};

}  // namespace taut::internal
