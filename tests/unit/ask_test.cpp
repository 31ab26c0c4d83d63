// Questions as text say what the functions say, and refuse what they do not know.
#include "taut/ask.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "taut/cells.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/outline.hpp"
#include "taut/proof.hpp"
#include "taut/separate.hpp"

namespace taut::testing {
namespace {

Scene falling_hammer() {
  return parse_scene(R"({"format": "taut-scene/1", "time": [0, 10], "bodies": [
    {"name": "anvil", "polygon": [[0, 0], [4, 0], [4, 1], [0, 1]]},
    {"name": "hammer", "polygon": [[1, 5], [3, 5], [2, 6]], "motion": {"y": [0, -0.5]}}]})");
}

std::string json_of(const std::string& name, const std::string& options = "{}") {
  static const Scene mechanism = read_scene("examples/mechanisms/toggle_press.json");
  // A follower has no motion of its own.
  Scene scene = name == "mechanism" ? mechanism : falling_hammer();
  if (name == "follow") scene.bodies[1].motion = {};
  return ask({.name = name, .options = options}, scene).json;
}

TEST(Ask, AnswersAsTheFunctions) {
  const Scene scene = falling_hammer();
  CheckOptions closed;
  closed.touch = Touch::closed;
  closed.engine = EngineChoice::kinetic;
  EXPECT_EQ(json_of("check", R"({"touch": "closed", "engine": "kinetic"})"),
            answer_json(scene, check(scene, closed), Touch::closed));
  EXPECT_EQ(json_of("check_clearance", R"({"clearance": 0.5})"),
            margin_json(scene, 0.5, check_clearance(scene, 0.5), Touch::open));
  EXPECT_EQ(json_of("clearance"), clearance_json(scene, clearance(scene)));
  ProfileOptions three;
  three.instants = 3;
  EXPECT_EQ(json_of("distance_profile", R"({"instants": 3})"), profile_json(scene, distance_profile(scene, three)));
  EXPECT_EQ(json_of("intervals"), intervals_json(scene, intervals(scene), Touch::open));
  EXPECT_EQ(json_of("range", R"({"from": 1})"), range_json(scene, 1, range(scene, 1), Touch::open));
  SeparateOptions near;
  near.travel = 2;
  EXPECT_EQ(json_of("separate", R"({"travel": 2})"), separation_json(scene, separate(scene, near)));
}

TEST(Ask, FindsCells) {
  const Scene scene = falling_hammer();
  CellOptions options;
  options.resolution = 0.5;
  options.origin = {0.25, 0};
  EXPECT_EQ(json_of("cells", R"({"body": "hammer", "resolution": 0.5, "origin_x": 0.25})"),
            cells_json(scene, 1, cells(scene, 1, options)));
}

TEST(Ask, Flattens) {
  const Scene scene = parse_scene(R"({"format": "taut-scene/1", "time": [0, 1], "bodies": [
    {"name": "plate", "polygon": [[5, 5], [6, 5], [5, 6]]},
    {"name": "disc", "parts": [{"path": "M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z", "z": [1, 2]}]}]})");
  for (const auto& [side, word] : {std::pair{CurveSide::outer, "outer"}, std::pair{CurveSide::inner, "inner"}}) {
    const std::string options = std::string(R"({"tolerance": 0.01, "side": ")") + word + "\"}";
    const Scene flat = parse_scene(ask({.name = "flatten", .options = options}, scene).json);
    EXPECT_EQ(flat.bodies[0].polygon.size(), 3u);
    ASSERT_EQ(flat.bodies[1].parts.size(), 1u);
    const Part& disc = flat.bodies[1].parts[0];
    EXPECT_TRUE(disc.z && disc.z->lo == 1 && disc.z->hi == 2);
    for (const Point& p : disc.outline) {
      const double away = std::hypot(p.x, p.y) - 1;
      EXPECT_TRUE(side == CurveSide::outer ? away > -1e-15 && away < 0.02 : away < 1e-15 && away > -0.02) << away;
    }
  }
}

TEST(Ask, ProvesExactly) {
  const Scene scene = falling_hammer();
  const Reply proof = ask({.name = "prove", .options = R"({"exact": true})"}, scene);
  const nlohmann::json log = nlohmann::json::parse(proof.log);
  EXPECT_EQ(log["format"], "taut-exact/1");
  EXPECT_LT(log["until"].get<double>(), 8);
  EXPECT_GT(log["until"].get<double>(), 7.9);
  EXPECT_EQ(proof.scene_sha256, to_hex(scene_fingerprint(scene, Touch::closed)));
  // The verifier of other logs says whose it is.
  const std::string said = ask({.name = "verify", .log = proof.log}, scene).json;
  EXPECT_NE(said.find("taut-verified"), std::string::npos) << said;
}

