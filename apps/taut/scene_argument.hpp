// What several subcommands share.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "command_line/command_line.hpp"

#include "scene_source.hpp"
#include "taut/check.hpp"
#include "taut/envelope.hpp"
#include "taut/scene.hpp"

namespace taut::cli {

/// Adds --touch open|closed.
void add_touch(const Command& command, Touch& touch);
/// Adds --engine kinetic|spacetime|both|either.
void add_engine(const Command& command, EngineChoice& engine);
/// Adds --max-seconds.
void add_max_seconds(const Command& command, Limits& limits);
/// Adds --max-events and --max-seconds.
void add_limits(const Command& command, CheckOptions& options);

/// Writes to a file, or to standard output if `path` is empty or "-".
void write_output(const std::string& path, const std::string& text);
/// "no proof was written", and, if there is a file already, that it was left as it is: it is not about this scene.
std::string not_written(const std::string& what, const std::string& path);

/// Before a long search: a picture of more joints than two is refused. `file`: where it is to go; empty: nowhere.
void require_drawable(const std::string& option, const std::string& file, const std::vector<Joint>& joints);

/// What a question is asked about, and what becomes of a scene in which nothing is tested.
struct AskedScene {
  SceneSource source;
  bool allow_untested = false;
};
/// Adds SCENE, --allow-outside, --at-rest and --allow-untested.
void add_asked_scene(const Command& command, AskedScene& scene);
/// Adds --allow-untested.
void add_allow_untested(const Command& command, bool& allow);

/// The exit code that an outcome stands for.
int exit_code(Outcome outcome, bool allow_untested);

}  // namespace taut::cli
