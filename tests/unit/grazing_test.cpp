// Contacts so flat that the displacement moves them: what is said of their time is true of the bodies as given. The
// expected numbers are closed forms: a corner at the height (t - 1/2)^m above an edge is within h of it from
// 1/2 - h^(1/m) to 1/2 + h^(1/m).
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "taut/check.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"
#include "taut/simulation.hpp"

namespace taut {
namespace {

constexpr double touching = 0.5;  ///< when the corner is on the edge's line

/// sign (t - 1/2)^order, whose coefficients are exact.
Coefficients power_about_half(int order, double sign) {
  Coefficients c{sign};
  for (int k = 0; k < order; ++k) {
    Coefficients next(c.size() + 1, 0.0);
    for (std::size_t i = 0; i < c.size(); ++i) {
      next[i] -= c[i] * touching;
      next[i + 1] += c[i];
    }
    c = next;
  }
  return c;
}

/// A triangle above a square comes down on it by that power: it crosses the square's upper edge if the order is odd and
/// the sign -1, and touches it and rises again if the order is even and the sign 1.
Scene lowered(int order, double sign, double start = 0, double end = 1) {
  Coefficients y = power_about_half(order, sign);
  y[0] += 1;
  Scene scene;
  scene.start = start;
  scene.end = end;
  scene.bodies = {{"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}},
                  {"triangle", {{0.25, 0}, {0.75, 0.5}, {0.25, 0.5}}, {{{{}, y, NoRotation{}}}}}};
  return scene;
}

Answer ask(const Scene& scene, Touch touch, EngineChoice engine) {
  CheckOptions options;
  options.touch = touch;
  options.engine = engine;
  return check(scene, options);
}

/// The bodies' displacement lies between 2^-201 and 2^-197 of a coordinate near 1, their sum within twice that; how far
/// a corner goes along its bisector is at most 4 times as much here.
double earliest(int order) { return std::pow(0x1p-203, 1.0 / order); }
double latest(int order) { return std::pow(0x1p-193, 1.0 / order); }

/// Is the bracket around 1/2, and as long as the displacement makes it?
void expect_bracket(const Contact& contact, int order) {
  EXPECT_LE(contact.time.lo, touching);
  EXPECT_GE(contact.time.hi, touching);
  const double ulp = 0x1p-53;
  EXPECT_LE(touching - contact.time.lo, latest(order) + 2 * ulp) << order;
  EXPECT_LE(contact.time.hi - touching, latest(order) + 2 * ulp) << order;
  if (contact.grazing) {
    EXPECT_GE(contact.time.hi - contact.time.lo, earliest(order)) << order;
  }
  EXPECT_EQ(contact.grazing, order >= 4) << order;
}

constexpr EngineChoice engines[] = {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::either};

TEST(Grazing, CrossingOfOddOrderIsEnclosed) {
  for (int order = 1; order <= 15; order += 2) {
    for (const EngineChoice engine : engines) {
      for (const Touch touch : {Touch::open, Touch::closed}) {
        const Answer answer = ask(lowered(order, -1), touch, engine);
        ASSERT_EQ(answer.outcome, Outcome::contact) << order;
        expect_bracket(*answer.contact, order);
        EXPECT_EQ(answer.free_until, answer.contact->time.lo);
        EXPECT_FALSE(answer.touching);
      }
    }
  }
}

TEST(Grazing, TouchOfEvenOrderIsFreeByLittleOrAnEnclosedContact) {
  for (int order = 2; order <= 16; order += 2) {
    for (const EngineChoice engine : engines) {
      const Answer closed = ask(lowered(order, 1), Touch::closed, engine);
      ASSERT_EQ(closed.outcome, Outcome::contact) << order;
      expect_bracket(*closed.contact, order);
      const Answer open = ask(lowered(order, 1), Touch::open, engine);
      ASSERT_EQ(open.outcome, Outcome::free) << order;
      ASSERT_TRUE(open.touching) << order;
      EXPECT_EQ(open.touching->time.lo, closed.contact->time.lo);
      EXPECT_EQ(open.touching->time.hi, closed.contact->time.hi);
    }
  }
}

TEST(Grazing, ContactThatLeavesTheStartSlowlyBeginsThere) {
  for (int order = 1; order <= 16; ++order) {
    for (const EngineChoice engine : engines) {
      const Answer answer = ask(lowered(order, -1, touching, 1), Touch::open, engine);
      ASSERT_EQ(answer.outcome, Outcome::contact) << order;
      EXPECT_EQ(answer.contact->time.lo, touching);
      expect_bracket(*answer.contact, order);
    }
  }
}

TEST(Grazing, ApproachThatEndsInATouchIsEnclosed) {
  for (int order = 2; order <= 16; order += 2) {
    for (const EngineChoice engine : engines) {
      const Answer closed = ask(lowered(order, 1, 0, touching), Touch::closed, engine);
      ASSERT_EQ(closed.outcome, Outcome::contact) << order;
      EXPECT_EQ(closed.contact->time.hi, touching);
      expect_bracket(*closed.contact, order);
    }
  }
}

TEST(Grazing, BodiesThatTurnIntoEachOtherSlowly) {
  // A bar about its corner on the square's edge, by the angle (t - 1/2)^m: at 1/2 it lies on the edge.
  for (int order = 1; order <= 5; order += 2) {
    Scene scene;
    scene.start = 0;
    scene.end = 1;
    const Motion swing{{{{}, {}, AngleRotation{power_about_half(order, -1)}}}};
    scene.bodies = {{"square", {{-1, -2}, {8, -2}, {8, 0}, {0, 0}, {-1, 0.0}}, {}},
                    {"bar", {{0, 0}, {4, 0}, {4, 1}, {0, 1}}, swing}};
    const Answer answer = ask(scene, Touch::open, EngineChoice::both);
    ASSERT_EQ(answer.outcome, Outcome::contact) << order;
    EXPECT_LE(answer.contact->time.lo, touching);
    EXPECT_GE(answer.contact->time.hi, touching);
  }
}

TEST(Grazing, StretchThatIsNotFlatStaysAsItIs) {
  // Faces that slide on each other for a second, and then meet a wall head on.
  Scene scene;
  scene.start = 0;
  scene.end = 2;
  scene.bodies = {{"floor", {{0, 0}, {10, 0}, {10, 3}, {8, 3}, {8, 1}, {0, 1}}, {}},
                  {"box", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{{{6, 1}, {1}, NoRotation{}}}}}};
  for (const EngineChoice engine : engines) {
    const Answer answer = ask(scene, Touch::open, engine);
    ASSERT_EQ(answer.outcome, Outcome::contact);
    EXPECT_FALSE(answer.contact->grazing);
    EXPECT_LE(answer.contact->time.lo, 1);
    EXPECT_GE(answer.contact->time.hi, 1);
    EXPECT_LT(answer.contact->time.hi - answer.contact->time.lo, 1e-14);
  }
}

TEST(Grazing, FreeWithRoomDoesNotSpeakOfTouching) {
  Scene scene = lowered(2, 1);
  scene.bodies[1].motion.pieces[0].y[0] += 0x1p-40;
  for (const EngineChoice engine : engines) {
    const Answer answer = ask(scene, Touch::open, engine);
    EXPECT_EQ(answer.outcome, Outcome::free);
    EXPECT_FALSE(answer.touching);
    EXPECT_TRUE(answer.touching_undecided.empty());
  }
}

TEST(Grazing, IsSaidInJson) {
  const Scene flat = lowered(15, -1), touch = lowered(16, 1), steep = lowered(1, -1);
  const std::string grazing = "\"grazing\":true";
  EXPECT_NE(answer_json(flat, check(flat), Touch::open).find(grazing), std::string::npos);
  EXPECT_NE(answer_json(touch, check(touch), Touch::open).find(grazing + ",\"touching\":{\"t\":["), std::string::npos);
  EXPECT_EQ(answer_json(steep, check(steep), Touch::open).find("grazing"), std::string::npos);
  CheckOptions plain;
  plain.tell_touching = false;
  EXPECT_EQ(answer_json(touch, check(touch, plain), Touch::open).find("grazing"), std::string::npos);
}

TEST(Grazing, ProofsAndSimulationsSayTheSame) {
  for (const Touch touch : {Touch::open, Touch::closed}) {
    const Scene scene = lowered(touch == Touch::open ? 15 : 16, touch == Touch::open ? -1 : 1);
    CheckOptions options;
    options.touch = touch;
    std::stringstream log;
    const Answer answer = prove(scene, log, options);
    const Verified verified = verify(scene, log);
    ASSERT_TRUE(verified.contact);
    EXPECT_TRUE(verified.contact->grazing);
    EXPECT_EQ(verified.contact->time.lo, answer.contact->time.lo);
    Simulation simulation(scene, touch);
    EXPECT_EQ(simulation.advance_to(1), SimulationState::contact);
    EXPECT_TRUE(simulation.contact()->grazing);
  }
}

}  // namespace
}  // namespace taut
