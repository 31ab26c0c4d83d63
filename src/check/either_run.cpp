// Two engines in turn. Each is far ahead of the other on some motions, and nobody knows beforehand on which.
#include <algorithm>
#include <memory>

#include "base/turns.hpp"
#include "check/run.hpp"

namespace taut {
namespace {

/// What the kinetic engine needs for each vertex before anything moves.
constexpr std::uint64_t building = 10;

TurnEnd turn(Run& run, std::uint64_t effort) {
  if (!run.work(effort)) return TurnEnd::open;
  return run.answer().outcome == Outcome::undecided ? TurnEnd::given_up : TurnEnd::decided;
}

std::uint64_t work_to_build(const Scene& scene) {
  std::uint64_t vertices = 0;
  for (const Body& body : scene.bodies) {
    if (!body.prepared) vertices += body.polygon.size();
  }
  return building * vertices;
}

}  // namespace

Answer run_either(const Scene& scene, const CheckOptions& options) {
  const auto finished = [&](const Run& run) { return with_touching(run, scene, options, run_either); };
  std::unique_ptr<Run> spacetime, kinetic;
  Contestant by_boxes, by_tiling;
  const auto in_boxes = [&](std::uint64_t effort) { return turn(*spacetime, effort); };
  const auto in_tiling = [&](std::uint64_t effort) { return turn(*kinetic, effort); };
  by_boxes.begin([&] { spacetime = begin_spacetime(scene, options); });
  const std::uint64_t first = by_boxes.spent() + std::max(Contestant::first_turn, work_to_build(scene));
  if (by_boxes.work_until(first, in_boxes) == TurnEnd::decided) return finished(*spacetime);
  by_tiling.begin([&] { kinetic = begin_kinetic(scene, options); });
  const int decided = take_turns(by_tiling, in_tiling, by_boxes, in_boxes);
  if (decided != 0) return finished(decided == 1 ? *kinetic : *spacetime);
  // Limits stopped both: what the one has proved free that went further.
  return kinetic->answer().free_until >= spacetime->answer().free_until ? kinetic->answer() : spacetime->answer();
}

}  // namespace taut
