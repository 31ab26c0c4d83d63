// Box2D 2.4: the edges of the fixed outline, as in a chain shape, in a dynamic tree; the moving one in convex pieces.
//
// Pairs are tested by b2Distance, as b2TestOverlap does. It is given the vertices themselves: b2PolygonShape and
// b2ChainShape weld or refuse vertices closer than 2.5 to 5 mm.
#include <box2d/b2_collision.h>
#include <box2d/b2_distance.h>
#include <box2d/b2_dynamic_tree.h>
#include <box2d/b2_time_of_impact.h>

#include <algorithm>
#include <cmath>

#include "peers/peer.hpp"

namespace taut::bench {
namespace {

b2Vec2 vec(const Point& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

/// Vertices in a frame, with the proxy that b2Distance takes.
struct Convex {
  std::vector<b2Vec2> vertices;
  b2DistanceProxy proxy;

  Convex(std::vector<b2Vec2> points, float radius) : vertices(std::move(points)) {
    proxy.Set(vertices.data(), static_cast<int32>(vertices.size()), radius);
  }
  b2AABB box(const b2Transform& pose) const {
    b2AABB out{b2Mul(pose, vertices[0]), b2Mul(pose, vertices[0])};
    for (const b2Vec2& v : vertices) {
      const b2Vec2 at = b2Mul(pose, v);
      out.lowerBound = b2Min(out.lowerBound, at);
      out.upperBound = b2Max(out.upperBound, at);
    }
    const b2Vec2 skin(proxy.m_radius, proxy.m_radius);
    out.lowerBound -= skin;
    out.upperBound += skin;
    return out;
  }
};

class Box2d : public Peer {
 public:
  Box2d(const PeerShape& fixed, const PeerShape& moving, float radius) {
    const std::size_t n = fixed.outline.size();
    edges_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      edges_.emplace_back(std::vector{vec(fixed.outline[i]), vec(fixed.outline[(i + 1) % n])}, radius);
      boxes_.push_back(edges_.back().box(still_));
      tree_.CreateProxy(boxes_.back(), reinterpret_cast<void*>(i));
    }
    for (const std::vector<Polygon>* pieces : {&fixed.pieces, &moving.pieces}) {
      std::vector<Convex>& out = pieces == &fixed.pieces ? fixed_ : moving_;
      for (const Polygon& piece : *pieces) {
        std::vector<b2Vec2> vertices;
        for (const Point& p : piece) vertices.push_back(vec(p));
        out.emplace_back(std::move(vertices), radius);
      }
    }
  }

  bool overlap(const RelativePose& pose) override {
    at_ = transform(pose);
    hit_ = false;
    for (const Convex& piece : moving_) {
      piece_ = &piece;
      piece_box_ = piece.box(at_);
      tree_.Query(this, piece_box_);
      if (hit_) return true;
    }
    return false;
  }

  /// What the tree calls for each of its leaves that the box meets; whether to go on.
  bool QueryCallback(int32 leaf) {
    const auto i = reinterpret_cast<std::size_t>(tree_.GetUserData(leaf));
    // The tree's own boxes are wider, by 0.1 m.
    if (!b2TestOverlap(boxes_[i], piece_box_)) return true;
    b2DistanceInput input;
    input.proxyA = edges_[i].proxy;
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

  bool casts() const override { return fixed_.size() == 1 && moving_.size() == 1; }

  std::optional<double> cast(const RelativePose& from, const RelativePose& to) override {
    b2TOIInput input;
    input.proxyA = fixed_[0].proxy;
    input.proxyB = moving_[0].proxy;
    input.sweepA = sweep({}, {});
    input.sweepB = sweep(from, to);
    input.tMax = 1;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    if (output.state == b2TOIOutput::e_separated || output.state == b2TOIOutput::e_failed) return std::nullopt;
    return output.t;
  }

 private:
  static b2Transform transform(const RelativePose& pose) {
    b2Rot rotation;
    rotation.c = static_cast<float>(pose.c);
    rotation.s = static_cast<float>(pose.s);
    return {b2Vec2(static_cast<float>(pose.x), static_cast<float>(pose.y)), rotation};
  }
  static b2Sweep sweep(const RelativePose& from, const RelativePose& to) {
    b2Sweep out;
    out.localCenter.SetZero();
    out.c0 = transform(from).p;
    out.c = transform(to).p;
    out.a0 = out.a = static_cast<float>(std::atan2(from.s, from.c));
    out.alpha0 = 0;
    return out;
  }

  const b2Transform still_{b2Vec2(0, 0), b2Rot(0)};
  b2DynamicTree tree_;
  std::vector<Convex> edges_, fixed_, moving_;
  std::vector<b2AABB> boxes_;  ///< of the edges
  b2Transform at_;
  const Convex* piece_ = nullptr;
  b2AABB piece_box_;
  bool hit_ = false;
};

}  // namespace

std::unique_ptr<Peer> make_box2d(const PeerShape& fixed, const PeerShape& moving) {
  return std::make_unique<Box2d>(fixed, moving, 0.0f);
}

std::unique_ptr<Peer> make_box2d_skin(const PeerShape& fixed, const PeerShape& moving) {
  return std::make_unique<Box2d>(fixed, moving, b2_polygonRadius);
}

}  // namespace taut::bench
