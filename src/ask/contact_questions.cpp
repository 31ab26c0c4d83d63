// The question about the first contact as text: check.
#include "ask/question.hpp"
#include "io/answer_json.hpp"

namespace taut::internal {
namespace {

Reply ask_check(const Scene& scene, const GivenOptions& given) {
  return {answer_json(scene, check(scene, given.check()), given.touch())};
}

}  // namespace

std::vector<QuestionEntry> contact_questions() {
  return {{"check",
           "The first contact, or that there is none.",
           "Answer",
           {touch_option(), engine_option(), pairs_option(), max_seconds_option(), max_events_option(),
            number_option("fit", CheckOptions{}.fit,
                          "Bodies are shrunk by so much to twice as much first, in the scene's units."),
            number_option("time_tolerance", CheckOptions{}.time_tolerance,
                          "Of curves: how wide the time of a contact may be, as a share of the scene's time.")},
           ask_check}};
}

}  // namespace taut::internal
