// Drawings as scenes for the npm package.
#include <emscripten.h>

#include <cmath>
#include <optional>
#include <string>

#include "ask/question.hpp"
#include "import/import.hpp"
#include "io/json_writer.hpp"
#include "replies.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::web {
using namespace internal;
namespace {

using drawing::Crossing;
using drawing::Grouping;
using drawing::ImportSettings;
using drawing::OpenRings;

/// The options of drawings, read and checked as those of questions are. Lengths that are not given are infinite.
const QuestionEntry& drawing_entry() {
  static const QuestionEntry entry{
      "read_drawing",
      "",
      "",
      {number_option("tolerance", INFINITY, ""), number_option("join", INFINITY, ""),
       number_option("repair", INFINITY, ""), number_option("drills", INFINITY, ""), number_option("scale", 1, ""),
       word_option("unit", {"", "mm", "cm", "m", "um", "in", "ft", "mil", "pt", "px"}, ""),
       word_option("open", {"error", "close", "skip"}, ""),
       word_option("crossing", {"error", "subtract", "union", "parts"}, ""),
       word_option("by", {"auto", "layer", "color", "group", "nesting"}, ""), flag_option("merge_layers", ""),
       flag_option("curves", ""), flag_option("split", ""), flag_option("strict", "")}};
  return entry;
}

/// 0 only where `zero` says so.
double length_in(const GivenOptions& given, const char* name, bool zero) {
  const double length = given.number(name);
  if (length < 0 || (length == 0 && !zero))
    throw InputError(name, "it is not a length", "give a positive number in the units of the scene");
  return length;
}

std::optional<double> if_given(double length) {
  return std::isinf(length) ? std::nullopt : std::optional<double>(length);
}

ImportSettings drawing_settings(const char* text) {
  const Question asked{"read_drawing", text};
  const GivenOptions given(asked, drawing_entry());
  ImportSettings s;
  s.tolerance = if_given(length_in(given, "tolerance", false));
  s.join = if_given(length_in(given, "join", true));
  s.repair = if_given(length_in(given, "repair", true));
  s.drills = if_given(length_in(given, "drills", true));
  s.scale = length_in(given, "scale", false);
  s.unit = given.word("unit");
  s.open = given.word_as<OpenRings>("open", {OpenRings::error, OpenRings::close, OpenRings::skip});
  s.crossing =
      given.word_as<Crossing>("crossing", {Crossing::error, Crossing::subtract, Crossing::unite, Crossing::parts});
  s.by = given.word_as<Grouping>(
      "by", {Grouping::automatic, Grouping::layer, Grouping::color, Grouping::group, Grouping::nesting});
  s.merge_all = given.flag("merge_layers");
  s.curves = given.flag("curves");
  s.split = given.flag("split");
  s.strict = given.flag("strict");
  return s;
}

}  // namespace
}  // namespace taut::web

using namespace taut;
using namespace taut::web;

extern "C" {

/// {"scene": the scene, or null if there are faults, "report": see report_json(), "svg": see report_svg()} of a drawing
/// whose format the ending of its name tells.
EMSCRIPTEN_KEEPALIVE const char* taut_read_drawing(const char* text, const char* name, const char* options) {
  return replied([&] {
    const ImportSettings settings = drawing_settings(options);
    const drawing::Import import = drawing::examine_drawings({drawing::read_drawing(text, name, settings)}, settings);
    return "{\"scene\":" + (import.faults.empty() ? write_scene(import.scene) : std::string("null")) +
           ",\"report\":" + report_json(import, settings) + ",\"svg\":" + io::string_text(report_svg(import)) + "}";
  });
}

}  // extern "C"
