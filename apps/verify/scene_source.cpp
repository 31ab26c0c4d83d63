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

void add_at_rest(const Command& command, std::optional<AtRest>& at_rest) {
  const auto set = [&at_rest](const std::string& word) { at_rest = word == "test" ? AtRest::test : AtRest::skip; };
  command.add_choice("--at-rest", {"skip", "test"}, set,
                     "pairs that do not move relative to each other: skip them, unless nothing moves\n"
                     "(default), or test them, at the start");
}

namespace {

/// What the command line says instead of the scene.
void take_choices(const SceneSource& source, Scene& scene) {
  if (source.at_rest) scene.at_rest = *source.at_rest;
}

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
  Scene scene = source.path != "-"
                    ? read_scene(source.path, limits)
                    : parse_scene(text_of_standard_input(limits.max_bytes), display_name(source.path), ".", limits);
  take_choices(source, scene);
  return scene;
}

Linkage load_linkage(const SceneSource& source) {
  ReadLimits limits;
  limits.allow_outside = source.allow_outside;
  Linkage linkage = source.path != "-" ? read_linkage(source.path, limits)
                                       : parse_linkage(text_of_standard_input(limits.max_bytes),
                                                       display_name(source.path), ".", limits);
  take_choices(source, linkage.scene);
  return linkage;
}

std::string display_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }

}  // namespace taut::cli
