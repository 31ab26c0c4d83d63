#include "expectation.hpp"

#include <fmt/format.h>

#include "scene/mechanism_lock.hpp"
#include "taut/error.hpp"

namespace taut::cli {

void validate(const Expectation& expected, const Scene& scene) {
  if (expected.clearance && !(*expected.clearance > 0))
    throw InputError("--clearance", "it is not a positive number", "leave it out for a proof about contact");
  if (!expected.until) return;
  const double until = *expected.until;
  if (!(until >= scene.start && until <= scene.end)) {
    throw InputError("--until", fmt::format("{} is outside the scene's time [{}, {}]", until, scene.start, scene.end),
                     "choose an instant within");
  }
  if (until == scene.start && scene.start < scene.end)
    throw InputError("--until", fmt::format("no time passes before the start, {}", until), "choose a later instant");
}

bool is_met(const Expectation& expected, const Scene& scene, const Verified& proved) {
  if (expected.no_way) return false;
  if (expected.touch && *expected.touch != proved.touch) return false;
  const double wanted = expected.clearance.value_or(0);
  if (expected.outcome != Outcome::contact && proved.clearance < wanted) return false;
  if (!expected.outcome) return true;
  if (*expected.outcome == Outcome::contact) {
    if (proved.outcome != Outcome::contact || proved.clearance > wanted) return false;
    const TimeInterval& time = proved.closer ? proved.closer->time : proved.contact->time;
    return !(expected.until && *expected.until < time.hi);
  }
  if (proved.outcome == Outcome::free) return true;
  return expected.until && *expected.until <= proved.free_until && scene.start < proved.free_until;
}

bool is_met(const Expectation& expected, const VerifiedPath& proved) {
  if (expected.outcome || (expected.touch && *expected.touch != proved.touch)) return false;
  // Where no way keeps a distance, none keeps a larger one.
  return proved.clearance <= expected.clearance.value_or(0);
}

std::string text_of(const Expectation& expected, const Scene& scene) {
  std::string text;
  if (expected.no_way) text = "no way from the start to the goal";
  if (expected.outcome == Outcome::free) {
    text = expected.until ? fmt::format("free on [{}, {})", scene.start, *expected.until)
                          : fmt::format("free on [{}, {}]", scene.start, internal::given_end(scene));
  } else if (expected.outcome) {
    text = expected.until ? fmt::format("a contact by t = {}", *expected.until) : "a contact";
  }
  if (expected.clearance) text += fmt::format("{}clearance {}", text.empty() ? "" : ", ", *expected.clearance);
  if (expected.touch) text += std::string(text.empty() ? "" : ", ") + "touch " + to_string(*expected.touch);
  return text;
}

}  // namespace taut::cli
