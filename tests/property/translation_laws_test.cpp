// Ways of what only translates, against a search of a grid that decides them by definition.
#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <functional>
#include <set>
#include <sstream>

#include "proof/bytes.hpp"
#include "support/effort.hpp"
#include "support/made_path.hpp"
#include "taut/path_proof.hpp"

namespace taut {
namespace {

using testing::effort;
using testing::expect_proved;
using testing::Rng;

using LatticePoint = std::array<int, 2>;

/// A square of a grid, by its lower corner, on one layer or on all.
struct LatticeSquare {
  LatticePoint at;
  std::optional<Layers> z;
};

/// Bodies made of squares, whole numbers for all that is asked.
struct LatticeProblem {
  std::vector<LatticeSquare> mover;
  std::vector<std::vector<LatticeSquare>> rests;
  bool framed = false;  ///< by a wall around the range from 0 to `size`
  int size = 0;
  std::array<LatticePoint, 2> range{};  ///< of each axis
  LatticePoint start{};
  std::array<std::optional<LatticePoint>, 2> goal;
  bool outside = false;
};

constexpr int frame_width = 9;  // more than a mover is wide

std::array<LatticePoint, 2> box_of_squares(const std::vector<LatticeSquare>& squares) {
  std::array<LatticePoint, 2> box{squares[0].at, squares[0].at};
  for (const LatticeSquare& s : squares) {
    for (std::size_t k = 0; k < 2; ++k) {
      box[0][k] = std::min(box[0][k], s.at[k]);
      box[1][k] = std::max(box[1][k], s.at[k] + 1);
    }
  }
  return box;
}

/// The displacements are divided into points, open edges and open squares of the grid, by twice their middles. Each is
/// free or not as a whole. A way is a chain of those that are free, each in the closure of the next or the other way.
class LatticeSearch {
 public:
  LatticeSearch(const LatticeProblem& problem, Touch touch) : problem_(problem), touch_(touch) {
    for (const auto& rest : problem.rests) {
      for (const LatticeSquare& fixed : rest) {
        for (const LatticeSquare& moving : problem.mover) {
          if (fixed.z.value_or(Layers{}).meet(moving.z.value_or(Layers{})))
            forbidden_.insert({fixed.at[0] - moving.at[0], fixed.at[1] - moving.at[1]});
        }
      }
    }
  }

  bool is_free(const LatticePoint& p) const {
    // The squares overlap at displacements less than 1 from one at which they coincide; they touch at 1.
    const int least = touch_ == Touch::open ? 2 : 3;
    for (const LatticePoint& c : forbidden_) {
      if (std::abs(p[0] - 2 * c[0]) < least && std::abs(p[1] - 2 * c[1]) < least) return false;
    }
    if (!problem_.framed) return true;
    const auto [lo, hi] = box_of_squares(problem_.mover);
    for (std::size_t k = 0; k < 2; ++k) {
      const int low = p[k] + 2 * lo[k], high = p[k] + 2 * hi[k] - 2 * problem_.size;
      if (low < least - 2 || high > 2 - least) return false;
    }
    return true;
  }
  bool is_goal(const LatticePoint& p) const {
    if (problem_.outside) {
      const auto own = box_of_squares(problem_.mover);
      for (const auto& rest : problem_.rests) {
        const auto other = box_of_squares(rest);
        bool overlap = true;
        for (std::size_t k = 0; k < 2; ++k)
          overlap = overlap && p[k] + 2 * own[0][k] < 2 * other[1][k] && p[k] + 2 * own[1][k] > 2 * other[0][k];
        if (overlap) return false;
      }
      return true;
    }
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& goal = problem_.goal[k];
      if (goal && (p[k] < 2 * (*goal)[0] || p[k] > 2 * (*goal)[1])) return false;
    }
    return true;
  }
  bool reaches() const {
    std::set<LatticePoint> seen;
    std::deque<LatticePoint> todo;
    const auto visit = [&](const LatticePoint& p) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (p[k] < 2 * problem_.range[k][0] || p[k] > 2 * problem_.range[k][1]) return;
      }
      if (is_free(p) && seen.insert(p).second) todo.push_back(p);
    };
    visit({2 * problem_.start[0], 2 * problem_.start[1]});
    for (; !todo.empty(); todo.pop_front()) {
      const LatticePoint p = todo.front();
      if (is_goal(p)) return true;
      for (const LatticePoint& step :
           {LatticePoint{1, 0}, LatticePoint{-1, 0}, LatticePoint{0, 1}, LatticePoint{0, -1}})
        visit({p[0] + step[0], p[1] + step[1]});
    }
    return false;
  }

 private:
  const LatticeProblem& problem_;
  Touch touch_;
  std::set<LatticePoint> forbidden_;
};

