// Ways of random problems: floods of grids, and problems that are the same but for how they are said.
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <sstream>

#include "path/convex_pieces.hpp"
#include "support/effort.hpp"
#include "support/made_path.hpp"
#include "support/made_world.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/path_proof.hpp"

namespace taut {
using namespace internal;
namespace {

using testing::effort;
using testing::expect_proved;
using testing::random_problem;
using testing::Rng;

/// A flood of a grid, by arithmetic of its own: through places that keep so far away that the bodies cannot meet on the
/// way to the next ones.
class Flood {
 public:
  Flood(const PathProblem& problem, int across) : problem_(problem), n_(across) {}

  bool reaches() {
    const bool turns = problem_.linkage.joints.size() == 3;
    const std::array<int, 3> size{n_, n_, turns ? n_ : 1};
    std::vector<char> seen(static_cast<std::size_t>(size[0] * size[1] * size[2]), 0);
    const auto index = [&](const std::array<int, 3>& c) {
      return static_cast<std::size_t>((c[0] * size[1] + c[1]) * size[2] + c[2]);
    };
    std::deque<std::array<int, 3>> todo;
    std::array<int, 3> first{}, last{};
    for (std::size_t k = 0; k < 2; ++k) {
      first[k] = std::clamp(static_cast<int>((problem_.start[k] + 2) / 4 * n_), 0, n_ - 1);
      last[k] = std::clamp(static_cast<int>(((*problem_.goal[k])[0] + 2) / 4 * n_), 0, n_ - 1);
    }
    const auto visit = [&](const std::array<int, 3>& c) {
      if (seen[index(c)]) return;
      seen[index(c)] = 1;
      if (is_free(c, turns)) todo.push_back(c);
    };
    visit(first);
    while (!todo.empty()) {
      const std::array<int, 3> c = todo.front();
      todo.pop_front();
      if (c[0] == last[0] && c[1] == last[1]) return true;
      for (std::size_t k = 0; k < (turns ? 3U : 2U); ++k) {
        for (const int step : {-1, 1}) {
          std::array<int, 3> next = c;
          next[k] += step;
          if (k == 2) next[k] = (next[k] + n_) % n_;
          if (next[k] >= 0 && next[k] < n_) visit(next);
        }
      }
    }
    return false;
  }

 private:
  bool is_free(const std::array<int, 3>& c, bool turns) const {
    using testing::Complex;
    const auto& motion = std::get<FreeMotion>(problem_.linkage.motions[0]->kind);
    const Complex pivot(motion.pivot.x, motion.pivot.y);
    const double x = -2 + 4 * (c[0] + 0.5) / n_, y = -2 + 4 * (c[1] + 0.5) / n_,
                 turn = turns ? 2 * M_PI * (c[2] + 0.5) / n_ : 0;
    testing::BodyAtPose mover, rest;
    double reach = 0;
    for (const Part& part : problem_.linkage.scene.bodies[0].parts) {
      testing::RingAtPose ring;
      for (const Point& p : part.outline) {
        const Complex arm = Complex(p.x, p.y) - pivot;
        reach = std::max(reach, std::abs(arm));
        ring.push_back(std::polar(1.0, turn) * arm + pivot + Complex(x, y));
      }
      mover.push_back({{ring}, {}});
    }
    for (const Part& part : problem_.linkage.scene.bodies[1].parts) {
      testing::RingAtPose ring;
      for (const Point& p : part.outline) ring.emplace_back(p.x, p.y);
      rest.push_back({{ring}, {}});
    }
    // Half a step along each joint.
    const double step = 2.0 / n_ * std::sqrt(2) + (turns ? M_PI / n_ * reach : 0);
    return !testing::overlap_clearly(mover, rest, 0) && testing::between_rings(mover, rest) > step * 1.001;
  }

