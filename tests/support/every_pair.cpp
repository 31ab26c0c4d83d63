#include "support/every_pair.hpp"

#include <algorithm>

#include "scene/instance.hpp"

namespace taut::testing {
using namespace internal;

std::vector<PairAnswer> every_pair(const Scene& scene, const Answer& answer) {
  const Instance instance(scene);
  std::vector<PairAnswer> all;
  const int n = static_cast<int>(scene.bodies.size());
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      if (!instance.asked(a, b)) continue;
      const std::array<BodyId, 2> bodies{a, b};
      const auto listed = std::find_if(answer.pairs->begin(), answer.pairs->end(),
                                       [&](const PairAnswer& pair) { return pair.bodies == bodies; });
      all.push_back(listed != answer.pairs->end() ? *listed : PairAnswer{bodies, Outcome::free, {}, scene.end, {}});
    }
  }
  return all;
}

}  // namespace taut::testing
