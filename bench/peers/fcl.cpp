// FCL 0.7: two convex bodies as convex prisms; others as closed surfaces of prisms, in trees of OBBRSS. The smaller
// body's prism is the thicker one, so that the bodies' lids are never in one plane, and so that a small body inside a
// large one pierces the large one's lids. The continuous test is for convex bodies: between two trees it missed every
// contact.
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>

#include "peers/peer.hpp"

namespace taut::bench {
namespace {

using Mesh = fcl::BVHModel<fcl::OBBRSSd>;

/// The outline below, then the outline above.
std::vector<fcl::Vector3d> prism_vertices(const Polygon& outline, double half_height) {
  std::vector<fcl::Vector3d> vertices;
  for (const double z : {-half_height, half_height}) {
    for (const Point& p : outline) vertices.emplace_back(p.x, p.y, z);
  }
  return vertices;
}

std::shared_ptr<Mesh> mesh_prism(const PeerShape& shape, double half_height) {
  const std::size_t n = shape.outline.size();
  const std::vector<fcl::Vector3d> vertices = prism_vertices(shape.outline, half_height);
  std::vector<fcl::Triangle> triangles;
  for (const Triangle& t : shape.triangles) {
    triangles.emplace_back(t[0], t[2], t[1]);
    triangles.emplace_back(n + t[0], n + t[1], n + t[2]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    triangles.emplace_back(i, j, n + j);
    triangles.emplace_back(i, n + j, n + i);
  }
  auto mesh = std::make_shared<Mesh>();
  mesh->beginModel();
  mesh->addSubModel(vertices, triangles);
  mesh->endModel();
  return mesh;
}

std::shared_ptr<fcl::Convexd> convex_prism(const Polygon& outline, double half_height) {
  const int n = static_cast<int>(outline.size());
  auto faces = std::make_shared<std::vector<int>>();  // each after the number of its vertices
  faces->push_back(n);
  for (int i = n - 1; i >= 0; --i) faces->push_back(i);
  faces->push_back(n);
  for (int i = 0; i < n; ++i) faces->push_back(n + i);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    faces->insert(faces->end(), {4, i, j, n + j, n + i});
  }
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>(prism_vertices(outline, half_height));
  return std::make_shared<fcl::Convexd>(vertices, n + 2, faces);
}

fcl::Transform3d transform(const RelativePose& pose) {
  fcl::Transform3d out = fcl::Transform3d::Identity();
  out.linear()(0, 0) = out.linear()(1, 1) = pose.c;
  out.linear()(1, 0) = pose.s;
  out.linear()(0, 1) = -pose.s;
  out.translation() = fcl::Vector3d(pose.x, pose.y, 0);
  return out;
}

class Fcl : public Peer {
 public:
  Fcl(const PeerShape& fixed, const PeerShape& moving)
      : convex_(fixed.pieces.size() == 1 && moving.pieces.size() == 1) {
    const double height = fixed.radius < moving.radius ? 2 : 1;
    if (convex_) {
      fixed_ = convex_prism(fixed.pieces[0], height);
      moving_ = convex_prism(moving.pieces[0], 3 - height);
    } else {
      fixed_ = mesh_prism(fixed, height);
      moving_ = mesh_prism(moving, 3 - height);
    }
  }

  bool overlap(const RelativePose& pose) override {
    const fcl::CollisionRequestd request(1, false);
    fcl::CollisionResultd result;
    return fcl::collide(fixed_.get(), still_, moving_.get(), transform(pose), request, result) > 0;
  }

  bool casts() const override { return convex_; }

  std::optional<double> cast(const RelativePose& from, const RelativePose& to) override {
    const fcl::ContinuousCollisionRequestd request(1000, 1e-6, fcl::CCDM_TRANS, fcl::GST_LIBCCD,
                                                   fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(fixed_.get(), still_, still_, moving_.get(), transform(from), transform(to), request,
                           result);
    if (!result.is_collide) return std::nullopt;
    return result.time_of_contact;
  }

 private:
  const fcl::Transform3d still_ = fcl::Transform3d::Identity();
  bool convex_;
  std::shared_ptr<fcl::CollisionGeometryd> fixed_, moving_;
};

}  // namespace

std::unique_ptr<Peer> make_fcl(const PeerShape& fixed, const PeerShape& moving) {
  return std::make_unique<Fcl>(fixed, moving);
}

}  // namespace taut::bench
