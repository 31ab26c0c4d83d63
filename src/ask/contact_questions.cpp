// The question about the first contact as text: check.
#include "ask/question.hpp"
#include "io/answer_writer.hpp"
#include "scene/mechanism_lock.hpp"
#include "taut/intervals.hpp"

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

// The questions about overlaps as text: intervals and range.

namespace {

using io::answer_text;
using io::AnswerWriter;

/// What meets when an overlap begins, or parts when it ends.
void write_meeting(AnswerWriter& json, const char* name, const std::optional<Contact>& contact) {
  if (!contact) return;
  json.key(name).object([&] {
    json.vertex("vertex", contact->vertex);
    json.edge("edge", contact->edge);
    json.member("point", contact->point);
    if (contact->grazing) json.member("grazing", true);
  });
}

void write_overlap(AnswerWriter& json, const OverlapInterval& overlap) {
  json.object([&] {
    json.pair("pair", overlap.pair);
    json.time("from", overlap.from);
    json.time("to", overlap.to);
    json.degrees("from_deg", overlap.pair, overlap.from);
    json.degrees("to_deg", overlap.pair, overlap.to);
    write_meeting(json, "enter", overlap.enter);
    write_meeting(json, "exit", overlap.exit);
  });
}

void write_range(AnswerWriter& json, const Range& answer) {
  json.key("range");
  if (answer.outcome != Outcome::free) return json.null();
  const auto end = [&](const char* name, const std::optional<TimeInterval>& t) {
    json.key(name);
    t ? json.numbers({t->lo, t->hi}) : json.null();
  };
  json.object([&] {
    end("from", answer.from);
    const bool to_lock = !answer.to && ends_at_lock(json.scene());
    end("to", to_lock ? TimeInterval{json.scene().end, json.scene().lock->time[1]} : answer.to);
    if (to_lock) {
      json.key("to_lock");
      json.boolean(true);
    }
    if (answer.before) json.degrees("from_deg", answer.before->pair, *answer.from);
    if (answer.after) json.degrees("to_deg", answer.after->pair, *answer.to);
  });
}

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

std::string intervals_json(const Scene& scene, const Intervals& answer, Touch touch) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.reason(answer.reason);
    json.key("intervals").array(answer.intervals, [&](const OverlapInterval& o) { write_overlap(json, o); });
    json.pair_answers("undecided", answer.undecided);
    json.grounds(answer.geometry, answer.coverage);
    json.scope(touch);
  });
}

std::string range_json(const Scene& scene, double from, const Range& answer, Touch touch) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.reason(answer.reason);
    write_range(json, answer);
    json.member("around", from);
    const auto overlap = [&](const char* name, const std::optional<OverlapInterval>& o) {
      if (!o) return;
      json.key(name);
      write_overlap(json, *o);
    };
    overlap("before", answer.before);
    overlap("after", answer.after);
    json.grounds(answer.geometry, answer.coverage);
    json.scope(touch);
  });
}

}  // namespace taut

namespace taut::internal {
namespace {

Reply ask_intervals(const Scene& scene, const GivenOptions& given) {
  return {intervals_json(scene, intervals(scene, given.check()), given.touch())};
}

Reply ask_range(const Scene& scene, const GivenOptions& given) {
  const double from = given.number("from");
  return {range_json(scene, from, range(scene, from, given.check()), given.touch())};
}

}  // namespace

std::vector<QuestionEntry> overlap_questions() {
  return {
      {"intervals",
       "All intervals of time in which bodies overlap.",
       "IntervalsAnswer",
       {touch_option(), max_seconds_option()},
       ask_intervals},
      {"range",
       "How far the bodies can go from an instant without overlapping, both ways.",
       "RangeAnswer",
       {required_number("from", "The instant, at which no bodies may overlap."), touch_option(), max_seconds_option()},
       ask_range}};
}

}  // namespace taut::internal
