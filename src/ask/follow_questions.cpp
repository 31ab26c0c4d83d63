// The question about a follower on a cam, as text: follow.
#include "ask/question.hpp"

#include "io/answer_writer.hpp"
#include "io/number_text.hpp"
#include "taut/follow.hpp"

namespace taut {
using namespace internal;

std::string follow_json(const Scene& scene, BodyId follower, const FollowOptions& options, const FollowAnswer& answer) {
  return io::answer_text(scene, [&](io::AnswerWriter& json) {
    json.member("body", json.body(follower).name);
    json.member("instants", static_cast<std::uint64_t>(options.instants));
    json.key("lifts").array(answer.lifts, [&](const Lift& lift) {
      json.object([&] {
        json.key("t").numbers({lift.time.lo, lift.time.hi});
        json.key("lift").numbers({lift.lift[0], lift.lift[1]});
        json.vertex("vertex", lift.vertex);
        json.edge("edge", lift.edge);
      });
    });
    if (!answer.undecided.empty()) {
      json.key("undecided").array(answer.undecided, [&](const TimeInterval& t) { json.numbers({t.lo, t.hi}); });
      json.member("reason", answer.reason);
    }
    json.grounds(answer.geometry, answer.coverage);
    json.scope(options.touch);
  });
}

std::string follow_csv(const FollowAnswer& answer) {
  std::string text = "t_lo,t_hi,lift_lo,lift_hi\n";
  for (const Lift& at : answer.lifts) {
    const double row[] = {at.time.lo, at.time.hi, at.lift[0], at.lift[1]};
    for (std::size_t k = 0; k < std::size(row); ++k) text += (k > 0 ? "," : "") + io::number_text(row[k]);
    text += "\n";
  }
  return text;
}

}  // namespace taut

namespace taut::internal {
namespace {

Reply ask_follow(const Scene& scene, const GivenOptions& given) {
  const BodyId body = body_called(scene, given.text("body"));
  const FollowOptions options{static_cast<std::size_t>(given.whole_number("instants")), given.touch(), given.limits()};
  const FollowAnswer answer =
      follow(scene, body, direction_of(given.number("direction_deg")), given.number("reach"), options);
  return {follow_json(scene, body, options, answer)};
}

}  // namespace

std::vector<QuestionEntry> follow_questions() {
  return {
      {"follow",
       "The lift of a follower on a cam, at many instants.",
       "FollowAnswer",
       {required_text("body", "The name of the follower."),
        required_number("reach", "The lift at which the follower clears all other bodies at all times."),
        number_option("direction_deg", 90, "Along which it is lifted, in degrees counterclockwise from the x axis."),
        whole_option("instants", 1, 1000000, FollowOptions{}.instants, "At about how many instants."), touch_option(),
        max_seconds_option()},
       ask_follow}};
}

}  // namespace taut::internal
