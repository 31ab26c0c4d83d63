#include "viewer_page.hpp"

#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include "io/json_writer.hpp"
#include "io/platform.hpp"
#include "io/text_file.hpp"
#include "scene_argument.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::cli {
using namespace internal;

namespace {

namespace fs = std::filesystem;

/// Where the template has a place for the data; web/build.mjs sees to it that it comes once.
const std::string marker = "@TAUT-DATA@";
const char* const remedy = "build it with `./dev web`, or name it with --template FILE";
constexpr std::size_t largest_template = std::size_t{1} << 28;

/// In order of preference; right for an installed taut, for one beside its page, and for build/release/taut.
std::vector<fs::path> candidates(const std::string& name) {
  const std::optional<fs::path> program = io::running_program();
  if (!program) return {};
  const fs::path folder = program->parent_path();
  return {folder / "../share/taut" / name, folder / name, folder / "../web" / name};
}

std::string find_template(const std::string& name) {
  std::string tried;
  for (const fs::path& path : candidates(name)) {
    std::error_code error;
    if (fs::is_regular_file(path, error)) return io::name_of(path);
    tried += (tried.empty() ? "" : ", ") + io::name_of(path.lexically_normal());
  }
  throw InputError("", "the viewer's page is missing" + (tried.empty() ? tried : " (looked for " + tried + ")"),
                   remedy);
}

/// JSON that may stand inside a script element: no "</script>" and no "<!--" can occur in it.
std::string for_script(const std::string& json) {
  std::string s;
  s.reserve(json.size() + json.size() / 16);
  for (const char c : json) {
    if (c == '<') {
      s += "\\u003c";
    } else {
      s += c;
    }
  }
  return s;
}

/// By the names that the library has for them, with their options.
std::string ask_text(const ViewerQuestions& ask) {
  std::string s;
  const auto add = [&s](bool asked, const char* name, const std::string& options) {
    if (asked) s += std::string(s.empty() ? "\"" : ",\"") + name + "\":{" + options + "}";
  };
  add(ask.intervals, "intervals", "");
  add(ask.clearance, "clearance", "");
  add(ask.profile > 0, "distance_profile", "\"instants\":" + std::to_string(ask.profile));
  add(ask.separate, "separate", "");
  return s;
}

std::string data_text(const Scene& scene, const ViewerOptions& options) {
  std::string s = std::string("{\"touch\":\"") + to_string(options.touch) + "\"";
  if (options.at) s += ",\"at\":" + io::number_text(*options.at);
  if (!options.title.empty()) s += ",\"title\":" + io::string_text(options.title);
  const std::string ask = ask_text(options.ask);
  if (!ask.empty()) s += ",\"ask\":{" + ask + "}";
  return s + ",\"scene\":" + write_scene(scene) + "}";
}

}  // namespace

std::string load_page_template(const std::string& name, const std::string& path) {
  const std::string file = path.empty() ? find_template(name) : path;
  std::string page = io::read_text_file(file, largest_template);
  const std::size_t at = page.find(marker);
  if (at == std::string::npos || page.find(marker, at + 1) != std::string::npos)
    throw InputError(file, "not a template of the viewer: " + marker + " must occur once", remedy);
  return page;
}

void write_page(const std::string& name, const std::string& template_path, const std::string& data,
                const std::string& output) {
  std::string page = load_page_template(name, template_path);
  page.replace(page.find(marker), marker.size(), for_script(data));
  write_output(output, page);
}

void write_viewer(const Scene& scene, const ViewerOptions& options, const std::string& output) {
  write_page("viewer.html", options.template_path, data_text(scene, options), output);
}

}  // namespace taut::cli
