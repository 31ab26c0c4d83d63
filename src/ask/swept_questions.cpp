// The question about the region that a body passes over, as text.
#include "ask/question.hpp"
#include "taut/swept.hpp"

namespace taut::internal {
namespace {

Reply ask_swept(const Scene& scene, const GivenOptions& given) {
  const BodyId body = body_called(scene, given.text("body"));
  return {swept_json(scene, body, swept(scene, body, {given.number("tolerance"), given.limits()}))};
}

}  // namespace

std::vector<QuestionEntry> swept_questions() {
  return {{"swept",
           "The region that a body passes over, whatever happens between poses.",
           "SweptRegion",
           {required_text("body", "The name of the body."),
            number_option("tolerance", SweptOptions{}.tolerance,
                          "How far the region may reach beyond it, in the scene's units; 0: a thousandth of the body's "
                          "diagonal."),
            max_seconds_option()},
           ask_swept}};
}

}  // namespace taut::internal
