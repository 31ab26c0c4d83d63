// The question about joint values as text: envelope.
#include "ask/question.hpp"

#include <array>

#include "io/answer_writer.hpp"
#include "taut/envelope.hpp"

namespace taut::internal {
namespace {

using io::answer_text;
using io::AnswerWriter;

void write_values(AnswerWriter& json, const char* name, const Linkage& linkage,
                  const std::array<double, max_joints>& values) {
  json.key(name).array([&] {
    for (std::size_t k = 0; k < linkage.joints.size(); ++k) json.number(values[k]);
  });
}

void write_cell(AnswerWriter& json, const Linkage& linkage, const EnvelopeCell& cell) {
  json.object([&] {
    json.member("state", to_string(cell.state));
    write_values(json, "lo", linkage, cell.lo);
    write_values(json, "hi", linkage, cell.hi);
    if (cell.state != CellState::free) json.pair("pair", cell.pair);
  });
}

void write_colliding(AnswerWriter& json, const Linkage& linkage, const std::optional<EnvelopeWitness>& witness) {
  json.key("witness");
  if (!witness) return json.null();
  json.object([&] {
    json.key("values").object([&] {
      for (std::size_t k = 0; k < linkage.joints.size(); ++k)
        json.user_key(linkage.joints[k].name).number(witness->values[k]);
    });
    json.pair("pair", witness->pair);
  });
}

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

std::string envelope_json(const Linkage& linkage, const Envelope& answer, double tolerance, bool cells) {
  return answer_text(linkage.scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.key("joints").array(linkage.joints, [&](const Joint& joint) {
      json.object([&] {
        json.member("name", joint.name);
        json.member("range", {joint.lo, joint.hi});
      });
    });
    write_colliding(json, linkage, answer.witness);
    json.member("free", answer.free);
    json.member("colliding", answer.colliding);
    json.member("undecided", answer.undecided);
    json.member("tolerance", tolerance);
    json.reason(answer.reason);
    if (cells) json.key("cells").array(answer.cells, [&](const EnvelopeCell& c) { write_cell(json, linkage, c); });
    json.coverage(answer.coverage);
  });
}

}  // namespace taut

namespace taut::internal {
namespace {

Reply ask_envelope(const Linkage& linkage, const GivenOptions& given) {
  EnvelopeOptions options;
  options.limits = given.limits();
  options.tolerance = given.number("tolerance");
  return {envelope_json(linkage, envelope(linkage, options), options.tolerance, given.flag("cells"))};
}

}  // namespace

std::vector<QuestionEntry> envelope_questions() {
  return {{.name = "envelope",
           .meaning = "For which combinations of the joints' values the bodies keep apart.",
           .answer = "EnvelopeAnswer",
           .options = {number_option("tolerance", EnvelopeOptions{}.tolerance,
                                     "Cells shorter than this share of a joint's range are not divided any more."),
                       flag_option("cells", "The whole partition, too."), max_seconds_option()},
           .about_linkage = ask_envelope}};
}

}  // namespace taut::internal
