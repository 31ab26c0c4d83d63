// A pair of a world by the kinetic engine.
#pragma once

#include <memory>

#include "kinetic/ring_engines.hpp"
#include "search/pair_solver.hpp"
#include "taut/simulation.hpp"
#include "world/world_plan.hpp"

namespace taut::internal {

/// How many events all pairs of a world may take together.
struct EventBudget {
  std::uint64_t most = UINT64_MAX;
  std::uint64_t left = UINT64_MAX;

  explicit EventBudget(std::uint64_t limit) : most(limit), left(limit) {}
};

/// The tilings of the pair's rings are built where its first window begins, and followed through windows that follow
/// each other; after a gap, in which the bodies were apart by their boxes, they are built anew.
class KineticSolver final : public PairSolver {
 public:
  /// The world and the budget must outlive it. Throws InputError where a body has features that are finer than the
  /// displacement.
  KineticSolver(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget);

  void ask_start() override;
  void ask(double from, double to) override { work(from, to, UINT64_MAX); }
  /// The same, for about so much work; true once it is settled. Else it can be asked again about the same window.
  bool work(double from, double to, std::uint64_t effort);
  const PairResult& result() const override { return result_; }
  std::optional<ContactInstant> instant() const override { return instant_of(result_, segments_, geometry_); }
  StageCounts stages() const override;
  KineticCounts counts() const override;
  /// Up to where the present tilings have come.
  double at() const { return at_; }
  /// The present tilings; null before the first window, and where the bodies overlap.
  RingEngines* engines() { return engines_.get(); }
  /// In the user's terms.
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
  double at_ = 0;         ///< up to where the present engines have come
  double window_ = 0;     ///< where the window begins that they are in
  KineticCounts before_;  ///< of engines that have been left
  StageCounts stages_;    ///< of these
  PairResult result_;
};

}  // namespace taut::internal
