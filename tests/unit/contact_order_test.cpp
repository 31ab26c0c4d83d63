// Contacts of different pairs that come nearly at once.
#include <gtest/gtest.h>

#include <algorithm>

#include "taut/check.hpp"

namespace taut {
namespace {

/// A unit square whose right side is `gap` before the wall, moved by t^2 + slant t along x.
Body racer(const std::string& name, double gap, double slant, double y) {
  Body body;
  body.name = name;
  body.polygon = {{-gap - 1, y}, {-gap, y}, {-gap, y + 1}, {-gap - 1, y + 1}};
  MotionPiece piece;
  piece.until = 4;
  piece.x = {0, slant, 1};
  body.motion.pieces = {piece};
  return body;
}

Scene race(std::vector<Body> racers) {
  Scene scene;
  scene.end = 4;
  Body wall;
  wall.name = "wall";
  wall.polygon = {{0, -10}, {1, -10}, {1, 10}, {0, 10}};
  scene.bodies = {wall};
  for (Body& body : racers) scene.bodies.push_back(std::move(body));
  return scene;
}

Answer asked_of(const Scene& scene, Touch touch, EngineChoice engine) {
  CheckOptions options;
  options.touch = touch;
  options.engine = engine;
  return check(scene, options);
}

constexpr EngineChoice every_engine[] = {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::both,
                                         EngineChoice::either, EngineChoice::usual};

TEST(ContactOrder, RootsThatDifferBy1e20AreToldApart) {
  // sqrt(2), less what the slant takes off.
  const Scene scene = race({racer("late", 2, 0, 0), racer("first", 2, 1.6e-20, 2), racer("second", 2, 0.8e-20, 4)});
  for (const EngineChoice engine : every_engine) {
    for (const Touch touch : {Touch::open, Touch::closed}) {
      const Answer answer = asked_of(scene, touch, engine);
      ASSERT_EQ(answer.outcome, Outcome::contact) << to_string(engine);
      EXPECT_EQ(*answer.pair, (std::array<BodyId, 2>{0, 2})) << to_string(engine);
      EXPECT_TRUE(answer.also.empty()) << to_string(engine);
    }
  }
}

TEST(ContactOrder, EqualRootsComeTogetherInTheOrderOfTheScene) {
  Scene scene = race({racer("a", 2, 0, 0), racer("slow", 2, -1e-20, 2), racer("b", 2, 0, 4), racer("c", 2, 0, 6)});
  // It moves as the others do, but is written otherwise, so that it is no copy of them.
  scene.bodies[3].motion.pieces[0].until = 2;
  scene.bodies[3].motion.pieces.push_back(scene.bodies[1].motion.pieces[0]);
  for (const EngineChoice engine : every_engine) {
    const Answer answer = asked_of(scene, Touch::open, engine);
    ASSERT_EQ(answer.outcome, Outcome::contact) << to_string(engine);
    EXPECT_EQ(*answer.pair, (std::array<BodyId, 2>{0, 1})) << to_string(engine);
    ASSERT_EQ(answer.also.size(), 2u) << to_string(engine);
    EXPECT_EQ(answer.also[0].bodies, (std::array<BodyId, 2>{0, 3}));
    EXPECT_EQ(answer.also[1].bodies, (std::array<BodyId, 2>{0, 4}));
  }
}

TEST(ContactOrder, WhatDoublesEncloseTogetherIsOrderedWhateverTheOrderOfTheScene) {
  // 0.3 is not three times 0.1: the times, about 10, differ by less than an ulp of theirs.
  const auto straight = [](const std::string& name, double gap, double speed, double y) {
    Body body = racer(name, gap, 0, y);
    body.motion.pieces[0].until = 20;
    body.motion.pieces[0].x = {0, speed};
    return body;
  };
  std::vector<Body> racers{straight("tenth", 1, 0.1, 0), straight("three", 3, 0.3, 2)};
  for (int k = 0; k < 2; ++k) {
    Scene scene = race(racers);
    scene.end = 20;
    const Answer answer = asked_of(scene, Touch::open, EngineChoice::usual);
    ASSERT_EQ(answer.outcome, Outcome::contact);
    // 0.1 is rounded up, and 0.3 down.
    EXPECT_EQ(scene.bodies[static_cast<std::size_t>((*answer.pair)[1])].name, "tenth");
    EXPECT_TRUE(answer.also.empty());
    std::reverse(racers.begin(), racers.end());
  }
}

TEST(ContactOrder, ContactsWithoutSpeedComeTogetherWhereTheirBracketsDo) {
  // Both come to the wall with no speed, and stop at it: in closed reading they touch, at t = 2 or nearly.
  const auto halting = [](const std::string& name, double slant, double y) {
    Body body = racer(name, 4, 0, y);
    body.motion.pieces[0].x = {0, 4 + slant, -1};
    return body;
  };
  const Scene scene = race({halting("a", 0, 0), halting("b", 0, 4)});
  const Answer answer = asked_of(scene, Touch::closed, EngineChoice::both);
  ASSERT_EQ(answer.outcome, Outcome::contact);
  EXPECT_EQ(*answer.pair, (std::array<BodyId, 2>{0, 1}));
  ASSERT_EQ(answer.also.size(), 1u);
  EXPECT_LE(answer.contact->time.lo, 2);
  EXPECT_GE(answer.contact->time.hi, 2);
}

}  // namespace
}  // namespace taut
