// A mechanism moves the same way, however it is described: elsewhere, larger, seen from another link, by other names,
// backwards, or drawn in another pose.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "support/closed_linkage.hpp"
#include "support/effort.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
namespace {

/// Calls visit(point) for all places of a mechanism and its bodies.
template <class Visit>
void for_each_place(Scene& scene, const Visit& visit) {
  for (Body& body : scene.bodies) {
    for (Point& p : body.polygon) visit(p);
  }
  for (MechanismJoint& joint : scene.mechanism->joints) visit(joint.at);
}

/// Bodies are large enough to meet, and coordinates short enough for others to be exact, too.
Scene linkage_with_large_bodies(Rng& rng) {
  Scene scene = ClosedLinkage(rng, rng.between(1, 3)).scene();
  for (Body& body : scene.bodies) {
    const Point at = body.polygon[0];
    const auto corner = [&](double x, double y) { return Point{at.x + rng.real(0, x), at.y + rng.real(0, y)}; };
    body.polygon = {corner(-9, -9), corner(9, -9), corner(0, 9)};
  }
  for_each_place(scene, [](Point& p) {
    p = {std::nearbyint(p.x * 0x1p16) * 0x1p-16, std::nearbyint(p.y * 0x1p16) * 0x1p-16};
  });
  return scene;
}

std::optional<Intervals> intervals_if_regular(const Scene& scene) {
  try {
    const Scene moving = assembled(scene);
    if (moving.lock && moving.lock->kind == MechanismLock::Kind::undecided) return std::nullopt;
    return intervals(moving);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

bool near(const TimeInterval& a, const TimeInterval& b, double tolerance) {
  return a.lo <= b.hi + tolerance && b.lo <= a.hi + tolerance;
}

void expect_same(const Intervals& a, const Intervals& b, double tolerance) {
  EXPECT_EQ(a.outcome, b.outcome) << a.reason << b.reason;
  ASSERT_EQ(a.intervals.size(), b.intervals.size());
  for (std::size_t k = 0; k < a.intervals.size(); ++k) {
    EXPECT_EQ(a.intervals[k].pair, b.intervals[k].pair) << k;
    EXPECT_TRUE(near(a.intervals[k].from, b.intervals[k].from, tolerance))
        << k << " " << a.intervals[k].from.lo << " " << b.intervals[k].from.lo;
    EXPECT_TRUE(near(a.intervals[k].to, b.intervals[k].to, tolerance))
        << k << " " << a.intervals[k].to.lo << " " << b.intervals[k].to.lo;
  }
}

Scene moved_far_away(Scene scene) {
  for_each_place(scene, [](Point& p) { p = {p.x + 0x1p14, p.y - 0x1p15}; });
  return scene;
}

Scene enlarged(Scene scene) {
  for_each_place(scene, [](Point& p) { p = {p.x * 0x1p30, p.y * 0x1p30}; });
  return scene;
}

Scene seen_from_another_link(Scene scene) {
  scene.mechanism->ground = scene.bodies.back().name;
  return scene;
}

Scene renamed(Scene scene) {
  const auto renames = [](std::string& name) { name = "the " + name; };
  for (Body& body : scene.bodies) renames(body.name);
  renames(scene.mechanism->ground);
  for (MechanismJoint& joint : scene.mechanism->joints) {
    renames(joint.first);
    renames(joint.second);
  }
  // Another tree, with other joints that close the loops.
  std::reverse(scene.mechanism->joints.begin(), scene.mechanism->joints.end());
  return scene;
}

Scene backwards(Scene scene) {
  auto& line = *scene.mechanism->drives[0].pieces[0].line;
  std::swap(line[1], line[3]);
  return scene;
}

Intervals mirrored(Intervals answer) {
  for (OverlapInterval& interval : answer.intervals) {
    const TimeInterval from = interval.from;
    interval.from = {1 - interval.to.hi, 1 - interval.to.lo};
    interval.to = {1 - from.hi, 1 - from.lo};
  }
  std::stable_sort(answer.intervals.begin(), answer.intervals.end(), [](const auto& a, const auto& b) {
    return std::pair(a.pair, a.from.lo) < std::pair(b.pair, b.from.lo);
  });
  return answer;
}

/// The same mechanism, drawn as it is at time t; lengths are rounded.
Scene drawn_at(const Scene& scene, double t) {
  const std::vector<BodyPose> poses = poses_at(assembled(scene), t);
  Scene other = scene;
  const auto pose = [&](const std::string& name) {
    const auto found =
        std::find_if(scene.bodies.begin(), scene.bodies.end(), [&](const Body& body) { return body.name == name; });
    return poses[static_cast<std::size_t>(found - scene.bodies.begin())];
  };
  const auto turned = [](const BodyPose& p, const Point& v) {
    return Point{p.axis.x * v.x - p.axis.y * v.y, p.axis.y * v.x + p.axis.x * v.y};
  };
  const auto placed = [&](const BodyPose& p, const Point& v) {
    const Point at = turned(p, v);
    return Point{at.x + p.origin.x, at.y + p.origin.y};
  };
  for (Body& body : other.bodies) {
    for (Point& p : body.polygon) p = placed(pose(body.name), p);
  }
  for (MechanismJoint& joint : other.mechanism->joints) {
    joint.at = placed(pose(joint.first), joint.at);
    joint.direction = turned(pose(joint.first), joint.direction);
  }
  auto& line = *other.mechanism->drives[0].pieces[0].line;
  const double drawn = line[3] * t;
  line[1] = -drawn;
  line[3] -= drawn;
  return other;
}

TEST(MechanismLaws, HoldForRandomLinkages) {
  int compared = 0, mirrors = 0, redrawn = 0;
  for (std::uint64_t seed = 0; seed < effort(100); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Scene scene = linkage_with_large_bodies(rng);
    const auto answer = intervals_if_regular(scene);
    if (!answer) continue;
    const bool locks = assembled(scene).lock.has_value();
    // Where following ends, up to the lock, depends on rounding.
    const double tolerance = locks ? 1e-7 : 1e-12;
    for (const auto& law : {moved_far_away, enlarged, seen_from_another_link, renamed}) {
      const auto other = intervals_if_regular(law(scene));
      if (!other) continue;
      expect_same(*answer, *other, tolerance);
      ++compared;
    }
    if (!locks) {
      if (const auto other = intervals_if_regular(backwards(scene))) {
        expect_same(*answer, mirrored(*other), tolerance);
        ++mirrors;
      }
      if (const auto other = intervals_if_regular(drawn_at(scene, 0.375))) {
        expect_same(*answer, *other, 1e-6);
        ++redrawn;
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(compared, static_cast<int>(enough(200)));
  EXPECT_GT(mirrors, static_cast<int>(enough(20)));
  EXPECT_GT(redrawn, static_cast<int>(enough(20)));
}

}  // namespace
}  // namespace taut::testing
