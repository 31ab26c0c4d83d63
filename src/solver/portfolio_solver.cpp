#include "solver/portfolio_solver.hpp"

#include <algorithm>

#include "numeric/slices.hpp"

namespace taut::internal {
namespace {

SpacetimeSolver by_spacetime(const Instance& world, int a, int b, Offset offset) {
  return {PairInstance(world, std::min(a, b), std::max(a, b), offset), offset, world.start(), world.end()};
}

/// Runs both engines to the end, to compare them. The result is the kinetic one, unless only the other one is decided.
class CrossCheckSolver final : public PairSolver {
 public:
  CrossCheckSolver(const Instance& world, int a, int b, Offset offset, EventBudget& budget, KineticObserver* observer)
      : kinetic_(world, a, b, offset, budget, observer), spacetime_(by_spacetime(world, a, b, offset)) {}

  void ask_start() override {
    kinetic_.ask_start();
    spacetime_.ask_start();
  }
  bool work(double from, double to, std::uint64_t) override {
    kinetic_.ask(from, to);
    spacetime_.ask(from, to);
    return true;
  }
  const PairResult& result() const override { return (by_spacetime_alone() ? spacetime_ : kinetic()).result(); }
  std::optional<ContactInstant> instant() const override {
    return (by_spacetime_alone() ? spacetime_ : kinetic()).instant();
  }
  const PairResult* other() const override { return &(by_spacetime_alone() ? kinetic() : spacetime_).result(); }
  StageCounts stages() const override { return kinetic_.stages() += spacetime_.stages(); }
  KineticCounts counts() const override { return kinetic_.counts(); }

 private:
  const PairSolver& kinetic() const { return kinetic_; }
  bool by_spacetime_alone() const {
    return kinetic_.result().outcome == Outcome::undecided && spacetime_.result().outcome != Outcome::undecided;
  }

  KineticSolver kinetic_;
  SpacetimeSolver spacetime_;
};

/// Runs both engines in alternating slices, until one has decided the window. Most pairs are decided in the first slice
/// of the spacetime engine, and never get a tiling.
class PortfolioSolver final : public PairSolver {
 public:
  PortfolioSolver(const SolverChoice& choice, const Instance& world, int a, int b, Offset offset, EventBudget& budget)
      : choice_(choice),
        world_(world),
        offset_(offset),
        budget_(budget),
        spacetime_(by_spacetime(world, a, b, offset)),
        result_(spacetime_.result()) {}

  void ask_start() override {
    spacetime_.ask_start();
    result_ = spacetime_.result();
  }
  bool work(double from, double to, std::uint64_t) override {
    if (open() || result_.free_until > from) decide(from, to);
    return true;
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

  void decide(double from, double to) {
    PortfolioMember by_boxes, by_tiling;
    const auto in_boxes = [&](std::uint64_t effort) { return end_of(spacetime_, spacetime_.work(from, to, effort)); };
    const auto in_tiling = [&](std::uint64_t effort) { return end_of(*kinetic_, kinetic_->work(from, to, effort)); };
    if (choice_.first == EngineName::spacetime &&
        by_boxes.work_until(choice_.first_slice, in_boxes) == SliceResult::decided)
      return take(spacetime_);
    by_tiling.begin([&] {
      if (!kinetic_)
        kinetic_ = std::make_unique<KineticSolver>(world_, result_.a, result_.b, offset_, budget_, choice_.observer);
    });
    if (choice_.first == EngineName::kinetic &&
        by_tiling.work_until(choice_.first_slice, in_tiling) == SliceResult::decided)
      return take(*kinetic_);
    if (take_turns(by_tiling, in_tiling, by_boxes, in_boxes) == 2) return take(spacetime_);
    // The kinetic engine decides, unless limits stopped both and the other one went further.
    const bool kinetic = decided(*kinetic_) || kinetic_->result().free_until >= spacetime_.result().free_until;
    take(kinetic ? static_cast<const PairSolver&>(*kinetic_) : spacetime_);
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

  SolverChoice choice_;
  const Instance& world_;
  Offset offset_;
  EventBudget& budget_;
  SpacetimeSolver spacetime_;
  std::unique_ptr<KineticSolver> kinetic_;
  PairResult result_;
  const PairSolver* teller_ = nullptr;  ///< the solver of that result, once something has been found
};

}  // namespace

std::unique_ptr<PairSolver> pair_solver(const SolverChoice& choice, const Instance& world, int a, int b, Offset offset,
                                        EventBudget& budget) {
  switch (choice.engine) {
    case EngineChoice::kinetic:
      return std::make_unique<KineticSolver>(world, a, b, offset, budget, choice.observer);
    case EngineChoice::spacetime:
      return std::make_unique<SpacetimeSolver>(by_spacetime(world, a, b, offset));
    case EngineChoice::both:
      return std::make_unique<CrossCheckSolver>(world, a, b, offset, budget, choice.observer);
    default:
      return std::make_unique<PortfolioSolver>(choice, world, a, b, offset, budget);
  }
}

}  // namespace taut::internal
