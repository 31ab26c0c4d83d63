// Polygons for the curves of a scene, as text: the answer is a scene.
#include "ask/question.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/outline.hpp"

namespace taut::internal {
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
