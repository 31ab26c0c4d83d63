#include "chosen_body.hpp"

#include <fmt/format.h>

#include "io/json_object.hpp"
#include "taut/error.hpp"

namespace taut::cli {
namespace {

bool moves(const Body& body) { return !body.motion.pieces.empty() || !body.relative_to.empty(); }

/// What may be meant, and all that there are.
std::string names_of(const Scene& scene, const std::string& name) {
  std::vector<std::string> names;
  std::string all;
  for (const Body& body : scene.bodies) {
    names.push_back(body.name);
    all += (all.empty() ? "\"" : ", \"") + body.name + "\"";
  }
  const std::string near = internal::io::nearest_word(name, names);
  return (near.empty() ? "" : fmt::format("did you mean \"{}\"? ", near)) + "the scene has " + all;
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
  throw InputError("--body", name.empty() ? "no body moves" : fmt::format("there is no body \"{}\"", name),
                   names_of(scene, name));
}

}  // namespace taut::cli
