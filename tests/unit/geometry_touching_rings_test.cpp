#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "geometry/part_rings.hpp"
#include "taut/validate.hpp"

namespace taut {
using namespace internal;
namespace {

double signed_area(const Polygon& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += (a.x * b.y - a.y * b.x) / 2;
  }
  return sum;
}

double area_of_parts(const std::vector<Part>& parts) {
  double sum = 0;
  for (const Part& part : parts) {
    sum += std::fabs(signed_area(part.outline));
    for (const Polygon& hole : part.holes) sum -= std::fabs(signed_area(hole));
  }
  return sum;
}

void expect_valid(const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    validate_polygon(part.outline, "outline");
    for (const Polygon& hole : part.holes) validate_polygon(hole, "hole");
    validate_holes(part, "part");
  }
}

TEST(TouchingRings, CutsAHoleThatTouchesTheOutlineOnce) {
  const Part part{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{5, 0}, {7, 3}, {3, 3}}, {{5, 6}, {6, 7}, {4, 7}}}};
  const std::vector<Part> parts = cut_where_rings_touch(part);
  EXPECT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].holes.size() + parts[1].holes.size(), 1u) << "the other hole stays one";
  EXPECT_EQ(area_of_parts(parts), 93);
  expect_valid(parts);
}

TEST(TouchingRings, LeavesOtherPartsAsTheyAre) {
  const auto same = [](const Part& part) {
    const std::vector<Part> parts = cut_where_rings_touch(part);
    return parts.size() == 1 && parts[0].outline == part.outline && parts[0].holes == part.holes;
  };
  const Polygon square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  EXPECT_TRUE(same({square, {}}));
  EXPECT_TRUE(same({square, {{{2, 2}, {4, 2}, {2, 4}}}}));
  // What is worse than touching at points is for validation to refuse.
  EXPECT_TRUE(same({square, {{{5, -1}, {7, 3}, {3, 3}}}})) << "crosses";
  EXPECT_TRUE(same({square, {{{2, 0}, {7, 0}, {3, 3}}}})) << "shares a piece of an edge";
  EXPECT_TRUE(same({square, {{{5, 0}, {7, -3}, {3, -3}}}})) << "lies outside";
  EXPECT_TRUE(same({square, {{{1, 1}, {9, 1}, {5, 9}}, {{5, 1}, {6, 2}, {4, 2}}}})) << "a hole in a hole";
  EXPECT_TRUE(same({square, {{{1, 1}, {1, 1}}}}));
}

/// Diamonds that touch each other, and the outline, at their corners: any of 5 x 5. Where they enclose something, that
/// is a part of its own.
TEST(TouchingRings, CutsAnyPatternOfDiamonds) {
  std::uint64_t state = 1;
  for (int round = 0; round < 500; ++round) {
    Part part{{{-1, -1}, {9, -1}, {9, 9}, {-1, 9}}, {}};
    for (int k = 0; k < 25; ++k) {
      state = state * 6364136223846793005u + 1442695040888963407u;
      if ((state >> 40) % 3 == 0) continue;
      const double x = 2 * (k % 5), y = 2 * (k / 5);
      part.holes.push_back({{x - 1, y}, {x, y - 1}, {x + 1, y}, {x, y + 1}});
    }
    const std::vector<Part> parts = cut_where_rings_touch(part);
    ASSERT_EQ(area_of_parts(parts), 100 - 2.0 * static_cast<double>(part.holes.size())) << round;
    expect_valid(parts);
  }
}

}  // namespace
}  // namespace taut
