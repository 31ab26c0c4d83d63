#include "motion/curve_box.hpp"

#include <algorithm>
#include <cmath>

#include "motion/joint_functions.hpp"

namespace taut::internal {
namespace {

class CurveBoxProof {
 public:
  CurveBoxProof(const CurveBox& box, const LoopEquations& equations, std::size_t piece, GapFrame seen)
      : curve_{equations, piece, box.parameter, seen},
        p_(static_cast<std::size_t>(box.parameter)),
        range_(box.range(p_)),
        ends_(box.ranges[p_]) {
    for (std::size_t i = 0; i < curve_.size(); ++i) {
      const auto& [lo, hi] = box.ranges[i == p_ ? curve_.size() : i];
      middle_.push_back(Ball<double>::exact(lo + (hi - lo) / 2));
      radii_.push_back(std::min(hi - middle_[i].mid, middle_[i].mid - lo) * (1 - 0x1p-50));
    }
  }

  bool prove(double from, double to, const Balls<double>& last) {
    const double s = ends_[0] + (ends_[1] - ends_[0]) / 2;
    weights_ = weights_along(curve_, from);
    std::vector<double> y;
    for (const Ball<double>& x : middle_) y.push_back(x.mid);
    const auto inverse = newton(curve_, y, s);
    return inverse && has_one_curve(s, *inverse) && contains(from, last) && is_outside(ends_[0], y, from, to) &&
           is_outside(ends_[1], y, from, to);
  }

 private:
  /// Krawczyk's test for all parameters at once.
  bool has_one_curve(double s, const Square<double>& inverse) const {
    Balls<double> tube = middle_;
    for (std::size_t i = 0; i < tube.size(); ++i) tube[i].rad = radii_[i];
    const std::vector<double> wrong = residual_over(curve_, middle_, s, range_, inverse);
    const std::vector<double> inner = Contraction(inverse, jacobian(curve_, tube, range_), weights_).times(radii_);
    for (std::size_t i = 0; i < tube.size(); ++i) {
      if (!(wrong[i] + inner[i] < radii_[i])) return false;
    }
    return true;
  }

  bool is_within(const Balls<double>& y) const {
    for (std::size_t i = 0; i < y.size(); ++i) {
      if (!((y[i] - middle_[i]).magnitude() < radii_[i])) return false;
    }
    return true;
  }

  bool contains(double from, const Balls<double>& last) const {
    Balls<double> y = last;
    y[p_] = Ball<double>::exact(from);
    return last[p_].lower() >= ends_[0] && last[p_].upper() <= ends_[1] && is_within(y);
  }

  /// Is the time of the solution for this parameter certainly none of these?
  bool is_outside(double s, std::vector<double> y, double from, double to) const {
    const auto inverse = newton(curve_, y, s);
    if (!inverse) return false;
    const auto solution = solve_at<double>(curve_, y, s, *inverse, weights_);
    return solution && is_within(*solution) && ((*solution)[p_].upper() < from || (*solution)[p_].lower() > to);
  }

  LoopCurve curve_;
  std::size_t p_;  ///< where the time is among what the curve leads through
  Ball<double> range_;
  std::array<double, 2> ends_;  ///< of the parameter
  Balls<double> middle_;
  std::vector<double> radii_, weights_;
};

}  // namespace

std::vector<double> weights_along(const LoopCurve& curve, double time) {
  using Moving = Series<double, 1>;
  std::vector<double> weights = weights_of(curve.equations);
  const std::vector<double> of_drives = weights_of_drives(curve.equations);
  const std::vector<Moving> rates = curve.rates_at(Moving::constant(time));
  double fastest = 0x1p-300;
  for (std::size_t i = 0; i < rates.size(); ++i)
    fastest = std::max(fastest, std::fabs(rates[i].c[0].mid) / of_drives[i]);
  weights[static_cast<std::size_t>(curve.parameter)] = 1 / fastest;
  return weights;
}

std::vector<double> residual_over(const LoopCurve& curve, const Balls<double>& y, double middle,
                                  const Ball<double>& range, const Square<double>& inverse) {
  using Moving = Series<double, 1>;
  std::vector<Moving> at;
  for (const Ball<double>& x : y) at.push_back(Moving::constant(x));
  Balls<double> slope;
  for (const Moving& f : curve.values(at, Moving::variable(range)))
    slope.push_back(f.terms > 1 ? f.c[1] : Ball<double>::exact(0));
  std::vector<double> wrong = magnitudes(product(inverse, values_of(curve, y, Ball<double>::exact(middle))));
  const std::vector<double> rates = magnitudes(product(inverse, slope));
  const double half = (range - Ball<double>::exact(middle)).magnitude();
  for (std::size_t i = 0; i < wrong.size(); ++i) wrong[i] = detail::inflate(wrong[i] + rates[i] * half);
  return wrong;
}

bool holds_motion(const CurveBox& box, const LoopEquations& equations, std::size_t piece, double from, double to,
                  const Balls<double>& last) {
  const auto shown = [&](GapFrame seen) { return CurveBoxProof(box, equations, piece, seen).prove(from, to, last); };
  return shown(GapFrame::ground) || shown(GapFrame::turning);
}

}  // namespace taut::internal
