#include "motion/loop_box.hpp"

#include <cmath>

#include "motion/box_model.hpp"

namespace taut::internal {
namespace {

Balls<double> exactly(const std::vector<double>& v) {
  Balls<double> out;
  for (const double x : v) out.push_back(Ball<double>::exact(x));
  return out;
}

/// F and F' where the unknowns and the drives are models of one kind.
class BoxEquations {
 public:
  BoxEquations(const LoopEquations& equations, const std::vector<BoxModel>& unknowns,
               const std::vector<BoxModel>& drives)
      : equations_(equations),
        unknowns_(unknowns),
        drives_(drives),
        links_(link_poses(equations, unknowns, drives)),
        by_joint_(derivatives(equations, links_, GapFrame::ground)) {}

  std::vector<BoxModel> values() const { return residuals(equations_, links_, unknowns_, drives_, GapFrame::ground); }
  std::vector<BoxModel> by_unknown(std::size_t j) const { return column(&LinearForm::unknowns, j); }
  std::vector<BoxModel> by_drive(std::size_t k) const { return column(&LinearForm::drives, k); }

 private:
  std::vector<BoxModel> column(std::vector<LinearForm::Term> LinearForm::*terms, std::size_t of) const {
    return change_of<BoxModel>(equations_, by_joint_, [&](const LinearForm& form) -> std::optional<BoxModel> {
      for (const LinearForm::Term& term : form.*terms) {
        if (static_cast<std::size_t>(term.of) == of) return BoxModel::constant(term.as<double>());
      }
      return std::nullopt;
    });
  }

  const LoopEquations& equations_;
  const std::vector<BoxModel>&unknowns_, &drives_;
  LinkPoses<BoxModel> links_;
  std::vector<std::vector<std::optional<BoxModel>>> by_joint_;
};

BoxModel row_times(const Square<double>& inverse, std::size_t row, const std::vector<BoxModel>& v) {
  BoxModel sum = v[0] * Ball<double>::exact(inverse(row, 0));
  for (std::size_t j = 1; j < v.size(); ++j) sum = sum + v[j] * Ball<double>::exact(inverse(row, j));
  return sum;
}

/// |Y v|.
std::vector<double> bounds_of(const Square<double>& inverse, const std::vector<BoxModel>& v) {
  std::vector<double> out;
  for (std::size_t i = 0; i < v.size(); ++i) out.push_back(row_times(inverse, i, v).magnitude());
  return out;
}

class BoxSolver {
 public:
  BoxSolver(const LoopEquations& equations, const std::vector<double>& weights, const DriveBox& box)
      : equations_(equations), weights_(weights), box_(box) {
    for (std::size_t k = 0; k < box.middle.size(); ++k) {
      middle_.push_back(BoxModel::constant(box.middle[k]));
      BoxModel drive = middle_.back();
      if (box.half[k] > 0) {
        drive.rate[varying_.size()] = box.half[k];
        varying_.push_back(k);
      }
      drives_.push_back(drive);
    }
  }

  std::optional<BoxSolution> solve(std::vector<double> about) {
    const auto inverse = newton_by([&](const Balls<double>& y) { return at_middle(y); }, about);
    if (!inverse) return std::nullopt;
    found_.at = std::move(about);
    set_slopes(*inverse);
    const std::vector<BoxModel> near = unknowns();
    const std::vector<double> wrong = bounds_of(*inverse, BoxEquations(equations_, near, drives_).values());
    // In a tube twice as wide as that, in the norm with the weights, and a little wider.
    double most = 0;
    for (std::size_t i = 0; i < wrong.size(); ++i) {
      if (!(wrong[i] < INFINITY)) return std::nullopt;
      most = std::max(most, wrong[i] / weights_[i]);
    }
    for (const double weight : weights_) found_.tube.push_back((2 * most + 0x1p-40) * weight);
    const std::vector<BoxModel> tube = unknowns();
    const BoxEquations over(equations_, tube, drives_);
    const Contraction e(contraction(*inverse, over), weights_);
    if (!(e.norm < 0.5)) return std::nullopt;
    found_.error = e.closure(wrong);
    found_.at_middle = e.closure(magnitudes(product(*inverse, at_middle(exactly(found_.at)).second)));
    for (const std::size_t k : varying_) found_.slope_error[k] = e.closure(miss_of_slope(*inverse, over, k));
    return std::move(found_);
  }

