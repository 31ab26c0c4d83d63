// A platform on three legs, one of which is held: a mechanism with two loops and two drives that gets into another pose
// at the same values without passing a lock. Carlo Innocenti and Vincenzo Parenti-Castelli described such platforms in
// "Singularity-free evolution from one configuration to another in serial and fully-parallel manipulators" (1992).
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "support/effort.hpp"
#include "support/two_drives.hpp"
#include "taut/envelope.hpp"
#include "taut/io.hpp"

namespace taut::testing {
namespace {

using LongPoint = std::array<long double, 2>;

constexpr std::array<LongPoint, 3> platform_feet{LongPoint{0, 0}, LongPoint{15.91L, 0}, LongPoint{0, 10}};
constexpr std::array<LongPoint, 3> platform_corners{LongPoint{0, 0}, LongPoint{17.04L, 0}, LongPoint{13.236L, 16.097L}};
constexpr long double platform_first_leg = 14.98L;

/// Its angle and that of the platform say where everything is.
struct Platform {
  long double leg, turn;

  LongPoint corner(std::size_t i) const {
    const long double c = std::cos(turn), s = std::sin(turn);
    return {platform_first_leg * std::cos(leg) + c * platform_corners[i][0] - s * platform_corners[i][1],
            platform_first_leg * std::sin(leg) + s * platform_corners[i][0] + c * platform_corners[i][1]};
  }
  long double length(std::size_t i) const {
    return std::hypot(corner(i)[0] - platform_feet[i][0], corner(i)[1] - platform_feet[i][1]);
  }
  /// Of the three lines along the legs, which meet in a point at a lock.
  long double determinant() const {
    std::array<std::array<long double, 3>, 3> m{};
    for (std::size_t i = 0; i < 3; ++i) {
      const long double x = (corner(i)[0] - platform_feet[i][0]) / length(i),
                        y = (corner(i)[1] - platform_feet[i][1]) / length(i);
      m[i] = {x, y, platform_feet[i][0] * y - platform_feet[i][1] * x};
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
};

Platform platform_at(long double leg, long double turn) {
  const long double one = std::acos(-1.0L) / 180;
  return {leg * one, turn * one};
}

/// The platform near `guess` whose second and third leg are as long as these; by Newton's method.
Platform with_lengths(Platform guess, long double second, long double third) {
  for (int step = 0; step < 50; ++step) {
    constexpr long double h = 1e-6L;
    const auto error = [&](long double leg, long double turn) {
      const Platform p{guess.leg + leg, guess.turn + turn};
      return LongPoint{p.length(1) - second, p.length(2) - third};
    };
    const LongPoint f = error(0, 0), a = error(h, 0), b = error(-h, 0), c = error(0, h), d = error(0, -h);
    const long double aa = (a[0] - b[0]) / (2 * h), ab = (c[0] - d[0]) / (2 * h), ba = (a[1] - b[1]) / (2 * h),
                      bb = (c[1] - d[1]) / (2 * h), det = aa * bb - ab * ba;
    guess.leg -= (bb * f[0] - ab * f[1]) / det;
    guess.turn -= (aa * f[1] - ba * f[0]) / det;
  }
  return guess;
}

Linkage drawn_platform(const Platform& at, const std::array<double, 4>& ranges) {
  const auto number = [](long double x) { return std::to_string(static_cast<double>(x)); };
  const auto point = [&](const LongPoint& p) { return "[" + number(p[0]) + ", " + number(p[1]) + "]"; };
  std::string bodies = R"({"name": "ground", "polygon": [[200, 0], [201, 0], [201, 1]]})", joints, ignore;
  bodies += R"(, {"name": "platform", "polygon": [)" + point(at.corner(0)) + ", " + point(at.corner(1)) + ", " +
            point(at.corner(2)) + "]}";
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string n = std::to_string(i);
    const LongPoint foot = platform_feet[i], corner = at.corner(i);
    for (const std::string part : {"cylinder ", "rod "}) {
      bodies += R"(, {"name": ")" + part + n + R"(", "polygon": [[300, 0], [301, 0], [301, 1]]})";
      ignore += (ignore.empty() ? "" : ", ") + (R"([")" + part + n + R"(", "*"])");
    }
    joints += R"("foot )" + n + R"(": {"revolute": ["ground", "cylinder )" + n + R"("], "at": )" + point(foot) + "}, ";
    joints += R"("leg )" + n + R"(": {"slide": ["cylinder )" + n + R"(", "rod )" + n + R"("], "direction": )" +
              point({corner[0] - foot[0], corner[1] - foot[1]}) + "}, ";
    joints += R"("corner )" + n + R"(": {"revolute": ["rod )" + n + R"(", "platform"], "at": )" + point(corner) + "}";
    if (i < 2) joints += ", ";
  }
  const auto range = [&](std::size_t k) { return "[" + number(ranges[k]) + ", " + number(ranges[k + 1]) + "]"; };
  return parse_linkage(R"({"format": "taut-scene/1", "bodies": [)" + bodies + R"(], "ignore": [)" + ignore +
                       R"(], "mechanism": {"ground": "ground", "joints": {)" + joints +
                       R"(}, "drive": {"leg 0": [0, 0], "leg 1": )" + range(0) + R"(, "leg 2": )" + range(2) + "}}}");
}

TEST(OtherPoses, AreSaidOfAPlatformThatChangesItsPose) {
  const std::vector<Platform> way{platform_at(-106, 44), platform_at(-96, 53), platform_at(-65, 53),
                                  platform_at(-63, 55)};
  const Platform begin = way.front(), end = with_lengths(platform_at(-35, 55), begin.length(1), begin.length(2));
  EXPECT_NEAR(static_cast<double>(end.length(1)), static_cast<double>(begin.length(1)), 1e-12);
  EXPECT_NEAR(static_cast<double>(end.length(2)), static_cast<double>(begin.length(2)), 1e-12);
  EXPECT_GT(end.leg - begin.leg, 1);
  // No lock on the way.
  std::vector<Platform> corners_of_way = way;
  corners_of_way.push_back(end);
  for (std::size_t k = 0; k + 1 < corners_of_way.size(); ++k) {
    for (int i = 0; i <= 1000; ++i) {
      const Platform &a = corners_of_way[k], &b = corners_of_way[k + 1];
      const Platform p{a.leg + i / 1000.0L * (b.leg - a.leg), a.turn + i / 1000.0L * (b.turn - a.turn)};
      ASSERT_LT(p.determinant(), -1);
    }
  }
  EnvelopeOptions options;
  options.tolerance = 0.01;
  const Envelope wide = envelope(drawn_platform(begin, {-8, 0.5, -3.6, 1.4}), options);
  EXPECT_TRUE(wide.other_poses);
  EXPECT_GT(wide.may_lock, 0);
  // Near the drawn pose, where no lock is, there is one.
  const Envelope near = envelope(drawn_platform(begin, {-0.05, 0.05, -0.05, 0.05}), options);
  EXPECT_FALSE(near.other_poses);
  EXPECT_EQ(near.may_lock, 0);
}

/// A sign for each loop tells which pose it is.
TEST(OtherPoses, AreNoneOfLoopsThatAreSolvedOneAfterTheOther) {
  Rng rng(3);
  int may_lock = 0;
  for (std::uint64_t n = effort(12); n > 0; --n) {
    const TwoDrives made(
        rng, rng.pick(std::vector{TwoDrives::Kind::bars, TwoDrives::Kind::slide, TwoDrives::Kind::two_loops}));
    if (!(made.margin(0, 0) > 0.05L)) continue;
    Linkage linkage;
    linkage.scene = made.scene();
    linkage.joints = {taut::Joint{"A", -60, 60}, taut::Joint{"E", -60, 60}};
    EnvelopeOptions options;
    options.tolerance = 0.1;
    const Envelope answer = envelope(assembled(linkage), options);
    EXPECT_FALSE(answer.other_poses) << n;
    may_lock += answer.may_lock > 0;
  }
  EXPECT_GE(may_lock, static_cast<int>(enough(3)));
}

}  // namespace
}  // namespace taut::testing
