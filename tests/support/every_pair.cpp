#include "support/every_pair.hpp"

#include <algorithm>

#include "scene/instance.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// A body whose parts are on different layers has several cross-sections.
bool asked_in_scene(const Instance& instance, BodyId a, BodyId b) {
  const std::vector<int> of_b = instance.sections(b);
  for (const int section : instance.sections(a)) {
    if (std::any_of(of_b.begin(), of_b.end(), [&](int other) { return instance.asked(section, other); })) return true;
  }
  return false;
}

}  // namespace

std::vector<PairAnswer> every_pair(const Scene& scene, const Answer& answer) {
  const Instance instance(scene);
  std::vector<PairAnswer> all;
  const int n = static_cast<int>(scene.bodies.size());
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      if (!asked_in_scene(instance, a, b)) continue;
      const std::array<BodyId, 2> bodies{a, b};
      const auto listed = std::find_if(answer.pairs->begin(), answer.pairs->end(),
                                       [&](const PairAnswer& pair) { return pair.bodies == bodies; });
      all.push_back(listed != answer.pairs->end() ? *listed : PairAnswer{bodies, Outcome::free, {}, scene.end, {}});
    }
  }
  return all;
}

}  // namespace taut::testing
