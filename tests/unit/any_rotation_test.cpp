// Bounds that hold however often bodies rotate, against the bodies' poses at many instants.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/motion_segment.hpp"
#include "spacetime/any_rotation.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
using namespace internal;
using spacetime::AnyRotation;
using spacetime::Box;
namespace {

using Rectangle = std::array<Point, 4>;

Box random_box(Rng& rng, double size) {
  const double angle = rng.real(0, 6.3);
  Box box;
  box.centre = {rng.real(-size, size), rng.real(-size, size)};
  box.along = {std::cos(angle), std::sin(angle)};
  box.half_length = rng.real(0.01, size);
  box.half_width = rng.real(0.01, box.half_length);
  box.radius = std::hypot(box.half_length, box.half_width) * (1 + 1e-12);
  return box;
}

/// By the pose as the scene's motion defines it, with the functions of the standard library.
Rectangle placed(const Box& box, const MotionPiece& piece, double t) {
  const BodyPose pose = pose_at({{piece}}, t);
  Rectangle corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const double u = (k == 0 || k == 3 ? -1 : 1) * box.half_length, w = (k < 2 ? -1 : 1) * box.half_width;
    const double x = box.centre.x + u * box.along.x - w * box.along.y;
    const double y = box.centre.y + u * box.along.y + w * box.along.x;
    corners[k] = {pose.origin.x + pose.axis.x * x - pose.axis.y * y, pose.origin.y + pose.axis.y * x + pose.axis.x * y};
  }
  return corners;
}

double distance_to_side(const Point& p, const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
  const double along = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length, 0.0, 1.0);
  return std::hypot(p.x - a.x - along * x, p.y - a.y - along * y);
}

bool holds(const Rectangle& r, const Point& p) {
  for (std::size_t k = 0; k < 4; ++k) {
    const Point &a = r[k], &b = r[(k + 1) % 4];
    if ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) < 0) return false;
  }
  return true;
}

/// Rectangles that cross without a corner in the other one have corners near the other's sides, or sides that cross.
bool cross(const Rectangle& r, const Rectangle& s) {
  const auto side = [](const Point& a, const Point& b, const Point& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
  };
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Point &a = r[i], &b = r[(i + 1) % 4], &c = s[k], &d = s[(k + 1) % 4];
      if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) return true;
    }
  }
  return false;
}

double distance_between(const Rectangle& r, const Rectangle& s) {
  if (holds(r, s[0]) || holds(s, r[0]) || cross(r, s)) return 0;
  double least = INFINITY;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      least =
          std::min({least, distance_to_side(r[i], s[k], s[(k + 1) % 4]), distance_to_side(s[i], r[k], r[(k + 1) % 4])});
    }
  }
  return least;
}

MotionPiece random_piece(Rng& rng, bool rotates, double away) {
  MotionPiece piece;
  piece.x = {away * rng.real(-1, 1), rng.real(-0.2, 0.2)};
  piece.y = {away * rng.real(-1, 1), rng.real(-0.2, 0.2), rng.real(-0.05, 0.05)};
  if (rotates) piece.rotation = AngleRotation{{rng.real(-3, 3), rng.real(-40, 40)}};
  return piece;
}

TEST(AnyRotation, NeverCallsFarWhatComesNear) {
  int far = 0, near = 0, far_by_distance = 0;
  for (std::uint64_t seed = 0; seed < effort(4000); ++seed) {
    Rng rng(seed);
    const double away = rng.chance(0.5) ? 6 : 1.5, margin = rng.chance(0.5) ? 0 : rng.real(0, 1);
    const bool p_rotates = rng.chance(0.6), q_rotates = rng.chance(0.6);
    const MotionPiece p = random_piece(rng, p_rotates, away), q = random_piece(rng, q_rotates, away);
    const double start = rng.real(-2, 2), end = start + rng.real(0.01, 2);
    const Box box_p = random_box(rng, rng.chance(0.3) ? 4 : 1), box_q = random_box(rng, 1);
    const bool says_far =
        AnyRotation(MotionSegment::motion(p, q, start, end), start, end).farther(box_p, box_q, margin);
    double least = INFINITY;
    constexpr int samples = 60;
    for (int k = 0; k <= samples; ++k) {
      const double t = start + (end - start) * k / samples;
      least = std::min(least, distance_between(placed(box_p, p, t), placed(box_q, q, t)));
    }
    if (says_far) {
      ASSERT_GT(least, margin - 1e-9) << "seed " << seed;
      ++far;
      far_by_distance += p_rotates && q_rotates;
    }
    near += least <= margin;
  }
  // Both answers are common, also where both bodies rotate.
  EXPECT_GT(far, static_cast<int>(enough(600)));
  EXPECT_GT(far_by_distance, static_cast<int>(enough(100)));
  EXPECT_GT(near, static_cast<int>(enough(300)));
}

}  // namespace
}  // namespace taut::testing