/// A linear map of the plane with whole numbers: where (1, 0) and (0, 1) go.
struct WholeMap {
  LatticePoint first{1, 0}, second{0, 1};

  Point of(double x, double y) const { return {first[0] * x + second[0] * y, first[1] * x + second[1] * y}; }
};

Part square_part(const LatticeSquare& s, const WholeMap& map) {
  Part part;
  const double x = s.at[0], y = s.at[1];
  part.outline = {map.of(x, y), map.of(x + 1, y), map.of(x + 1, y + 1), map.of(x, y + 1)};
  part.z = s.z;
  return part;
}

/// A frame is a part with a hole. The bodies go through the map of shapes; joints go along the columns of the other
/// one.
PathProblem problem_of(const LatticeProblem& grid, const WholeMap& shapes, const WholeMap& joints, bool one_slide) {
  PathProblem problem;
  Body mover{"mover", {}, {}};
  for (const LatticeSquare& s : grid.mover) mover.parts.push_back(square_part(s, shapes));
  problem.linkage.scene.bodies.push_back(mover);
  for (const auto& rest : grid.rests) {
    Body body{"rest " + std::to_string(problem.linkage.scene.bodies.size()), {}, {}};
    for (const LatticeSquare& s : rest) body.parts.push_back(square_part(s, shapes));
    problem.linkage.scene.bodies.push_back(body);
  }
  if (grid.framed) {
    const auto ring = [&](double lo, double hi) {
      return Polygon{shapes.of(lo, lo), shapes.of(hi, lo), shapes.of(hi, hi), shapes.of(lo, hi)};
    };
    Body frame{"frame", {}, {}};
    frame.parts = {{ring(-frame_width, grid.size + frame_width), {ring(0, grid.size)}}};
    problem.linkage.scene.bodies.push_back(frame);
  }
  const std::array<LatticePoint, 2> columns{joints.first, joints.second};
  for (std::size_t k = 0; k < (one_slide ? 1U : 2U); ++k) {
    problem.linkage.joints.push_back(
        {k == 0 ? "a" : "b", static_cast<double>(grid.range[k][0]), static_cast<double>(grid.range[k][1])});
    problem.start[k] = grid.start[k];
    if (grid.goal[k])
      problem.goal[k] = {static_cast<double>((*grid.goal[k])[0]), static_cast<double>((*grid.goal[k])[1])};
  }
  problem.goal_outside = grid.outside;
  // One joint carries what the other one moves. The carriage itself is far away.
  Body carriage{"carriage", {{900, 900}, {901, 900}, {901, 901}}, {}};
  const auto slide = [&](int k) {
    const LatticePoint& v = columns[static_cast<std::size_t>(k)];
    return JointMotion{Slide{{static_cast<double>(v[0]), static_cast<double>(v[1])}}, k, 1, 0};
  };
  problem.linkage.motions.resize(problem.linkage.scene.bodies.size());
  problem.linkage.motions[0] = slide(0);
  if (!one_slide) {
    problem.linkage.scene.bodies[0].relative_to = "carriage";
    problem.linkage.scene.bodies.push_back(carriage);
    problem.linkage.scene.ignore = {{"carriage", "*"}};
    problem.linkage.motions.push_back(slide(1));
  }
  return problem;
}

std::optional<Layers> random_layers_of_square(Rng& rng) {
  if (rng.chance(0.8)) return std::nullopt;
  return rng.chance(0.5) ? Layers{0, 1} : Layers{1, 2};
}

LatticeProblem random_grid(Rng& rng, bool outside) {
  LatticeProblem grid;
  grid.size = rng.between(4, 8);
  grid.framed = !outside;
  grid.outside = outside;
  LatticePoint at{0, 0};
  for (int n = rng.between(1, 4); n > 0; --n) {
    grid.mover.push_back({at, random_layers_of_square(rng)});
    ++at[static_cast<std::size_t>(rng.below(2))];
  }
  grid.rests.resize(static_cast<std::size_t>(rng.between(1, 2)));
  const double share = rng.real(0.1, 0.45);
  for (int x = 0; x < grid.size; ++x) {
    for (int y = 0; y < grid.size; ++y) {
      const bool at_border = x == 0 || y == 0 || x == grid.size - 1 || y == grid.size - 1;
      if (rng.chance(outside && at_border ? 0.97 : share))
        grid.rests[static_cast<std::size_t>(rng.below(static_cast<int>(grid.rests.size())))].push_back(
            {{x, y}, random_layers_of_square(rng)});
    }
  }
  for (std::size_t i = 0; i < grid.rests.size(); ++i) {
    if (grid.rests[i].empty()) grid.rests[i].push_back({{0, static_cast<int>(i)}, {}});
  }
  for (std::size_t k = 0; k < 2; ++k) {
    grid.range[k] =
        outside ? LatticePoint{-6, grid.size + 2} : LatticePoint{rng.between(-1, 0), grid.size + rng.below(2)};
    grid.start[k] = rng.between(std::max(0, grid.range[k][0]), std::min(grid.size, grid.range[k][1]));
  }
  for (std::size_t k = 0; k < 2 && !outside; ++k) {
    const int a = rng.between(0, grid.size), b = rng.between(0, grid.size);
    if (rng.chance(0.4)) {
      grid.goal[k] = {a, a};
    } else if (rng.chance(0.6)) {
      grid.goal[k] = {std::min(a, b), std::max(a, b)};
    }
  }
  if (!outside && !grid.goal[0] && !grid.goal[1]) grid.goal[0] = {grid.size / 2, grid.size / 2};
  return grid;
}

