#include "chosen_body.hpp"

#include <fmt/format.h>

#include "scene/names.hpp"
#include "taut/error.hpp"

namespace taut::cli {
namespace {

bool moves(const Body& body) { return !body.motion.pieces.empty() || !body.relative_to.empty(); }

std::string all_bodies(const Scene& scene) {
  std::string all;
  for (const Body& body : scene.bodies) all += (all.empty() ? "\"" : ", \"") + body.name + "\"";
  return all;
}

}  // namespace

BodyId chosen_body(const Scene& scene, const std::string& name) {
  BodyId found = -1;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    if (name.empty() ? !moves(body) : body.name != name) continue;
    if (found >= 0)
      throw InputError("--body", fmt::format("several bodies move: {} and {}", scene.bodies[found].name, body.name),
                       "say which one is meant: --body NAME");
    found = static_cast<BodyId>(k);
  }
  if (found >= 0) return found;
  if (name.empty() && scene.bodies.size() == 1) return 0;
  const std::string hint = "the scene has " + all_bodies(scene);
  if (name.empty()) throw InputError("--body", "no body moves", hint);
  throw internal::no_such_body(internal::names_of(scene.bodies), name, "--body", "", hint);
}

}  // namespace taut::cli
