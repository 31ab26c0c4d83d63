// Small scenes, looked at from all sides: both engines, the static construction after every event, the proof, queries
// between events, and the same motion announced piece by piece, by changes of plan.
//
// The input is a scene file, so that the corpus can be the seed, and a finding can be shrunk and kept. Where the bytes
// are one, they are changed as a scene; otherwise a random scene takes their place.
#include <cstring>
#include <numeric>
#include <optional>

#include "examine.hpp"
#include "require.hpp"
#include "scene_mutator.hpp"
#include "support/random_scenes.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

using namespace taut;

namespace {

std::optional<Scene> read(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (text.find("wkt") != std::string::npos || text.find("geojson") != std::string::npos) return std::nullopt;
  try {
    Scene scene = parse_scene(text);
    if (scene.bodies.size() != 2) return std::nullopt;
    return scene;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool is_finite(const Scene& scene) {
  // Numbers that JSON cannot say would not survive being written.
  try {
    return parse_scene(write_scene(scene)).bodies.size() == 2;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::optional<Scene> scene = read(data, size);
  if (!scene || !fuzz::fits(*scene, {})) return 0;
  fuzz::Evaluations looks;
  // One of the two, by chance, and the same for the same input.
  looks.touch = {std::accumulate(data, data + size, 0u) % 2 ? Touch::closed : Touch::open};
  looks.max_events = 50;
  looks.max_seconds = 0.1;
  std::string report;
  const fuzz::Finding found = fuzz::examine(*scene, looks, &report);
  fuzz::require(!found.is_defect(), found.signature() + "\n" + found.message + "\n" + report);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  testing::Rng rng(seed);
  std::optional<Scene> scene = read(data, size);
  if (!scene || rng.chance(0.02)) {
    testing::SceneOptions options;
    options.grid = rng.chance(0.5);
    scene = testing::random_scene(rng.next() % 1000000, testing::all_families[rng.below(8)], options);
  }
  for (int k = rng.between(1, 4); k > 0; --k) scene = fuzz::mutated(rng, *scene, {});
  const std::string text = is_finite(*scene) ? write_scene(*scene) : std::string();
  if (text.empty() || text.size() > max_size) return size;
  std::memcpy(data, text.data(), text.size());
  return text.size();
}