/// Looks for a start at which nothing collides. False if there is none, or the goal is one place that collides: such
/// problems are refused.
bool find_start(LatticeProblem& grid, Rng& rng, Touch touch) {
  const LatticeSearch search(grid, touch);
  const auto is_free = [&] { return search.is_free({2 * grid.start[0], 2 * grid.start[1]}); };
  for (int n = 0; n < 30 && !is_free(); ++n) {
    for (std::size_t k = 0; k < 2; ++k)
      grid.start[k] = rng.between(std::max(0, grid.range[k][0]), std::min(grid.size, grid.range[k][1]));
  }
  if (!is_free()) return false;
  const auto is_one = [](const auto& goal) { return goal && (*goal)[0] == (*goal)[1]; };
  return !is_one(grid.goal[0]) || !is_one(grid.goal[1]) ||
         search.is_free({2 * (*grid.goal[0])[0], 2 * (*grid.goal[1])[0]});
}

struct Seen {
  int ways = 0, none = 0, logs = 0;
  int refused = 0;  ///< logs of no way that were given to problems that have one
  int inexact = 0;  ///< ways that fit exactly, along no doubles
};

/// A log of no way, by a polygon that no way crosses. Empty if there is none.
std::string log_of(const PathProblem& problem, const PathOptions& options) {
  std::ostringstream log;
  if (prove_path(problem, log, options).outcome != PathOutcome::none) return "";
  std::istringstream in(log.str());
  const VerifiedPath verified = verify_path(problem, in);
  EXPECT_GT(verified.barrier, 0U);
  EXPECT_EQ(verified.touch, options.touch);
  return log.str();
}

/// A log that says that it is about another problem.
std::string given_to(const PathProblem& problem, std::string log) {
  constexpr std::size_t fingerprint_at = 8, checksum_size = 8;
  const Fingerprint fingerprint = path_fingerprint(problem);
  std::copy(fingerprint.begin(), fingerprint.end(), log.begin() + fingerprint_at);
  log.resize(log.size() - checksum_size);
  internal::proof::Checksum checksum;
  for (const char c : log) checksum.add(static_cast<std::uint8_t>(c));
  for (std::size_t i = 0; i < checksum_size; ++i) log.push_back(static_cast<char>(checksum.value() >> (8 * i)));
  return log;
}

using MakeProblem = std::function<PathProblem(const LatticeProblem& grid)>;

/// Without one of its squares, a problem may have a way. The log must be refused then.
void expect_refused_with_a_way(const LatticeProblem& grid, const MakeProblem& make, Touch touch, const std::string& log,
                               Seen& seen) {
  for (std::size_t rest = 0; rest < grid.rests.size(); ++rest) {
    for (std::size_t i = 0; i < grid.rests[rest].size() && grid.rests[rest].size() > 1; ++i) {
      LatticeProblem open = grid;
      open.rests[rest].erase(open.rests[rest].begin() + static_cast<std::ptrdiff_t>(i));
      if (!LatticeSearch(open, touch).reaches()) continue;
      const PathProblem problem = make(open);
      std::istringstream in(given_to(problem, log));
      EXPECT_THROW(verify_path(problem, in), ProofError);
      ++seen.refused;
    }
  }
}

void expect_decided(const LatticeProblem& grid, const MakeProblem& make, Touch touch, Seen& seen) {
  const PathProblem problem = make(grid);
  PathOptions options;
  options.touch = touch;
  options.tolerance = 1;  // means nothing here
  const PathAnswer answer = find_path(problem, options);
  const bool reaches = LatticeSearch(grid, touch).reaches();
  EXPECT_TRUE(answer.exact);
  ++(reaches ? seen.ways : seen.none);
  if (reaches && answer.outcome == PathOutcome::undecided) {
    ++seen.inexact;
    return;
  }
  EXPECT_EQ(answer.outcome, reaches ? PathOutcome::path : PathOutcome::none) << answer.reason;
  if (answer.outcome == PathOutcome::path) return expect_proved(problem, answer, options);
  const std::string log = log_of(problem, options);
  ASSERT_FALSE(log.empty());
  ++seen.logs;
  expect_refused_with_a_way(grid, make, touch, log, seen);
}

