// Cells against rasters of ten thousand poses: none is missing, and none is more than a sixteenth of a cell away.
#include "taut/cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "taut/error.hpp"
#include "taut/grid.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
namespace {

using CellSet = std::set<std::array<int, 2>>;

/// How far a ring's segment is from a cell: 0 where they meet.
double cell_to_segment(double x, double y, const Complex& a, const Complex& b) {
  const Complex corners[4] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
  const auto beside = [](const Complex& p, const Complex& q, const Complex& r) {
    return (q.real() - p.real()) * (r.imag() - p.imag()) - (q.imag() - p.imag()) * (r.real() - p.real());
  };
  double least = INFINITY;
  for (int k = 0; k < 4; ++k) {
    const Complex &c = corners[k], &d = corners[(k + 1) % 4];
    const bool crosses = beside(a, b, c) * beside(a, b, d) < 0 && beside(c, d, a) * beside(c, d, b) < 0;
    if (crosses) return 0;
    least = std::min({least, to_segment(c, a, b), to_segment(a, c, d), to_segment(b, c, d)});
  }
  const bool inside = a.real() >= x && a.real() <= x + 1 && a.imag() >= y && a.imag() <= y + 1;
  return inside ? 0 : least;
}

bool inside_part(const PartAtPose& part, const Complex& p) {
  bool inside = false;
  for (const RingAtPose& ring : part.rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Complex &a = ring[k], &b = ring[(k + 1) % ring.size()];
      if ((a.imag() > p.imag()) != (b.imag() > p.imag()) &&
          p.real() < a.real() + (p.imag() - a.imag()) / (b.imag() - a.imag()) * (b.real() - a.real()))
        inside = !inside;
    }
  }
  return inside;
}

/// How far a cell is from the body; coordinates are in cells.
double cell_to_body(const std::array<int, 2>& cell, const BodyAtPose& body) {
  const double x = cell[0], y = cell[1];
  double least = INFINITY;
  for (const PartAtPose& part : body) {
    if (inside_part(part, {x + 0.5, y + 0.5})) return 0;
    for (const RingAtPose& ring : part.rings) {
      for (std::size_t k = 0; k < ring.size(); ++k)
        least = std::min(least, cell_to_segment(x, y, ring[k], ring[(k + 1) % ring.size()]));
    }
  }
  return least;
}

BodyAtPose in_cells(const MadeWorld& world, int body, double t, double resolution, const Point& origin) {
  BodyAtPose posed = testing::posed(world, body, t);
  for (PartAtPose& part : posed) {
    for (RingAtPose& ring : part.rings) {
      for (Complex& p : ring) p = (p - Complex(origin.x, origin.y)) / resolution;
    }
  }
  return posed;
}

/// Cells around the body at one pose that it certainly touches: a little less than touching counts.
void add_touched(const BodyAtPose& body, CellSet& all) {
  for (const PartAtPose& part : body) {
    int i0 = 1 << 30, i1 = -i0, j0 = i0, j1 = -i0;
    for (const Complex& p : part.rings[0]) {
      i0 = std::min(i0, static_cast<int>(std::floor(p.real())));
      i1 = std::max(i1, static_cast<int>(std::floor(p.real())));
      j0 = std::min(j0, static_cast<int>(std::floor(p.imag())));
      j1 = std::max(j1, static_cast<int>(std::floor(p.imag())));
    }
    for (int j = j0; j <= j1; ++j) {
      for (int i = i0; i <= i1; ++i) {
        if (!all.count({i, j}) && cell_to_body({i, j}, {part}) < 1e-9) all.insert({i, j});
      }
    }
  }
}

TEST(Cells, AsTenThousandPosesSay) {
  std::size_t listed = 0;
  for (std::uint64_t seed = 0; seed < effort(10); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const MadeWorld world = random_way(rng);
    const int body = static_cast<int>(world.bodies.size()) - 1;
    CellOptions options;
    options.resolution = rng.real(0.15, 0.5);
    options.origin = {rng.real(-1, 1), rng.real(-1, 1)};
    const CoveredCells covered = cells(scene_of(world), body, options);
    CellSet touched;
    constexpr int poses = 10000;
    std::vector<double> nearest(covered.cells.size(), INFINITY);
    for (int k = 0; k <= poses; ++k) {
      const BodyAtPose at = in_cells(world, body, world.end * k / poses, options.resolution, options.origin);
      add_touched(at, touched);
      if (k % 50 != 0) continue;
      for (std::size_t c = 0; c < covered.cells.size(); ++c) {
        if (nearest[c] > 0.01) nearest[c] = std::min(nearest[c], cell_to_body(covered.cells[c], at));
      }
    }
    const CellSet answer(covered.cells.begin(), covered.cells.end());
    EXPECT_EQ(answer.size(), covered.cells.size());
    for (const auto& cell : touched) EXPECT_TRUE(answer.count(cell)) << cell[0] << ", " << cell[1];
    // Between two of the poses that were measured a body goes a few hundredths of a cell.
    for (std::size_t c = 0; c < nearest.size(); ++c) {
      EXPECT_LT(nearest[c], 1.0 / 16 + 0.35) << covered.cells[c][0] << ", " << covered.cells[c][1];
    }
    listed += covered.cells.size();
  }
  EXPECT_GE(listed, enough(800));
}

