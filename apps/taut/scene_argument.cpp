#include "scene_argument.hpp"

#include <cstdio>
#include <filesystem>
#include <map>
#include <system_error>

#include "commands.hpp"
#include "io/platform.hpp"
#include "io/text.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::cli {

void add_touch(const Command& command, Touch& touch) {
  const auto set = [&touch](const std::string& mode) { touch = mode == "closed" ? Touch::closed : Touch::open; };
  command.add_choice("--touch", {"open", "closed"}, set,
                     "open: contact is overlap, touching is allowed (default)\n"
                     "closed: touching counts");
}

void add_engine(const Command& command, EngineChoice& engine) {
  static const std::map<std::string, EngineChoice> names = {{"kinetic", EngineChoice::kinetic},
                                                            {"spacetime", EngineChoice::spacetime},
                                                            {"both", EngineChoice::both},
                                                            {"either", EngineChoice::either}};
  const auto set = [&engine](const std::string& name) { engine = names.at(name); };
  command.add_choice("--engine", {"kinetic", "spacetime", "both", "either"}, set,
                     "kinetic: a tiling of the free space, event by event\n"
                     "spacetime: bounding volumes over time, for a second opinion\n"
                     "both: ask both, and compare; of a world, pair by pair\n"
                     "either: ask both in turn, for longer and longer; the first answer counts, of a world for\n"
                     "each pair (default; kinetic where events are limited)");
}

void add_max_seconds(const Command& command, Limits& limits) {
  command.add_option("--max-seconds", limits.max_seconds, "give up (undecided) after S seconds")
      .value("S")
      .not_negative();
}

void add_limits(const Command& command, CheckOptions& options) {
  command.add_option("--max-events", options.max_events, "give up (undecided) after N events").value("N");
  add_max_seconds(command, options.limits);
}

void write_output(const std::string& path, const std::string& text) {
  if (!path.empty() && path != "-") return write_file(path, text);
  std::fwrite(text.data(), 1, text.size(), stdout);
}

std::string not_written(const std::string& what, const std::string& path) {
  std::error_code ignored;
  const std::string name = internal::io::line_for_terminal(path);
  const bool old = std::filesystem::is_regular_file(internal::io::path_of(path), ignored);
  return "no " + what + " was written" + (old ? "; " + name + " is an older file, left as it was" : "");
}

void require_drawable(const std::string& option, const std::string& file, const std::vector<Joint>& joints) {
  if (file.empty() || joints.size() <= 2) return;
  throw InputError(option,
                   "the scene has " + std::to_string(joints.size()) + " joints, and a picture has two directions",
                   "leave it out, or write a scene with two joints, in which all else has one place");
}

void add_allow_untested(const Command& command, bool& allow) {
  command.add_flag("--allow-untested", allow, "exit with 0, not with 2, where no pair of bodies is tested");
}

void add_asked_scene(const Command& command, AskedScene& scene) {
  add_scene(command, scene.source);
  add_at_rest(command, scene.source.at_rest);
  add_allow_untested(command, scene.allow_untested);
}

int exit_code(Outcome outcome, bool allow_untested) {
  switch (outcome) {
    case Outcome::free:
      return exit_free;
    case Outcome::contact:
    case Outcome::overlap_at_start:
    case Outcome::closer_at_start:
      return exit_contact;
    case Outcome::undecided:
    case Outcome::locked:
      return exit_undecided;
    case Outcome::untested:
      return allow_untested ? exit_free : exit_bad_input;
  }
  return exit_internal;
}

}  // namespace taut::cli
