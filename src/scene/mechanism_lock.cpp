#include "scene/mechanism_lock.hpp"

#include <fmt/format.h>

#include "scene/mechanism.hpp"

namespace taut::internal {
namespace {

bool is_undecided(const Scene& scene) { return scene.lock && scene.lock->kind == MechanismLock::Kind::undecided; }

std::string why_undecided(const Scene& scene) {
  std::string links;
  for (const std::string& link : scene.lock->links) links += (links.empty() ? "" : ", ") + link;
  return fmt::format(
      "after t = {}, links of the mechanism are so near to a line that it is not decided how it goes on ({}); nothing "
      "is "
      "said of later times",
      scene.lock->time[0], links);
}

}  // namespace

bool ends_at_lock(const Scene& scene) {
  // Not a part of the scene's time that ends before.
  return scene.lock && scene.end == scene.assembly->end && scene.end < scene.assembly->asked_end;
}

double given_end(const Scene& scene) { return ends_at_lock(scene) ? scene.assembly->asked_end : scene.end; }

void note_lock(const Scene& scene, Outcome& outcome, std::string& reason) {
  if (outcome != Outcome::free || !ends_at_lock(scene)) return;
  outcome = Outcome::locked;
  note_undecided_lock(scene, outcome, reason);
}

void note_undecided_lock(const Scene& scene, Outcome& outcome, std::string& reason) {
  if (!ends_at_lock(scene) || !is_undecided(scene) || outcome == Outcome::untested || outcome == Outcome::undecided)
    return;
  outcome = Outcome::undecided;
  reason = why_undecided(scene);
}

}  // namespace taut::internal
