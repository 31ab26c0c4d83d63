// Two engines in turn. Each is far ahead of the other on some motions, and nobody knows beforehand on which.
#include <algorithm>
#include <memory>

#include "base/interruption.hpp"
#include "check/run.hpp"

namespace taut {
namespace {

/// The spacetime engine's first turn: as long as a small question takes.
constexpr std::uint64_t first_turn = 256;
/// By how much an engine may be ahead of the other in work: so an answer costs about so many times and once more what
/// the better one takes alone.
constexpr double lead = 1.25;
/// What the kinetic engine needs for each vertex before anything moves.
constexpr std::uint64_t building = 10;

bool decided(const Run& run) { return run.answer().outcome != Outcome::undecided; }

/// An engine, and the work that it has done.
class Contestant {
 public:
  template <class Begin>
  explicit Contestant(const Begin& begin) {
    const std::uint64_t before = work_spent();
    run_ = begin();
    spent_ = work_spent() - before;
  }
  /// Until its work in all is so much; true if there is an answer.
  bool work_until(std::uint64_t total) {
    if (done_ || total <= spent_) return false;
    const std::uint64_t before = work_spent();
    done_ = run_->work(total - spent_);
    spent_ += work_spent() - before;
    return done_ && decided(*run_);
  }
  /// The other one's share is this one's work and what it may be ahead.
  std::uint64_t for_other() const {
    return static_cast<std::uint64_t>(lead * static_cast<double>(spent_)) + first_turn;
  }
  bool done() const { return done_; }
  std::uint64_t spent() const { return spent_; }
  const Run& run() const { return *run_; }

 private:
  std::unique_ptr<Run> run_;
  std::uint64_t spent_ = 0;
  bool done_ = false;
};

std::uint64_t work_to_build(const Scene& scene) {
  std::uint64_t vertices = 0;
  for (const Body& body : scene.bodies) {
    if (!body.prepared) vertices += body.polygon.size();
  }
  return building * vertices;
}

}  // namespace

Answer run_either(const Scene& scene, const CheckOptions& options) {
  const auto finished = [&](const Contestant& c) { return with_touching(c.run(), scene, options, run_either); };
  Contestant spacetime([&] { return begin_spacetime(scene, options); });
  if (spacetime.work_until(spacetime.spent() + std::max(first_turn, work_to_build(scene)))) return finished(spacetime);
  Contestant kinetic([&] { return begin_kinetic(scene, options); });
  for (;;) {
    if (kinetic.work_until(spacetime.done() ? UINT64_MAX : spacetime.for_other())) return finished(kinetic);
    if (spacetime.work_until(kinetic.done() ? UINT64_MAX : kinetic.for_other())) return finished(spacetime);
    if (!kinetic.done() || !spacetime.done()) continue;
    // Limits stopped both: what the one has proved free that went further.
    const Answer &a = kinetic.run().answer(), &b = spacetime.run().answer();
    return a.free_until >= b.free_until ? a : b;
  }
}

}  // namespace taut
