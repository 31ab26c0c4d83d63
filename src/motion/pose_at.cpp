#include "taut/pose.hpp"

#include "motion/pieces.hpp"
#include "motion/pose.hpp"

namespace taut {

BodyPose pose_at(const Motion& motion, double t) {
  if (motion.pieces.empty()) return {};
  const Pose<double> p = pose(piece_at(motion.pieces, t), Ball<double>::exact(t));
  return {{p.ox.v.mid, p.oy.v.mid}, {p.xx.v.mid, p.xy.v.mid}};
}

}  // namespace taut
