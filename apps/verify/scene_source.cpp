#include "scene_source.hpp"

#include <cstdio>

#include "taut/io.hpp"

namespace taut::cli {

void add_allow_outside(const Command& command, bool& allow_outside) {
  command.add_flag("--allow-outside", allow_outside, "files that a scene names may lie outside of its folder");
}

void add_scene(const Command& command, SceneSource& scene) {
  command.add_option("SCENE", scene.path, "scene file (taut-scene/1), or - for standard input").required().value(" ");
  add_allow_outside(command, scene.allow_outside);
}

namespace {

std::string text_of_standard_input(std::size_t most) {
  std::string text;
  char buffer[1 << 16];
  while (std::size_t n = std::fread(buffer, 1, sizeof buffer, stdin)) {
    text.append(buffer, n);
    if (text.size() > most) break;  // the parser refuses it
  }
  return text;
}

}  // namespace

Scene load_scene(const SceneSource& source) {
  ReadLimits limits;
  limits.allow_outside = source.allow_outside;
  if (source.path != "-") return read_scene(source.path, limits);
  return parse_scene(text_of_standard_input(limits.max_bytes), display_name(source.path), ".", limits);
}

Linkage load_linkage(const SceneSource& source) {
  ReadLimits limits;
  limits.allow_outside = source.allow_outside;
  if (source.path != "-") return read_linkage(source.path, limits);
  return parse_linkage(text_of_standard_input(limits.max_bytes), display_name(source.path), ".", limits);
}

std::string display_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }

}  // namespace taut::cli
