// What a leg's clock keeps: a pair of bodies with many parts has hundreds of clocks.
#include "relative/leg_clock.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "relative/make_legs.hpp"

namespace taut::testing {
namespace {

/// Of a body that rests and one that turns so, from 0 to 1.
Leg turning_leg(const Rotation& rotation) {
  MotionPiece piece;
  piece.rotation = rotation;
  return make_legs(std::vector<MotionPiece>{MotionPiece{}}, std::vector<MotionPiece>{piece}, 0, 1).front();
}

void expect_room_where_it_is_needed() {
  LegClock clock;
  const Leg smooth = turning_leg(AngleRotation{{0, 20}});
  clock.reset(smooth);
  for (int k = 0; k <= 1000; ++k) clock.at(k / 1000.0, k % 2 == 0);
  const std::size_t little = clock.bytes();
  EXPECT_GT(little, 0u);
  EXPECT_LT(little, std::size_t{3} << 19);
  // The cosine of the angle reaches 1 where the leg ends.
  const Leg singular = turning_leg(CosineRotation{{0, 1}});
  clock.reset(singular);
  for (int k = 1; k <= 40; ++k) clock.at(1 - std::ldexp(1.0, -k), true);
  EXPECT_GT(clock.bytes(), 4 * little);
  // The cells of one leg are not taken for those of the next one.
  const Leg other = turning_leg(CosineRotation{{0.5, 0.5}});
  LegClock fresh;
  clock.reset(other);
  fresh.reset(other);
  for (int k = 1; k <= 40; ++k) {
    const double t = 1 - std::ldexp(1.0, -k);
    EXPECT_EQ(clock.cell(t).start, fresh.cell(t).start);
    for (int f = 0; f < 3; ++f) EXPECT_EQ(clock.cell(t).third(true).most[f], fresh.cell(t).third(true).most[f]);
  }
}

/// In a thread of its own, which keeps no room of another clock's.
TEST(LegClock, RoomForSingularInstantsIsMadeWhereThereIsOne) { std::thread(expect_room_where_it_is_needed).join(); }

}  // namespace
}  // namespace taut::testing
