// Cells of joint values against single poses; conditions and convex pieces against their definitions.
#include <gtest/gtest.h>

#include <cmath>

#include "path/conditions.hpp"
#include "path/convex_pieces.hpp"
#include "path/joint_space.hpp"
#include "support/effort.hpp"
#include "support/made_path.hpp"
#include "support/made_world.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

using testing::effort;
using testing::random_linkage;
using testing::random_problem;
using testing::Rng;

TEST(Conditions, ExcludeEachOtherOnlyWhereTheyDo) {
  Rng rng(7);
  int excluded = 0, open = 0;
  for (std::uint64_t n = effort(20000); n > 0; --n) {
    std::vector<path::Condition> conditions(static_cast<std::size_t>(rng.between(1, 8)));
    const int joints = rng.between(1, 4);
    for (path::Condition& c : conditions) {
      c.constant = rng.real(-0.6, 1);
      for (int k = 0; k < joints; ++k) c.rate[static_cast<std::size_t>(k)] = rng.chance(0.2) ? 0 : rng.real(-1, 1);
    }
    const path::JointConditions all = path::decide(conditions);
    const auto least = [&](const std::array<double, max_joints>& h) {
      double smallest = INFINITY;
      for (const path::Condition& c : conditions) {
        double value = c.constant;
        for (std::size_t k = 0; k < h.size(); ++k) value += c.rate[k] * h[k];
        smallest = std::min(smallest, value);
      }
      return smallest;
    };
    const double best = least(all.best);
    ++(all.exclude_each_other ? excluded : open);
    EXPECT_EQ(all.exclude_each_other, best < 0) << best;
    for (int i = 0; i < 50; ++i) {
      std::array<double, max_joints> h{};
      for (double& x : h) x = rng.chance(0.3) ? rng.sign() : rng.real(-1, 1);
      ASSERT_LE(least(h), best + 1e-9);
    }
  }
  EXPECT_GT(excluded, 100);
  EXPECT_GT(open, 100);
}

TEST(ConvexPieces, AreConvexAndCoverThePart) {
  Rng rng(3);
  int found = 0;
  for (std::uint64_t n = effort(2000); n > 0; --n) {
    Part part = testing::star_part(rng, {rng.real(-1, 1), rng.real(-1, 1)}, 1, rng.chance(0.5) ? 0.3 : 0);
    const auto pieces = path::convex_pieces(part);
    if (!pieces) continue;
    ++found;
    const auto area = [](const Polygon& p) {
      double sum = 0;
      for (std::size_t i = 0; i < p.size(); ++i) {
        const Point &a = p[i], &b = p[(i + 1) % p.size()];
        sum += (a.x * b.y - a.y * b.x) / 2;
      }
      return std::fabs(sum);
    };
    double whole = area(part.outline), sum = 0;
    for (const Polygon& hole : part.holes) whole -= area(hole);
    for (const Polygon& piece : *pieces) sum += area(piece);
    EXPECT_NEAR(sum, whole, 1e-9);
  }
  EXPECT_GT(found, static_cast<int>(effort(2000) * 9 / 10));
}

/// What a cell is said to be, it is at combinations drawn from it.
TEST(JointSpace, CellsAreWhatTheySay) {
  Rng rng(11);
  int free = 0, colliding = 0;
  for (std::uint64_t n = effort(300); n > 0; --n) {
    const PathProblem problem = random_problem(rng, 3);
    for (const double clearance : {0.0, 0.1}) {
      const path::JointSpace space(problem, clearance);
      for (int i = 0; i < 30; ++i) {
        JointCell cell;
        for (std::size_t k = 0; k < 3; ++k) {
          cell.middle[k] = rng.real(k == 2 ? 0 : -2, k == 2 ? 360 : 2);
          cell.half[k] = std::exp2(rng.real(-12, -2)) * (k == 2 ? 90 : 1);
        }
        path::OpenPairs open = space.all_open();
        JointValues best{};
        const CellState state = space.evaluate(cell, open, &best);
        if (state == CellState::undecided) continue;
        ++(state == CellState::free ? free : colliding);
        for (int s = 0; s < 4; ++s) {
          JointValues at = cell.middle;
          for (std::size_t k = 0; k < 3; ++k) at[k] += cell.half[k] * (rng.chance(0.5) ? rng.sign() : rng.real(-1, 1));
          const Scene scene = posed(problem.linkage, at);
          const Outcome outcome = clearance > 0 ? check_clearance(scene, clearance).outcome : check(scene).outcome;
          EXPECT_EQ(outcome == Outcome::free, state == CellState::free) << to_string(outcome);
        }
      }
    }
  }
  EXPECT_GT(free, 50);
  EXPECT_GT(colliding, 50);
}

TEST(JointSpace, CellsOfRandomLinkagesAreWhatTheySay) {
  std::array<int, 3> seen{};
  for (std::uint64_t seed = 9000; seed < 9000 + effort(400); ++seed) {
    SCOPED_TRACE(seed);
    const PathProblem problem = random_linkage(seed);
    try {
      validate(problem.linkage);
    } catch (const InputError&) {
      continue;
    }
    Rng rng(seed);
    const path::JointSpace space(problem, 0);
    if (space.pairs().pairs().empty()) continue;
    for (int i = 0; i < 25; ++i) {
      JointCell cell;
      const double size = std::exp2(rng.real(-14, -1));
      for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
        const Joint& joint = problem.linkage.joints[k];
        cell.middle[k] = rng.real(joint.lo, joint.hi);
        cell.half[k] = size * (joint.hi - joint.lo) * rng.real(0.2, 1);
      }
      path::OpenPairs open = space.all_open();
      JointValues best{};
      CellState state = space.evaluate(cell, open, &best);
      if (state == CellState::undecided && space.collides_deeply(cell, open)) state = CellState::colliding;
      ++seen[static_cast<std::size_t>(state)];
      if (state == CellState::undecided) continue;
      for (int s = 0; s < 3; ++s) {
        JointValues at = cell.middle;
        for (std::size_t k = 0; k < at.size(); ++k)
          at[k] += cell.half[k] * (rng.chance(0.5) ? rng.sign() : rng.real(-1, 1));
        Scene scene = posed(problem.linkage, at);
        for (const auto& [a, b] : space.pairs().fixed())
          scene.ignore.push_back(
              {scene.bodies[static_cast<std::size_t>(a)].name, scene.bodies[static_cast<std::size_t>(b)].name});
        const Outcome outcome = check(scene).outcome;
        EXPECT_EQ(outcome == Outcome::free, state == CellState::free) << to_string(outcome);
      }
    }
  }
  for (const int n : seen) EXPECT_GT(n, 30);
}

}  // namespace
}  // namespace taut
