#include "search/pair_engines.hpp"

#include <algorithm>

#include "base/turns.hpp"

namespace taut {
namespace {

PairQuestion by_spacetime(const WorldPlan& world, int a, int b, bool inwards) {
  return {PairSearch(world, std::min(a, b), std::max(a, b), inwards), inwards, world.start(), world.end()};
}

/// Both, to be compared.
class BothPair final : public WindowedPair {
 public:
  BothPair(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget)
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
  KineticPair kinetic_;
  PairQuestion spacetime_;
};

/// Both in turn; most pairs are settled in the first turn of the spacetime engine, and never
/// get a tiling.
class EitherPair final : public WindowedPair {
 public:
  EitherPair(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget)
      : world_(world), inwards_(inwards), budget_(budget), spacetime_(by_spacetime(world, a, b, inwards)) {}

  void ask_start() override { spacetime_.ask_start(); }
  void ask(double from, double to) override {
    if (!open() && result().free_until <= from) return;
    Contestant by_boxes, by_tiling;
    const auto in_boxes = [&](std::uint64_t effort) {
      return end_of(spacetime_, spacetime_.try_ask(from, to, effort));
    };
    const auto in_tiling = [&](std::uint64_t effort) { return end_of(*kinetic_, kinetic_->work(from, to, effort)); };
    if (by_boxes.work_until(first_turn, in_boxes) == TurnEnd::decided) return;
    by_tiling.begin([&] {
      const PairResult& known = spacetime_.result();
      if (!kinetic_) kinetic_ = std::make_unique<KineticPair>(world_, known.a, known.b, inwards_, budget_);
    });
    if (take_turns(by_tiling, in_tiling, by_boxes, in_boxes) == 2) return;
    // It is the kinetic engine's, unless limits stopped both and the other one went further.
    by_kinetic_ = decided(*kinetic_) || kinetic_->result().free_until >= spacetime_.result().free_until;
  }
  const PairResult& result() const override { return by_kinetic_ ? kinetic_->result() : spacetime_.result(); }
  std::optional<ContactInstant> instant() const override {
    return by_kinetic_ ? kinetic_->instant() : spacetime_.instant();
  }
  StageCounts stages() const override { return spacetime_.stages() += kinetic_ ? kinetic_->stages() : StageCounts(); }
  KineticCounts counts() const override { return kinetic_ ? kinetic_->counts() : KineticCounts(); }

 private:
  /// Tilings of all parts take long to build: so much is worth trying before.
  static constexpr std::uint64_t first_turn = 8192;

  static bool decided(const WindowedPair& pair) { return pair.result().outcome != Outcome::undecided; }
  static TurnEnd end_of(const WindowedPair& pair, bool done) {
    return !done ? TurnEnd::open : decided(pair) ? TurnEnd::decided : TurnEnd::given_up;
  }

  const WorldPlan& world_;
  bool inwards_;
  EventBudget& budget_;
  PairQuestion spacetime_;
  std::unique_ptr<KineticPair> kinetic_;
  bool by_kinetic_ = false;
};

}  // namespace

std::unique_ptr<WindowedPair> windowed_pair(EngineChoice engine, const WorldPlan& world, int a, int b, bool inwards,
                                            EventBudget& budget) {
  switch (engine) {
    case EngineChoice::kinetic:
      return std::make_unique<KineticPair>(world, a, b, inwards, budget);
    case EngineChoice::spacetime:
      return std::make_unique<PairQuestion>(by_spacetime(world, a, b, inwards));
    case EngineChoice::both:
      return std::make_unique<BothPair>(world, a, b, inwards, budget);
    default:
      return std::make_unique<EitherPair>(world, a, b, inwards, budget);
  }
}

}  // namespace taut
