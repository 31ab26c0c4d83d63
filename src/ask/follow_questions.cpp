// The question about a follower on a cam, as text: follow.
#include "ask/question.hpp"

#include <fmt/format.h>

#include "io/answer_writer.hpp"
#include "io/text.hpp"
#include "taut/follow.hpp"

namespace taut {
using namespace internal;
namespace {

void write_contact(io::AnswerWriter& json, const FollowContact& contact) {
  json.object([&] {
    json.vertex("vertex", contact.vertex);
    json.edge("edge", contact.edge);
  });
}

void write_stretch(io::AnswerWriter& json, const FollowStretch& stretch) {
  json.object([&] {
    json.time("t", stretch.time);
    json.member("state", to_string(stretch.state));
    json.key("lift").numbers({stretch.lift[0], stretch.lift[1]});
    if (stretch.once) json.member("once", true);
    if (stretch.jumps) json.member("jumps", true);
    json.key("touching").array(stretch.contacts, [&](const FollowContact& contact) { write_contact(json, contact); });
  });
}

/// "plate 0", or "plate part 1 hole 0 3" where there are several rings.
template <class Ref>
std::string feature_text(const Scene& scene, const Ref& ref) {
  const Body& body = scene.bodies[static_cast<std::size_t>(ref.body)];
  std::string text = body.name;
  if (body.parts.size() > 1) text += fmt::format(" part {}", ref.part);
  if (ref.ring > 0) text += fmt::format(" hole {}", ref.ring - 1);
  return fmt::format("{} {}", text, ref.index);
}

}  // namespace

const char* to_string(FollowState state) {
  constexpr const char* names[] = {"carried", "low", "change", "open"};
  return names[static_cast<std::size_t>(state)];
}

std::string contact_text(const Scene& scene, const FollowContact& contact) {
  return feature_text(scene, contact.vertex) + " on " + feature_text(scene, contact.edge);
}

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
    if (options.contacts) {
      json.member("tolerance", options.tolerance);
      json.key("contacts").array(answer.contacts, [&](const FollowStretch& s) { write_stretch(json, s); });
      if (!answer.contacts_reason.empty()) json.member("contacts_reason", answer.contacts_reason);
    }
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

std::string follow_contacts_csv(const Scene& scene, const FollowAnswer& answer) {
  std::string text = "t_lo,t_hi,state,lift_lo,lift_hi,once,jumps,touching\n";
  for (const FollowStretch& s : answer.contacts) {
    std::string touching;
    for (const FollowContact& contact : s.contacts)
      touching += (touching.empty() ? "" : "; ") + contact_text(scene, contact);
    text += fmt::format("{},{},{},{},{},{},{},{}\n", io::number_text(s.time.lo), io::number_text(s.time.hi),
                        to_string(s.state), io::number_text(s.lift[0]), io::number_text(s.lift[1]), s.once ? 1 : 0,
                        s.jumps ? 1 : 0, io::csv_field(touching));
  }
  return text;
}

}  // namespace taut

namespace taut::internal {
namespace {

Reply ask_follow(const Scene& scene, const GivenOptions& given) {
  const BodyId body = body_called(scene, given.text("body"));
  const FollowOptions options{static_cast<std::size_t>(given.whole_number("instants")), given.flag("contacts"),
                              given.number("tolerance"), given.touch(), given.limits()};
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
        whole_option("instants", 1, 1000000, FollowOptions{}.instants, "At about how many instants."),
        flag_option("contacts", "Also what touches what, at all times."),
        number_option("tolerance", FollowOptions{}.tolerance,
                      "Of the contacts: how long a change may be, as a share of the scene's time."),
        touch_option(), max_seconds_option()},
       ask_follow}};
}

}  // namespace taut::internal
