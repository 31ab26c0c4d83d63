// Proves that a solution of a mechanism's equations is near given polynomials, over a part of the time.
#include <cmath>

#include "motion/joint_functions.hpp"

namespace taut::internal {
namespace {

/// The cell's part of the disc on which it is analytic. Derivatives at its ends are as good as this is far from 1.
constexpr double share_of_disc = 0.6875;

class CellProof {
 public:
  CellProof(const LoopCell& cell, const LoopCurve& curve, const Square<double>& inverse)
      : curve_(curve), inverse_(inverse), weights_(weights_of(curve.equations)), cell_(cell) {}

  /// Krawczyk's test among the analytic functions on the disc; it holds for each time by itself, too.
  bool prove(LoopCell& cell, const Balls<double>& last) const {
    const std::size_t n = curve_.size();
    const std::vector<double> wrong = residual();
    // As narrow as the beginning allows: near a dead point, another branch is near.
    for (std::size_t i = 0; i < n; ++i)
      cell.tube.push_back(4 * std::max(wrong[i], last[i].rad) + 0x1p-40 * weights_[i]);
    const auto f = columns(curve_, functions(cell.tube), time());
    Square<double> bound(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        DiscSeries entry = DiscSeries::constant(i == j ? 1.0 : 0.0);
        for (std::size_t k = 0; k < n; ++k) entry = entry - f[j][k] * Ball<double>::exact(inverse_(i, k));
        bound(i, j) = entry.norm();
      }
    }
    const Contraction e(std::move(bound), weights_);
    const std::vector<double> inner = e.times(cell.tube), closed = e.closure(wrong);
    for (std::size_t i = 0; i < n; ++i) {
      if (!(wrong[i] + inner[i] < cell.tube[i])) return false;
      cell.error.push_back(std::min(closed[i], cell.tube[i]));
    }
    return true;
  }

  /// Is the solution the one that the cell before has led to?
  bool continues(const std::vector<double>& tube, const Balls<double>& last) const {
    LoopCell polynomial = cell_;
    polynomial.error.assign(curve_.size(), 0.0);
    for (std::size_t i = 0; i < last.size(); ++i) {
      const Ball<double> value = polynomial.about<0>(i, Ball<double>::exact(cell_.from)).c[0];
      if (!((last[i] - value).magnitude() < tube[i])) return false;
    }
    return true;
  }

 private:
  DiscSeries time() const { return DiscSeries::time(cell_.middle, cell_.radius); }
  /// The polynomials as functions on the disc, each with an error.
  std::vector<DiscSeries> functions(const std::vector<double>& error) const {
    std::vector<DiscSeries> out(cell_.c.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].c = cell_.c[i];
      out[i].terms = LoopCell::order + 1;
      out[i].error = error[i];
    }
    return out;
  }
  /// |Y F| at the polynomials.
  std::vector<double> residual() const {
    const std::size_t n = curve_.size();
    const std::vector<DiscSeries> f = curve_.values(functions(std::vector<double>(n)), time());
    std::vector<double> out;
    for (std::size_t i = 0; i < n; ++i) {
      DiscSeries sum = DiscSeries::constant(0.0);
      for (std::size_t j = 0; j < n; ++j) sum = sum + f[j] * Ball<double>::exact(inverse_(i, j));
      out.push_back(sum.norm());
    }
    return out;
  }

  const LoopCurve& curve_;
  const Square<double>& inverse_;
  std::vector<double> weights_;
  LoopCell cell_;  ///< as it was given
};

}  // namespace

LoopCell LoopCell::between(double from, double to) {
  LoopCell cell{from, to, from + (to - from) / 2, 0, {}, {}, {}, {}};
  cell.radius = std::max({to - cell.middle, cell.middle - from, 0x1p-900}) / share_of_disc;
  return cell;
}

std::optional<Square<double>> certify(LoopCell& cell, const LoopCurve& curve, const Balls<double>& last) {
  cell.error.clear();
  cell.tube.clear();
  std::vector<double> middle;
  for (const LoopCell::Coefficients& c : cell.c) middle.push_back(c[0]);
  auto inverse = newton(curve, middle, cell.middle);
  if (!inverse) return std::nullopt;
  const CellProof proof(cell, curve, *inverse);
  if (!proof.prove(cell, last) || !proof.continues(cell.tube, last)) return std::nullopt;
  return inverse;
}

Balls<double> values_at_end(const LoopCell& cell) {
  Balls<double> out;
  for (std::size_t i = 0; i < cell.c.size(); ++i) out.push_back(cell.about<0>(i, Ball<double>::exact(cell.to)).c[0]);
  return out;
}

std::optional<Balls<double>> for_exact_drives(const LoopCurve& curve, double start, const Balls<double>& last) {
  std::vector<double> about;
  for (const Ball<double>& x : last) about.push_back(x.mid);
  const auto inverse = newton(curve, about, start);
  if (!inverse) return std::nullopt;
  // Balls of doubles enclose the drives, with what rounding left off.
  const Ball<double> at = Ball<double>::exact(start);
  Balls<double> middle;
  for (const double x : about) middle.push_back(Ball<double>::exact(x));
  const std::vector<double> wrong = magnitudes(product(*inverse, values_of(curve, middle, at)));
  const std::vector<double> weights = weights_of(curve.equations);
  Balls<double> box = middle;
  std::vector<double> tube;
  for (std::size_t i = 0; i < box.size(); ++i) {
    tube.push_back(4 * std::max(wrong[i], (last[i] - middle[i]).magnitude()) + 0x1p-40 * weights[i]);
    box[i].rad = tube[i];
  }
  const Contraction e(*inverse, jacobian(curve, box, at), weights);
  const std::vector<double> inner = e.times(tube), closed = e.closure(wrong);
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (!(wrong[i] + inner[i] < tube[i])) return std::nullopt;
    middle[i].rad = std::min(closed[i], tube[i]);
  }
  return middle;
}

}  // namespace taut::internal
