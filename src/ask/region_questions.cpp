#include <array>

#include "ask/question.hpp"
#include "io/answer_writer.hpp"
#include "taut/cells.hpp"
#include "taut/envelope.hpp"
#include "taut/swept.hpp"

namespace taut::internal {

// The question about joint values as text: envelope.

namespace {

using io::answer_text;
using io::AnswerWriter;

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
    if (answer.may_lock > 0) json.member("may_lock", answer.may_lock);
    if (answer.other_poses) json.member("other_poses", true);
    json.member("tolerance", tolerance);
    json.reason(answer.reason);
    if (cells)
      json.key("cells").array(answer.cells, [&](const EnvelopeCell& c) { json.cell(c, linkage.joints.size()); });
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

// The question about the cells of a grid that a body touches, as text.

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

// The question about the region that a body passes over, as text.

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
