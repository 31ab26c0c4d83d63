// Where a command reads its scene from.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "taut/scene.hpp"

namespace taut::cli {

struct SceneSource {
  std::string path;            ///< a file, or - for standard input
  bool allow_outside = false;  ///< may its outlines lie outside of its folder?
};

/// Adds --allow-outside.
void add_allow_outside(CLI::App& command, bool& allow_outside);
/// Adds the positional SCENE, and --allow-outside.
void add_scene(CLI::App& command, SceneSource& scene);

/// Throws InputError.
Scene load_scene(const SceneSource& source);

/// What the path is called in messages.
std::string display_name(const std::string& path);

}  // namespace taut::cli
