#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_dynamic_tree.h>

#include <deque>

#include "planners/state_tests.hpp"

namespace taut::bench {
namespace {

/// Vertices, and the proxy that b2Distance takes: no skin, and no vertex welded to another one.
struct ProxyPolygon {
  std::vector<b2Vec2> vertices;
  b2DistanceProxy proxy;

  explicit ProxyPolygon(const Polygon& polygon) {
    for (const Point& p : polygon) vertices.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
    proxy.Set(vertices.data(), static_cast<int32>(vertices.size()), 0);
  }
  b2AABB box(const b2Transform& pose) const {
    b2AABB out{b2Mul(pose, vertices[0]), b2Mul(pose, vertices[0])};
    for (const b2Vec2& v : vertices) {
      out.lowerBound = b2Min(out.lowerBound, b2Mul(pose, v));
      out.upperBound = b2Max(out.upperBound, b2Mul(pose, v));
    }
    return out;
  }
};

class Box2dTest : public StateTest {
 public:
  explicit Box2dTest(const PlanMap& map) {
    for (const Polygon& piece : map.pieces) pieces_.emplace_back(piece);
    for (const Polygon& piece : map.robot_pieces) robot_.emplace_back(piece);
    for (ProxyPolygon& piece : pieces_) tree_.CreateProxy(piece.box(still_), &piece);
  }

  bool free(const PoseSE2& pose) override {
    at_ = b2Transform(b2Vec2(static_cast<float>(pose.x), static_cast<float>(pose.y)),
                      b2Rot(static_cast<float>(pose.angle)));
    hit_ = false;
    for (const ProxyPolygon& piece : robot_) {
      piece_ = &piece;
      tree_.Query(this, piece.box(at_));
      if (hit_) return false;
    }
    return true;
  }

  /// What the tree calls for each of its leaves that the box meets; whether to go on.
  bool QueryCallback(int32 leaf) {
    b2DistanceInput input;
    input.proxyA = static_cast<const ProxyPolygon*>(tree_.GetUserData(leaf))->proxy;
    input.proxyB = piece_->proxy;
    input.transformA = still_;
    input.transformB = at_;
    input.useRadii = true;
    b2SimplexCache cache;
    cache.count = 0;
    b2DistanceOutput output;
    b2Distance(&output, &cache, &input);
    hit_ = output.distance < 10.0f * b2_epsilon;
    return !hit_;
  }

 private:
  const b2Transform still_{b2Vec2(0, 0), b2Rot(0)};
  std::deque<ProxyPolygon> pieces_, robot_;
  b2DynamicTree tree_;
  b2Transform at_;
  const ProxyPolygon* piece_ = nullptr;
  bool hit_ = false;
};

}  // namespace

std::unique_ptr<StateTest> make_box2d_test(const PlanMap& map) { return std::make_unique<Box2dTest>(map); }

}  // namespace taut::bench
