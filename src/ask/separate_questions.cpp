// The question about ways apart as text: separate.
#include "ask/question.hpp"

#include "io/answer_writer.hpp"
#include "taut/io.hpp"
#include "taut/separate.hpp"

namespace taut::internal {
namespace {

using io::answer_text;
using io::AnswerWriter;

void write_arc(AnswerWriter& json, const DirectionArc& arc) {
  const auto vertices = [&](const char* name, const std::optional<std::array<VertexRef, 2>>& pair) {
    if (pair) json.key(name).array(*pair, [&](const VertexRef& v) { json.vertex(v); });
  };
  const auto reach = [&](const char* name, const std::optional<VertexAtEdge>& at) {
    if (!at) return;
    json.key(name).object([&] {
      json.vertex("vertex", at->vertex);
      json.edge("edge", at->edge);
    });
  };
  json.object([&] {
    json.member("from_deg", {arc.from.lo, arc.from.hi});
    json.member("to_deg", {arc.to.lo, arc.to.hi});
    json.member("point", arc.point);
    vertices("from_vertices", arc.from_vertices);
    vertices("to_vertices", arc.to_vertices);
    reach("from_reach", arc.from_reach);
    reach("to_reach", arc.to_reach);
  });
}

/// The members about one body.
void write_directions(AnswerWriter& json, const BodyDirections& of) {
  json.member("body", json.body(of.body).name);
  json.member("all", of.all);
  json.key("directions").array(of.free, [&](const DirectionArc& arc) { write_arc(json, arc); });
}

void write_removal(AnswerWriter& json, const Separation& answer) {
  json.key("bodies").array(answer.bodies,
                           [&](const BodyDirections& body) { json.object([&] { write_directions(json, body); }); });
  json.key("order").array(answer.order, [&](const RemovalStep& step) {
    json.object([&] {
      json.member("body", json.body(step.body).name);
      json.member("direction_deg", step.direction_deg);
      json.key("within");
      write_arc(json, step.free);
    });
  });
}

/// The members about ways with turns; without the bodies that are stuck, which are a member of straight ways, too.
void write_ways(AnswerWriter& json, const Separation& answer) {
  json.key("ways").array(answer.ways, [&](const RemovalWay& way) {
    json.object([&] {
      json.member("body", json.body(way.body).name);
      json.member("pivot", {way.pivot.x, way.pivot.y});
      json.key("points").array(way.points, [&](const WayPoint& at) {
        json.object([&] {
          json.member("x", at.x);
          json.member("y", at.y);
          json.member("deg", at.deg);
        });
      });
    });
  });
  json.key("unsure").array(answer.unsure, [&](BodyId id) { json.name(id); });
  json.member("rounded", answer.rounded);
}

/// Strings in JSON have no line breaks.
std::string on_one_line(std::string json) {
  std::erase(json, '\n');
  return json;
}

void write_stuck(AnswerWriter& json, const Separation& answer) {
  json.key("stuck").array(answer.stuck, [&](BodyId id) { json.name(id); });
}

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

std::string separation_json(const Scene& scene, const Separation& answer, const SeparateOptions& options,
                            bool removal) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.reason(answer.reason);
    if (!answer.wide.empty()) json.member("wide", answer.wide);
    if (answer.overlap) json.pair("pair", *answer.overlap);
    if (scene.bodies.size() == 2) {
      write_directions(json, answer.bodies.empty() ? BodyDirections{1, {}, false} : answer.bodies[0]);
    } else {
      write_removal(json, answer);
    }
    if (options.turns || scene.bodies.size() != 2) write_stuck(json, answer);
    if (options.turns) write_ways(json, answer);
    if (options.turns && removal) json.key("scene").raw(on_one_line(write_scene(removal_scene(scene, answer))));
    json.grounds(answer.geometry, answer.coverage);
  });
}

}  // namespace taut

namespace taut::internal {
namespace {

Reply ask_separate(const Scene& scene, const GivenOptions& given) {
  SeparateOptions options;
  options.limits = given.limits();
  options.travel = given.number("travel");
  options.turns = given.flag("turns");
  options.tolerance = given.number("tolerance");
  options.max_cells = given.whole_number("max_cells");
  const Separation answer = separate(scene, options);
  return {separation_json(scene, answer, options, given.flag("scene"))};
}

}  // namespace

std::vector<QuestionEntry> separate_questions() {
  return {{"separate",
           "In which directions bodies come apart, and in which order.",
           "SeparationAnswer",
           {number_option("travel", SeparateOptions{}.travel,
                          "How far bodies move straight, in the scene's units, > 0; without it, any distance."),
            flag_option("turns", "Also whether bodies come apart if the one that is taken away may turn on its way."),
            number_option("tolerance", SeparateOptions{}.tolerance,
                          "With turns: places and angles are divided down to this share of their ranges."),
            whole_option("max_cells", 1, UINT32_MAX, SeparateOptions{}.max_cells,
                         "With turns: a body is left undecided at so many cells."),
            flag_option("scene", "With turns: the scene in which the bodies leave, too."), max_seconds_option()},
           ask_separate}};
}

}  // namespace taut::internal
