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
CLI::App* add_kind(CLI::App& gen, Action& action, const std::string& name, const std::string& what,
                   const std::string& hit_text, const std::shared_ptr<Options>& options, Make make) {
  CLI::App* kind = gen.add_subcommand(name, what);
  const auto arguments = std::make_shared<GenArguments>();
  kind->add_option("-n", arguments->vertices, "about this many vertices in each polygon")
      ->option_text("N")
      ->check(CLI::Range(3, 20000000));
  kind->add_flag("--hit", options->hit, hit_text);
  kind->add_option("-o,--output", arguments->output, "write to FILE instead of standard output")->option_text("FILE");
  kind->footer(fmt::format("Example:\n  taut gen {} -n 200 -o {}.json\n", name, name));
  kind->callback([&action, arguments, options, make] {
    action = [arguments, options, make] {
      write_output(arguments->output, write_scene(make(*options, arguments->vertices)));
      return static_cast<int>(exit_free);
    };
  });
  return kind;
}

void add_gears(CLI::App& gen, Action& action) {
  const auto o = std::make_shared<gen::GearOptions>();
  CLI::App* kind = add_kind(gen, action, "gears", "two meshing involute gears", "one tooth is too thick", o,
                            [](gen::GearOptions options, std::optional<int> n) {
                              if (n) options.flank_points = std::max(2, (*n / options.teeth_1 - 2) / 2);
                              return gen::make_gears(options);
                            });
  kind->add_option("--teeth1", o->teeth_1, "teeth of the first gear (17)")->option_text("N");
  kind->add_option("--teeth2", o->teeth_2, "teeth of the second gear (23)")->option_text("N");
  kind->add_option("--module", o->module, "pitch diameter per tooth (1)")->option_text("M");
  kind->add_option("--pressure-angle", o->pressure_angle_deg, "in degrees (20)")->option_text("A");
  kind->add_option("--backlash", o->backlash, "along the pitch circle, in modules (0.06)")->option_text("B");
  kind->add_option("--flank-points", o->flank_points, "vertices per flank (6)")->option_text("N");
  kind->add_option("--turns", o->turns, "revolutions of the first gear (1)")->option_text("R");
}

void add_combs(CLI::App& gen, Action& action) {
  const auto o = std::make_shared<gen::CombOptions>();
  CLI::App* kind =
      add_kind(gen, action, "combs", "interlocked combs, sliding, then pulled out",
               "the combs swing wider than their play", o, [](gen::CombOptions options, std::optional<int> n) {
                 if (n) options.teeth = std::max(1, (*n - 2) / 4);
                 return gen::make_combs(options);
               });
  kind->add_option("--teeth", o->teeth, "teeth of either comb (12)")->option_text("N");
  kind->add_option("--swings", o->swings, "degree of the oscillation, at most 16 (4)")->option_text("N");
}

void add_lock(CLI::App& gen, Action& action) {
  const auto o = std::make_shared<gen::LockOptions>();
  CLI::App* kind = add_kind(gen, action, "lock", "a stepped key slides into its lock", "the key is the wrong one", o,
                            [](gen::LockOptions options, std::optional<int> n) {
                              if (n) options.steps = std::max(1, (*n - 6) / 2);
                              return gen::make_lock(options);
                            });
  kind->add_option("--steps", o->steps, "steps of the key (10)")->option_text("N");
  kind->add_option("--clearance", o->clearance, "gap around the key (0.05)")->option_text("C");
  kind->add_option("--seed", o->seed, "of the random steps (1)")->option_text("S");
}

void add_jigsaw(CLI::App& gen, Action& action) {
  const auto o = std::make_shared<gen::JigsawOptions>();
  CLI::App* kind =
      add_kind(gen, action, "jigsaw", "two pieces with knobs are pulled apart", "the knobs have necks and are caught",
               o, [](gen::JigsawOptions options, std::optional<int> n) {
                 if (n) options.knobs = std::max(1, (*n - 4) / options.knob_points);
                 return gen::make_jigsaw(options);
               });
  kind->add_option("--knobs", o->knobs, "knobs on the seam (3)")->option_text("N");
  kind->add_option("--knob-points", o->knob_points, "vertices per knob (12)")->option_text("N");
  kind->add_option("--clearance", o->clearance, "gap along the seam (0.04)")->option_text("C");
}

