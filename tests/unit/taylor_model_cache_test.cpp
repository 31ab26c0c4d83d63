// What a segment's clock keeps: a pair of bodies with many parts has hundreds of clocks.
#include "motion/taylor_model_cache.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "motion/motion_segments.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// Of a body that rests and one that turns so, from 0 to 1.
MotionSegment turning_segment(const Rotation& rotation) {
  MotionPiece piece;
  piece.rotation = rotation;
  return make_segments(std::vector<MotionPiece>{MotionPiece{}}, std::vector<MotionPiece>{piece}, 0, 1).front();
}

void expect_room_where_it_is_needed() {
  TaylorModelCache clock;
  const MotionSegment smooth = turning_segment(AngleRotation{{0, 20}});
  clock.reset(smooth);
  for (int k = 0; k <= 1000; ++k) clock.at(k / 1000.0, k % 2 == 0);
  const std::size_t little = clock.bytes();
  EXPECT_GT(little, 0u);
  EXPECT_LT(little, std::size_t{3} << 19);
  // The cosine of the angle reaches 1 where the segment ends.
  const MotionSegment singular = turning_segment(CosineRotation{{0, 1}});
  clock.reset(singular);
  for (int k = 1; k <= 40; ++k) clock.at(1 - std::ldexp(1.0, -k), true);
  EXPECT_GT(clock.bytes(), 4 * little);
  // The cells of one segment are not taken for those of the next one.
  const MotionSegment other = turning_segment(CosineRotation{{0.5, 0.5}});
  TaylorModelCache fresh;
  clock.reset(other);
  fresh.reset(other);
  for (int k = 1; k <= 40; ++k) {
    const double t = 1 - std::ldexp(1.0, -k);
    EXPECT_EQ(clock.cell(t).start, fresh.cell(t).start);
    for (int f = 0; f < 3; ++f) EXPECT_EQ(clock.cell(t).third(true).most[f], fresh.cell(t).third(true).most[f]);
  }
}

/// In a thread of its own, which keeps no room of another clock's.
TEST(TaylorModelCache, RoomForSingularInstantsIsMadeWhereThereIsOne) {
  std::thread(expect_room_where_it_is_needed).join();
}

}  // namespace
}  // namespace taut::testing
