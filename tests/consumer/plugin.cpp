#include <taut/taut.hpp>

// As a scripting language would call it: one scene in, one answer out, and no exception passes.
extern "C" int consumer_check(const char* scene) {
  try {
    return static_cast<int>(taut::check(taut::parse_scene(scene)).outcome);
  } catch (const taut::Error&) {
    return -1;
  }
}
