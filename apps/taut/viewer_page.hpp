// A scene as one HTML file that shows it in a browser.
#pragma once

#include <optional>
#include <string>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::cli {

/// Questions that the page answers from the beginning, besides that of the first contact.
struct ViewerQuestions {
  bool intervals = false, clearance = false, separate = false;
  int profile = 0;  ///< instants of the distance over time; 0: it is not asked for
};

struct ViewerOptions {
  Touch touch = Touch::open;
  std::optional<double> at;  ///< the instant to show first; without it, the start
  std::string title;         ///< of the page; empty: the bodies' names
  ViewerQuestions ask;
  std::string template_path;  ///< empty: look next to the executable
};

/// A page that `./dev web` builds, with a marked place for data: the file `path`, or the one of that name beside the
/// program if `path` is empty. Throws InputError that names the remedy if there is none.
std::string load_page_template(const std::string& name, const std::string& path);

/// Writes that page with JSON in its place to `output`, or to standard output if it is empty or "-".
void write_page(const std::string& name, const std::string& template_path, const std::string& data,
                const std::string& output);

/// Writes a self-contained page to `output`, or to standard output if it is empty or "-". The scene must be valid.
/// The same scene and template give the same bytes. Throws InputError.
void write_viewer(const Scene& scene, const ViewerOptions& options, const std::string& output);

}  // namespace taut::cli
