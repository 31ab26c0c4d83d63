// The question about the cells of a grid that a body touches, as text.
#include "ask/question.hpp"
#include "taut/cells.hpp"

namespace taut::internal {
namespace {

Reply ask_cells(const Scene& scene, const GivenOptions& given) {
  const BodyId body = body_called(scene, given.text("body"));
  CellOptions options;
  options.resolution = given.number("resolution");
  options.origin = {given.number("origin_x"), given.number("origin_y")};
  options.limits = given.limits();
  return {cells_json(scene, body, cells(scene, body, options))};
}

}  // namespace

std::vector<QuestionEntry> cells_questions() {
  return {{"cells",
           "The cells of a grid that a body touches on its way, whatever happens between poses.",
           "CellsAnswer",
           {required_text("body", "The name of the body."),
            required_number("resolution", "The side of a cell, in the scene's units."),
            number_option("origin_x", 0, "The left side of column 0."),
            number_option("origin_y", 0, "The lower side of row 0."), max_seconds_option()},
           ask_cells}};
}

}  // namespace taut::internal
