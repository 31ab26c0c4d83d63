#include "scene/untested.hpp"

#include <algorithm>

#include "scene/ignored_pairs.hpp"
#include "scene/validate_scene.hpp"

namespace taut::internal {
namespace {

std::string counted(std::uint64_t count, const char* what) {
  return std::to_string(count) + (count == 1 ? " is " : " are ") + what;
}

}  // namespace

std::string why_untested(const Coverage& c) {
  if (c.pairs == 0) return "nothing was tested: the scene has one body; add another one";
  const std::string pairs = c.pairs == 1 ? "the only pair" : "of " + std::to_string(c.pairs) + " pairs";
  const std::string start = "nothing was tested: " + pairs;
  if (c.ignored == c.pairs)
    return start + (c.pairs == 1 ? " is ignored" : " all are ignored") + R"(; take a pair out of "ignore")";
  if (c.layers == c.pairs)
    return start + (c.pairs == 1 ? " is" : " all are") +
           R"( on different layers; give bodies a layer in common, by their "z")";
  std::string parts;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) parts += (parts.empty() ? " " : ", ") + counted(count, what);
  };
  add(c.ignored, "ignored");
  add(c.at_rest, "at rest");
  add(c.moving_alike, "moving alike");
  add(c.layers, "on different layers");
  if (c.ignored + c.layers == c.pairs)
    return start + parts + R"(; give bodies a layer in common, by their "z", or take pairs out of "ignore")";
  return start + parts + R"(; take pairs out of "ignore", or test those at rest with "at_rest": "test")";
}

std::string untested_note(const Coverage& c) {
  if (c.untested() == 0) return c.pairs == 0 ? "; nothing was tested" : "";
  if (c.untested() == c.pairs) return "; nothing was tested";
  return "; " + std::to_string(c.untested()) + (c.untested() == 1 ? " pair" : " pairs") + " not tested";
}

Coverage coverage_before_search(const Scene& scene) {
  validate_ignored(scene);
  Coverage coverage;
  const std::uint64_t n = scene.bodies.size();
  coverage.pairs = n < 2 ? 0 : n * (n - 1) / 2;
  coverage.ignored = IgnoredPairs(scene).count();
  coverage.not_reached = coverage.pairs - coverage.ignored;
  return coverage;
}

Coverage coverage_when_stopped(Coverage c, std::uint64_t tested) {
  const std::uint64_t asked = c.tested + c.apart + c.not_reached;
  c.tested = std::min(tested, asked);
  c.apart = 0;
  c.not_reached = asked - c.tested;
  return c;
}

}  // namespace taut::internal
