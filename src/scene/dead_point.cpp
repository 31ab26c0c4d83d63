// Dead points of a mechanism: where the time, as a function of another unknown, has a maximum.
#include <algorithm>
#include <cmath>

#include "scene/mechanism.hpp"

namespace taut::internal {
namespace {

using Order2 = Series<double, 2>;
/// Values that change along a vector, by a parameter.
using Moving = Series<double, 1>;

class DeadPointSearch {
 public:
  DeadPointSearch(const LoopEquations& equations, std::size_t piece, const LoopPath& path, GapFrame seen)
      : path_(path),
        curve_{equations, piece, fastest(path, weights_of(equations)), seen},
        weights_(weights_along(curve_, path.until)) {}

  std::optional<DeadPoint> find() const {
    const std::size_t p = static_cast<std::size_t>(curve_.parameter);
    const LoopCell& last = path_.cells.back();
    const double speed = last.about<1>(p, Ball<double>::exact(last.to)).c[1].mid;
    std::vector<double> y;
    for (const Ball<double>& x : path_.last) y.push_back(x.mid);
    const double first = y[p];
    y[p] = path_.until;
    const auto turning = turning_point(y, first);
    if (!turning || !((*turning - first) * speed > 0)) return std::nullopt;
    // Farther beyond the turning point than the start is before it: the time is earlier there.
    const double beyond = *turning + (*turning - first) * (1 + 0x1p-3);
    const double room = std::max(std::fabs(*turning - first) * 0x1p-3, 2 * path_.last[p].rad);
    const double before = first - std::copysign(room, *turning - first);
    return prove(std::move(y), *turning, std::min(before, beyond), std::max(before, beyond));
  }

 private:
  /// The unknown that changes fastest at the path's end.
  static int fastest(const LoopPath& path, const std::vector<double>& weights) {
    int best = 0;
    double most = -1;
    for (std::size_t i = 0; i < path.last.size(); ++i) {
      const double speed =
          std::fabs(path.cells.back().about<1>(i, Ball<double>::exact(path.until)).c[1].mid) / weights[i];
      if (speed > most) {
        most = speed;
        best = static_cast<int>(i);
      }
    }
    return best;
  }

  /// Where the time does not change with the parameter, approximately.
  std::optional<double> turning_point(std::vector<double> y, double s) const {
    const std::size_t p = static_cast<std::size_t>(curve_.parameter);
    for (int k = 0; k < 40; ++k) {
      const auto inverse = newton(curve_, y, s);
      if (!inverse) return std::nullopt;
      Balls<double> at;
      for (const double x : y) at.push_back(Ball<double>::exact(x));
      const auto series = series_of<double, 2>(curve_, at, Ball<double>::exact(s), *inverse, weights_);
      if (!series) return std::nullopt;
      const Order2& time = (*series)[p];
      const double step = -time.c[1].mid / (2 * time.c[2].mid);
      if (!std::isfinite(step)) return std::nullopt;
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += (*series)[i].c[1].mid * step;
      s += step;
      if (std::fabs(step) <= 0x1p-50 * std::fabs(s) + 0x1p-60 * weights_[p]) return s;
    }
    return s;
  }

  /// A tube about the curve for parameters from lo to hi, in which it goes on from the path's end, and in which the
  /// time has one maximum.
  std::optional<DeadPoint> prove(std::vector<double> y, double turning, double lo, double hi) const {
    const std::size_t p = static_cast<std::size_t>(curve_.parameter), n = curve_.size();
    const auto inverse = newton(curve_, y, turning);
    if (!inverse) return std::nullopt;
    const auto at_turn = solve_at<double>(curve_, y, turning, *inverse, weights_);
    if (!at_turn) return std::nullopt;
    const Ball<double> all = Ball<double>::between(lo, hi);
    Balls<double> middle;
    for (const double x : y) middle.push_back(Ball<double>::exact(x));
    const std::vector<double> wrong = residual_over(curve_, middle, turning, all, *inverse);
    Balls<double> tube = middle;
    double most = 0;
    for (std::size_t i = 0; i < n; ++i) most = std::max(most, wrong[i] / weights_[i]);
    for (std::size_t i = 0; i < n; ++i) tube[i].rad = 4 * most * weights_[i];
    const Contraction e(*inverse, jacobian(curve_, tube, all), weights_);
    if (!(e.norm < 0.25)) return std::nullopt;
    std::vector<double> radii = e.closure(wrong);
    for (std::size_t i = 0; i < n; ++i) radii[i] = std::min(2 * radii[i], tube[i].rad);
    CurveBox box{curve_.parameter, {}};
    for (std::size_t i = 0; i < n; ++i) {
      tube[i].rad = radii[i];
      box.ranges.push_back({tube[i].lower(), tube[i].upper()});
    }
    box.ranges.push_back(box.ranges[p]);
    box.ranges[p] = {lo, hi};
    if (!holds_motion(box, curve_.equations, curve_.piece, path_.until, INFINITY, path_.last)) return std::nullopt;
    const auto over = series_of<double, 2>(curve_, tube, all, *inverse, weights_);
    const auto there = series_of<double, 2>(curve_, *at_turn, Ball<double>::exact(turning), *inverse, weights_);
    if (!over || !there) return std::nullopt;
    const Ball<double> bend = (*over)[p].c[2] * 2.0, slope = (*there)[p].c[1];
    if (bend.sign() >= 0) return std::nullopt;
    // The slope has its zero within lo and hi: it changes by at least the least bend.
    const double least = (-bend).lower();
    if (!(slope.magnitude() < least * std::min(turning - lo, hi - turning))) return std::nullopt;
    const double gain = slope.magnitude() * slope.magnitude() / (2 * least) * (1 + 0x1p-40);
    const Ball<double> time = (*there)[p].c[0];
    return DeadPoint{{time.lower(), std::nextafter(time.upper() + gain, INFINITY)}, std::move(box)};
  }

