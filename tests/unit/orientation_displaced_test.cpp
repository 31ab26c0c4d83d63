// The displacement, and the orientation of displaced vertices of one body.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "geometry/displacement.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

TEST(Displacement, MovesEdgesToOneSide) {
  Rng rng(7);
  const double delta = 0x1p-30;  // coarse, so that doubles can measure it
  for (int i = 0; i < 300; ++i) {
    const int n = 3 + rng.below(9);
    std::vector<Point> polygon;
    for (int k = 0; k < n; ++k) {
      const double a = 2 * 3.14159265358979 * k / n, r = rng.real(0.3, 1);
      polygon.push_back({r * std::cos(a), r * std::sin(a)});
    }
    for (const Offset offset : {Offset::inward, Offset::outward}) {
      const auto moved = displace(polygon, offset, delta, static_cast<std::uint64_t>(i)).points;
      for (int k = 0; k < n; ++k) {
        const auto at = [&](int j) { return polygon[static_cast<std::size_t>((j + n) % n)]; };
        const DisplacedPoint& m = moved[static_cast<std::size_t>(k)];
        EXPECT_EQ(m.x, at(k).x);
        for (const auto& [a, b] : {std::pair{at(k - 1), at(k)}, std::pair{at(k), at(k + 1)}}) {
          const double length = std::hypot(b.x - a.x, b.y - a.y);
          const double side = ((b.x - a.x) * m.dy - (b.y - a.y) * m.dx) / length / delta;
          EXPECT_GE(offset == Offset::inward ? side : -side, 1.0) << n;
          EXPECT_LE(offset == Offset::inward ? side : -side, 2.0) << n;
        }
      }
    }
  }
}

TEST(DisplacedOrientation, TellsWhichStageAnswered) {
  const auto decided = [](const DisplacedPoint& x, const DisplacedPoint& y, const DisplacedPoint& z, Stage by,
                          int sign) {
    const StagedSign answer = orientation_staged(x, y, z);
    return answer.sign == sign && answer.stage == by;
  };
  const DisplacedPoint a{0, 0, 0, 0}, b{1, 0, 0, 0}, c{0.5, 1, 0, 0}, straight{2, 0, 0, 0};
  EXPECT_TRUE(decided(a, b, c, Stage::doubles, 1));
  EXPECT_TRUE(decided(a, b, straight, Stage::exact, 0));
  const DisplacedPoint up{2, 0, 0, 0x1p-200}, down{2, 0, 0x1p-190, -0x1p-201};
  EXPECT_TRUE(decided(a, b, up, Stage::exact, 1));
  EXPECT_TRUE(decided(a, b, down, Stage::exact, -1));
  // Not collinear by one unit in the last place.
  const DisplacedPoint p{0.1, 0.1, 0, 0}, q{0.2, 0.2, 0, 0}, r{0.3, std::nextafter(0.3, 1.0), 0, -0x1p-180};
  EXPECT_TRUE(decided(p, q, r, Stage::exact, 1));
  EXPECT_TRUE(decided(q, p, r, Stage::exact, -1));
  EXPECT_TRUE(decided(q, r, p, Stage::exact, 1));
}

}  // namespace
}  // namespace taut::testing
