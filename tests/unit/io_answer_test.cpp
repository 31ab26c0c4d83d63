#include "io/answer_writer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

Scene two_bodies() {
  Scene scene;
  scene.end = 2.5;
  scene.bodies = {{"lid", {{0, 0}, {1, 0}, {0, 1}}, {}}, {"the \"bin\"", {{0, 0}, {1, 0}, {0, 1}}, {}}};
  return scene;
}

Answer contact_answer() {
  Answer answer;
  answer.outcome = Outcome::contact;
  answer.contact = Contact{{0.1, 0.25}, {0, 2}, {1, 1}, {12.5, -3}, {0, 1}};
  answer.pair = {0, 1};
  answer.coverage.pairs = answer.coverage.tested = 1;
  answer.events = 212;
  answer.certificates_initial = 7;
  answer.certificates_max = 30;
  return answer;
}

TEST(AnswerJson, OfAContactIsExactlyThis) {
  EXPECT_EQ(
      answer_json(two_bodies(), contact_answer(), Touch::open),
      R"({"outcome":"contact","t":[0.1,0.25],"contact":{"vertex":{"body":"lid","index":2},)"
      R"("edge":{"body":"the \"bin\"","index":1},"point":[12.5,-3],"normal":[0,1]},"pair":["lid","the \"bin\""],)"
      R"("coverage":{"pairs":1,"tested":1,"apart":0,"ignored":0,"moving_alike":0,"at_rest":0,"layers":0,"not_reached":0},"engine":"kinetic",)"
      R"("events":212,"certificates":{"initial":7,"max":30},)"
      R"("scope":{"bodies":["lid","the \"bin\""],"time":[0,2.5],"touch":"open"}})");
}

TEST(AnswerJson, OfASweepStatesTheAngle) {
  Scene scene = two_bodies();
  scene.bodies[1].motion = from_sweep({}, 0, 90, 0, 1);
  const auto answer = nlohmann::json::parse(answer_json(scene, contact_answer(), Touch::open));
  const auto& angle = answer.at("contact").at("angle_deg");
  ASSERT_EQ(angle.size(), 2u);
  EXPECT_LT(angle[0].get<double>(), 9);
  EXPECT_GT(angle[0].get<double>(), 9 - 1e-13);
  EXPECT_GT(angle[1].get<double>(), 22.5);
  EXPECT_LT(angle[1].get<double>(), 22.5 + 1e-13);
}

TEST(AnswerJson, OfNoContactHasNeitherTimeNorContact) {
  for (Outcome outcome : {Outcome::free, Outcome::overlap_at_start, Outcome::undecided}) {
    Answer answer;
    answer.outcome = outcome;
    answer.reason = "the limit of 3 events was reached";
    const auto json = nlohmann::json::parse(answer_json(two_bodies(), answer, Touch::closed));
    EXPECT_EQ(json.at("outcome"), to_string(outcome));
    EXPECT_EQ(json.at("scope").at("touch"), "closed");
    EXPECT_FALSE(json.contains("t"));
    EXPECT_FALSE(json.contains("contact"));
    EXPECT_FALSE(json.contains("timing"));
    EXPECT_EQ(json.contains("reason"), !answer.reason.empty());
    EXPECT_EQ(json.contains("free_until"), outcome == Outcome::undecided);
  }
}

TEST(AnswerJson, OfAnOverlapNamesAPoint) {
  Answer answer;
  answer.outcome = Outcome::overlap_at_start;
  answer.overlap_point = Point{0.5, -2};
  const std::string text = answer_json(two_bodies(), answer, Touch::open);
  EXPECT_EQ(text.find(R"({"outcome":"overlap_at_start","overlap":{"point":[0.5,-2]},"coverage":)"), 0u) << text;
}

TEST(AnswerJson, HandsIdsThrough) {
  Scene scene = two_bodies();
  scene.id = R"({"job":[1,"x"]})";
  scene.bodies[1].id = "17";
  const std::string text = answer_json(scene, contact_answer(), Touch::open);
  EXPECT_EQ(text.find(R"({"id":{"job":[1,"x"]},"outcome":"contact",)"), 0u) << text;
  EXPECT_NE(text.find(R"("edge":{"body":"the \"bin\"","id":17,"index":1})"), text.npos) << text;
  EXPECT_NE(text.find(R"("vertex":{"body":"lid","index":2})"), text.npos) << text;
}

TEST(AnswerJson, NamesTheEngineThatAnsweredOrBoth) {
  Answer answer = contact_answer();
  answer.engine = EngineName::spacetime;
  EXPECT_NE(answer_json(two_bodies(), answer, Touch::open).find(R"("engine":"spacetime")"), std::string::npos);
  answer.compared = true;
  EXPECT_NE(answer_json(two_bodies(), answer, Touch::open).find(R"("engine":"both")"), std::string::npos);
}

TEST(AnswerJson, HasTimingOnlyWhenAsked) {
  const std::string text = answer_json(two_bodies(), contact_answer(), Touch::open, AnswerTiming{0.5, 0.25, 1e-6});
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const auto timing = nlohmann::json::parse(text).at("timing");
  EXPECT_EQ(timing.at("read"), 0.5);
  EXPECT_EQ(timing.at("build"), 0.25);
  EXPECT_EQ(timing.at("run"), 1e-6);
}

}  // namespace
}  // namespace taut
