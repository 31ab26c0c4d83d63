// Where a command reads its scene from.
#pragma once

#include <optional>
#include <string>
#include "command_line/command_line.hpp"

#include "taut/envelope.hpp"
#include "taut/path.hpp"
#include "taut/scene.hpp"

namespace taut::cli {

struct SceneSource {
  std::string path;                    ///< a file, or - for standard input
  bool allow_outside = false;          ///< may its outlines lie outside of its folder?
  std::optional<AtRest> at_rest = {};  ///< instead of what the scene says
};

/// Adds --allow-outside.
void add_allow_outside(const Command& command, bool& allow_outside);
/// Adds --at-rest skip|test.
void add_at_rest(const Command& command, std::optional<AtRest>& at_rest);
/// Adds the positional SCENE, and --allow-outside.
void add_scene(const Command& command, SceneSource& scene);

/// Throws InputError.
Scene load_scene(const SceneSource& source);
/// The same of a scene that has joints instead of a time.
Linkage load_linkage(const SceneSource& source);
/// The same of a scene that has joints, a start and a goal.
PathProblem load_path_problem(const SceneSource& source);

/// Does the scene say "joints" instead of a time? False for what is no file, and for what cannot be read.
bool has_joints(const SceneSource& source);

/// What the path is called in messages.
std::string display_name(const std::string& path);

}  // namespace taut::cli
