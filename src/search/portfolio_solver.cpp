#include "search/portfolio_solver.hpp"

#include <algorithm>

#include "base/slices.hpp"

namespace taut::internal {
namespace {

SpacetimeSolver by_spacetime(const WorldPlan& world, int a, int b, bool inwards) {
  return {PairInstance(world, std::min(a, b), std::max(a, b), inwards), inwards, world.start(), world.end()};
}

/// Runs both engines, to compare them.
class CrossCheckSolver final : public PairSolver {
 public:
  CrossCheckSolver(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget)
      : kinetic_(world, a, b, inwards, budget), spacetime_(by_spacetime(world, a, b, inwards)) {}

  void ask_start() override {
    kinetic_.ask_start();
    spacetime_.ask_start();
  }
  void ask(double from, double to) override {
    kinetic_.ask(from, to);
    spacetime_.ask(from, to);
  }
  const PairResult& result() const override { return kinetic_.result(); }
  std::optional<ContactInstant> instant() const override { return kinetic_.instant(); }
  const PairResult* other() const override { return &spacetime_.result(); }
  StageCounts stages() const override { return kinetic_.stages() += spacetime_.stages(); }
  KineticCounts counts() const override { return kinetic_.counts(); }

 private:
  KineticSolver kinetic_;
  SpacetimeSolver spacetime_;
};

/// Runs both engines in alternating slices. Most pairs are decided in the first slice of the spacetime engine, and
/// never get a tiling.
class PortfolioSolver final : public PairSolver {
 public:
  PortfolioSolver(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget, std::uint64_t first_turn)
      : world_(world),
        inwards_(inwards),
        budget_(budget),
        first_turn_(first_turn),
        spacetime_(by_spacetime(world, a, b, inwards)),
        result_(spacetime_.result()) {}

  void ask_start() override {
    spacetime_.ask_start();
    result_ = spacetime_.result();
  }
  void ask(double from, double to) override {
    if (!open() && result_.free_until <= from) return;
    PortfolioMember by_boxes, by_tiling;
    const auto in_boxes = [&](std::uint64_t effort) {
      return end_of(spacetime_, spacetime_.try_ask(from, to, effort));
    };
    const auto in_tiling = [&](std::uint64_t effort) { return end_of(*kinetic_, kinetic_->work(from, to, effort)); };
    if (by_boxes.work_until(first_turn_, in_boxes) == SliceResult::decided) return take(spacetime_);
    by_tiling.begin([&] {
      if (!kinetic_) kinetic_ = std::make_unique<KineticSolver>(world_, result_.a, result_.b, inwards_, budget_);
    });
    if (take_turns(by_tiling, in_tiling, by_boxes, in_boxes) == 2) return take(spacetime_);
    // The kinetic engine decides, unless limits stopped both and the other one went further.
    const bool kinetic = decided(*kinetic_) || kinetic_->result().free_until >= spacetime_.result().free_until;
    take(kinetic ? static_cast<const PairSolver&>(*kinetic_) : spacetime_);
  }
  const PairResult& result() const override { return result_; }
  std::optional<ContactInstant> instant() const override { return teller_ ? teller_->instant() : spacetime_.instant(); }
  StageCounts stages() const override { return spacetime_.stages() += kinetic_ ? kinetic_->stages() : StageCounts(); }
  KineticCounts counts() const override { return kinetic_ ? kinetic_->counts() : KineticCounts(); }

 private:
  static bool decided(const PairSolver& pair) { return pair.result().outcome != Outcome::undecided; }
  static SliceResult end_of(const PairSolver& pair, bool done) {
    return !done ? SliceResult::open : decided(pair) ? SliceResult::decided : SliceResult::given_up;
  }

  /// Takes the result of the engine that has decided the current window. The other engine has no result for it. An
  /// earlier result, of either engine, stays unless this one concerns an earlier time.
  void take(const PairSolver& decided) {
    const PairResult& found = decided.result();
    // A free result is attributed to the kinetic engine as soon as one window is.
    if (open() && found.engine == EngineName::kinetic) result_.engine = found.engine;
    if (decided.open()) return;
    if (!open() && !(found.free_until < result_.free_until)) return;
    result_ = found;
    teller_ = &decided;
  }

  const WorldPlan& world_;
  bool inwards_;
  EventBudget& budget_;
  std::uint64_t first_turn_;  ///< of the spacetime engine
  SpacetimeSolver spacetime_;
  std::unique_ptr<KineticSolver> kinetic_;
  PairResult result_;
  const PairSolver* teller_ = nullptr;  ///< the solver of that result, once something has been found
};

}  // namespace

std::unique_ptr<PairSolver> windowed_pair(EngineChoice engine, const WorldPlan& world, int a, int b, bool inwards,
                                          EventBudget& budget) {
  switch (engine) {
    case EngineChoice::kinetic:
      return std::make_unique<KineticSolver>(world, a, b, inwards, budget);
    case EngineChoice::spacetime:
      return std::make_unique<SpacetimeSolver>(by_spacetime(world, a, b, inwards));
    case EngineChoice::both:
      return std::make_unique<CrossCheckSolver>(world, a, b, inwards, budget);
    default:
      return pair_in_turns(world, a, b, inwards, budget);
  }
}

std::unique_ptr<PairSolver> pair_in_turns(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget,
                                          std::uint64_t first_turn) {
  return std::make_unique<PortfolioSolver>(world, a, b, inwards, budget, first_turn);
}

}  // namespace taut::internal
