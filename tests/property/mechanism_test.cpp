// Mechanisms against closed forms in 2,000 bits: where all links are at any time, with which speed, and when it locks.
#include <gtest/gtest.h>

#include <optional>

#include "motion/joint_functions.hpp"
#include "motion/pose.hpp"
#include "support/closed_linkage.hpp"
#include "support/effort.hpp"
#include "support/sum_of_doubles.hpp"
#include "taut/error.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// The pieces that a body follows, from the ground on.
PieceChain chain_of(const Scene& scene, int body) {
  PieceChain chain;
  for (const Body* b = &scene.bodies[static_cast<std::size_t>(body)];;) {
    if (!b->motion.pieces.empty()) chain.insert(chain.begin(), b->motion.pieces.front());
    if (b->relative_to.empty()) break;
    const std::string& parent = b->relative_to;
    b = &*std::find_if(scene.bodies.begin(), scene.bodies.end(),
                       [&](const Body& other) { return other.name == parent; });
  }
  if (chain.empty()) chain.push_back(MotionPiece{});
  return chain;
}

template <class Real>
bool encloses(const Ball<Real>& ball, const Long& x) {
  return boost::multiprecision::abs(sum_of_doubles<Long>(ball.mid) - x) <= Long(ball.rad);
}

/// Both coordinates of a marker, over a ball of times.
template <class Real>
std::array<Jet<Real>, 2> placed(const Scene& scene, const ClosedLinkage::Marker& marker, const Ball<Real>& t) {
  return placed_point(pose_of<Jet<Real>>(chain_of(scene, marker.body), t), LocalPoint(marker.at, {0, 0}));
}

class Comparison {
 public:
  explicit Comparison(const ClosedLinkage& linkage, const Scene& scene) : linkage_(linkage), scene_(scene) {}

  template <class Real>
  void values_at(double t, double widest) const {
    std::vector<LongPoint> expected;
    ASSERT_GT(linkage_.place(t, expected), 0) << t;
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const auto [x, y] = placed<Real>(scene_, linkage_.markers()[k], Ball<Real>::exact(t));
      EXPECT_TRUE(encloses(x.v, expected[k].x)) << t << " marker " << k;
      EXPECT_TRUE(encloses(y.v, expected[k].y)) << t << " marker " << k;
      EXPECT_LT(x.v.rad, widest) << t << " marker " << k;
    }
  }

  /// Values over a range of times contain those at its instants, and by the mean value theorem so does the slope.
  void values_over(double from, double to, Rng& rng) const {
    const Ball<double> range = Ball<double>::between(from, to);
    std::vector<LongPoint> a, b;
    const double s = rng.real(from, to), t = rng.real(from, to);
    if (s == t || linkage_.place(s, a) <= 0 || linkage_.place(t, b) <= 0) return;
    for (std::size_t k = 0; k < a.size(); ++k) {
      const auto [x, y] = placed<double>(scene_, linkage_.markers()[k], range);
      EXPECT_TRUE(encloses(x.v, a[k].x) && encloses(y.v, a[k].y)) << from << " " << to << " marker " << k;
      const Long slope = (b[k].x - a[k].x) / (Long(t) - Long(s));
      EXPECT_TRUE(!(x.d.rad < INFINITY) || encloses(x.d, slope)) << from << " " << to << " marker " << k;
    }
  }

 private:
  const ClosedLinkage& linkage_;
  const Scene& scene_;
};

/// Nothing where it is drawn nearly at a dead point.
std::optional<Scene> assembled_or_refused(const ClosedLinkage& linkage) {
  std::vector<LongPoint> points;
  try {
    return assembled(linkage.scene());
  } catch (const InputError& e) {
    EXPECT_LT(linkage.place(0, points), Long(1e-6)) << e.what();
    return std::nullopt;
  }
}

TEST(Mechanism, MovesAsClosedFormsSay) {
  int locks = 0, turns = 0, undecided = 0;
  for (std::uint64_t seed = 0; seed < effort(400); ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const ClosedLinkage linkage(rng, rng.between(1, 4));
    const auto scene = assembled_or_refused(linkage);
    if (!scene) continue;
    const Comparison comparison(linkage, *scene);
    for (int k = 0; k < 4; ++k) {
      const double t = k == 0 ? scene->end : rng.real(0, scene->end);
      comparison.values_at<double>(t, 1e-3);
      if (k > 0) comparison.values_at<Real960>(t, 1e-200);
      const double width = scene->end * std::ldexp(1, -rng.between(0, 20)), from = rng.real(0, scene->end - width);
      comparison.values_over(from, from + width, rng);
    }
    std::vector<LongPoint> points;
    const double past = scene->lock ? scene->lock->time[1] * (1 + 1e-12) : 0;
    if (!scene->lock) {
      ++turns;
      for (int k = 0; k <= 64; ++k) EXPECT_GT(linkage.place(k / 64.0, points), 0);
    } else if (scene->lock->kind == MechanismLock::Kind::dead_point) {
      ++locks;
      EXPECT_GT(linkage.place(scene->lock->time[0] * (1 - 1e-12), points), 0);
      EXPECT_LT(linkage.place(past, points), 0);
      EXPECT_LT(scene->lock->time[0] - scene->end, 1e-7);
      EXPECT_FALSE(scene->lock->joints.empty());
    } else {
      ++undecided;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(locks, static_cast<int>(enough(100)));
  EXPECT_GT(turns, static_cast<int>(enough(100)));
  EXPECT_LE(undecided, static_cast<int>(enough(20) * soak_times()));
}

/// Where one pin of a dyad is the crank's pivot, the dyad turns with the crank as a whole. Found by 20,000 rounds of
/// the test above: with links nearly in line, the Jacobian of such loops turns, as seen from the ground, out of reach
/// of its inverse at the middle of a cell, unless cells are a thousandth of a degree long.
TEST(Mechanism, FollowsLoopsThatTurnAsAWhole) {
  for (const std::uint64_t seed : {7163u, 8833u}) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const ClosedLinkage linkage(rng, rng.between(1, 4));
    const auto scene = assembled_or_refused(linkage);
    ASSERT_TRUE(scene);
    EXPECT_FALSE(scene->lock);
    const Comparison comparison(linkage, *scene);
    for (const double t : {0.0, 0.3, 0.7, 1.0}) {
      comparison.values_at<double>(t, 1e-3);
      comparison.values_at<Real960>(t, 1e-200);
    }
  }
}

}  // namespace
}  // namespace taut::testing