  const PathProblem& problem_;
  int n_;
};

bool collides_at(const PathProblem& problem, const JointValues& values) {
  return check(posed(problem.linkage, values)).outcome != Outcome::free;
}

/// Where there is no way, there is a log that shows it.
void expect_log(const PathProblem& problem, const PathOptions& options) {
  std::ostringstream log;
  const PathAnswer answer = prove_path(problem, log, options);
  ASSERT_EQ(answer.outcome, PathOutcome::none) << answer.reason;
  std::istringstream in(log.str());
  EXPECT_NO_THROW(verify_path(problem, in));
}

TEST(PathLaws, NoWayHasALog) {
  int none = 0;
  for (std::uint64_t seed = 0; seed < effort(1000); ++seed) {
    SCOPED_TRACE(seed);
    PathProblem problem = testing::random_linkage(seed);
    Rng rng(seed + 77);
    for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
      const Joint& joint = problem.linkage.joints[k];
      problem.start[k] = rng.real(joint.lo, joint.hi);
      const double goal = rng.real(joint.lo, joint.hi);
      if (k == 0 || rng.chance(0.6)) problem.goal[k] = {goal, goal};
    }
    PathOptions options;
    options.tolerance = 0.01;
    options.max_cells = 3000;
    try {
      if (find_path(problem, options).outcome != PathOutcome::none) continue;
    } catch (const InputError&) {
      continue;  // it collides at the start, or is not valid
    }
    ++none;
    expect_log(problem, options);
  }
  EXPECT_GE(none, static_cast<int>(testing::enough(10)));
}

TEST(PathLaws, DoesNotMissWhatAFloodReaches) {
  Rng rng(21);
  std::array<int, 3> seen{};
  for (std::uint64_t n = effort(400); n > 0; --n) {
    SCOPED_TRACE(n);
    PathProblem problem = random_problem(rng, n % 2 ? 2 : 3);
    if (problem.linkage.joints.size() == 3) problem.goal[2].reset();
    if (problem.linkage.joints.size() == 3 && rng.chance(0.5)) problem.start[2] = rng.real(0, 360);
    JointValues goal{(*problem.goal[0])[0], (*problem.goal[1])[0]};
    if (collides_at(problem, problem.start)) continue;
    if (problem.linkage.joints.size() == 2 && collides_at(problem, goal)) continue;
    PathOptions options;
    options.tolerance = 1e-3;
    const PathAnswer answer = find_path(problem, options);
    ++seen[static_cast<std::size_t>(answer.outcome)];
    if (answer.outcome == PathOutcome::path) expect_proved(problem, answer, options);
    if (answer.outcome == PathOutcome::none) {
      EXPECT_FALSE(Flood(problem, problem.linkage.joints.size() == 3 ? 24 : 60).reaches());
      expect_log(problem, options);
    }
  }
  EXPECT_GE(seen[static_cast<std::size_t>(PathOutcome::path)], static_cast<int>(testing::enough(80)));
  EXPECT_GE(seen[static_cast<std::size_t>(PathOutcome::none)], static_cast<int>(testing::enough(10)));
}

/// The same problem said otherwise has the same outcome: the way back, in other units, elsewhere, with other joints,
/// and with the mover as two bodies that overlap.
TEST(PathLaws, LawsOfProblems) {
  Rng rng(31);
  for (std::uint64_t n = effort(150); n > 0; --n) {
    SCOPED_TRACE(n);
    PathProblem problem = random_problem(rng, 3);
    problem.goal[2] = {90, 90};
    const JointValues goal{(*problem.goal[0])[0], (*problem.goal[1])[0], 90};
    if (collides_at(problem, problem.start) || collides_at(problem, goal)) continue;
    PathOptions options;
    options.tolerance = 1e-3;
    const PathOutcome outcome = find_path(problem, options).outcome;
    if (outcome == PathOutcome::undecided) continue;
    const auto expect_same = [&](const PathProblem& other, const char* law) {
      const PathAnswer answer = find_path(other, options);
      EXPECT_TRUE(answer.outcome == outcome || answer.outcome == PathOutcome::undecided)
          << law << ": " << to_string(answer.outcome) << " instead of " << to_string(outcome);
    };
    PathProblem back = problem;
    back.start = goal;
    for (std::size_t k = 0; k < 3; ++k) back.goal[k] = {problem.start[k], problem.start[k]};
    expect_same(back, "back");
    PathProblem large = problem;
    for (Body& body : large.linkage.scene.bodies) {
      for (Part& part : body.parts) {
        for (Point& p : part.outline) p = {8 * p.x, 8 * p.y};
      }
    }
    auto& motion = std::get<FreeMotion>(large.linkage.motions[0]->kind);
    motion.pivot = {8 * motion.pivot.x, 8 * motion.pivot.y};
    for (std::size_t k = 0; k < 2; ++k) {
      large.linkage.joints[k].lo *= 8;
      large.linkage.joints[k].hi *= 8;
      large.start[k] *= 8;
      large.goal[k] = {8 * (*large.goal[k])[0], 8 * (*large.goal[k])[1]};
    }
    expect_same(large, "large");
    PathProblem renamed = problem;
    std::swap(renamed.linkage.joints[0], renamed.linkage.joints[2]);
    std::swap(renamed.start[0], renamed.start[2]);
    std::swap(renamed.goal[0], renamed.goal[2]);
    renamed.periodic = {true, false, false, false};
    std::get<FreeMotion>(renamed.linkage.motions[0]->kind).x = 2;
    std::get<FreeMotion>(renamed.linkage.motions[0]->kind).deg = 0;
    expect_same(renamed, "renamed");
    PathProblem cut = problem;
    Part& whole = cut.linkage.scene.bodies[0].parts[0];
    if (const auto pieces = path::convex_pieces(whole)) {
      cut.linkage.scene.bodies[0].parts.clear();
      for (const Polygon& piece : *pieces) cut.linkage.scene.bodies[0].parts.push_back({piece, {}});
      expect_same(cut, "cut");
    }
  }
}

}  // namespace
}  // namespace taut
