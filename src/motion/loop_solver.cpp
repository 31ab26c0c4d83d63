#include "motion/loop_solver.hpp"

#include <numeric>

namespace taut::internal {

std::optional<Square<double>> approximate_inverse(const Square<double>& a) {
  const std::size_t n = a.n;
  Square<double> left = a, right(n);
  for (std::size_t i = 0; i < n; ++i) right(i, i) = 1;
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t i = column + 1; i < n; ++i) {
      if (std::fabs(left(i, column)) > std::fabs(left(pivot, column))) pivot = i;
    }
    if (!(std::fabs(left(pivot, column)) > 0)) return std::nullopt;
    for (std::size_t j = 0; j < n; ++j) {
      std::swap(left(pivot, j), left(column, j));
      std::swap(right(pivot, j), right(column, j));
    }
    const double factor = 1 / left(column, column);
    for (std::size_t j = 0; j < n; ++j) {
      left(column, j) *= factor;
      right(column, j) *= factor;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double share = left(i, column);
      if (i == column || share == 0) continue;
      for (std::size_t j = 0; j < n; ++j) {
        left(i, j) -= share * left(column, j);
        right(i, j) -= share * right(column, j);
      }
    }
  }
  const bool finite =
      std::all_of(right.entries.begin(), right.entries.end(), [](double x) { return std::isfinite(x); });
  return finite ? std::optional(right) : std::nullopt;
}

Contraction::Contraction(const Square<double>& y, const Square<Ball<double>>& derivative,
                         std::vector<double> given_weights)
    : Contraction(
          [&] {
            Square<double> bounds(y.n);
            for (std::size_t i = 0; i < y.n; ++i) {
              for (std::size_t j = 0; j < y.n; ++j) {
                Ball<double> entry = Ball<double>::exact(i == j ? 1 : 0);
                for (std::size_t k = 0; k < y.n; ++k) entry = entry - derivative(k, j) * y(i, k);
                bounds(i, j) = entry.magnitude();
              }
            }
            return bounds;
          }(),
          std::move(given_weights)) {}

Contraction::Contraction(Square<double> given_bound, std::vector<double> given_weights)
    : bound(std::move(given_bound)), weights(std::move(given_weights)) {
  for (std::size_t i = 0; i < bound.n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < bound.n; ++j) sum += bound(i, j) * weights[j] / weights[i];
    sum *= 1 + 0x1p-45;
    if (!(sum < INFINITY)) sum = INFINITY;  // also where it is not a number
    norm = std::max(norm, sum);
  }
}

std::vector<double> Contraction::times(const std::vector<double>& v) const {
  std::vector<double> out;
  for (std::size_t i = 0; i < bound.n; ++i) {
    double sum = 0;
    for (std::size_t j = 0; j < bound.n; ++j) sum += bound(i, j) * v[j];
    out.push_back(sum * (1 + 0x1p-45) + underflow_slack);
  }
  return out;
}

std::vector<double> Contraction::closure(const std::vector<double>& g) const {
  double most = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double share = g[i] / weights[i];
    most = share < INFINITY ? std::max(most, share) : INFINITY;
  }
  most = norm < 1 ? most / (1 - norm) * (1 + 0x1p-45) + underflow_slack : INFINITY;
  std::vector<double> all;
  for (const double weight : weights) all.push_back(weight * most * (1 + 0x1p-50));
  // In the norm, a bound of one unknown costs all others theirs. Each round takes that back where they depend little on
  // it.
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<double> rest = times(all);
    for (std::size_t i = 0; i < g.size(); ++i) all[i] = std::min(all[i], (rest[i] + g[i]) * (1 + 0x1p-50));
  }
  return all;
}

std::vector<double> magnitudes(const Balls<double>& v) {
  std::vector<double> out;
  for (const Ball<double>& x : v) out.push_back(x.magnitude());
  return out;
}

std::optional<Square<double>> newton(const LoopCurve& curve, std::vector<double>& y, double s) {
  const Ball<double> at = Ball<double>::exact(s);
  return newton_by([&](const Balls<double>& x) { return std::pair(jacobian(curve, x, at), values_of(curve, x, at)); },
                   y);
}

}  // namespace taut::internal