TEST(Ask, ProvesAndVerifies) {
  const Scene scene = falling_hammer();
  for (const auto& [name, options] : {std::pair{"prove", "{}"}, {"prove_clearance", R"({"clearance": 0.5})"}}) {
    const Reply proof = ask({.name = name, .options = options}, scene);
    EXPECT_FALSE(proof.log.empty()) << name;
    EXPECT_EQ(proof.scene_sha256, to_hex(scene_fingerprint(scene, Touch::open)));
    EXPECT_EQ(ask({.name = "verify", .log = proof.log}, scene).json.substr(0, 13), R"({"valid":true)");
    std::string damaged = proof.log;
    damaged.pop_back();
    EXPECT_EQ(ask({.name = "verify", .log = damaged}, scene).json.substr(0, 14), R"({"valid":false)");
  }
}

TEST(Ask, StopsByItsLimits) {
  const std::atomic<bool> stop{true};
  const Reply stopped =
      ask({.name = "check", .options = R"({"engine": "spacetime"})", .stop = &stop}, falling_hammer());
  EXPECT_NE(stopped.json.find(R"("outcome":"undecided")"), std::string::npos);
  EXPECT_NE(json_of("clearance", R"({"max_seconds": 0})").find(R"("reason":"the time limit was reached")"),
            std::string::npos);
}

/// Where an error is, and what it advises.
std::pair<std::string, std::string> refusal(const std::string& name, const std::string& options = "{}") {
  try {
    json_of(name, options);
  } catch (const InputError& error) {
    return {error.place(), error.what()};
  }
  ADD_FAILURE() << name << " took " << options;
  return {};
}

TEST(Ask, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(refusal("chekc").first, "question");
  EXPECT_NE(refusal("chekc").second.find("did you mean check?"), std::string::npos);
  EXPECT_NE(refusal("envelope").second.find("joints"), std::string::npos);
  EXPECT_EQ(refusal("check", R"({"touch": "ajar"})").first, "touch");
  EXPECT_EQ(refusal("distance_profile", R"({"instants": 1})").first, "instants");
  EXPECT_NE(refusal("clearance", R"({"touch": "closed"})").second.find("touch"), std::string::npos);
  EXPECT_NE(refusal("range").second.find("from"), std::string::npos);
  EXPECT_NE(refusal("check", R"({"max_second": 1})").second.find("did you mean \"max_seconds\"?"), std::string::npos);
}

void expect_refused(const std::string& name, const std::string& options, const std::string& place) {
  SCOPED_TRACE(options);
  try {
    json_of(name, options);
    ADD_FAILURE() << "it was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(place + ": "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("hint: "), std::string::npos) << error.what();
  }
}

TEST(Ask, RefusesCountsAndLimitsThatMakeNoSense) {
  for (const std::string number : {"-1", "1.5", "1e300", "-1e-300"}) {
    expect_refused("check", R"({"max_events": )" + number + "}", "max_events");
    expect_refused("prove", R"({"max_events": )" + number + "}", "max_events");
    expect_refused("distance_profile", R"({"instants": )" + number + "}", "instants");
  }
  for (const auto& known : {"check", "clearance", "intervals", "separate", "prove", "distance_profile"})
    expect_refused(known, R"({"max_seconds": -1})", "max_seconds");
  expect_refused("clearance", R"({"tolerance": 1.5})", "tolerance");
  EXPECT_NO_THROW(json_of("check", R"({"max_events": 0})"));
  EXPECT_NO_THROW(json_of("check", R"({"max_events": 9007199254740992})"));
}

/// A value that the option takes, and one of another type.
std::pair<std::string, std::string> values_of(const nlohmann::json& option) {
  const std::string type = option["type"];
  if (type == "word") return {option["words"].back().dump(), "7"};
  if (type == "flag") return {"true", "7"};
  // A text is a body's name.
  if (type == "text") return {R"("hammer")", "7"};
  return {type == "number" ? "0.125" : "300", "true"};
}

TEST(Ask, DescribesTheOptionsThatQuestionsTake) {
  const auto questions = nlohmann::json::parse(question_descriptions());
  EXPECT_EQ(questions.size(), question_names().size());
  for (const auto& question : questions) {
    const std::string name = question["name"];
    EXPECT_EQ(asked_about(name), question["about"]);
    EXPECT_EQ(question["meaning"].get<std::string>().back(), question["name"] == "check_clearance" ? '?' : '.');
    if (asked_about(name) != "scene") continue;
    std::string all;
    for (const auto& option : question["options"])
      all += (all.empty() ? "" : ", ") + option["name"].dump() + ": " + values_of(option).first;
    EXPECT_NO_THROW(json_of(name, "{" + all + "}")) << name << " " << all;
    for (const auto& option : question["options"]) {
      const std::string key = option["name"];
      std::string others;
      for (const auto& other : question["options"])
        if (other != option) others += ", " + other["name"].dump() + ": " + values_of(other).first;
      expect_refused(name, "{\"" + key + "\": " + values_of(option).second + others + "}", key);
    }
  }
}

TEST(Ask, NamesEveryQuestionOnce) {
  std::vector<std::string> names = question_names();
  EXPECT_EQ(names.front(), "check");
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace taut::testing
