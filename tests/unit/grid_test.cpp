// Occupancy grids: the bodies of cells against the cells, and what is read of map_server's files.
#include "taut/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/effort.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/map_query.hpp"
#include "taut/static_map.hpp"

namespace taut::testing {
namespace {

OccupancyGrid random_grid(Rng& rng, int width, int height, double share) {
  OccupancyGrid grid;
  grid.width = width;
  grid.height = height;
  grid.resolution = rng.chance(0.5) ? 0.05 : 0.25;
  grid.origin = {rng.real(-3, 3), -1};
  for (int k = 0; k < width * height; ++k) grid.occupied.push_back(rng.chance(share) ? 1 : 0);
  return grid;
}

bool inside_ring(const Polygon& ring, const Point& p) {
  bool inside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// How many parts a point lies in.
int parts_around(const std::vector<Body>& bodies, const Point& p) {
  int count = 0;
  for (const Body& body : bodies) {
    for (const Part& part : body.parts) {
      bool inside = inside_ring(part.outline, p);
      for (const Polygon& hole : part.holes) inside = inside && !inside_ring(hole, p);
      if (inside) ++count;
    }
  }
  return count;
}

double twice_area(const Polygon& ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

TEST(Grids, CellsAndBodiesAreTheSame) {
  int holes = 0, parts = 0;
  for (std::uint64_t seed = 0; seed < effort(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    OccupancyGrid grid = random_grid(rng, rng.between(1, 14), rng.between(1, 14), rng.real(0.1, 0.9));
    if (seed % 4 == 3) grid.yaw = rng.real(-3, 3);
    grid.occupied[0] = 1;
    const std::vector<Body> bodies = grid_bodies(grid);
    // Every ring is simple and every hole in its outline, or this throws.
    const StaticMap map(bodies);
    const double c = std::cos(grid.yaw), s = std::sin(grid.yaw);
    for (int j = -1; j <= grid.height; ++j) {
      for (int i = -1; i <= grid.width; ++i) {
        const double x = grid.resolution * (i + 0.45), y = grid.resolution * (j + 0.55);
        const Point p{grid.origin.x + c * x - s * y, grid.origin.y + s * x + c * y};
        EXPECT_EQ(parts_around(bodies, p), grid.at(i, j) ? 1 : 0) << i << ", " << j;
      }
    }
    double area = 0;
    for (const Body& body : bodies) {
      parts += static_cast<int>(body.parts.size());
      for (const Part& part : body.parts) {
        EXPECT_GT(twice_area(part.outline), 0);
        area += twice_area(part.outline) / 2;
        for (const Polygon& hole : part.holes) area += twice_area(hole) / 2;
        holes += static_cast<int>(part.holes.size());
      }
    }
    const auto cells = std::count(grid.occupied.begin(), grid.occupied.end(), 1);
    EXPECT_NEAR(area / (grid.resolution * grid.resolution), static_cast<double>(cells), 1e-9);
  }
  EXPECT_GE(holes, static_cast<int>(enough(80)));
  EXPECT_GE(parts, static_cast<int>(enough(1000)));
}

TEST(Grids, ARoomIsOneBodyWithAHole) {
  OccupancyGrid grid;
  grid.width = grid.height = 4;
  grid.occupied = {1, 1, 1, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 1, 1, 1};
  const std::vector<Body> bodies = grid_bodies(grid);
  ASSERT_EQ(bodies.size(), 1u);
  EXPECT_EQ(bodies[0].name, "cells 1");
  ASSERT_EQ(bodies[0].parts.size(), 1u);
  EXPECT_EQ(bodies[0].parts[0].outline, (Polygon{{4, 0}, {4, 4}, {0, 4}, {0, 0}}));
  ASSERT_EQ(bodies[0].parts[0].holes.size(), 1u);
  EXPECT_EQ(bodies[0].parts[0].holes[0].size(), 4u);
  // A door that is a corner wide is none.
  grid.occupied[15] = 0;
  const StaticMap map = StaticMap::from_grid(grid);
  EXPECT_EQ(map.size(), 1u);
  Body robot;
  robot.name = "robot";
  robot.polygon = {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}};
  MapQuery query(map, map.prepare(robot));
  EXPECT_TRUE(query.at({2, 2, 0}).free());
  EXPECT_TRUE(query.passes({2, 2, 0}, {2.0625, 2.0625, 0}).free());
  EXPECT_FALSE(query.passes({2, 2, 0}, {5, 5, 0}).free());
}

/// A folder for one test's files.
class GridFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("taut_grid_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  std::string fault(const std::string& yaml, const std::string& pgm) {
    write("map.pgm", pgm);
    try {
      read_grid(write("map.yaml", yaml));
    } catch (const InputError& error) {
      std::string what = error.what();
      return what.substr(what.find("map."));
    }
    return "nothing was refused";
  }

  std::filesystem::path folder_;
};

const std::string grid_yaml = "image: map.pgm\nresolution: 0.5   # metres\norigin: [-1.0, 2, 0]\n";

TEST_F(GridFiles, BytesAndNumbers) {
  // Dark is occupied; the first row is the highest. 205 is what was never seen.
  write("map.pgm", std::string("P5\n# a comment\n3 2\n255\n") + std::string("\x00\xfe\xcd\xfe\x00\xfe", 6));
  const OccupancyGrid bytes = read_grid(write("map.yaml", grid_yaml));
  EXPECT_EQ(bytes.width, 3);
  EXPECT_EQ(bytes.height, 2);
  EXPECT_EQ(bytes.resolution, 0.5);
  EXPECT_EQ(bytes.origin, (Point{-1, 2}));
  // By default free_thresh is 0.25: (255 - 205) / 255 = 0.196 is free.
  EXPECT_EQ(bytes.occupied, (std::vector<std::uint8_t>{0, 1, 0, 1, 0, 0}));
  EXPECT_EQ(StaticMap::from_grid((folder_ / "map.yaml").string()).size(), 2u);
  const OccupancyGrid unknown = read_grid(write("map.yaml", grid_yaml + "free_thresh: 0.196\noccupied_thresh: 0.65\n"));
  EXPECT_EQ(unknown.occupied, (std::vector<std::uint8_t>{0, 1, 0, 1, 0, 1}));
  GridOptions seen;
  seen.unknown_occupied = false;
  EXPECT_EQ(read_grid((folder_ / "map.yaml").string(), seen).occupied, bytes.occupied);
  write("map.pgm", "P2 3 2 15 0 15 12 15 0 15");
  EXPECT_EQ(read_grid(write("map.yaml", grid_yaml)).occupied, bytes.occupied);
  EXPECT_EQ(read_grid(write("map.yaml", grid_yaml + "negate: 1\nmode: trinary\n")).occupied,
            (std::vector<std::uint8_t>{1, 0, 1, 0, 1, 1}));
}

TEST_F(GridFiles, ReadsListsInAllForms) {
  write("map.pgm", "P2 2 1 255 0 255");
  const std::string rest = "image: 'map.pgm' # '\nresolution: 0.5\n";
  for (const std::string origin :
       {"origin:\n - -1.0\n - 2\n - 0\n", "origin:\n- -1.0\n-\t2\n\n- 0.0 # yaw\n", "origin:\n  [-1.0, 2, 0]\n",
        "origin: [-1.0,\n  2,\n  0]\n", "origin: [ -1.0, 2, 0 ]\n...\nnonsense\n"}) {
    EXPECT_EQ(read_grid(write("map.yaml", "%YAML 1.1\n--- # a map\n" + rest + origin)).origin, (Point{-1, 2}))
        << origin;
    if (origin.find("...") == std::string::npos) {
      EXPECT_EQ(read_grid(write("map.yaml", origin + rest)).origin, (Point{-1, 2})) << origin;
    }
  }
  const std::string pgm = "P2 2 1 255 0 255";
  EXPECT_NE(fault(rest + "origin:\n - 1\n - 2\n", pgm).find("map.yaml:3: `origin` has 2 numbers"), std::string::npos);
  EXPECT_NE(fault(rest + "origin:\n - a\n", pgm).find("\"a\" is not a finite number"), std::string::npos);
  EXPECT_NE(fault(rest + "origin: [1,\n", pgm).find("is not a list in brackets"), std::string::npos);
  EXPECT_NE(fault(rest + "- 1\n", pgm).find("map.yaml:3: the line \"- 1\" is no `key: value`"), std::string::npos);
}

TEST_F(GridFiles, FaultsHavePlacesAndRemedies) {
  const std::string pgm = "P2 2 1 255 0 255";
  EXPECT_EQ(fault("resolution: 1\norigin: [0, 0, 0]\n", pgm).substr(0, 29), "map.yaml: `image` is missing\n");
  EXPECT_NE(fault("image: map.pgm\nresolution: x\norigin: [0,0,0]\n", pgm).find("map.yaml:2: `resolution`: \"x\""),
            std::string::npos);
  EXPECT_NE(fault("image: map.pgm\nresolution: 1\norigin: [0,0]\n", pgm).find("map.yaml:3: `origin` has 2 numbers"),
            std::string::npos);
  EXPECT_NE(fault("image: map.pgm\nresolution: -1\norigin: [0,0,0]\n", pgm).find("not positive"), std::string::npos);
  EXPECT_NE(fault("image: map.pgm\nimage: map.pgm\n", pgm).find("map.yaml:2: `image` is given twice"),
            std::string::npos);
  EXPECT_NE(fault("hello\n", pgm).find("map.yaml:1: the line \"hello\" is no `key: value`"), std::string::npos);
  EXPECT_NE(fault("image: ../map.pgm\nresolution: 1\norigin: [0,0,0]\n", pgm).find("map.yaml:1: the file"),
            std::string::npos);
  EXPECT_NE(fault("image: \"map.pgm\nresolution: 1\norigin: [0,0,0]\n", pgm).find("quotes"), std::string::npos);
  EXPECT_NE(fault(grid_yaml, "P6 1 1 255 aaa").find("map.pgm:1:1: this is no PGM"), std::string::npos);
  EXPECT_NE(fault(grid_yaml, "P2 2 1 255 0").find("map.pgm:1:13: a grey is not a number"), std::string::npos);
  EXPECT_NE(fault(grid_yaml, "P5 20 10 255 a").find("ends before its 200 cells"), std::string::npos);
  EXPECT_NE(fault(grid_yaml, "P2 0 1 255").find("the width is not a number from 1"), std::string::npos);
  EXPECT_NE(fault(grid_yaml + "mode: raw\n", pgm).find("map.yaml:4: `mode` \"raw\" is not read"), std::string::npos);
  EXPECT_NE(fault(grid_yaml + "free_thresh: 0.9\n", pgm).find("above `occupied_thresh`"), std::string::npos);
  OccupancyGrid grid;
  EXPECT_THROW(grid_bodies(grid), InputError);
  grid.width = grid.height = 2;
  grid.occupied.assign(4, 0);
  EXPECT_THROW(grid_bodies(grid), InputError);
}

}  // namespace
}  // namespace taut::testing
