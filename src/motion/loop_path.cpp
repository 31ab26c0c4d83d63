// Follows the solution of a mechanism's equations through time, cell by cell.
#include <cmath>

#include "motion/joint_functions.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

using Step = Series<double, LoopCell::order + 1>;

/// sum |c_k| r^k, k = 1 .. last.
template <class Coefficients>
double spread(const Coefficients& c, int last, double r) {
  double sum = 0, power = 1;
  for (int k = 1; k <= last; ++k) {
    power *= r;
    sum += c[static_cast<std::size_t>(k)].magnitude() * power;
  }
  return sum * (1 + 0x1p-45) + underflow_slack;
}

class Follower {
 public:
  Follower(const LoopEquations& equations, std::size_t piece)
      : curve_{equations, piece, equations.unknowns}, weights_(weights_of(equations)) {}

  LoopPath follow(double from, double to, const Balls<double>& first) {
    LoopPath path;
    path.until = from;
    path.last = first;
    // A path of length 0 has a cell as well.
    double length = to - from;
    const double least = length * 0x1p-42;
    while (path.until < to || path.cells.empty()) {
      checkpoint();
      const double end = length >= to - path.until ? to : path.until + length;
      double factor = 0.5;
      const auto cell = try_cell(path, path.until, end, factor);
      if (cell) {
        path.last = at_end(*cell);
        path.cells.push_back(std::move(*cell));
        path.until = end;
      }
      length = (end - (cell ? path.cells.back().from : path.until)) * factor;
      if (!cell && !(length > least)) {
        path.singular = true;
        return path;
      }
    }
    return path;
  }

 private:
  /// How small the last term has to be, as a share of an unknown's weight: one rounding of an angle of a radian.
  static constexpr double fine = 0x1p-45;

  std::optional<LoopCell> try_cell(const LoopPath& path, double from, double to, double& factor) {
    const std::size_t n = curve_.size();
    LoopCell cell{from, to, from + (to - from) / 2, false, {}, {}, {}};
    const double radius = std::max(to - cell.middle, cell.middle - from) * (1 + 0x1p-50);
    std::vector<double> guess;
    for (std::size_t i = 0; i < n; ++i)
      guess.push_back(path.cells.empty() ? path.last[i].mid : path.cells.back().approximate(i, cell.middle));
    const auto inverse = newton(curve_, guess, cell.middle);
    if (!inverse) return std::nullopt;
    const auto middle = solve_at<double>(curve_, guess, cell.middle, *inverse, weights_);
    if (!middle) return std::nullopt;
    const auto series =
        series_of<double, LoopCell::order>(curve_, *middle, Ball<double>::exact(cell.middle), *inverse, weights_);
    if (!series) return std::nullopt;
    for (const auto& s : *series) cell.c.push_back(s.c);
    if (!prove_tube(cell, radius, *inverse)) return std::nullopt;
    if (!continues(cell, path.last)) return std::nullopt;
    return bound_rest(cell, radius, *inverse, factor) ? std::optional(std::move(cell)) : std::nullopt;
  }

  /// Krawczyk's test about the polynomial, with one box for all times.
  bool prove_tube(LoopCell& cell, double radius, const Square<double>& inverse) {
    const std::size_t n = curve_.size();
    const Ball<double> whole = Ball<double>::between(cell.from, cell.to);
    const std::vector<double> wrong = magnitudes(product(inverse, residual_over(cell, radius, whole)));
    for (std::size_t i = 0; i < n; ++i) cell.tube.push_back(std::max(0x1p-20 * weights_[i], 4 * wrong[i]));
    const Contraction e(inverse, jacobian(curve_, range(cell, radius), whole), weights_);
    const std::vector<double> inner = e.times(cell.tube), closed = e.closure(wrong);
    deviation_.clear();
    for (std::size_t i = 0; i < n; ++i) {
      if (!(wrong[i] + inner[i] < cell.tube[i])) return false;
      deviation_.push_back(std::min(closed[i], cell.tube[i]));
    }
    return true;
  }