  const LoopPath& path_;
  LoopCurve curve_;
  std::vector<double> weights_;
};

}  // namespace

std::optional<DeadPoint> dead_point_after(const LoopEquations& equations, std::size_t piece, const LoopPath& path) {
  if (path.cells.empty()) return std::nullopt;
  for (const GapFrame seen : {GapFrame::ground, GapFrame::turning}) {
    if (auto found = DeadPointSearch(equations, piece, path, seen).find()) return found;
  }
  return std::nullopt;
}

namespace {

/// A vector that the Jacobian maps to nearly 0. Near a singular matrix, the columns of its inverse are nearly multiples
/// of one.
std::vector<double> kernel_of(Square<double> matrix) {
  double largest = 0;
  for (const double x : matrix.entries) largest = std::max(largest, std::fabs(x));
  for (std::size_t i = 0; i < matrix.n; ++i) matrix(i, i) += largest * 0x1p-45;
  const auto inverse = approximate_inverse(matrix);
  std::vector<double> kernel(matrix.n);
  if (!inverse) return kernel;
  const auto most = std::max_element(inverse->entries.begin(), inverse->entries.end(),
                                     [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  const std::size_t column = static_cast<std::size_t>(most - inverse->entries.begin()) % matrix.n;
  for (std::size_t i = 0; i < matrix.n; ++i) kernel[i] = (*inverse)(i, column) / *most;
  return kernel;
}

bool moves(const Moving& x, double size) { return x.terms > 1 && std::fabs(x.c[1].mid) > 0x1p-16 * size; }

}  // namespace

LooseParts loose_parts(const LoopEquations& equations, std::size_t piece, double t,
                       const std::vector<double>& unknowns) {
  const LoopCurve curve{equations, piece, equations.unknowns};
  Balls<double> at;
  for (const double x : unknowns) at.push_back(Ball<double>::exact(x));
  const Square<Ball<double>> slope = jacobian(curve, at, Ball<double>::exact(t));
  Square<double> middle(slope.n);
  for (std::size_t i = 0; i < middle.entries.size(); ++i) middle.entries[i] = slope.entries[i].mid;
  const std::vector<double> kernel = kernel_of(middle);
  std::vector<Moving> moving;
  for (std::size_t i = 0; i < kernel.size(); ++i) {
    moving.push_back(Moving::variable(at[i]));
    moving.back().c[1] = Ball<double>::exact(kernel[i]);
  }
  const std::vector<Moving> drives = curve.drives_at(Moving::constant(t));
  const LinkPoses<Moving> poses = link_poses(equations, moving, drives);
  const std::vector<double> weights = weights_of(equations);
  const double size = *std::max_element(weights.begin(), weights.end());
  LooseParts loose;
  for (std::size_t k = 0; k < equations.joints.size(); ++k) {
    if (moves(poses.values[k], 1)) loose.joints.push_back(k);
    const PoseOf<Moving>& p = poses.of[k];
    // One degree moves a link's axis by a sixtieth.
    if (moves(p.xx, 0x1p-6) || moves(p.xy, 0x1p-6) || moves(p.ox, size) || moves(p.oy, size)) loose.links.push_back(k);
  }
  for (std::size_t k = 0; k < equations.closures.size(); ++k) {
    const LoopEquations::Closure& closure = equations.closures[k];
    const Moving turned = angle_of(equations, poses, closure.second) - angle_of(equations, poses, closure.first);
    const auto p = placed_point(pose_of_link(poses, closure.first), closure.at);
    const auto q = placed_point(pose_of_link(poses, closure.second), closure.at);
    if (moves(turned, 1) || moves(q[0] - p[0], size) || moves(q[1] - p[1], size)) loose.closures.push_back(k);
  }
  return loose;
}

}  // namespace taut::internal
