#include "scene_source.hpp"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "io/json_object.hpp"
#include "io/platform.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"
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

/// Of `taut check <(command)`: a pipe that the shell opened, and that is read to its end as standard input is. A pipe
/// that somebody made, or that a scene names, may never have one.
bool is_opened_pipe(const std::string& path) {
  return path.rfind("/dev/fd/", 0) == 0 || path.rfind("/proc/self/fd/", 0) == 0;
}

/// What the command line says instead of the scene.
void take_choices(const SceneSource& source, Scene& scene) {
  if (source.at_rest) scene.at_rest = *source.at_rest;
}

std::string text_of(std::FILE* file, std::size_t most) {
  std::string text;
  char buffer[1 << 16];
  while (std::size_t n = std::fread(buffer, 1, sizeof buffer, file)) {
    text.append(buffer, n);
    if (text.size() > most) break;  // the parser refuses it
  }
  return text;
}

/// Of what is no file by a name of its own; nothing for others.
std::optional<std::string> streamed_text(const std::string& path, std::size_t most) {
  if (path == "-") return text_of(stdin, most);
  if (!is_opened_pipe(path)) return std::nullopt;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return std::nullopt;  // read_scene() says why
  return text_of(file.get(), most);
}

}  // namespace

namespace {

/// By one of two functions: of a text and its name, or of a file.
template <class Parse, class Read>
auto load(const SceneSource& source, const Parse& parse, const Read& read) {
  ReadLimits limits;
  limits.allow_outside = source.allow_outside;
  const std::optional<std::string> text = streamed_text(source.path, limits.max_bytes);
  return text ? parse(*text, display_name(source.path), ".", limits) : read(source.path, limits);
}

}  // namespace

Scene load_scene(const SceneSource& source) {
  Scene scene = load(source, parse_scene, read_scene);
  take_choices(source, scene);
  return scene;
}

Linkage load_linkage(const SceneSource& source) {
  Linkage linkage = load(source, parse_linkage, read_linkage);
  take_choices(source, linkage.scene);
  return linkage;
}

PathProblem load_path_problem(const SceneSource& source) {
  PathProblem problem = load(source, parse_path_problem, read_path_problem);
  take_choices(source, problem.linkage.scene);
  return problem;
}

bool has_joints(const SceneSource& source) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(internal::io::path_of(source.path), none)) return false;
  try {
    const internal::io::JsonDocument document =
        internal::io::parse_json(internal::io::read_text_file(source.path, ReadLimits{}.max_bytes), source.path, "");
    return internal::io::has_ranges(document);
  } catch (const InputError&) {
    return false;
  }
}

std::string display_name(const std::string& path) { return path == "-" ? "<stdin>" : path; }

}  // namespace taut::cli
