#include "chosen_body.hpp"

#include <fmt/format.h>

#include "taut/error.hpp"

namespace taut::cli {
namespace {

bool moves(const Body& body) { return !body.motion.pieces.empty() || !body.relative_to.empty(); }

}  // namespace

BodyId chosen_body(const Scene& scene, const std::string& name) {
  BodyId found = -1;
  std::string names;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    names += (names.empty() ? "" : ", ") + body.name;
    if (name.empty() ? !moves(body) : body.name != name) continue;
    if (found >= 0)
      throw InputError("--body", fmt::format("several bodies move: {} and {}", scene.bodies[found].name, body.name),
                       "say which one is meant: --body NAME");
    found = static_cast<BodyId>(k);
  }
  if (found >= 0) return found;
  if (name.empty() && scene.bodies.size() == 1) return 0;
  throw InputError("--body", name.empty() ? "no body moves" : fmt::format("there is no body \"{}\"", name),
                   "the scene has " + names);
}

}  // namespace taut::cli