Scene one_body(const Polygon& outline, Motion motion, double end) {
  Scene scene;
  scene.end = end;
  scene.bodies = {{"cart", outline, std::move(motion)}};
  return scene;
}

/// By hand: a square of one cell that moves half a cell touches what it borders on, and no more.
TEST(Cells, ExactlyByHand) {
  Motion motion;
  motion.pieces = {{{0.25, 0.5}, {0.25}, NoRotation{}}};
  const Scene scene = one_body({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, motion, 1);
  CellOptions options;
  options.resolution = 1;
  const CoveredCells covered = cells(scene, 0, options);
  EXPECT_EQ(covered.cells, (std::vector<std::array<int, 2>>{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
  EXPECT_EQ(cells_json(scene, 0, covered),
            "{\"body\":\"cart\",\"resolution\":1,\"origin\":[0,0],\"cells\":[[0,0],[1,0],[0,1],[1,1]]}");
  EXPECT_EQ(cells_pgm(covered), std::string("P5\n2 2\n255\n") + std::string(4, '\0'));
  // Touching counts, from every side: on the grid's lines, eight more cells are touched.
  const CoveredCells on_lines = cells(one_body({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}, 1), 0, options);
  EXPECT_EQ(on_lines.cells.size(), 9u);
  // Never farther than a sixteenth: a quarter of a cell away nothing is listed.
  options.origin = {-0.25, -0.25};
  options.resolution = 1.5;
  EXPECT_EQ(cells(one_body({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}, 1), 0, options).cells.size(), 1u);
}

/// The excess, measured on a lattice of cells around a turning bar whose sweep is known: a disc.
TEST(Cells, ADiscIsADisc) {
  Motion spin;
  spin.pieces = {{{}, {}, AngleRotation{{0, 1}}}};
  const Scene scene = one_body({{-1, -0.01}, {1, -0.01}, {1, 0.01}, {-1, 0.01}}, spin, 3.2);
  const double reach = std::hypot(1, 0.01);
  CellOptions options;
  options.resolution = 0.0625;
  const CoveredCells covered = cells(scene, 0, options);
  const CellSet answer(covered.cells.begin(), covered.cells.end());
  for (int j = -20; j < 20; ++j) {
    for (int i = -20; i < 20; ++i) {
      const double dx = std::max({i, 0, -i - 1}) * 0.0625, dy = std::max({j, 0, -j - 1}) * 0.0625;
      const double distance = std::hypot(dx, dy);
      if (distance <= reach - 1e-9) {
        EXPECT_TRUE(answer.count({i, j})) << i << ", " << j;
      }
      if (distance > reach + 0.0625 / 16) {
        EXPECT_FALSE(answer.count({i, j})) << i << ", " << j;
      }
    }
  }
}

TEST(Cells, SingularTurnsAndFaults) {
  // A linear cosine that starts at 1: infinite speed.
  Motion fast;
  fast.pieces = {{{}, {}, CosineRotation{{1, -1}}}};
  CellOptions options;
  options.resolution = 0.1;
  const Scene scene = one_body({{0, 0}, {1, 0}, {1, 0.1}, {0, 0.1}}, fast, 2);
  EXPECT_GT(cells(scene, 0, options).cells.size(), 100u);
  EXPECT_THROW(cells(scene, 1, options), InputError);
  options.resolution = 0;
  EXPECT_THROW(cells(scene, 0, options), InputError);
  options.resolution = 1e-15;
  EXPECT_THROW(cells(scene, 0, options), InputError);
  options.resolution = 1e-4;
  options.origin = {1e12, 0};
  EXPECT_THROW(cells(scene, 0, options), InputError);
  const std::atomic<bool> stop{true};
  options = {};
  options.resolution = 0.001;
  options.limits.stop = &stop;
  EXPECT_THROW(cells(scene, 0, options), UndecidedError);
}

}  // namespace
}  // namespace taut::testing
