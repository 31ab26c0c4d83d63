// Loops that two driven joints move together, over ranges of both: values over cells, cells and ways against closed
// forms, and one joint's range against the motion through it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "joints/linked_pairs.hpp"
#include "support/effort.hpp"
#include "support/two_drives.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/path.hpp"
#include "taut/path_proof.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
namespace {

using Corner = std::array<long double, 2>;

Linkage with_ranges(const TwoDrives& made, const std::array<double, 2>& a, const std::array<double, 2>& e) {
  Linkage linkage;
  linkage.scene = made.scene();
  linkage.joints = {taut::Joint{"A", a[0], a[1]}, taut::Joint{"E", e[0], e[1]}};
  return assembled(linkage);
}

TwoDrives made_by(Rng& rng) {
  for (;;) {
    TwoDrives made(rng,
                   rng.pick(std::vector{TwoDrives::Kind::bars, TwoDrives::Kind::slide, TwoDrives::Kind::two_loops}));
    if (made.margin(0, 0) > 0.05L) return made;
  }
}

std::array<double, 2> some_range(Rng& rng) {
  const double most = rng.pick(std::vector{10.0, 40.0, 170.0});
  return {rng.chance(0.2) ? rng.real(0, 10) : -rng.real(1, most), rng.real(11, most + 11)};
}

/// How far two convex counterclockwise polygons are apart along the normal of some edge; if negative, they overlap at
/// least by that.
long double gap_of(const std::vector<Corner>& p, const std::vector<Corner>& q) {
  long double gap = -INFINITY;
  for (const auto& [own, other] : {std::pair(&p, &q), std::pair(&q, &p)}) {
    for (std::size_t i = 0; i < own->size(); ++i) {
      const Corner &from = (*own)[i], &to = (*own)[(i + 1) % own->size()];
      const long double x = to[0] - from[0], y = to[1] - from[1], length = std::hypot(x, y);
      long double least = INFINITY;
      for (const Corner& c : *other) least = std::min(least, ((c[0] - from[0]) * y - (c[1] - from[1]) * x) / length);
      gap = std::max(gap, least);
    }
  }
  return gap;
}

std::vector<Corner> outline_at(const Body& body, const TwoDrives::Place& place) {
  std::vector<Corner> out;
  for (const Point& p : body.polygon) out.push_back(place.of(p));
  return out;
}

/// The law of JointModel, and what is not known: beyond a lock all of it.
TEST(TwoDrivesOfALoop, PosesAreThoseOfClosedForms) {
  Rng rng(4712);
  int judged = 0, unknown = 0;
  double widest = 0;
  for (std::uint64_t n = effort(100); n > 0; --n) {
    const TwoDrives made = made_by(rng);
    const Linkage linkage = with_ranges(made, some_range(rng), some_range(rng));
    const internal::LinkedPairs pairs(linkage);
    for (int trial = 0; trial < 20; ++trial) {
      internal::JointCell cell;
      std::array<double, 2> h{}, at{};
      for (std::size_t k = 0; k < 2; ++k) {
        const taut::Joint& joint = linkage.joints[k];
        cell.half[k] = std::min(std::exp2(rng.real(-12, 4)), (joint.hi - joint.lo) / 2);
        cell.middle[k] = rng.real(joint.lo + cell.half[k], joint.hi - cell.half[k]);
        h[k] = rng.chance(0.3) ? rng.sign() : rng.real(-1, 1);
        at[k] = cell.middle[k] + h[k] * cell.half[k];
      }
      const auto places = made.places(at[0], at[1]);
      if (pairs.may_lock(cell).anywhere) {
        ++unknown;
        continue;
      }
      ASSERT_TRUE(places) << "beyond a lock";
      for (std::size_t body = 0; body < places->size(); ++body) {
        for (const Point& p : made.scene().bodies[body].polygon) {
          const internal::JointModel model =
              pairs.pose(static_cast<int>(body), cell).place({p.x * pairs.scale(), p.y * pairs.scale()});
          const Corner exact = (*places)[body].of(p);
          const auto value = [&](double v, double r0, double r1) { return v + h[0] * r0 + h[1] * r1; };
          const double x = static_cast<double>(exact[0]) * pairs.scale() -
                           value(model.value.x, model.rate[0].x, model.rate[1].x),
                       y = static_cast<double>(exact[1]) * pairs.scale() -
                           value(model.value.y, model.rate[0].y, model.rate[1].y);
          const double off = std::hypot(x, y);
          ASSERT_LE(off, model.error + 1e-10) << "body " << body << " at " << at[0] << " " << at[1];
          ++judged;
          if (model.error < 0.01 && off > 1e-8) widest = std::max(widest, off / model.error);
        }
      }
    }
  }
  EXPECT_GT(judged, static_cast<int>(enough(1000)));
  EXPECT_GT(unknown, static_cast<int>(enough(50)));
  // The bound is not idle.
  EXPECT_GT(widest, 0.1);
}

/// Where no lock is near on the way from the drawn pose, everything is known.
TEST(TwoDrivesOfALoop, KnowsWhatIsFarFromLocks) {
  Rng rng(31);
  int judged = 0;
  for (std::uint64_t n = effort(100); n > 0; --n) {
    const TwoDrives made = made_by(rng);
    const std::array<double, 2> a = some_range(rng), e = some_range(rng);
    long double least = 1;
    const auto spread = [](const std::array<double, 2>& range, int i) {
      const double lo = std::min(0.0, range[0]);
      return lo + (range[1] - lo) * i / 200;
    };
    for (int i = 0; i <= 200; ++i) {
      for (int k = 0; k <= 200; ++k) least = std::min(least, made.margin(spread(a, i), spread(e, k)));
    }
    if (!(least > 0.4L)) continue;
    EnvelopeOptions options;
    options.tolerance = 0.05;
    EXPECT_EQ(envelope(with_ranges(made, a, e), options).may_lock, 0) << n;
    ++judged;
  }
  EXPECT_GT(judged, static_cast<int>(enough(15)));
}

/// Free cells are free, in colliding ones the pair overlaps, and what may lock is undecided.
TEST(TwoDrivesOfALoop, CellsAreThoseOfClosedForms) {
  Rng rng(815);
  std::array<int, 3> judged{};
  int near_lock = 0;
  for (std::uint64_t n = effort(200); n > 0; --n) {
    const TwoDrives made = made_by(rng);
    const Linkage linkage = with_ranges(made, some_range(rng), some_range(rng));
    EnvelopeOptions options;
    options.tolerance = 0.01;
    const Envelope answer = envelope(linkage, options);
    EXPECT_NEAR(answer.free + answer.colliding + answer.undecided, 1, 1e-9);
    EXPECT_LE(answer.may_lock, answer.undecided + 1e-12);
    const internal::LinkedPairs pairs(linkage);
    for (int trial = 0; trial < 300; ++trial) {
      const auto& cell = answer.cells[static_cast<std::size_t>(rng.below(static_cast<int>(answer.cells.size())))];
      const auto pick = [&](std::size_t k) { return rng.chance(0.2) ? cell.lo[k] : rng.real(cell.lo[k], cell.hi[k]); };
      const double a = pick(0), e = pick(1);
      const auto places = made.places(a, e);
      ++judged[static_cast<std::size_t>(cell.state)];
      if (!places) {
        ++near_lock;
        ASSERT_EQ(cell.state, CellState::undecided) << n << ": beyond a lock at " << a << " " << e;
      }
      if (cell.state == CellState::undecided) continue;
      long double least = INFINITY, of_pair = INFINITY;
      for (const auto& pair : pairs.pairs()) {
        const auto i = static_cast<std::size_t>(pair->bodies[0]), k = static_cast<std::size_t>(pair->bodies[1]);
        const std::vector<Body>& bodies = made.scene().bodies;
        const long double gap = gap_of(outline_at(bodies[i], (*places)[i]), outline_at(bodies[k], (*places)[k]));
        least = std::min(least, gap);
        if (pair->bodies == cell.pair) of_pair = gap;
      }
      if (cell.state == CellState::free) {
        ASSERT_GT(least, -1e-9L) << n << ": free at " << a << " " << e;
      } else {
        ASSERT_LT(of_pair, 1e-9L) << n << ": colliding at " << a << " " << e;
      }
    }
  }
  EXPECT_GT(judged[static_cast<std::size_t>(CellState::free)], static_cast<int>(enough(500)));
  EXPECT_GT(judged[static_cast<std::size_t>(CellState::colliding)], static_cast<int>(enough(150)));
  EXPECT_GT(near_lock, static_cast<int>(enough(40)));
}

/// If one of the two is held, cells are what the engines say about the motion through the range of the other one.
TEST(TwoDrivesOfALoop, ARangeOfOneIsTheMotionThroughIt) {
  Rng rng(6);
  int collide = 0, free = 0, judged = 0;
  double open = 0;
  for (std::uint64_t n = effort(100); n > 0; --n) {
    const TwoDrives made = made_by(rng);
    const bool first = rng.chance(0.5);
    const double held = rng.chance(0.3) ? 0 : rng.real(-20, 20);
    std::array<double, 2> moved = some_range(rng);
    const Linkage linkage = first ? with_ranges(made, moved, {held, held}) : with_ranges(made, {held, held}, moved);
    // Beyond the first lock, a motion says nothing. Before the drawn pose, it would begin beyond one.
    PathProblem problem{linkage};
    for (std::size_t k = 0; k < 2; ++k) problem.goal[k] = {linkage.joints[k].lo, linkage.joints[k].hi};
    problem.start = first ? JointValues{moved[0], held} : JointValues{held, moved[0]};
    try {
      validate(problem);
    } catch (const InputError&) {
      continue;
    }
    Scene motion = made.scene();
    motion.start = moved[0];
    motion.end = moved[1];
    taut::Drive a{"A", {{}}}, e{"E", {{}}};
    (first ? a : e).pieces[0].polynomial = {0, 1};
    (first ? e : a).pieces[0].polynomial = {held};
    motion.mechanism->drives = {a, e};
    motion = assembled(motion);
    const Intervals all = intervals(motion);
    if (all.outcome == Outcome::undecided) continue;
    const Envelope answer = envelope(linkage);
    const std::size_t axis = first ? 0 : 1;
    for (const EnvelopeCell& cell : answer.cells) {
      if (cell.hi[axis] > motion.end) continue;
      const auto overlaps = [&](const OverlapInterval& o) {
        return o.from.hi < cell.hi[axis] && cell.lo[axis] < o.to.lo;
      };
      const auto covers = [&](const OverlapInterval& o) {
        return o.pair == cell.pair && o.from.lo <= cell.lo[axis] && cell.hi[axis] <= o.to.hi;
      };
      if (cell.state == CellState::free) {
        ++free;
        EXPECT_TRUE(std::none_of(all.intervals.begin(), all.intervals.end(), overlaps)) << n;
      } else if (cell.state == CellState::colliding) {
        ++collide;
        EXPECT_TRUE(std::any_of(all.intervals.begin(), all.intervals.end(), covers)) << n;
      }
    }
    ++judged;
    open += answer.undecided - answer.may_lock;
    if (HasFailure()) return;
  }
  // What is left are the ends of intervals, and where bodies hardly miss each other.
  EXPECT_LE(open, 0.01 * judged);
  EXPECT_GT(collide, static_cast<int>(enough(20)));
  EXPECT_GT(free, static_cast<int>(enough(20)));
}

/// The pin between the arms cannot pass a wall. The log says why, and the verifier encloses the loop's values itself.
TEST(TwoDrivesOfALoop, NoWayPastAWall) {
  PathProblem problem = read_path_problem("examples/paths/five_bar.json");
  for (taut::Joint& joint : problem.linkage.joints) joint = {joint.name, -40, 20};
  for (Body& body : problem.linkage.scene.bodies) {
    if (body.name == "post") body.polygon = {{29, 30}, {31, 30}, {31, 90}, {29, 90}};
    body.relative_to.clear();
  }
  problem.linkage.motions.clear();
  problem.linkage.loops.clear();
  problem.linkage = assembled(problem.linkage);
  problem.goal = {std::array{-40.0, -35.0}, std::array{-40.0, -35.0}};
  std::ostringstream log;
  ASSERT_EQ(prove_path(problem, log).outcome, PathOutcome::none);
  std::istringstream read(log.str());
  EXPECT_GT(verify_path(problem, read).cells, 20U);
  // Another wall, another scene.
  problem.linkage.scene.bodies.back().polygon[0].x = 28;
  std::istringstream again(log.str());
  EXPECT_THROW(verify_path(problem, again), ProofError);
}

/// Where a lock can be reached, the mechanism might go on in another pose than the one that cells are about.
TEST(TwoDrivesOfALoop, SaysNoNoneWhereALockIsReached) {
  PathProblem problem = read_path_problem("examples/paths/five_bar.json");
  for (taut::Joint& joint : problem.linkage.joints) joint = {joint.name, -40, 20};
  problem.linkage.joints[0].hi = 60;
  problem.linkage.joints[1].lo = -60;
  for (Body& body : problem.linkage.scene.bodies) {
    if (body.name == "post") body.polygon = {{29, -60}, {31, -60}, {31, 190}, {29, 190}};
    body.relative_to.clear();
  }
  problem.linkage.motions.clear();
  problem.linkage.loops.clear();
  problem.linkage = assembled(problem.linkage);
  problem.goal = {std::array{-40.0, -35.0}, std::array{-40.0, -35.0}};
  std::ostringstream log;
  const PathAnswer answer = prove_path(problem, log);
  EXPECT_EQ(answer.outcome, PathOutcome::undecided);
  EXPECT_NE(answer.reason.find("may lock"), std::string::npos) << answer.reason;
  EXPECT_TRUE(log.str().empty());
}

/// A goal that is not reached straight from the drawn pose is no error: other ways may lead there.
TEST(TwoDrivesOfALoop, GoalsNeedNotBeStraightAhead) {
  PathProblem problem = read_path_problem("examples/paths/five_bar.json");
  problem.goal = {std::array{60.0, 60.0}, std::array{-60.0, -60.0}};
  PathAnswer answer;
  ASSERT_NO_THROW(answer = find_path(problem));
  EXPECT_EQ(answer.outcome, PathOutcome::undecided);
}

/// A pose behind a lock is none to start from; drawings of it are errors.
TEST(TwoDrivesOfALoop, NamesWhatMayLock) {
  PathProblem problem = read_path_problem("examples/paths/five_bar.json");
  problem.start = {60, -60};
  const auto message_of = [](const auto& ask) -> std::string {
    try {
      ask();
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_NE(message_of([&] { find_path(problem); }).find("may lock on the straight way"), std::string::npos);
  EXPECT_NE(message_of([&] { posed(problem.linkage, {60, -60}); }), "none");
  EXPECT_EQ(message_of([&] { posed(problem.linkage, {10, 10}); }), "none");
}

/// Ways, at many instants, by closed forms.
TEST(TwoDrivesOfALoop, WaysAreFree) {
  Rng rng(53);
  int ways = 0;
  for (std::uint64_t n = effort(60); n > 0; --n) {
    const TwoDrives made = made_by(rng);
    PathProblem problem{with_ranges(made, {-40, 40}, {-40, 40})};
    problem.start = {rng.real(-20, 20), rng.real(-20, 20)};
    const double to = rng.real(-40, 40);
    problem.goal[0] = {to, to};
    PathAnswer found;
    PathOptions options;
    options.max_cells = 3000;
    try {
      found = find_path(problem, options);
    } catch (const InputError&) {
      continue;
    }
    if (found.outcome != PathOutcome::path) continue;
    ++ways;
    EXPECT_EQ(found.waypoints.back()[0], to);
    EXPECT_EQ(check(path_scene(problem, found.waypoints)).outcome, Outcome::free) << n;
    const internal::LinkedPairs pairs(problem.linkage);
    for (std::size_t i = 0; i + 1 < found.waypoints.size(); ++i) {
      for (int k = 0; k <= 100; ++k) {
        const auto at = [&](std::size_t joint) {
          const double from = found.waypoints[i][joint], until = found.waypoints[i + 1][joint];
          return from + (until - from) * k / 100;
        };
        const auto places = made.places(at(0), at(1));
        ASSERT_TRUE(places) << n << ": beyond a lock";
        for (const auto& pair : pairs.pairs()) {
          const auto a = static_cast<std::size_t>(pair->bodies[0]), b = static_cast<std::size_t>(pair->bodies[1]);
          const std::vector<Body>& bodies = made.scene().bodies;
          ASSERT_GT(gap_of(outline_at(bodies[a], (*places)[a]), outline_at(bodies[b], (*places)[b])), -1e-9L) << n;
        }
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(ways, static_cast<int>(enough(10)));
}

}  // namespace
}  // namespace taut::testing
