// The question about a mechanism itself as text: mechanism.
#include "ask/question.hpp"
#include "io/answer_writer.hpp"
#include "io/text.hpp"
#include "taut/mechanism_motion.hpp"

namespace taut::internal {
namespace {

using io::answer_text;
using io::AnswerWriter;

void write_extreme(AnswerWriter& json, const char* name, const Extreme& extreme) {
  json.key(name).object([&] {
    json.member("lo", extreme.lo);
    json.member("hi", extreme.hi);
    json.member("t", extreme.t);
  });
}

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

std::string mechanism_json(const Scene& scene, const MechanismMotion& answer) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.reason(answer.reason);
    json.member("mobility", static_cast<std::uint64_t>(answer.mobility));
    json.member("loops", static_cast<std::uint64_t>(answer.loops));
    json.key("joints").array(answer.joints, [&](const JointRange& joint) {
      json.object([&] {
        json.member("joint", joint.joint);
        json.key("bodies").array(std::array{joint.first, joint.second},
                                 [&](const std::string& body) { json.string(body); });
        json.member("unit", joint.slides ? "length" : "degrees");
        write_extreme(json, "least", joint.least);
        write_extreme(json, "greatest", joint.greatest);
      });
    });
    json.key("transmission").array(answer.transmission, [&](const TransmissionAngle& angle) {
      json.object([&] {
        json.member("joint", angle.joint);
        json.key("links").array(angle.links, [&](const std::string& link) { json.string(link); });
        write_extreme(json, "least", angle.least);
        write_extreme(json, "greatest", angle.greatest);
      });
    });
    if (answer.lock) json.lock(*answer.lock);
    if (!answer.instants.empty()) {
      json.key("instants").array([&] {
        for (std::size_t i = 0; i < answer.instants.size(); ++i) {
          json.object([&] {
            json.member("t", answer.instants[i]);
            json.key("values").array(answer.values[i], [&](const std::array<double, 2>& v) {
              json.numbers({v[0], v[1]});
            });
          });
        }
      });
    }
    json.scope();
  });
}

std::string mechanism_csv(const Scene& scene, const MechanismMotion& answer) {
  std::string text = "t";
  for (const MechanismJoint& joint : scene.mechanism->joints)
    text += "," + io::csv_field(joint.name + " lo") + "," + io::csv_field(joint.name + " hi");
  text += "\n";
  for (std::size_t i = 0; i < answer.instants.size(); ++i) {
    text += io::number_text(answer.instants[i]);
    for (const auto& [lo, hi] : answer.values[i]) text += "," + io::number_text(lo) + "," + io::number_text(hi);
    text += "\n";
  }
  return text;
}

}  // namespace taut

namespace taut::internal {
namespace {

Reply ask_mechanism(const Scene& scene, const GivenOptions& given) {
  MechanismOptions options;
  options.instants = static_cast<std::size_t>(given.whole_number("instants"));
  options.limits = given.limits();
  return {mechanism_json(scene, mechanism_motion(scene, options))};
}

}  // namespace

std::vector<QuestionEntry> mechanism_questions() {
  return {{"mechanism",
           "How a mechanism moves: the ranges of its joints, transmission angles, and locks.",
           "MechanismAnswer",
           {whole_option("instants", 0, 1000000, 0,
                         "At how many instants, evenly over the time, all joint values are listed; 0, or 2 at least."),
            max_seconds_option()},
           ask_mechanism}};
}

}  // namespace taut::internal