 private:
  /// F' and F at exact values.
  std::pair<Square<Ball<double>>, Balls<double>> at_middle(const Balls<double>& y) const {
    std::vector<BoxModel> at;
    for (const Ball<double>& x : y) at.push_back(BoxModel::constant(x));
    const BoxEquations there(equations_, at, middle_);
    std::pair<Square<Ball<double>>, Balls<double>> out{Square<Ball<double>>(y.size()), {}};
    for (std::size_t j = 0; j < y.size(); ++j) {
      const std::vector<BoxModel> f = there.by_unknown(j);
      for (std::size_t i = 0; i < y.size(); ++i) out.first(i, j) = {f[i].value, f[i].error};
    }
    for (const BoxModel& f : there.values()) out.second.emplace_back(f.value, f.error);
    return out;
  }

  void set_slopes(const Square<double>& inverse) {
    found_.slope.resize(drives_.size());
    found_.slope_error.resize(drives_.size());
    std::vector<BoxModel> at;
    for (const double x : found_.at) at.push_back(BoxModel::constant(x));
    const BoxEquations there(equations_, at, middle_);
    for (const std::size_t k : varying_) {
      const std::vector<BoxModel> f = there.by_drive(k);
      for (std::size_t i = 0; i < f.size(); ++i) found_.slope[k].push_back(-row_times(inverse, i, f).value);
    }
  }

  /// The linear functions, up to the tube.
  std::vector<BoxModel> unknowns() const {
    std::vector<BoxModel> out;
    for (std::size_t i = 0; i < found_.at.size(); ++i) {
      BoxModel u = BoxModel::constant(found_.at[i]);
      for (std::size_t k = 0; k < varying_.size(); ++k)
        u.rate[k] = found_.slope[varying_[k]][i] * box_.half[varying_[k]];
      u.error = detail::inflate(0x1p-52 * u.swing() + (found_.tube.empty() ? 0 : found_.tube[i]));
      out.push_back(u);
    }
    return out;
  }

  static Square<double> contraction(const Square<double>& inverse, const BoxEquations& over) {
    Square<double> bound(inverse.n);
    for (std::size_t j = 0; j < inverse.n; ++j) {
      const std::vector<BoxModel> f = over.by_unknown(j);
      for (std::size_t i = 0; i < inverse.n; ++i)
        bound(i, j) = (BoxModel::constant(i == j ? 1.0 : 0.0) - row_times(inverse, i, f)).magnitude();
    }
    return bound;
  }

  /// |Y (F_u slope + F_d)|: how far a slope is from that of the solutions.
  std::vector<double> miss_of_slope(const Square<double>& inverse, const BoxEquations& over, std::size_t k) const {
    std::vector<BoxModel> sum = over.by_drive(k);
    for (std::size_t j = 0; j < inverse.n; ++j) {
      const std::vector<BoxModel> f = over.by_unknown(j);
      for (std::size_t i = 0; i < inverse.n; ++i) sum[i] = sum[i] + f[i] * Ball<double>::exact(found_.slope[k][j]);
    }
    return bounds_of(inverse, sum);
  }

  const LoopEquations& equations_;
  const std::vector<double>& weights_;
  const DriveBox& box_;
  std::vector<BoxModel> middle_, drives_;
  std::vector<std::size_t> varying_;  ///< drives, each of which is a parameter of the models
  BoxSolution found_;
};

}  // namespace

Balls<double> BoxSolution::about(const DriveBox& box, const std::vector<double>& d) const {
  Balls<double> out = exactly(at);
  for (std::size_t k = 0; k < d.size(); ++k) {
    if (slope[k].empty()) continue;
    const Ball<double> way = Ball<double>::exact(d[k]) - Ball<double>::exact(box.middle[k]);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = out[i] + way * slope[k][i];
  }
  return out;
}

std::optional<BoxSolution> solve_over(const LoopEquations& equations, const std::vector<double>& weights,
                                      const DriveBox& box, std::vector<double> about) {
  return BoxSolver(equations, weights, box).solve(std::move(about));
}

}  // namespace taut::internal
