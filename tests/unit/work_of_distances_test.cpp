// What questions about distances cost where doubles tell little: work is the same on every machine.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "base/interruption.hpp"
#include "taut/clearance.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

Scene in_corpus(const char* name) { return read_scene(std::string("tests/corpus/") + name + ".json"); }

/// Far above what it takes, so that a test that fails ends.
constexpr double many_seconds = 20;

TEST(WorkOfAClearance, FarFromTheOriginAtAJoint) {
  ClearanceOptions options;
  options.max_seconds = many_seconds;
  const std::uint64_t before = work_spent();
  const Clearance found = clearance(in_corpus("combs_far_from_the_origin_with_a_joint"), options);
  EXPECT_LT(work_spent() - before, 20'000u);
  ASSERT_TRUE(found.nearest) << found.reason;
  EXPECT_NEAR(found.nearest->lo, 0.02, 1e-8);
  EXPECT_NEAR(found.nearest->hi, 0.02, 1e-8);
}

void expect_profile(const char* name, double greatest, std::uint64_t limit) {
  ProfileOptions options;
  options.instants = 9;
  options.max_seconds = many_seconds;
  const std::uint64_t before = work_spent();
  const DistanceProfile found = distance_profile(in_corpus(name), options);
  EXPECT_LT(work_spent() - before, limit) << name;
  ASSERT_EQ(found.reason, "") << name;
  EXPECT_LE(found.curves[0].largest_lo, greatest * (1 + 1e-12)) << name;
  EXPECT_GE(found.curves[0].largest_hi, greatest * (1 - 1e-12)) << name;
  EXPECT_LE(found.curves[0].largest_hi - found.curves[0].largest_lo, 2e-6 * greatest) << name;
}

TEST(WorkOfAProfile, ThatIsGreatestAtAnInfiniteSpeed) {
  expect_profile("greatest_distance_at_an_infinite_speed", 63.998046875, 4'000'000);
}

TEST(WorkOfAProfile, OfSliversThatSlideALittleApart) {
  expect_profile("slivers_that_slide_a_little_apart", 956, 1'000'000);
}

}  // namespace
}  // namespace taut
