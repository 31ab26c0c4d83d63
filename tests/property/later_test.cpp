// The law of time: a scene that takes place later, with the origins of its pieces, has the same answers, later.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "soak/soak_scene.hpp"
#include "support/effort.hpp"
#include "support/moved_in_time.hpp"
#include "support/small_world.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

/// All times that matter are multiples of 2^-20, and so all sums with this are doubles.
constexpr double much_later = 0x1.9p30;
constexpr double time_room = 0x1p-21;

double to_short_time(double t) { return std::ldexp(std::nearbyint(std::ldexp(t, 20)), -20); }

/// Whether that leaves a motion that joins up, validation says.
Scene at_short_times(Scene scene) {
  scene.start = to_short_time(scene.start);
  scene.end = to_short_time(scene.end);
  for (Body& body : scene.bodies) {
    for (MotionPiece& piece : body.motion.pieces) {
      if (std::isfinite(piece.until)) piece.until = to_short_time(piece.until);
      piece.origin = to_short_time(piece.origin);
    }
  }
  return scene;
}

void expect_later(const TimeInterval& early, const TimeInterval& late) {
  EXPECT_LE(early.lo, late.hi - much_later + time_room);
  EXPECT_GE(early.hi, late.lo - much_later - time_room);
}

void expect_later(const Answer& early, const Answer& late) {
  ASSERT_EQ(early.outcome, late.outcome) << early.reason << late.reason;
  ASSERT_EQ(early.contact.has_value(), late.contact.has_value());
  if (!early.contact) return;
  const TimeInterval &here = early.contact->time, &there = late.contact->time;
  expect_later(here, there);
  EXPECT_LE(there.hi - there.lo, here.hi - here.lo + 2 * time_room);
}

struct Tally {
  int asked = 0, contacts = 0, intervals = 0;
};

void compare(const Scene& early, Touch touch, EngineChoice engine, Tally& tally) {
  const Scene late = later(early, much_later);
  CheckOptions options;
  options.touch = touch;
  options.engine = engine;
  options.tell_touching = false;
  const Answer here = check(early, options);
  expect_later(here, check(late, options));
  std::ostringstream log;
  expect_later(here, prove(late, log, options));
  if (here.outcome == Outcome::free || here.outcome == Outcome::contact) {
    std::istringstream read(log.str());
    EXPECT_NO_THROW(verify(late, read));
  }
  const Clearance near = clearance(early), far = clearance(late);
  ASSERT_EQ(near.outcome, far.outcome);
  if (near.nearest) {
    const double size = 2e-9 * near.nearest->hi + 1e-10;
    EXPECT_LE(near.nearest->lo, far.nearest->hi + size);
    EXPECT_LE(far.nearest->lo, near.nearest->hi + size);
  }
  const Intervals first = intervals(early, options), second = intervals(late, options);
  ASSERT_EQ(first.outcome, second.outcome);
  ++tally.asked;
  tally.contacts += here.contact.has_value();
  // Ends of overlaps that doubles hardly tell apart there are taken together.
  if (first.intervals.size() != second.intervals.size()) {
    EXPECT_LT(second.intervals.size(), first.intervals.size());
    return;
  }
  for (std::size_t k = 0; k < first.intervals.size(); ++k) {
    expect_later(first.intervals[k].from, second.intervals[k].from);
    expect_later(first.intervals[k].to, second.intervals[k].to);
    ++tally.intervals;
  }
}

EngineChoice engine_of(std::uint64_t number) {
  constexpr EngineChoice engines[] = {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::either};
  return engines[number % 3];
}

TEST(LaterScenes, HaveTheSameAnswersLater) {
  Tally tally;
  for (std::uint64_t number = 0; number < effort(600); ++number) {
    const SoakScene s = number % 2 == 0 ? soak_contact_scene(number) : soak_scene(number);
    if (s.scene.bodies[0].polygon.size() + s.scene.bodies[1].polygon.size() > 120) continue;
    const Scene scene = at_short_times(s.scene);
    SCOPED_TRACE(number);
    try {
      compare(scene, s.touch, engine_of(number), tally);
    } catch (const InputError&) {
      continue;  // times of its own that rounding moved
    }
    if (::testing::Test::HasFailure()) FAIL() << write_scene(scene);
  }
  EXPECT_GT(tally.asked, static_cast<int>(enough(200)));
  EXPECT_GT(tally.contacts, static_cast<int>(enough(60)));
}

TEST(LaterScenes, OfManyBodiesToo) {
  Tally tally;
  for (std::uint64_t number = 0; number < effort(400); ++number) {
    const Scene scene = at_short_times(scene_of(small_world(number).world));
    SCOPED_TRACE(number);
    try {
      compare(scene, number % 2 ? Touch::open : Touch::closed, engine_of(number), tally);
    } catch (const InputError&) {
      continue;
    }
    if (::testing::Test::HasFailure()) FAIL() << write_scene(scene);
  }
  EXPECT_GT(tally.asked, static_cast<int>(enough(200)));
  EXPECT_GT(tally.intervals, static_cast<int>(enough(60)));
}

}  // namespace
}  // namespace taut::testing
