#include "proof/path_bodies.hpp"

#include <algorithm>

#include "scene/ring_set.hpp"

namespace taut::internal::proof {

PathBodies::PathBodies(const PathProblem& problem) : problem_(problem), ignored_(problem.linkage.scene) {
  const std::vector<Body>& bodies = problem.linkage.scene.bodies;
  const std::map<std::string, int> by_name = bodies_by_name(problem.linkage.scene);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    BodyShape shape;
    for (const Part& part : parts_of(bodies[i])) {
      shape.parts.push_back({{part.outline}, part.z.value_or(bodies[i].z)});
      shape.parts.back().rings.insert(shape.parts.back().rings.end(), part.holes.begin(), part.holes.end());
    }
    for (int body = static_cast<int>(i);; body = by_name.at(bodies[static_cast<std::size_t>(body)].relative_to)) {
      shape.chain.push_back(body);
      if (bodies[static_cast<std::size_t>(body)].relative_to.empty()) break;
    }
    bodies_.push_back(std::move(shape));
  }
}

bool PathBodies::moves(int body) const {
  const auto& motions = problem_.linkage.motions;
  return static_cast<std::size_t>(body) < motions.size() && motions[static_cast<std::size_t>(body)].has_value();
}

bool PathBodies::is_tested(std::uint32_t a, std::uint32_t b) const {
  if (a >= bodies_.size() || b >= bodies_.size() || a == b) return false;
  if (ignored_.has(static_cast<int>(a), static_cast<int>(b))) return false;
  const std::vector<int>&first = bodies_[a].chain, &second = bodies_[b].chain;
  const auto moves_apart = [&](const std::vector<int>& own, const std::vector<int>& other) {
    return std::any_of(own.begin(), own.end(), [&](int body) {
      return moves(body) && std::find(other.begin(), other.end(), body) == other.end();
    });
  };
  return moves_apart(first, second) || moves_apart(second, first);
}

bool PathBodies::is_moved(const BodyShape& body) const {
  return std::any_of(body.chain.begin(), body.chain.end(), [&](int one) { return moves(one); });
}

}  // namespace taut::internal::proof
