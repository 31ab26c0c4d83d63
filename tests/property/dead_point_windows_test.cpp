// How many windows a search takes to a dead point, where only a box of the joints' values is known at the end.
#include <gtest/gtest.h>

#include <algorithm>

#include "solver/pair_solver.hpp"
#include "spacetime/frame_window.hpp"
#include "taut/io.hpp"

namespace taut::testing {
namespace {

TEST(DeadPointWindows, AreNotOneInstantLong) {
  const Scene scene = read_scene("tests/corpus/mechanisms/toggle_straight_at_the_end.json");
  const internal::Instance world(scene);
  int turning = 0;
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) {
      if (world.excluded(a, b)) continue;
      const internal::PairInstance pair(world, a, b, internal::Offset::inward);
      for (std::size_t i = 0; i < pair.segments().size(); ++i) {
        const internal::MotionSegment& segment = pair.segments()[i];
        if (segment.translation) continue;
        ++turning;
        int windows = 0;
        double wanted = segment.end - segment.start;
        for (double t = segment.start; t < segment.end && windows < 2000; ++windows) {
          internal::spacetime::FrameWindow window(segment, t, segment.end,
                                                  std::min(wanted, segment.end - segment.start));
          wanted = window.fitting_length();
          t = window.end();
        }
        // Cells of the joints' values become shorter before it by halves, some fifty.
        EXPECT_LT(windows, 500) << a << " " << b;
      }
    }
  }
  EXPECT_GT(turning, 1);
}

}  // namespace
}  // namespace taut::testing
