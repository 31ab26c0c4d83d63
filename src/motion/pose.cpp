#include "motion/pose.hpp"

#include <map>
#include <optional>

#include "motion/pieces.hpp"
#include "numeric/dyadic.hpp"
#include "taut/error.hpp"
#include "taut/pose.hpp"

namespace taut::internal {

std::optional<SingularCosine> singular_at(const CosineRotation& rotation, double origin, double end) {
  if (rotation.a.size() < 2) return std::nullopt;
  double about = 0;
  for (std::size_t k = rotation.a.size(); k-- > 0;) about = about * (end - origin) + rotation.a[k];
  const double extreme = about > 0 ? 1 : -1;
  if (!(std::fabs(about - extreme) < 0x1p-10)) return std::nullopt;
  // The coefficients about the end, exactly.
  DyadicPolynomial c;
  for (const double x : rotation.a) c.push_back(Dyadic::exact(x));
  c = expanded_about(std::move(c), Dyadic::exact(end) - Dyadic::exact(origin));
  c[0] = c[0] - Dyadic::exact(extreme);
  SingularCosine cosine{end, extreme, 0, {}};
  while (cosine.order < c.size() && c[cosine.order].is_zero()) ++cosine.order;
  if (cosine.order == c.size()) return std::nullopt;
  for (std::size_t k = cosine.order; k < c.size(); ++k) cosine.rest.push_back(ball_of<RealMax>(c[k]));
  return cosine;
}

namespace {

/// What cannot be distinguished from zero is zero.
template <class Real>
Ball<double> rounded(const Ball<Real>& x) {
  const double mid = RealTraits<Real>::to_double(x.mid), size = std::fabs(mid);
  if (!(size > x.rad)) return Ball<double>(0, detail::inflate(x.rad + size));
  return Ball<double>(mid, detail::inflate(x.rad + size * 0x1p-52));
}
template <class Real>
Jet<double> rounded(const Jet<Real>& x) {
  return {rounded(x.v), rounded(x.d), rounded(x.dd)};
}

template <class Real>
double width(const Pose<Real>& p) {
  return p.ox.v.rad + p.oy.v.rad + p.xx.v.rad + p.xy.v.rad;
}

/// The first precision that leaves no doubt about a double; the last one says what it can.
template <int stage>
Pose<double> sharp_pose_from(const MotionPiece& piece, double t) {
  using Real = std::tuple_element_t<stage, Precisions>;
  const Pose<Real> p = pose(piece, Ball<Real>::exact(t));
  if constexpr (stage + 1 < precise_stages) {
    if (!(width(p) < 0x1p-160)) return sharp_pose_from<stage + 1>(piece, t);
  }
  return {rounded(p.ox), rounded(p.oy), rounded(p.xx), rounded(p.xy)};
}

}  // namespace

Pose<double> sharp_pose(const MotionPiece& piece, double t) {
  const Pose<double> p = pose(piece, Ball<double>::exact(t));
  if (p.xx.v.rad + p.xy.v.rad < 0x1p-40) return p;
  return sharp_pose_from<0>(piece, t);
}

}  // namespace taut::internal

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
