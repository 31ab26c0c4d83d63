// Two engines in turn. Each is far ahead of the other on some motions, and nobody knows beforehand on which.
#include <algorithm>
#include <memory>

#include "base/turns.hpp"
#include "check/run.hpp"

namespace taut {
namespace {

/// What the kinetic engine needs for each vertex before anything moves.
constexpr std::uint64_t building = 10;

std::uint64_t work_to_build(const Scene& scene) {
  std::uint64_t vertices = 0;
  for (const Body& body : scene.bodies) {
    if (!body.prepared) vertices += body.polygon.size();
  }
  return building * vertices;
}

/// One of the engines, and what it has done.
class Entrant {
 public:
  Entrant(EngineName engine, const Scene& scene, const CheckOptions& options)
      : engine_(engine), scene_(scene), options_(options) {}

  void begin() {
    effort_.begin([&] {
      run_ = engine_ == EngineName::kinetic ? begin_kinetic(scene_, options_) : begin_spacetime(scene_, options_);
    });
  }
  TurnEnd work(std::uint64_t effort) {
    if (!run_->work(effort)) return TurnEnd::open;
    return run_->answer().outcome == Outcome::undecided ? TurnEnd::given_up : TurnEnd::decided;
  }
  bool decides_by(std::uint64_t total) {
    return effort_.work_until(total, [this](std::uint64_t effort) { return work(effort); }) == TurnEnd::decided;
  }
  EngineName engine() const { return engine_; }
  const Run& run() const { return *run_; }
  Contestant& effort() { return effort_; }

 private:
  EngineName engine_;
  const Scene& scene_;
  const CheckOptions& options_;
  std::unique_ptr<Run> run_;
  Contestant effort_;
};

/// The engine that begins, and how much more it may do before the other one does.
struct Lead {
  EngineName engine;
  std::uint64_t work;
};

Answer answer_in_turns(const Scene& scene, const CheckOptions& options, const Lead& lead) {
  const bool kinetic_first = lead.engine == EngineName::kinetic;
  Entrant first(lead.engine, scene, options);
  Entrant second(kinetic_first ? EngineName::spacetime : EngineName::kinetic, scene, options);
  // Touching asks the same once more, for which the same engine is the better one, as a rule.
  const auto finished = [&](Entrant& winner) {
    const Lead next{winner.engine(), winner.effort().spent() + winner.effort().spent() / 2};
    const auto again = [&next](const Scene& s, const CheckOptions& o) { return answer_in_turns(s, o, next); };
    return with_touching(winner.run(), scene, options, again);
  };
  first.begin();
  if (first.decides_by(first.effort().spent() + lead.work)) return finished(first);
  second.begin();
  const auto by_first = [&](std::uint64_t effort) { return first.work(effort); };
  const auto by_second = [&](std::uint64_t effort) { return second.work(effort); };
  const int decided = take_turns(second.effort(), by_second, first.effort(), by_first);
  if (decided != 0) return finished(decided == 1 ? second : first);
  // Limits stopped both: what the one has proved free that went further.
  const Answer &a = first.run().answer(), &b = second.run().answer();
  if (a.free_until == b.free_until) return kinetic_first ? a : b;
  return a.free_until > b.free_until ? a : b;
}

}  // namespace

Answer run_either(const Scene& scene, const CheckOptions& options) {
  const std::uint64_t work = std::max(Contestant::first_turn, work_to_build(scene));
  return answer_in_turns(scene, options, {EngineName::spacetime, work});
}

}  // namespace taut
