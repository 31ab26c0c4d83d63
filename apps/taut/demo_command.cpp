// taut demo NAME: something to look at, and what to type next.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>

#include "ask/scene_pictures.hpp"
#include "commands.hpp"
#include "demo_scenes.hpp"
#include "generators/generators.hpp"
#include "io/platform.hpp"
#include "io/text.hpp"
#include "scene_argument.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "terminal.hpp"
#include "viewer_page.hpp"

namespace taut::cli {
using namespace internal;

namespace {

struct Demo {
  const char* name;
  const char* what;
  std::function<std::string()> scene;
};

/// Scenes for editors to complete do not name a schema that is not there.
std::string without_schema(std::string text) {
  const std::size_t at = text.find("  \"$schema\"");
  return at == std::string::npos ? text : text.erase(at, text.find('\n', at) + 1 - at);
}

std::string gears() {
  gen::GearOptions options;
  options.teeth_1 = 19;
  options.teeth_2 = 13;
  options.flank_points = 3;
  options.hit = true;
  return write_scene(gen::make_gears(options));
}

const Demo demos[] = {
    {"lid", "a bin's lid on its hinge: it hits the back wall at 106.6 degrees",
     [] { return without_schema(lid_scene); }},
    {"parking", "a car backs into a parking space by keyframes, and clips another car",
     [] { return without_schema(parking_scene); }},
    {"gears", "two involute gears, one with a tooth that is too thick", gears},
    {"jigsaw", "two pieces of a puzzle are pulled apart: free",
     [] { return write_scene(gen::make_jigsaw(gen::JigsawOptions())); }},
    {"combs", "interlocked combs swing within their play: free",
     [] { return write_scene(gen::make_combs(gen::CombOptions())); }},
    {"room", "a robot drives around pillars in a room, and meets one of them", [] { return std::string(room_scene); }},
    {"planetary", "a planetary gear, planets turning on a carrier inside a ring: free",
     [] { return write_scene(gen::make_planetary(gen::PlanetaryOptions())); }},
    {"spiral", "a spiral is screwed along the groove of another: free",
     [] { return write_scene(gen::make_spiral(gen::SpiralOptions())); }},
};

std::string list() {
  std::string s = "Demos, for `taut demo NAME`:\n";
  for (const Demo& demo : demos) s += fmt::format("  {:9}  {}\n", demo.name, demo.what);
  return s;
}

const Demo& find_demo(const std::string& name) {
  for (const Demo& demo : demos) {
    if (name == demo.name) return demo;
  }
  throw InputError("", fmt::format("there is no demo \"{}\"", name), "`taut demo` lists them");
}

/// What somebody wrote is not to be lost.
void require_new(const std::string& path) {
  if (std::filesystem::exists(internal::io::path_of(path)))
    throw InputError(path, "the file is there already", "write to another folder with -d, or over it with --force");
}

void write_new(const std::string& path, const std::string& text, bool force) {
  if (!force) require_new(path);
  write_file(path, text);
}

/// The page is built apart from the program, by `./dev web`.
bool viewer_is_there() {
  try {
    load_page_template("viewer.html", "");
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// As a shell takes it for one word.
std::string shell_word(const std::string& text) {
  const auto plain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || std::strchr("_./+,:=@%-", c);
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string s = "'";
  for (const char c : text) s += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return s + "'";
}

struct DemoArguments {
  std::string program;  ///< as it was called: what is said to type next must work as it stands
  std::string name, folder = ".";
  bool force = false;
};

int run_demo(const DemoArguments& arguments) {
  if (arguments.name.empty()) {
    print_text(list());
    return exit_free;
  }
  const Demo& demo = find_demo(arguments.name);
  const std::string stem = arguments.folder == "." ? demo.name : arguments.folder + "/" + demo.name;
  const std::string shown = io::line_for_terminal(stem);
  const std::string text = demo.scene();
  const Scene scene = parse_scene(text);
  write_new(stem + ".json", text, arguments.force);
  print_text(fmt::format("{}.json  {}\n", shown, demo.what));
  write_new(stem + ".svg", world_animation(scene, DrawnTilings()), arguments.force);
  print_text(fmt::format("{}.svg   the motion, to open in a browser\n", shown));
  if (viewer_is_there()) {
    if (!arguments.force) require_new(stem + ".html");
    write_viewer(scene, {}, stem + ".html");
    print_text(fmt::format("{}.html  the motion, to step through in a browser\n", shown));
  }
  const std::string next = shell_word(arguments.program) + " check " + shell_word(stem + ".json");
  print_text(fmt::format("next:  {}\n", io::line_for_terminal(next)));
  return exit_free;
}

}  // namespace

void add_demo(const Command& app, Action& action, const std::string& program) {
  const Command command = app.add_command("demo", "Write a scene to try, a page to look at, and say what to type next");
  const auto arguments = std::make_shared<DemoArguments>();
  arguments->program = program;
  std::string names;
  for (const Demo& demo : demos) names += (names.empty() ? "" : "|") + std::string(demo.name);
  command.add_option("NAME", arguments->name, "which one; without it, they are listed").value(names);
  command.add_option("-d,--directory", arguments->folder, "write to FOLDER instead of this one").value("FOLDER");
  command.add_flag("--force", arguments->force, "write over files that are there");
  command.footer("Example:\n  taut demo lid\n");
  command.on_chosen([&action, arguments] { action = [arguments] { return run_demo(*arguments); }; });
}

}  // namespace taut::cli
