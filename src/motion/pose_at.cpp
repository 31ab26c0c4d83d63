#include "taut/pose.hpp"

#include <map>
#include <optional>

#include "motion/pieces.hpp"
#include "motion/pose.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

const Pose<double> resting_pose{Jet<double>::constant(0.0), Jet<double>::constant(0.0), Jet<double>::constant(1.0),
                                Jet<double>::constant(0.0)};

Pose<double> own_pose(const Motion& motion, double t) { return sharp_pose(piece_at(motion.pieces, t), t); }

BodyPose rounded(const Pose<double>& p) { return {{p.ox.v.mid, p.oy.v.mid}, {p.xx.v.mid, p.xy.v.mid}}; }

/// Each body's pose is that of its parent times its own: one multiplication a body, however long the chains.
class ScenePoses {
 public:
  ScenePoses(const Scene& scene, double t) : scene_(scene), t_(t), poses_(scene.bodies.size()) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) names_.emplace(scene.bodies[i].name, i);
  }

  const Pose<double>& of(std::size_t i, int depth = 0) {
    if (poses_[i]) return *poses_[i];
    const Body& body = scene_.bodies[i];
    const Motion& motion = body.motion;
    Pose<double> p = motion.pieces.empty() ? resting_pose : own_pose(motion, t_);
    if (!body.relative_to.empty()) p = compose(of(parent(body, depth), depth + 1), p);
    poses_[i] = p;
    return *poses_[i];
  }

 private:
  std::size_t parent(const Body& body, int depth) const {
    const auto found = names_.find(body.relative_to);
    if (found == names_.end())
      throw InputError(body.name, "there is no body \"" + body.relative_to + "\" for it to be relative to",
                       "`relative_to` is the name of another body of the scene");
    if (depth >= max_depth)
      throw InputError(body.name, "its chain of parents is too long", "look for a cycle among its parents");
    return found->second;
  }

  const Scene& scene_;
  double t_;
  std::map<std::string, std::size_t> names_;
  std::vector<std::optional<Pose<double>>> poses_;
};

}  // namespace

BodyPose pose_at(const Motion& motion, double t) {
  if (motion.pieces.empty()) return {};
  return rounded(own_pose(motion, t));
}

std::vector<BodyPose> poses_at(const Scene& scene, double t) {
  ScenePoses placed(scene, t);
  std::vector<BodyPose> poses;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) poses.push_back(rounded(placed.of(i)));
  return poses;
}

}  // namespace taut
