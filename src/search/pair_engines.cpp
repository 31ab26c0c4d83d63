#include "search/pair_engines.hpp"

#include <algorithm>

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
  bool doubles_sufficed() const override { return kinetic_.doubles_sufficed() && spacetime_.doubles_sufficed(); }
  KineticCounts counts() const override { return kinetic_.counts(); }

 private:
  KineticPair kinetic_;
  PairQuestion spacetime_;
};

/// Both in turn, for longer and longer; most pairs are settled in the first turn of the spacetime engine, and never
/// get a tiling.
class EitherPair final : public WindowedPair {
 public:
  EitherPair(const WorldPlan& world, int a, int b, bool inwards, EventBudget& budget)
      : world_(world), inwards_(inwards), budget_(budget), spacetime_(by_spacetime(world, a, b, inwards)) {}

  void ask_start() override { spacetime_.ask_start(); }
  void ask(double from, double to) override {
    if (!open() && result().free_until <= from) return;
    if (spacetime_.try_ask(from, to, first_effort * looks_per_event) && decided(spacetime_)) return;
    if (!kinetic_) {
      const PairResult& known = spacetime_.result();
      kinetic_ = std::make_unique<KineticPair>(world_, known.a, known.b, inwards_, budget_);
    }
    for (std::uint64_t effort = first_effort;; effort *= 2) {
      const bool kinetic_done = kinetic_->work(from, to, effort);
      if (kinetic_done && decided(*kinetic_)) break;
      const bool spacetime_done = spacetime_.try_ask(from, to, 2 * effort * looks_per_event);
      if (spacetime_done && decided(spacetime_)) return;
      if (kinetic_done && spacetime_done) break;
    }
    // It is the kinetic engine's, unless limits stopped both and the other one went further.
    by_kinetic_ = decided(*kinetic_) || kinetic_->result().free_until >= spacetime_.result().free_until;
  }
  const PairResult& result() const override { return by_kinetic_ ? kinetic_->result() : spacetime_.result(); }
  std::optional<ContactInstant> instant() const override {
    return by_kinetic_ ? kinetic_->instant() : spacetime_.instant();
  }
  bool doubles_sufficed() const override {
    return spacetime_.doubles_sufficed() && (!kinetic_ || kinetic_->doubles_sufficed());
  }
  KineticCounts counts() const override { return kinetic_ ? kinetic_->counts() : KineticCounts(); }

 private:
  /// As for two polygons: see either_run.cpp.
  static constexpr std::uint64_t first_effort = 1024, looks_per_event = 8;

  static bool decided(const WindowedPair& pair) { return pair.result().outcome != Outcome::undecided; }

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
