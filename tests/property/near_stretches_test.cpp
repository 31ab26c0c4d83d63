// Stretches of time outside of which boxes are apart: nothing overlaps there, and intervals of overlap are those that a
// walk through all of the time finds.
#include "scene/meeting_boxes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "solver/overlap_intervals.hpp"
#include "support/effort.hpp"
#include "support/small_world.hpp"

namespace taut::testing {
using namespace internal;
namespace {

bool within_some(const std::vector<TimeInterval>& stretches, double t) {
  return std::any_of(stretches.begin(), stretches.end(), [t](const TimeInterval& s) { return s.lo <= t && t <= s.hi; });
}

bool same_interval(const OverlapInterval& a, const OverlapInterval& b) {
  const auto meet = [](const TimeInterval& s, const TimeInterval& t) {
    return s.lo <= t.hi && t.lo <= s.hi && s.hi - s.lo <= 1e-12 && t.hi - t.lo <= 1e-12;
  };
  return meet(a.from, b.from) && meet(a.to, b.to) && a.enter.has_value() == b.enter.has_value() &&
         a.exit.has_value() == b.exit.has_value();
}

/// What was looked at, so that nothing is true of nothing.
struct Looked {
  int pairs = 0, partly = 0, never = 0, found = 0;
};

class PairOfWorld {
 public:
  PairOfWorld(const MadeWorld& world, const Instance& instance, const NearStretches& near, int a, int b)
      : world_(world), instance_(instance), a_(a), b_(b), known_(near.pairs().count({a, b}) > 0) {
    if (known_) stretches_ = near.pairs().at({a, b});
  }

  /// By definition, at some instants.
  void expect_apart_outside() const {
    for (std::size_t i = 1; i < stretches_.size(); ++i) EXPECT_LT(stretches_[i - 1].hi, stretches_[i].lo);
    for (int k = 0; k <= 64; ++k) {
      const double t = world_.end * k / 64;
      if (within_some(stretches_, t)) continue;
      EXPECT_FALSE(overlap_clearly(posed(world_, a_, t), posed(world_, b_, t), 1e-9)) << a_ << ' ' << b_ << ' ' << t;
    }
  }
  void expect_same_intervals(Offset offset, Looked& looked) const {
    const std::vector<TimeInterval> whole{{instance_.start(), instance_.end()}};
    const auto expected = overlap_intervals(instance_, a_, b_, whole, offset, true);
    const auto said = overlap_intervals(instance_, a_, b_, stretches_, offset, false);
    ASSERT_EQ(said.size(), expected.size()) << a_ << ' ' << b_;
    for (std::size_t i = 0; i < said.size(); ++i) EXPECT_TRUE(same_interval(said[i], expected[i])) << a_ << ' ' << b_;
    ++looked.pairs;
    looked.never += !known_;
    looked.partly += known_ && (stretches_.empty() || stretches_[0].hi - stretches_[0].lo < world_.end);
    looked.found += static_cast<int>(said.size());
  }

 private:
  const MadeWorld& world_;
  const Instance& instance_;
  int a_, b_;
  bool known_;
  std::vector<TimeInterval> stretches_;
};

TEST(NearStretches, HoldAllOverlaps) {
  Looked looked;
  for (std::uint64_t number = 0; number < effort(300); ++number) {
    SCOPED_TRACE(number);
    const MadeWorld world = number % 30 == 0 ? large_world(number).world : small_world(number).world;
    const Instance instance(scene_of(world));
    const NearStretches near(instance);
    const int n = static_cast<int>(world.bodies.size());
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) {
        if (!instance.asked(a, b)) continue;
        const PairOfWorld pair(world, instance, near, a, b);
        pair.expect_apart_outside();
        if (n < 10) pair.expect_same_intervals(number % 2 == 0 ? Offset::inward : Offset::outward, looked);
      }
    }
  }
  EXPECT_GT(looked.partly, looked.pairs / 20);
  EXPECT_GT(looked.never, looked.pairs / 20);
  EXPECT_GT(looked.found, looked.pairs / 20);
}

}  // namespace
}  // namespace taut::testing
