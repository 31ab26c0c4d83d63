// Scenes with exact logs, and scenes as they were read, as JSON lines, for the checker that is proved (formal/test.py).
// `taut_exact_logs random COUNT`: {"scene", "outcome", "until", "pairs", "log"} of so many random scenes; the log is
// null where there is none. `taut_exact_logs read FILE...`: {"file", "scene"}, with motions as polynomials.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>

#include "support/layered.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "support/small_world.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

Scene exact_scene_number(std::uint64_t number) {
  Rng rng(number);
  if (number % 2 == 0) return scene_of(soak_world(number).world);
  SceneOptions options;
  options.grid = rng.chance(0.3);
  return random_scene(number, all_families[rng.below(static_cast<int>(std::size(all_families)))], options);
}

void print_exact_log(const Scene& scene) {
  CheckOptions options;
  options.limits.max_seconds = 5;
  std::ostringstream log;
  const Answer answer = prove_exact(scene, log, options);
  // What the engines say of the same scene, for claims of damaged logs.
  options.touch = Touch::closed;
  const Answer known = check(scene, options);
  const double until = known.outcome == Outcome::free ? scene.end
                       : known.contact                ? known.contact->time.hi
                                                      : known.free_until;
  fmt::print("{{\"scene\":{},\"outcome\":\"{}\",\"known\":\"{}\",\"until\":{},\"pairs\":{},\"log\":{}}}\n",
             on_one_line(write_scene(scene)), to_string(answer.outcome), to_string(known.outcome), until,
             known.coverage.tested + known.coverage.apart, log.str().empty() ? "null" : on_one_line(log.str()));
}

}  // namespace
}  // namespace taut::testing

int main(int argc, char** argv) {
  const std::string mode = argc > 2 ? argv[1] : "";
  if (mode == "random") {
    const std::uint64_t count = std::strtoull(argv[2], nullptr, 10);
    for (std::uint64_t k = 1; k <= count; ++k) taut::testing::print_exact_log(taut::testing::exact_scene_number(k));
    return 0;
  }
  if (mode != "read") return 2;
  for (int k = 2; k < argc; ++k) {
    try {
      const taut::Scene scene = taut::read_scene(argv[k]);
      fmt::print("{{\"file\":\"{}\",\"scene\":{}}}\n", argv[k], taut::testing::on_one_line(taut::write_scene(scene)));
    } catch (const taut::Error&) {
      // No scene: not for this comparison.
    }
  }
  return 0;
}