/// Two slides in any directions: shapes and slides go through the same map, so the answer is that of the grid.
TEST(TranslationLaws, TwoSlidesInAnyDirections) {
  Rng rng(41);
  Seen seen;
  const std::vector<WholeMap> maps = {
      {{1, 0}, {0, 1}}, {{0, 1}, {1, 0}}, {{3, 1}, {-1, 2}}, {{1, 0}, {5, 7}}, {{-2, 1}, {3, 3}}};
  for (std::uint64_t n = effort(600); n > 0; --n) {
    SCOPED_TRACE(n);
    LatticeProblem grid = random_grid(rng, false);
    const WholeMap map = maps[n % maps.size()];
    const Touch touch = rng.chance(0.5) ? Touch::open : Touch::closed;
    const auto make = [&](const LatticeProblem& of) { return problem_of(of, map, map, false); };
    if (find_start(grid, rng, touch)) expect_decided(grid, make, touch, seen);
  }
  EXPECT_GE(seen.ways, static_cast<int>(testing::enough(60)));
  EXPECT_GE(seen.none, static_cast<int>(testing::enough(60)));
  EXPECT_LE(50 * seen.inexact, seen.ways);
  EXPECT_EQ(seen.logs, seen.none);
  EXPECT_GE(seen.refused, seen.logs / 4);
}

TEST(TranslationLaws, OneSlideAlone) {
  Rng rng(43);
  Seen seen;
  const std::vector<WholeMap> maps = {{{1, 0}, {0, 1}}, {{2, 3}, {-1, 1}}, {{-1, 4}, {1, 1}}};
  for (std::uint64_t n = effort(400); n > 0; --n) {
    SCOPED_TRACE(n);
    LatticeProblem grid = random_grid(rng, false);
    grid.range[1] = {0, 0};
    grid.start[1] = 0;
    if (!grid.goal[0]) grid.goal[0] = {1, 3};
    const Touch touch = rng.chance(0.8) ? Touch::open : Touch::closed;
    if (touch == Touch::closed) grid.framed = false;
    grid.goal[1] = {0, 0};
    const WholeMap map = maps[n % maps.size()];
    const auto make = [&](const LatticeProblem& of) { return problem_of(of, map, map, true); };
    if (find_start(grid, rng, touch)) expect_decided(grid, make, touch, seen);
  }
  EXPECT_GE(seen.ways, static_cast<int>(testing::enough(40)));
  EXPECT_GE(seen.none, static_cast<int>(testing::enough(40)));
  EXPECT_LE(50 * seen.inexact, seen.ways);
  EXPECT_EQ(seen.logs, seen.none);
  EXPECT_GE(seen.refused, seen.logs / 4);
}

/// Out of everything. Boxes are along the axes, so the shapes stay as they are; the slides go along the columns of a
/// map whose inverse has whole numbers, and their ranges hold all places of the grid that matter.
TEST(TranslationLaws, Outside) {
  Rng rng(47);
  Seen seen;
  for (std::uint64_t n = effort(400); n > 0; --n) {
    SCOPED_TRACE(n);
    LatticeProblem grid = random_grid(rng, true);
    const Touch touch = rng.chance(0.7) ? Touch::open : Touch::closed;
    if (!find_start(grid, rng, touch)) continue;
    // p = a (2, 1) + b (1, 1): a = x - y, b = 2 y - x.
    const bool slanted = n % 2 == 0;
    const WholeMap joints = slanted ? WholeMap{{2, 1}, {1, 1}} : WholeMap{};
    const auto make = [&](const LatticeProblem& of) {
      PathProblem problem = problem_of(of, {}, joints, false);
      const double x = of.start[0], y = of.start[1];
      problem.linkage.joints = {{"a", -99, 99}, {"b", -99, 99}};
      problem.start = slanted ? JointValues{x - y, 2 * y - x} : JointValues{x, y};
      return problem;
    };
    expect_decided(grid, make, touch, seen);
  }
  EXPECT_GE(seen.ways, static_cast<int>(testing::enough(40)));
  EXPECT_GE(seen.none, static_cast<int>(testing::enough(10)));
  EXPECT_LE(50 * seen.inexact, seen.ways);
  EXPECT_EQ(seen.logs, seen.none);
  EXPECT_GE(seen.refused, seen.logs / 4);
}

}  // namespace
}  // namespace taut
