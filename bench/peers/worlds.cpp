// Many moving stars in a box, until two of them first touch: taut's world search beside what physics engines do in
// steps.
//
// usage: taut_world_peers BODIES... : for each number, stars of 64 vertices that go straight and spin. The time ends
// just after the first contact, so that nobody may stop early. Box2D looks at 4,096 instants: its dynamic tree over the
// stars, then, for pairs whose boxes meet, the pair of peers/box2d.cpp. FCL looks at 256: its dynamic tree of collision
// objects, each a mesh of a prism. CPU time; making shapes is not counted.
#include <box2d/b2_dynamic_tree.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "peers/peer.hpp"
#include "stopwatch.hpp"
#include "taut/check.hpp"
#include "taut/motions.hpp"
#include "taut/shape.hpp"

namespace taut::bench {
namespace {

constexpr std::size_t star_vertices = 64;
constexpr int box2d_steps = 4096, fcl_steps = 256;
/// Of more stars the steps would take many minutes.
constexpr int most_for_peers = 20000;

struct Star {
  PeerShape shape;
  Point at, speed;
  double spin = 0;

  RelativePose pose(double t) const {
    return {at.x + t * speed.x, at.y + t * speed.y, std::cos(spin * t), std::sin(spin * t)};
  }
};

/// On a grid with room around each, with speeds so low that most pairs never come near.
std::vector<Star> stars(int count) {
  std::mt19937_64 random(static_cast<std::uint64_t>(count));
  const auto between = [&random](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  std::vector<Star> all;
  for (int i = 0; i < count; ++i) {
    Star star;
    for (std::size_t k = 0; k < star_vertices; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / star_vertices;
      const double radius = k % 2 == 0 ? between(0.85, 1) : between(0.4, 0.8);
      star.shape.outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    star.shape.triangles = triangulate(star.shape.outline);
    star.shape.pieces = convex_pieces(star.shape.outline, 8);
    star.shape.radius = 1;
    star.at = {4.0 * (i % side) + between(-0.3, 0.3), 4.0 * (i / side) + between(-0.3, 0.3)};
    const double way = between(0, 2 * std::numbers::pi), speed = between(0.2, 1);
    star.speed = {speed * std::cos(way), speed * std::sin(way)};
    star.spin = between(-1, 1);
    all.push_back(std::move(star));
  }
  return all;
}

Scene world_of(const std::vector<Star>& all, double end) {
  Scene scene;
  scene.end = end;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Star& star = all[i];
    Body body;
    body.name = "star " + std::to_string(i);
    body.polygon = star.shape.outline;
    body.motion.pieces = {{{star.at.x, star.speed.x}, {star.at.y, star.speed.y}, AngleRotation{{0, star.spin}}}};
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

CheckOptions world_options() {
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  options.tell_touching = false;
  return options;
}

/// Seen from the other one.
RelativePose relative(const RelativePose& from, const RelativePose& to) {
  const double x = to.x - from.x, y = to.y - from.y;
  return {from.c * x + from.s * y, from.c * y - from.s * x, from.c * to.c + from.s * to.s,
          from.c * to.s - from.s * to.c};
}

/// Stars in Box2D's tree; pairs that come near get shapes of their own once.
class Box2dWorld {
 public:
  explicit Box2dWorld(const std::vector<Star>& all) : all_(all) {
    for (std::size_t i = 0; i < all.size(); ++i)
      proxies_.push_back(tree_.CreateProxy(box(i, 0), reinterpret_cast<void*>(i)));
  }
  bool hit_at(double t) {
    poses_.clear();
    for (const Star& star : all_) poses_.push_back(star.pose(t));
    for (std::size_t i = 0; i < all_.size(); ++i) tree_.MoveProxy(proxies_[i], box(i, t), {0, 0});
    hit_ = false;
    for (at_ = 0; at_ < all_.size() && !hit_; ++at_) tree_.Query(this, box(at_, t));
    return hit_;
  }
  bool QueryCallback(int32 leaf) {
    const auto other = reinterpret_cast<std::size_t>(tree_.GetUserData(leaf));
    if (other <= at_ || !close(other)) return true;
    std::unique_ptr<Peer>& pair = pairs_[{at_, other}];
    if (!pair) pair = make_box2d(all_[at_].shape, all_[other].shape);
    hit_ = pair->overlap(relative(poses_[at_], poses_[other]));
    return !hit_;
  }

 private:
  b2AABB box(std::size_t i, double t) const {
    const RelativePose pose = all_[i].pose(t);
    const auto x = static_cast<float>(pose.x), y = static_cast<float>(pose.y);
    return {{x - 1, y - 1}, {x + 1, y + 1}};
  }
  bool close(std::size_t other) const {
    const double x = poses_[other].x - poses_[at_].x, y = poses_[other].y - poses_[at_].y;
    return x * x + y * y < 4;
  }

  const std::vector<Star>& all_;
  b2DynamicTree tree_;
  std::vector<int32> proxies_;
  std::vector<RelativePose> poses_;
  std::map<std::pair<std::size_t, std::size_t>, std::unique_ptr<Peer>> pairs_;
  std::size_t at_ = 0;
  bool hit_ = false;
};

class FclWorld {
 public:
  explicit FclWorld(const std::vector<Star>& all) : all_(all) {
    for (const Star& star : all) objects_.push_back(std::make_unique<fcl::CollisionObjectd>(mesh(star.shape)));
    for (const auto& object : objects_) manager_.registerObject(object.get());
    manager_.setup();
  }
  bool hit_at(double t) {
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const RelativePose pose = all_[i].pose(t);
      fcl::Matrix3d turn = fcl::Matrix3d::Identity();
      turn(0, 0) = turn(1, 1) = pose.c;
      turn(1, 0) = pose.s;
      turn(0, 1) = -pose.s;
      objects_[i]->setTransform(turn, fcl::Vector3d(pose.x, pose.y, 0));
      objects_[i]->computeAABB();
    }
    manager_.update();
    bool hit = false;
    manager_.collide(&hit, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* found) {
      fcl::CollisionResultd result;
      if (fcl::collide(a, b, fcl::CollisionRequestd(), result) > 0) *static_cast<bool*>(found) = true;
      return *static_cast<bool*>(found);
    });
    return hit;
  }

 private:
  /// The outline's walls: two such surfaces meet wherever the outlines do.
  static std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> mesh(const PeerShape& shape) {
    std::vector<fcl::Vector3d> vertices;
    std::vector<fcl::Triangle> triangles;
    const std::size_t n = shape.outline.size();
    for (const double z : {-1.0, 1.0}) {
      for (const Point& p : shape.outline) vertices.emplace_back(p.x, p.y, z);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = (i + 1) % n;
      triangles.emplace_back(i, j, n + j);
      triangles.emplace_back(i, n + j, n + i);
    }
    auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
    model->beginModel();
    model->addSubModel(vertices, triangles);
    model->endModel();
    return model;
  }

  const std::vector<Star>& all_;
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

/// CPU seconds, and the first step that sees a contact.
template <class World>
std::pair<double, double> stepped(const std::vector<Star>& all, double end, int steps) {
  World world(all);
  const Stopwatch watch;
  for (int k = 0; k <= steps; ++k) {
    const double t = end * k / steps;
    if (world.hit_at(t)) return {watch.seconds(), t};
  }
  return {watch.seconds(), INFINITY};
}

void compare_worlds(int count) {
  const std::vector<Star> all = stars(count);
  Scene scene = world_of(all, 4);
  Answer first = check(scene, world_options());
  if (!first.contact) {
    scene.end = 1000;
    first = check(scene, world_options());
  }
  if (!first.contact) {
    std::printf("%d stars: %s\n", count, to_string(first.outcome));
    return;
  }
  scene.end = first.contact->time.hi * (1 + 1e-9);
  for (Body& body : scene.bodies) body.prepared = prepare(body.polygon, body.name);
  double best = INFINITY;
  for (int run = 0; run < 5; ++run) {
    const Stopwatch watch;
    check(scene, world_options());
    best = std::min(best, watch.seconds());
  }
  if (count > most_for_peers) {
    std::printf("| %d | %.4g | %.1f | | |\n", count, scene.end, 1e3 * best);
    return;
  }
  const auto said = [](double t) { return std::isfinite(t) ? "sees it" : "misses it"; };
  const auto [box2d, box2d_at] = stepped<Box2dWorld>(all, scene.end, box2d_steps);
  const auto [fcl, fcl_at] = stepped<FclWorld>(all, scene.end, fcl_steps);
  std::printf("| %d | %.4g | %.1f | %.0f (%.1f, %s) | %.0f (%.1f, %s) |\n", count, scene.end, 1e3 * best, 1e3 * box2d,
              box2d / best, said(box2d_at), 1e3 * fcl, fcl / best, said(fcl_at));
  std::fflush(stdout);
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) {
  std::puts(
      "| stars | first contact at | taut, ms | Box2D, 4,096 steps, ms (times taut) | FCL, 256 steps, ms (times taut) "
      "|");
  std::puts("|---:|---:|---:|---:|---:|");
  for (int i = 1; i < argc; ++i) taut::bench::compare_worlds(std::max(2, std::atoi(argv[i])));
}
