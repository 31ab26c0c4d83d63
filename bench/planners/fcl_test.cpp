#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include "planners/state_tests.hpp"

namespace taut::bench {
namespace {

using PrismMesh = fcl::BVHModel<fcl::OBBRSSd>;

void add_prism(PrismMesh& mesh, const Polygon& piece, double half_height) {
  const std::size_t n = piece.size();
  std::vector<fcl::Vector3d> vertices;
  for (const double z : {-half_height, half_height}) {
    for (const Point& p : piece) vertices.emplace_back(p.x, p.y, z);
  }
  std::vector<fcl::Triangle> triangles;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    triangles.emplace_back(0, i + 1, i);
    triangles.emplace_back(n, n + i, n + i + 1);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    triangles.emplace_back(i, j, n + j);
    triangles.emplace_back(i, n + j, n + i);
  }
  mesh.addSubModel(vertices, triangles);
}

std::shared_ptr<PrismMesh> prisms(const ConvexPieces& pieces, double half_height) {
  auto mesh = std::make_shared<PrismMesh>();
  mesh->beginModel();
  for (const Polygon& piece : pieces) add_prism(*mesh, piece, half_height);
  mesh->endModel();
  return mesh;
}

class FclTest : public StateTest {
 public:
  explicit FclTest(const PlanMap& map) : map_(prisms(map.pieces, 1)), robot_(prisms(map.robot_pieces, 2)) {}

  bool free(const PoseSE2& pose) override {
    fcl::Transform3d at = fcl::Transform3d::Identity();
    at.linear() = fcl::AngleAxis<double>(pose.angle, fcl::Vector3d::UnitZ()).toRotationMatrix();
    at.translation() = fcl::Vector3d(pose.x, pose.y, 0);
    const fcl::CollisionRequestd request(1, false);
    fcl::CollisionResultd result;
    return fcl::collide(map_.get(), still_, robot_.get(), at, request, result) == 0;
  }

 private:
  const fcl::Transform3d still_ = fcl::Transform3d::Identity();
  std::shared_ptr<PrismMesh> map_, robot_;
};

}  // namespace

std::unique_ptr<StateTest> make_fcl_test(const PlanMap& map) { return std::make_unique<FclTest>(map); }

}  // namespace taut::bench
