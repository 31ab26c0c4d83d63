// The scene of two bodies and all their parents.
#include "query/curved_questions.hpp"

namespace taut::internal {

Scene scene_of_pair(const Scene& scene, const std::array<BodyId, 2>& pair, std::vector<BodyId>& ids) {
  std::vector<bool> kept(scene.bodies.size(), false);
  const auto keep = [&](BodyId id) {
    for (bool found = true; found;) {
      found = false;
      kept[static_cast<std::size_t>(id)] = true;
      const std::string& parent = scene.bodies[static_cast<std::size_t>(id)].relative_to;
      for (std::size_t k = 0; k < scene.bodies.size() && !found && !parent.empty(); ++k) {
        found = scene.bodies[k].name == parent && !kept[k];
        if (found) id = static_cast<BodyId>(k);
      }
    }
  };
  keep(pair[0]);
  keep(pair[1]);
  Scene small;
  small.start = scene.start;
  small.end = scene.end;
  small.at_rest = AtRest::test;  // the pair may be one at rest
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    if (!kept[k]) continue;
    ids.push_back(static_cast<BodyId>(k));
    small.bodies.push_back(scene.bodies[k]);
    if (ids.back() != pair[0] && ids.back() != pair[1]) small.ignore.push_back({scene.bodies[k].name, "*"});
  }
  return small;
}

}  // namespace taut::internal