  /// F at the polynomial over the cell, by Taylor's formula.
  Balls<double> residual_over(const LoopCell& cell, double radius, const Ball<double>& whole) const {
    std::vector<Step> at_middle, over;
    for (const LoopCell::Coefficients& c : cell.c) {
      std::array<Ball<double>, LoopCell::order + 1> middles = c;
      for (Ball<double>& x : middles) x.rad = 0;
      at_middle.push_back(Step::polynomial(middles, Ball<double>::exact(0)));
      over.push_back(Step::polynomial(middles, whole - Ball<double>::exact(cell.middle)));
    }
    const std::vector<Step> f = curve_.values(at_middle, Step::variable(Ball<double>::exact(cell.middle)));
    const std::vector<Step> g = curve_.values(over, Step::variable(whole));
    Balls<double> out;
    const double last = std::pow(radius, LoopCell::order + 1) * (1 + 0x1p-40);
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double rest = g[i].c[LoopCell::order + 1].magnitude() * last;
      const double size = f[i].c[0].magnitude() + spread(f[i].c, LoopCell::order, radius) + rest;
      out.emplace_back(0.0, size * (1 + 0x1p-45));
    }
    return out;
  }

  /// All that the polynomial, or a solution in its tube, can be on the cell.
  Balls<double> range(const LoopCell& cell, double radius) const {
    Balls<double> box;
    for (std::size_t i = 0; i < cell.c.size(); ++i) {
      const Ball<double>& middle = cell.c[i][0];
      box.emplace_back(middle.mid,
                       detail::inflate(middle.rad + cell.tube[i] + spread(cell.c[i], LoopCell::order, radius)));
    }
    return box;
  }

  /// Is the solution the one that the cell before has led to?
  static bool continues(const LoopCell& cell, const Balls<double>& last) {
    for (std::size_t i = 0; i < last.size(); ++i) {
      Ball<double> value = Ball<double>::exact(0);
      const Ball<double> h = Ball<double>::exact(cell.from) - Ball<double>::exact(cell.middle);
      for (int k = LoopCell::order; k >= 0; --k)
        value = value * h + Ball<double>::exact(cell.c[i][static_cast<std::size_t>(k)].mid);
      if (!((last[i] - value).magnitude() < cell.tube[i])) return false;
    }
    return true;
  }

  bool bound_rest(LoopCell& cell, double radius, const Square<double>& inverse, double& factor) {
    Balls<double> box = range(cell, radius);
    for (std::size_t i = 0; i < box.size(); ++i)
      box[i].rad = detail::inflate(box[i].rad - cell.tube[i] + deviation_[i]);
    const auto series = series_of<double, LoopCell::order + 1>(curve_, box, Ball<double>::between(cell.from, cell.to),
                                                               inverse, weights_);
    if (!series) return false;
    const double last = std::pow(radius, LoopCell::order + 1);
    double worst = 0x1p-60;
    for (std::size_t i = 0; i < box.size(); ++i) {
      cell.rest.push_back((*series)[i].c[LoopCell::order + 1]);
      const double allowed = std::max(fine * weights_[i], 4 * cell.c[i][0].rad);
      const double share = cell.rest.back().magnitude() * last / allowed;
      if (!(share <= worst)) worst = share;
    }
    if (!(worst < INFINITY)) return false;
    // The last term grows with this power of the length.
    factor = std::clamp(0.8 * std::pow(worst, -1.0 / (LoopCell::order + 1)), 0.25, 2.0);
    return worst <= 1;
  }

  Balls<double> at_end(const LoopCell& cell) const {
    Balls<double> out;
    for (std::size_t i = 0; i < cell.c.size(); ++i) out.push_back(cell.about<0>(i, Ball<double>::exact(cell.to)).c[0]);
    return out;
  }

  LoopCurve curve_;
  std::vector<double> weights_;
  std::vector<double> deviation_;  ///< of the solution from the polynomial on the last cell that was tried
};

}  // namespace

LoopPath follow(const LoopEquations& equations, std::size_t piece, double from, double to, const Balls<double>& first) {
  return Follower(equations, piece).follow(from, to, first);
}

}  // namespace taut::internal
