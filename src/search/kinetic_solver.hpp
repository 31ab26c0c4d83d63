// Solves a pair of a world by the kinetic engine.
#pragma once

#include <memory>

#include "kinetic/ring_engines.hpp"
#include "search/pair_solver.hpp"
#include "taut/simulation.hpp"
#include "world/world_plan.hpp"

namespace taut::internal {

/// The number of events that all pairs of a world may process together.
struct EventBudget {
  std::uint64_t most = UINT64_MAX;
  std::uint64_t left = UINT64_MAX;

  explicit EventBudget(std::uint64_t limit) : most(limit), left(limit) {}
};

/// The tilings of the pair's rings are built where its first window begins, and followed through consecutive windows.
/// After a gap, in which the bounding boxes show the bodies to be disjoint, they are rebuilt.
class KineticSolver final : public PairSolver {
 public:
  /// The world and the budget must outlive this object. Throws InputError if a body has features that are finer than
  /// the displacement.
  KineticSolver(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget);

  void ask_start() override;
  void ask(double from, double to) override { work(from, to, UINT64_MAX); }
  /// Like ask(), for about this much work. Returns true once the window is decided. Otherwise it can be called again
  /// for the same window.
  bool work(double from, double to, std::uint64_t effort);
  const PairResult& result() const override { return result_; }
  std::optional<ContactInstant> instant() const override { return instant_of(result_, segments_, geometry_); }
  StageCounts stages() const override;
  KineticCounts counts() const override;
  /// The time up to which the current tilings have been followed.
  double at() const { return at_; }
  /// The current tilings; null before the first window, and where the bodies overlap.
  RingEngines* engines() { return engines_.get(); }
  /// The tilings in the user's terms.
  std::vector<NearTiling> tilings() const;

 private:
  void resolve_start();
  void begin(double from);
  void leave();
  bool advance(double to, std::uint64_t events);
  void note_contact();
  void give_up(const std::string& reason, double until);
  FeatureMap witness() const { return {plan_, geometry_, inwards_}; }

  const WorldPlan& world_;
  bool inwards_;
  EventBudget& budget_;
  PairPlan plan_;
  PairGeometry geometry_;
  MotionSegments segments_;  ///< from the world's start
  std::unique_ptr<RingEngines> engines_;
  double at_ = 0;         ///< the time up to which the current engines have been followed
  double window_ = 0;     ///< the beginning of their current window
  KineticCounts before_;  ///< of discarded engines
  StageCounts stages_;    ///< of discarded engines
  PairResult result_;
};

}  // namespace taut::internal
