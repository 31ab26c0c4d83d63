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
  DeadPointSearch(const LoopEquations& equations, std::size_t piece, const LoopPath& path)
      : path_(path), weights_(weights_of(equations)), curve_{equations, piece, fastest(path)} {
    // In place of the parameter there is the time, in which a drive moves by its weight.
    const std::vector<double> of_drives = weights_of_drives(equations);
    const std::vector<Moving> rates = curve_.rates_at(Moving::constant(path.until));
    double fastest = 0x1p-300;
    for (std::size_t i = 0; i < rates.size(); ++i)
      fastest = std::max(fastest, std::fabs(rates[i].c[0].mid) / of_drives[i]);
    weights_[static_cast<std::size_t>(curve_.parameter)] = 1 / fastest;
  }

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
    // As far beyond the turning point as the start is before it, and a little more.
    const double beyond = *turning + (*turning - first);
    const double room = std::max(std::fabs(*turning - first) * 0x1p-3, 2 * path_.last[p].rad);
    const double before = first - std::copysign(room, *turning - first);
    return prove(std::move(y), first, *turning, std::min(before, beyond), std::max(before, beyond));
  }

 private:
  /// The unknown that changes fastest at the path's end.
  int fastest(const LoopPath& path) const {
    int best = 0;
    double most = -1;
    for (std::size_t i = 0; i < path.last.size(); ++i) {
      const double speed =
          std::fabs(path.cells.back().about<1>(i, Ball<double>::exact(path.until)).c[1].mid) / weights_[i];
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
  std::optional<DeadPoint> prove(std::vector<double> y, double first, double turning, double lo, double hi) const {
    const std::size_t p = static_cast<std::size_t>(curve_.parameter), n = curve_.size();
    const auto inverse = newton(curve_, y, turning);
    if (!inverse) return std::nullopt;
    const auto at_turn = solve_at<double>(curve_, y, turning, *inverse, weights_);
    if (!at_turn) return std::nullopt;
    const Ball<double> all = Ball<double>::between(lo, hi);
    Balls<double> middle;
    for (const double x : y) middle.push_back(Ball<double>::exact(x));
    const std::vector<double> wrong = residual_over(middle, turning, all, *inverse);
    Balls<double> tube = middle;
    double most = 0;
    for (std::size_t i = 0; i < n; ++i) most = std::max(most, wrong[i] / weights_[i]);
    for (std::size_t i = 0; i < n; ++i) tube[i].rad = 4 * most * weights_[i];
    const Contraction e(*inverse, jacobian(curve_, tube, all), weights_);
    if (!(e.norm < 0.25)) return std::nullopt;
    std::vector<double> radii = e.closure(wrong);
    for (std::size_t i = 0; i < n; ++i) radii[i] = std::min(2 * radii[i], tube[i].rad);
    const std::vector<double> inner = e.times(radii);
    // The path's end is on the curve at some parameter, which has to be one of these.
    if (!(path_.last[p].lower() >= lo && path_.last[p].upper() <= hi)) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i) {
      tube[i].rad = radii[i];
      if (!(wrong[i] + inner[i] < radii[i])) return std::nullopt;
      const Ball<double> from = i == p ? Ball<double>::exact(path_.until) : path_.last[i];
      if (!((from - middle[i]).magnitude() < radii[i])) return std::nullopt;
    }
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
    DeadPoint found{{time.lower(), std::nextafter(time.upper() + gain, INFINITY)}, {}};
    for (std::size_t i = 0; i < n; ++i)
      found.values.push_back(i == p ? Ball<double>::between(std::min(first, lo), std::max(first, hi)) : tube[i]);
    return found;
  }

  /// |Y F| at constant y for all parameters, by the mean value theorem: Y F hardly changes with the parameter where y
  /// does not.
  std::vector<double> residual_over(const Balls<double>& y, double s, const Ball<double>& all,
                                    const Square<double>& inverse) const {
    std::vector<Moving> at;
    for (const Ball<double>& x : y) at.push_back(Moving::constant(x));
    Balls<double> slope;
    for (const Moving& f : curve_.values(at, Moving::variable(all)))
      slope.push_back(f.terms > 1 ? f.c[1] : Ball<double>::exact(0));
    std::vector<double> wrong = magnitudes(product(inverse, values_of(curve_, y, Ball<double>::exact(s))));
    const std::vector<double> rates = magnitudes(product(inverse, slope));
    const double half = (all - Ball<double>::exact(s)).magnitude();
    for (std::size_t i = 0; i < wrong.size(); ++i) wrong[i] = detail::inflate(wrong[i] + rates[i] * half);
    return wrong;
  }

  const LoopPath& path_;
  std::vector<double> weights_;
  LoopCurve curve_;
};

}  // namespace

std::optional<DeadPoint> dead_point_after(const LoopEquations& equations, std::size_t piece, const LoopPath& path) {
  if (path.cells.empty()) return std::nullopt;
  return DeadPointSearch(equations, piece, path).find();
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
