// The questions about distances as text: clearance, profile, and whether a clearance is kept.
#include "ask/question.hpp"

#include "io/answer_writer.hpp"
#include "io/json_writer.hpp"
#include "taut/clearance.hpp"

namespace taut::internal {
namespace {

using io::answer_text;
using io::AnswerWriter;

void write_nearest(AnswerWriter& json, const NearestPoints& nearest) {
  json.object([&] {
    json.member("lo", nearest.lo);
    json.member("hi", nearest.hi);
    json.time("t", nearest.time);
    json.pair("pair", nearest.pair);
    json.degrees("angle_deg", nearest.pair, nearest.time);
    if (nearest.hi > 0) json.nearest(nearest);
  });
}

/// What the pair is to keep, as in the scene, and what that is at the time that its answer is about.
void write_own_margin(AnswerWriter& json, const PairMargin& pair) {
  const Margin& margin = pair.margin;
  if (margin.coefficients.size() == 1) {
    json.member("margin", margin.coefficients[0]);
    return;
  }
  json.key("margin").array(margin.coefficients, [&](double c) { json.number(c); });
  if (margin.origin != 0) json.member("origin", margin.origin);
  if (pair.outcome != Outcome::free) json.member("margin_at", pair.margin_at);
}

/// The members of one pair's answer.
void write_margin(AnswerWriter& json, const PairMargin& pair) {
  json.pair("bodies", pair.bodies);
  json.member("outcome", to_string(pair.outcome));
  if (pair.outcome == Outcome::contact) json.time("t", pair.time);
  if (pair.grazing) json.member("grazing", true);
  if (!json.scene().clearances.empty()) write_own_margin(json, pair);
  if (pair.features) json.features(*pair.features);
  if (pair.nearest) {
    json.member("distance", pair.nearest->hi);
    json.nearest(*pair.nearest);
  }
  if (pair.outcome != Outcome::free) json.member("free_until", pair.free_until);
  json.reason(pair.reason);
}

void write_margins(AnswerWriter& json, const char* name, const std::vector<PairMargin>& pairs) {
  if (pairs.empty()) return;
  json.key(name).array(pairs, [&](const PairMargin& pair) { json.object([&] { write_margin(json, pair); }); });
}

void write_curve(AnswerWriter& json, const DistanceCurve& curve) {
  json.object([&] {
    if (curve.pair) {
      json.pair("pair", *curve.pair);
    } else {
      json.key("pair").null();
    }
    json.key("largest").object([&] {
      json.member("lo", curve.largest_lo);
      json.member("hi", curve.largest_hi);
      json.member("t", curve.largest_at);
      json.member("settled", curve.settled);
      if (!curve.wide.empty()) json.member("wide", curve.wide);
    });
    json.key("instants").array(curve.instants, [&](const DistanceAt& d) { json.numbers({d.t, d.lo, d.hi}); });
    json.key("stretches").array(curve.stretches, [&](const DistanceWithin& d) {
      json.numbers({d.from, d.to, d.lo, d.hi});
    });
  });
}

}  // namespace
}  // namespace taut::internal

namespace taut {
using namespace internal;

std::string clearance_json(const Scene& scene, const Clearance& answer) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.key("clearance");
    answer.nearest ? write_nearest(json, *answer.nearest) : json.null();
    if (!answer.pairs.empty())
      json.key("pairs").array(answer.pairs, [&](const NearestPoints& n) { write_nearest(json, n); });
    json.reason(answer.reason);
    if (!answer.wide.empty()) json.member("wide", answer.wide);
    json.grounds(answer.geometry, answer.coverage);
    json.scope();
  });
}

std::string profile_json(const Scene& scene, const DistanceProfile& answer) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.key("profile").array(answer.curves, [&](const DistanceCurve& c) { write_curve(json, c); });
    json.reason(answer.reason);
    json.grounds(answer.geometry, answer.coverage);
    json.scope();
  });
}

std::string margin_json(const Scene& scene, double clearance, const MarginAnswer& answer, Touch touch) {
  return answer_text(scene, [&](AnswerWriter& json) {
    json.verdict(to_string(answer.outcome));
    json.member("clearance", clearance);
    if (!scene.clearances.empty()) json.key("clearances").raw(io::clearances_text(scene.clearances));
    if (answer.first) {
      const PairMargin& first = *answer.first;
      if (first.outcome == Outcome::contact) json.time("t", first.time);
      json.pair("pair", first.bodies);
      json.key("first").object([&] { write_margin(json, first); });
    }
    write_margins(json, "also", answer.also);
    write_margins(json, "pairs", answer.pairs);
    if (answer.outcome == Outcome::undecided || answer.outcome == Outcome::locked)
      json.member("free_until", answer.free_until);
    json.reason(answer.reason);
    json.grounds(answer.geometry, answer.coverage);
    json.scope(touch);
  });
}

}  // namespace taut

namespace taut::internal {
namespace {

Reply ask_margin(const Scene& scene, const GivenOptions& given) {
  const double clearance = given.number("clearance");
  return {margin_json(scene, clearance, check_clearance(scene, clearance, given.check()), given.touch())};
}

/// What clearance() and distance_profile() have in common.
template <class Options>
Options distance_options(const GivenOptions& given) {
  Options options;
  options.limits = given.limits();
  options.relative = given.number("tolerance");
  options.all_pairs = given.all_pairs();
  return options;
}

Reply ask_clearance(const Scene& scene, const GivenOptions& given) {
  auto options = distance_options<ClearanceOptions>(given);
  options.within = given.number("within");
  return {clearance_json(scene, clearance(scene, options))};
}

Reply ask_profile(const Scene& scene, const GivenOptions& given) {
  ProfileOptions options = distance_options<ProfileOptions>(given);
  options.instants = static_cast<int>(given.whole_number("instants"));
  return {profile_json(scene, distance_profile(scene, options))};
}

OptionEntry tolerance_option() {
  return number_option("tolerance", ClearanceOptions{}.relative,
                       "How wide brackets may be, as a share of the distance.");
}

}  // namespace

std::vector<QuestionEntry> distance_questions() {
  return {{"check_clearance",
           "Do all bodies keep this distance, and if not, when and where do they first come closer?",
           "MarginAnswer",
           {clearance_option(), touch_option(), pairs_option(), max_seconds_option()},
           ask_margin},
          {"clearance",
           "How close bodies come over the scene's time, as a certain bracket.",
           "ClearanceAnswer",
           {tolerance_option(), pairs_option(),
            number_option("within", ClearanceOptions{}.within,
                          "With all pairs: only those that may come as close as this, in the scene's units."),
            max_seconds_option()},
           ask_clearance},
          {"distance_profile",
           "The distance over time in certain brackets: at instants, between them, and the greatest.",
           "ProfileAnswer",
           {whole_option("instants", 2, 1000000, static_cast<std::uint64_t>(ProfileOptions{}.instants),
                         "At how many instants, evenly spaced."),
            tolerance_option(), pairs_option(), max_seconds_option()},
           ask_profile}};
}

}  // namespace taut::internal
