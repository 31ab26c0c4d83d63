#include "scene/untested.hpp"

#include <algorithm>

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

std::map<std::string, int> bodies_by_name(const Scene& scene) {
  std::map<std::string, int> by_name;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) by_name.emplace(scene.bodies[i].name, static_cast<int>(i));
  return by_name;
}

IgnoredPairs::IgnoredPairs(const Scene& scene) : all_(scene.bodies.size(), false) {
  if (scene.ignore.empty()) return;
  const std::map<std::string, int> by_name = bodies_by_name(scene);
  for (const auto& [first, second] : scene.ignore) {
    if (first == "*" && second == "*") {
      everything_ = true;
      all_.assign(all_.size(), true);
    } else if (first == "*" || second == "*") {
      all_[static_cast<std::size_t>(by_name.at(first == "*" ? second : first))] = true;
    } else {
      const int a = by_name.at(first), b = by_name.at(second);
      if (a != b) pairs_.emplace_back(std::min(a, b), std::max(a, b));
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
}

bool IgnoredPairs::names(int body) const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [body](const auto& p) { return p.first == body || p.second == body; });
}

void IgnoredPairs::add(int a, int b) {
  const std::pair<int, int> pair(std::min(a, b), std::max(a, b));
  const auto place = std::lower_bound(pairs_.begin(), pairs_.end(), pair);
  if (a != b && (place == pairs_.end() || *place != pair)) pairs_.insert(place, pair);
}

bool IgnoredPairs::has(int a, int b) const {
  if (has_all(a) || has_all(b)) return true;
  return !pairs_.empty() && std::binary_search(pairs_.begin(), pairs_.end(), std::pair(std::min(a, b), std::max(a, b)));
}

std::uint64_t IgnoredPairs::count() const {
  const auto pairs_of = [](std::uint64_t n) { return n < 2 ? 0 : n * (n - 1) / 2; };
  const std::uint64_t n = all_.size();
  const auto single = std::count_if(pairs_.begin(), pairs_.end(),
                                    [&](const auto& pair) { return !has_all(pair.first) && !has_all(pair.second); });
  const auto listening = std::count(all_.begin(), all_.end(), false);
  return pairs_of(n) - pairs_of(static_cast<std::uint64_t>(listening)) + static_cast<std::uint64_t>(single);
}

}  // namespace taut::internal