void add_dips(CLI::App& gen, Action& action) {
  const auto o = std::make_shared<gen::DipOptions>();
  CLI::App* kind = add_kind(gen, action, "dips", "a regular polygon dips into a cup (the paper's Fig. 16)",
                            "it hits the bottom", o, [](gen::DipOptions options, std::optional<int> n) {
                              if (n) options.sides = *n;
                              return gen::make_dips(options);
                            });
  kind->add_option("--sides", o->sides, "of the regular polygon (64)")->option_text("N");
  kind->add_option("--dips", o->dips, "how often it dips in, at most 8 (4)")->option_text("K");
}

void add_rotor(CLI::App& gen, Action& action) {
  const auto o = std::make_shared<gen::RotorOptions>();
  CLI::App* kind = add_kind(gen, action, "rotor", "a toothed rotor near a flat chain (the paper's Fig. 17)",
                            "one tooth is too long", o, [](gen::RotorOptions options, std::optional<int> n) {
                              if (n) options.teeth = std::max(3, *n / 2);
                              if (n) options.chain_edges = std::max(2, *n - 8);
                              return gen::make_rotor(options);
                            });
  kind->add_option("--teeth", o->teeth, "of the rotor (24)")->option_text("N");
  kind->add_option("--chain-edges", o->chain_edges, "edges of the chain (24)")->option_text("N");
  kind->add_option("--turns", o->turns, "revolutions (1)")->option_text("R");
}

void add_spiral(CLI::App& gen, Action& action) {
  const auto o = std::make_shared<gen::SpiralOptions>();
  CLI::App* kind = add_kind(gen, action, "spiral", "a spiral is screwed along the groove of another",
                            "it is screwed too far", o, [](gen::SpiralOptions options, std::optional<int> n) {
                              if (n) {
                                options.side_points = std::max(12, *n / 2);
                                // As many turns as so many vertices can show without touching.
                                options.turns = 0.95 * std::pow((options.side_points - 4) / 18.0, 2.0 / 3.0);
                              }
                              return gen::make_spiral(options);
                            });
  kind->add_option("--turns", o->turns, "of the spiral (2)")->option_text("R");
  kind->add_option("--side-points", o->side_points, "vertices along either side (64)")->option_text("N");
}

void add_maze(CLI::App& gen, Action& action) {
  const auto o = std::make_shared<gen::MazeOptions>();
  CLI::App* kind = add_kind(gen, action, "maze", "a small ship drives through a serpentine corridor",
                            "the ship is too long to turn", o, [](gen::MazeOptions options, std::optional<int> n) {
                              if (n) options.passes = std::max(1, (*n - 4) / 4);
                              return gen::make_maze(options);
                            });
  kind->add_option("--passes", o->passes, "of the corridor (12)")->option_text("N");
  kind->add_option("--ship-points", o->ship_points, "vertices of the ship (12)")->option_text("N");
  kind->add_option("--seed", o->seed, "of the passes' lengths; 0: all alike (1)")->option_text("S");
}

}  // namespace

void add_gen(CLI::App& app, Action& action) {
  CLI::App* gen = app.add_subcommand("gen", "Write an example scene");
  gen->require_subcommand(1);
  gen->footer(
      "Example:\n"
      "  taut gen gears --teeth1 19 --teeth2 31 -o gears.json\n"
      "\n"
      "Every scene is free of contact, or has one with --hit. `taut gen KIND --help` tells each kind's options.\n");
  add_gears(*gen, action);
  add_combs(*gen, action);
  add_lock(*gen, action);
  add_jigsaw(*gen, action);
  add_dips(*gen, action);
  add_rotor(*gen, action);
  add_spiral(*gen, action);
  add_maze(*gen, action);
}

}  // namespace taut::cli
