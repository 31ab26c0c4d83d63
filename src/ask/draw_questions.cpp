// Pictures as answers: draw.
#include <cmath>
#include <optional>
#include <string>

#include "ask/question.hpp"
#include "ask/scene_pictures.hpp"
#include "io/json_writer.hpp"
#include "numeric/budget.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/outline.hpp"
#include "taut/simulation.hpp"

namespace taut::internal {
namespace {

std::optional<double> instant_of(const Scene& scene, const GivenOptions& given) {
  const double at = given.number("at");
  if (std::isinf(at)) return std::nullopt;
  if (at >= scene.start && at <= scene.end) return at;
  throw InputError("at", "the instant is not within the scene's time", "choose one within");
}

/// Two polygons and the faces of their tiling; nothing if the scene has no tiling.
std::optional<std::string> tiling_picture(const Scene& scene, std::optional<double> at, const GivenOptions& given) {
  if (!is_ring_pair(scene)) return std::nullopt;
  SimulationOptions options;
  options.touch = given.touch();
  options.limits = given.limits();
  Simulation simulation(scene, options);
  if (simulation.tiling().edges.empty()) return std::nullopt;
  TilingDrawOptions drawn;
  drawn.width = static_cast<int>(given.whole_number("width"));
  drawn.faces = !given.flag("plain");
  if (simulation.advance_to(at.value_or(scene.end)) == SimulationState::contact) drawn.contact = &*simulation.contact();
  return draw_svg(scene, simulation.tiling(), drawn);
}

std::string bodies_picture(const Scene& scene, std::optional<double> at, const GivenOptions& given) {
  CheckOptions options;
  options.touch = given.touch();
  options.limits = given.limits();
  options.tell_touching = false;
  const Answer answer = check(scene, options);
  const DrawnTilings how{!given.flag("plain"), given.touch()};
  DrawOptions drawn;
  drawn.width = static_cast<int>(given.whole_number("width"));
  return given.flag("animate") ? world_animation(scene, answer, how, {.draw = drawn})
                               : world_picture(scene, answer, at, how, drawn);
}

Reply ask_draw(const Scene& scene, const GivenOptions& given) {
  const std::optional<double> at = instant_of(scene, given);
  std::optional<std::string> svg;
  if (!given.flag("animate")) svg = tiling_picture(scene, at, given);
  if (!svg) svg = bodies_picture(scene, at, given);
  return {io::json_text([&](io::JsonWriter& json) { json.object([&] { json.member("svg", *svg); }); })};
}

}  // namespace

std::vector<QuestionEntry> draw_questions() {
  return {{"draw",
           "A picture of the bodies as SVG, at an instant or moving, with the tilings between them.",
           "Drawn",
           {number_option("at", INFINITY, "The instant; without it, the first contact, or the end. Not after that."),
            flag_option("animate", "A picture that moves from the start to the contact, or to the end."),
            flag_option("plain", "Without tilings; those of two polygons without colours."), touch_option(),
            whole_option("width", 200, 20000, 800, "In pixels."), max_seconds_option()},
           ask_draw}};
}

// Polygons for the curves of a scene, as text: the answer is a scene.

namespace {

Reply ask_flatten(const Scene& scene, const GivenOptions& given) {
  const CurveSide side = given.word_as<CurveSide>("side", {CurveSide::outer, CurveSide::inner});
  try {
    const Budget scope(given.limits());
    return {write_scene(flatten(scene, side, given.number("tolerance")))};
  } catch (const Interrupted& interrupted) {
    throw UndecidedError(interrupted.reason);
  }
}

}  // namespace

std::vector<QuestionEntry> flatten_questions() {
  return {{"flatten",
           "The scene with polygons in place of curves, around the bodies or within them, for what takes no curves.",
           "SceneObject",
           {required_number("tolerance", "The most that polygons may be from the curves, in the scene's units."),
            word_option("side", {"outer", "inner"},
                        "Whether polygons contain the bodies (\"outer\") or are contained (\"inner\"); proved."),
            max_seconds_option()},
           ask_flatten}};
}

}  // namespace taut::internal
