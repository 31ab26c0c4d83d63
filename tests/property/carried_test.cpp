// A motion shared between a body and its parent: where a body is depends on the product of the two poses alone, so that
// any way of dividing one motion into two, without rounding, has the same answer. What is about a singular end of a
// plain segment has an oracle of its own; this holds chains against it.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/carried_scene.hpp"
#include "support/contact_scene.hpp"
#include "support/effort.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"

namespace taut::testing {
namespace {

bool has_cosine(const Body& body) {
  return std::any_of(body.motion.pieces.begin(), body.motion.pieces.end(), [](const MotionPiece& piece) {
    return std::holds_alternative<CosineRotation>(piece.rotation) && piece.orbit.angle.empty();
  });
}

Answer answer_to(const Scene& scene, Touch touch, EngineChoice engine) {
  CheckOptions options;
  options.touch = touch;
  options.engine = engine;
  options.tell_touching = false;
  return check(scene, options);
}

TEST(Carried, BodiesThatTurnWithInfiniteSpeedHaveTheSameAnswer) {
  int compared = 0, contacts = 0;
  for (std::uint64_t number = 0; number < effort(3000); ++number) {
    const Scene scene = contact_scene(number).scene;
    if (!has_cosine(scene.bodies[1])) continue;
    SCOPED_TRACE("contact scene " + std::to_string(number));
    try {
      for (const Touch touch : {Touch::open, Touch::closed}) {
        const Answer plain = answer_to(scene, touch, EngineChoice::either);
        for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
          const Answer chain = answer_to(carried(scene, number % 2 == 1), touch, engine);
          ASSERT_STREQ(to_string(chain.outcome), to_string(plain.outcome)) << chain.reason;
          ++compared;
          if (!chain.contact) continue;
          ++contacts;
          EXPECT_LE(chain.contact->time.lo, plain.contact->time.hi);
          EXPECT_LE(plain.contact->time.lo, chain.contact->time.hi);
        }
      }
    } catch (const InputError&) {
      // Blades fold.
    }
  }
  EXPECT_GT(std::min(compared - contacts, contacts), static_cast<int>(enough(100)));
}

}  // namespace
}  // namespace taut::testing
