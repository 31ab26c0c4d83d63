// Poses of an arm of two links on a grid, by Box2D: what envelope() stands beside.
//
// usage: taut_pose_grid N, with the arm on standard input: the two joints' ranges in radians, the second joint's pivot,
// the number of parts of the room, and as polygons (a number of vertices, then their coordinates) these, the first link
// and the second one. Prints whether one of N x N poses collides, how many were looked at, and the CPU seconds.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "peers/peer.hpp"

namespace taut::bench {
namespace {

PeerShape read_shape() {
  std::size_t n = 0;
  std::cin >> n;
  PeerShape shape;
  for (std::size_t i = 0; i < n; ++i) {
    Point p;
    std::cin >> p.x >> p.y;
    shape.outline.push_back(p);
    shape.radius = std::max(shape.radius, std::hypot(p.x, p.y));
  }
  if (!std::cin || n < 3) throw std::runtime_error("a polygon is missing");
  shape.triangles = triangulate(shape.outline);
  shape.pieces = convex_pieces(shape.outline, 8);
  return shape;
}

/// An arm among the parts of a room, one pair of shapes for each part and link.
class Arm {
 public:
  Arm() {
    std::size_t parts = 0;
    std::cin >> shoulder_[0] >> shoulder_[1] >> elbow_[0] >> elbow_[1] >> pivot_.x >> pivot_.y >> parts;
    if (!std::cin || parts == 0) throw std::runtime_error("no arm on standard input");
    for (std::size_t i = 0; i < parts + 2; ++i) shapes_.push_back(read_shape());
    for (std::size_t i = 0; i < parts; ++i) {
      upper_.push_back(make_box2d(shapes_[i], shapes_[parts]));
      fore_.push_back(make_box2d(shapes_[i], shapes_[parts + 1]));
    }
  }
  /// Of a grid with n x n poses, ends included: how many were looked at, and whether the last one collides.
  std::pair<long, bool> look(int n) {
    long count = 0;
    for (int i = 0; i < n; ++i) {
      const double a = shoulder_[0] + (shoulder_[1] - shoulder_[0]) * i / (n - 1);
      const double c = std::cos(a), s = std::sin(a);
      if (hits(upper_, {0, 0, c, s})) return {count + 1, true};
      for (int k = 0; k < n; ++k) {
        const double b = elbow_[0] + (elbow_[1] - elbow_[0]) * k / (n - 1);
        // About the pivot of the first link, then with it.
        const double x = pivot_.x - pivot_.x * std::cos(b) + pivot_.y * std::sin(b);
        const double y = pivot_.y - pivot_.x * std::sin(b) - pivot_.y * std::cos(b);
        ++count;
        if (hits(fore_, {x * c - y * s, x * s + y * c, std::cos(a + b), std::sin(a + b)})) return {count, true};
      }
    }
    return {count, false};
  }

 private:
  static bool hits(const std::vector<std::unique_ptr<Peer>>& pairs, const RelativePose& pose) {
    for (const auto& pair : pairs) {
      if (pair->overlap(pose)) return true;
    }
    return false;
  }

  double shoulder_[2] = {}, elbow_[2] = {};
  Point pivot_;
  std::vector<PeerShape> shapes_;
  std::vector<std::unique_ptr<Peer>> upper_, fore_;
};

int look_at_grid(int argc, char** argv) {
  const int n = argc == 2 ? std::atoi(argv[1]) : 0;
  if (n < 2) {
    std::fputs("usage: taut_pose_grid N < ARM\n", stderr);
    return 2;
  }
  const std::clock_t began = std::clock();
  Arm arm;
  const auto [count, hit] = arm.look(n);
  std::printf("%s %ld %.4f\n", hit ? "hit" : "none", count, static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC);
  return 0;
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) {
  try {
    return taut::bench::look_at_grid(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "taut_pose_grid: %s\n", error.what());
    return 2;
  }
}
