#include "soak_scene.hpp"

#include <iterator>

#include "generators/generators.hpp"
#include "support/contact_scene.hpp"
#include "support/random_scenes.hpp"

namespace taut::testing {
namespace {

/// One of the generators of `taut gen`, small.
Scene generated(Rng& rng, std::string& family) {
  const bool hit = rng.chance(0.5);
  const std::uint64_t seed = rng.next() % 1000;
  switch (rng.below(8)) {
    case 0:
      family = "gears";
      return gen::make_gears({.teeth_1 = rng.between(8, 14),
                              .teeth_2 = rng.between(8, 14),
                              .flank_points = rng.between(2, 3),
                              .turns = rng.real(0.05, 0.2),
                              .hit = hit});
    case 1:
      family = "combs";
      return gen::make_combs({.teeth = rng.between(2, 8), .swings = rng.between(1, 8), .hit = hit});
    case 2:
      family = "lock";
      return gen::make_lock({.steps = rng.between(3, 12), .seed = seed, .hit = hit});
    case 3:
      family = "jigsaw";
      return gen::make_jigsaw({.knobs = rng.between(1, 3), .knob_points = rng.between(6, 10), .hit = hit});
    case 4:
      family = "dips";
      return gen::make_dips({.sides = rng.between(4, 40), .dips = rng.between(1, 8), .hit = hit});
    case 5:
      family = "rotor";
      return gen::make_rotor({.teeth = rng.between(4, 10), .chain_edges = rng.between(3, 10), .hit = hit});
    case 6:
      family = "spiral";
      return gen::make_spiral({.turns = rng.real(0.8, 2.5), .side_points = rng.between(80, 100), .hit = hit});
    default:
      family = "maze";
      return gen::make_maze({.passes = rng.between(2, 5), .ship_points = rng.between(4, 10), .seed = seed, .hit = hit});
  }
}

}  // namespace

SoakScene soak_scene(std::uint64_t number) {
  Rng rng(number * 0x9e3779b97f4a7c15u + 17);
  SoakScene s;
  s.touch = rng.chance(0.5) ? Touch::closed : Touch::open;
  s.injection = all_injections[rng.below(static_cast<int>(std::size(all_injections)))];
  if (rng.chance(0.1)) {
    s.scene = generated(rng, s.family);
  } else {
    const Family family = all_families[rng.below(static_cast<int>(std::size(all_families)))];
    s.family = to_string(family);
    SceneOptions options;
    options.grid = rng.chance(0.4);
    // Tangencies are made from straight ways.
    if (s.injection == Injection::tangency) options.kinds = {MotionKind::rest, MotionKind::linear};
    s.scene = random_scene(rng.next() % 1000000007, family, options);
  }
  s.scene = inject(rng, s.injection, s.scene);
  return s;
}

SoakScene soak_contact_scene(std::uint64_t number) {
  const ContactScene s = contact_scene(number);
  return {s.scene, s.family, Injection::none, s.touch};
}

}  // namespace taut::testing
