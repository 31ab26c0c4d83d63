// taut gen KIND: the generators with their options.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "generators/generators.hpp"
#include "scene_argument.hpp"
#include "taut/io.hpp"

namespace taut::cli {

namespace {

/// What every kind has: -n, --hit, -o.
struct GenArguments {
  std::optional<int> vertices;
  std::string output;
};

/// Adds the subcommand of one kind. `make(options, n)` gets -n if given, else no value.
template <class Options, class Make>
Command add_kind(const Command& gen, Action& action, const std::string& name, const std::string& what,
                 const std::string& hit_text, const std::shared_ptr<Options>& options, Make make) {
  const Command kind = gen.add_command(name, what);
  const auto arguments = std::make_shared<GenArguments>();
  kind.add_option("-n", arguments->vertices, "about this many vertices in each polygon").value("N").within(3, 20000000);
  kind.add_flag("--hit", options->hit, hit_text);
  kind.add_option("-o,--output", arguments->output, "write to FILE instead of standard output").value("FILE");
  kind.footer(fmt::format("Example:\n  taut gen {} -n 200 -o {}.json\n", name, name));
  kind.on_chosen([&action, arguments, options, make] {
    action = [arguments, options, make] {
      write_output(arguments->output, write_scene(make(*options, arguments->vertices)));
      return static_cast<int>(exit_free);
    };
  });
  return kind;
}

void add_gears(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::GearOptions>();
  const Command kind = add_kind(gen, action, "gears", "two meshing involute gears", "one tooth is too thick", o,
                                [](gen::GearOptions options, std::optional<int> n) {
                                  if (n) options.flank_points = std::max(2, (*n / options.teeth_1 - 2) / 2);
                                  return gen::make_gears(options);
                                });
  kind.add_option("--teeth1", o->teeth_1, "teeth of the first gear (17)").value("N");
  kind.add_option("--teeth2", o->teeth_2, "teeth of the second gear (23)").value("N");
  kind.add_option("--module", o->module, "pitch diameter per tooth (1)").value("M");
  kind.add_option("--pressure-angle", o->pressure_angle_deg, "in degrees (20)").value("A");
  kind.add_option("--backlash", o->backlash, "along the pitch circle, in modules (0.06)").value("B");
  kind.add_option("--flank-points", o->flank_points, "vertices per flank (6)").value("N");
  kind.add_option("--turns", o->turns, "revolutions of the first gear (1)").value("R");
}

void add_planetary(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::PlanetaryOptions>();
  const Command kind =
      add_kind(gen, action, "planetary", "a planetary gear: sun, planets on a carrier, ring",
               "one space of the ring is too narrow", o, [](gen::PlanetaryOptions options, std::optional<int> n) {
                 if (n) options.flank_points = std::max(2, (*n / options.planet - 2) / 2);
                 return gen::make_planetary(options);
               });
  kind.add_option("--sun", o->sun, "teeth of the sun (18)").value("N");
  kind.add_option("--planet", o->planet, "teeth of each planet (18)").value("N");
  kind.add_option("--planets", o->planets, "how many planets (3)").value("N");
  kind.add_option("--module", o->module, "pitch diameter per tooth (1)").value("M");
  kind.add_option("--backlash", o->backlash, "along the pitch circle, in modules (0.1)").value("B");
  kind.add_option("--flank-points", o->flank_points, "vertices per flank (4)").value("N");
  kind.add_option("--turns", o->turns, "revolutions of the sun (1)").value("R");
}

void add_combs(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::CombOptions>();
  const Command kind =
      add_kind(gen, action, "combs", "interlocked combs, sliding, then pulled out",
               "the combs swing wider than their play", o, [](gen::CombOptions options, std::optional<int> n) {
                 if (n) options.teeth = std::max(1, (*n - 2) / 4);
                 return gen::make_combs(options);
               });
  kind.add_option("--teeth", o->teeth, "teeth of either comb (12)").value("N");
  kind.add_option("--swings", o->swings, "degree of the oscillation, at most 16 (4)").value("N");
}

void add_lock(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::LockOptions>();
  const Command kind = add_kind(gen, action, "lock", "a stepped key slides into its lock", "the key is the wrong one",
                                o, [](gen::LockOptions options, std::optional<int> n) {
                                  if (n) options.steps = std::max(1, (*n - 6) / 2);
                                  return gen::make_lock(options);
                                });
  kind.add_option("--steps", o->steps, "steps of the key (10)").value("N");
  kind.add_option("--clearance", o->clearance, "gap around the key (0.05)").value("C");
  kind.add_option("--seed", o->seed, "of the random steps (1)").value("S");
}

void add_jigsaw(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::JigsawOptions>();
  const Command kind =
      add_kind(gen, action, "jigsaw", "two pieces with knobs are pulled apart", "the knobs have necks and are caught",
               o, [](gen::JigsawOptions options, std::optional<int> n) {
                 if (n) options.knobs = std::max(1, (*n - 4) / options.knob_points);
                 return gen::make_jigsaw(options);
               });
  kind.add_option("--knobs", o->knobs, "knobs on the seam (3)").value("N");
  kind.add_option("--knob-points", o->knob_points, "vertices per knob (12)").value("N");
  kind.add_option("--clearance", o->clearance, "gap along the seam (0.04)").value("C");
}

void add_dips(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::DipOptions>();
  const Command kind = add_kind(gen, action, "dips", "a regular polygon dips into a cup (the paper's Fig. 16)",
                                "it hits the bottom", o, [](gen::DipOptions options, std::optional<int> n) {
                                  if (n) options.sides = *n;
                                  return gen::make_dips(options);
                                });
  kind.add_option("--sides", o->sides, "of the regular polygon (64)").value("N");
  kind.add_option("--dips", o->dips, "how often it dips in, at most 8 (4)").value("K");
}

void add_rotor(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::RotorOptions>();
  const Command kind = add_kind(gen, action, "rotor", "a toothed rotor near a flat chain (the paper's Fig. 17)",
                                "one tooth is too long", o, [](gen::RotorOptions options, std::optional<int> n) {
                                  if (n) options.teeth = std::max(3, *n / 2);
                                  if (n) options.chain_edges = std::max(2, *n - 8);
                                  return gen::make_rotor(options);
                                });
  kind.add_option("--teeth", o->teeth, "of the rotor (24)").value("N");
  kind.add_option("--chain-edges", o->chain_edges, "edges of the chain (24)").value("N");
  kind.add_option("--turns", o->turns, "revolutions (1)").value("R");
}

void add_spiral(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::SpiralOptions>();
  const Command kind = add_kind(gen, action, "spiral", "a spiral is screwed along the groove of another",
                                "it is screwed too far", o, [](gen::SpiralOptions options, std::optional<int> n) {
                                  if (n) {
                                    options.side_points = std::max(12, *n / 2);
                                    // As many turns as so many vertices can show without touching.
                                    options.turns = 0.95 * std::pow((options.side_points - 4) / 18.0, 2.0 / 3.0);
                                  }
                                  return gen::make_spiral(options);
                                });
  kind.add_option("--turns", o->turns, "of the spiral (2)").value("R");
  kind.add_option("--side-points", o->side_points, "vertices along either side (64)").value("N");
}

void add_maze(const Command& gen, Action& action) {
  const auto o = std::make_shared<gen::MazeOptions>();
  const Command kind = add_kind(gen, action, "maze", "a small ship drives through a serpentine corridor",
                                "the ship is too long to turn", o, [](gen::MazeOptions options, std::optional<int> n) {
                                  if (n) options.passes = std::max(1, (*n - 4) / 4);
                                  return gen::make_maze(options);
                                });
  kind.add_option("--passes", o->passes, "of the corridor (12)").value("N");
  kind.add_option("--ship-points", o->ship_points, "vertices of the ship (12)").value("N");
  kind.add_option("--seed", o->seed, "of the passes' lengths; 0: all alike (1)").value("S");
}

}  // namespace

void add_gen(const Command& app, Action& action) {
  const Command gen = app.add_command("gen", "Write an example scene");
  gen.hide();  // of interest to those who measure; `taut --help` is to fit a screen
  gen.require_command();
  gen.footer(
      "Example:\n"
      "  taut gen gears --teeth1 19 --teeth2 31 -o gears.json\n"
      "\n"
      "Every scene is free of contact, or has one with --hit. `taut gen KIND --help` lists each kind's options.\n");
  add_gears(gen, action);
  add_planetary(gen, action);
  add_combs(gen, action);
  add_lock(gen, action);
  add_jigsaw(gen, action);
  add_dips(gen, action);
  add_rotor(gen, action);
  add_spiral(gen, action);
  add_maze(gen, action);
}

}  // namespace taut::cli
