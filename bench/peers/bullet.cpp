// Bullet 3.24 in single precision, as it comes: both bodies as compounds of convex prisms without a margin, in trees of
// boxes; each pose asks the collision world about the pair.
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <btBulletCollisionCommon.h>

#include "peers/peer.hpp"

namespace taut::bench {
namespace {

btScalar real(double x) { return static_cast<btScalar>(x); }

std::unique_ptr<btConvexHullShape> prism(const Polygon& piece) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const double z : {-1.0, 1.0}) {
    for (const Point& p : piece) hull->addPoint(btVector3(real(p.x), real(p.y), real(z)), false);
  }
  hull->setMargin(0);
  hull->recalcLocalAabb();
  return hull;
}

btTransform transform(const RelativePose& pose) {
  const btMatrix3x3 turn(real(pose.c), real(-pose.s), 0, real(pose.s), real(pose.c), 0, 0, 0, 1);
  return btTransform(turn, btVector3(real(pose.x), real(pose.y), 0));
}

/// A compound and its parts.
struct Compound {
  std::vector<std::unique_ptr<btConvexHullShape>> parts;
  btCompoundShape shape;
  btCollisionObject object;

  explicit Compound(const PeerShape& from) : shape(true, static_cast<int>(from.pieces.size())) {
    for (const Polygon& piece : from.pieces) {
      parts.push_back(prism(piece));
      shape.addChildShape(btTransform::getIdentity(), parts.back().get());
    }
    shape.setMargin(0);
    // Alone, a convex shape needs no compound.
    object.setCollisionShape(parts.size() == 1 ? static_cast<btCollisionShape*>(parts[0].get()) : &shape);
  }
};

/// Hears of contact points, those of shapes that are merely near included.
struct Penetration : btCollisionWorld::ContactResultCallback {
  bool found = false;
  btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    found = found || point.getDistance() < 0;
    return 0;
  }
};

class Bullet : public Peer {
 public:
  Bullet(const PeerShape& fixed, const PeerShape& moving)
      : dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &configuration_),
        fixed_(fixed),
        moving_(moving) {
    fixed_.object.setWorldTransform(btTransform::getIdentity());
  }

  bool overlap(const RelativePose& pose) override {
    moving_.object.setWorldTransform(transform(pose));
    Penetration result;
    world_.contactPairTest(&fixed_.object, &moving_.object, result);
    return result.found;
  }

  bool casts() const override { return fixed_.parts.size() == 1 && moving_.parts.size() == 1; }

  std::optional<double> cast(const RelativePose& from, const RelativePose& to) override {
    btVoronoiSimplexSolver simplex;
    btGjkEpaPenetrationDepthSolver depth;
    btContinuousConvexCollision test(fixed_.parts[0].get(), moving_.parts[0].get(), &simplex, &depth);
    btConvexCast::CastResult result;
    const btTransform still = btTransform::getIdentity();
    if (!test.calcTimeOfImpact(still, still, transform(from), transform(to), result)) return std::nullopt;
    return result.m_fraction;
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  Compound fixed_, moving_;
};

}  // namespace

std::unique_ptr<Peer> make_bullet(const PeerShape& fixed, const PeerShape& moving) {
  return std::make_unique<Bullet>(fixed, moving);
}

}  // namespace taut::bench
