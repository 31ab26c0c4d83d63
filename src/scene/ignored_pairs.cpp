#include "scene/ignored_pairs.hpp"

#include <algorithm>

namespace taut::internal {

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
