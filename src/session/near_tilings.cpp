// The tilings of the pairs of a world that are near at an instant, to be drawn.
#include <algorithm>
#include <numeric>
#include <utility>

#include "scene/meeting_boxes.hpp"
#include "scene/validate_scene.hpp"
#include "solver/kinetic_solver.hpp"
#include "taut/error.hpp"
#include "taut/simulation.hpp"

namespace taut::internal {
namespace {

/// Of the scene's time: so soon do the boxes of near bodies meet, and so long before do bodies that touch stand apart.
constexpr double share_that_is_near = 0x1p-4, share_before_touching = 0x1p-20;

/// The rest of a scene, or a little of it.
Scene from_there(const Scene& scene, double t) {
  Scene rest = scene;
  rest.start = t;
  rest.end = std::min(scene.end, t + share_that_is_near * (scene.end - scene.start));
  return rest;
}

std::vector<std::pair<int, int>> near_pairs(const Instance& instance) {
  std::vector<int> bodies(instance.bodies().size());
  std::iota(bodies.begin(), bodies.end(), 0);
  std::vector<std::pair<int, int>> pairs;
  if (instance.is_single_pair()) {
    if (!instance.excluded(0, 1)) pairs.emplace_back(0, 1);
    return pairs;
  }
  MeetingBoxes(instance, bodies, instance.start(), instance.end()).each([&](int a, int b, bool) {
    pairs.emplace_back(a, b);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// None where they overlap, or it was not decided.
std::vector<NearTiling> tilings_at_start(const Instance& instance, const std::pair<int, int>& pair, Offset offset) {
  EventBudget budget(UINT64_MAX);
  KineticSolver near(instance, pair.first, pair.second, offset, budget);
  near.ask_start();
  return near.tilings();
}

}  // namespace

}  // namespace taut::internal

namespace taut {
using namespace internal;

std::vector<NearTiling> tilings_of_near_pairs(const Scene& scene, double t, Touch touch) {
  if (!(t >= scene.start && t <= scene.end))
    throw InputError("t", "the instant is outside of the scene's time", "choose one within");
  const Offset offset = offset_for(touch);
  const Instance instance(from_there(scene, t));
  std::vector<NearTiling> all;
  for (const std::pair<int, int>& pair : near_pairs(instance)) {
    std::vector<NearTiling> own = tilings_at_start(instance, pair, offset);
    const double before = t - share_before_touching * (scene.end - scene.start);
    if (own.empty() && before >= scene.start) own = tilings_at_start(Instance(from_there(scene, before)), pair, offset);
    std::move(own.begin(), own.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace taut
