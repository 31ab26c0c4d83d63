// Follows the solution of a mechanism's equations through time, cell by cell.
#include <cmath>

#include "motion/joint_functions.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// The cell's part of the disc on which it is analytic. Derivatives at its ends are as good as this is far from 1.
constexpr double share_of_disc = 0.6875;

/// x^(1/16) by square roots, which are the same on all platforms.
double sixteenth_root(double x) { return std::sqrt(std::sqrt(std::sqrt(std::sqrt(x)))); }

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
    // Shorter ones, as near a dead point, might not move a time in doubles on.
    const double least = std::max(length * 0x1p-42, std::max(std::fabs(from), std::fabs(to)) * 0x1p-50);
    while (path.until < to || path.cells.empty()) {
      checkpoint();
      if (path.cells.size() * curve_.size() > most_values || is_hopeless(path, from, to))
        throw InputError(
            "mechanism",
            "its motion is too long: some thousand turns, or as many changes of direction, can be followed",
            "ask about a shorter time");
      const double end = length >= to - path.until ? to : path.until + length;
      double factor = 0.5;
      const auto cell = try_cell(path, path.until, end, factor);
      if (cell) {
        path.last = at_end(*cell);
        path.cells.push_back(std::move(*cell));
        path.until = end;
      }
      length = (end - (cell ? path.cells.back().from : path.until)) * factor;
      if (path.until < to && !(length > least)) {
        path.singular = true;
        return path;
      }
    }
    return path;
  }

 private:
  /// Of unknowns in all cells of a path: some 40 MB, and as many seconds.
  static constexpr std::size_t most_values = std::size_t{1} << 18;
  /// Would all cells be far too many if they went on as so far?
  bool is_hopeless(const LoopPath& path, double from, double to) const {
    constexpr std::size_t enough = 1024;
    constexpr double far = 16;
    const double values = static_cast<double>(path.cells.size() * curve_.size());
    return path.cells.size() >= enough &&
           values * ((to - from) / (path.until - from)) > far * static_cast<double>(most_values);
  }

  /// How small the error has to be, as a share of an unknown's weight: one rounding of an angle of a radian.
  static constexpr double fine = 0x1p-46;

  std::optional<LoopCell> try_cell(const LoopPath& path, double from, double to, double& factor) {
    LoopCell cell{from, to, from + (to - from) / 2, 0, false, {}, {}, {}};
    cell.radius = std::max({to - cell.middle, cell.middle - from, 0x1p-900}) / share_of_disc;
    std::vector<double> middle;
    for (std::size_t i = 0; i < curve_.size(); ++i)
      middle.push_back(path.cells.empty() ? path.last[i].mid : path.cells.back().approximate(i, cell.middle));
    const auto inverse = newton(curve_, middle, cell.middle);
    if (!inverse) return std::nullopt;
    approximate(cell, middle, *inverse);
    const auto wrong = residual(cell, *inverse);
    if (!prove_tube(cell, wrong, path.last, *inverse) || !continues(cell, path.last)) return std::nullopt;
    return is_fine(cell, *inverse, factor) ? std::optional(std::move(cell)) : std::nullopt;
  }

  /// The Taylor coefficients, one after the other, without bounds.
  void approximate(LoopCell& cell, const std::vector<double>& middle, const Square<double>& inverse) const {
    const std::size_t n = curve_.size();
    RoughSeries time = RoughSeries::constant(cell.middle);
    time.c[1] = cell.radius;
    time.terms = 2;
    std::vector<RoughSeries> y;
    for (const double x : middle) y.push_back(RoughSeries::constant(x));
    for (int k = 1; k <= LoopCell::order; ++k) {
      for (RoughSeries& x : y) x.known = x.terms = k + 1;
      const std::vector<RoughSeries> f = curve_.values(y, time);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j)
          y[i].c[static_cast<std::size_t>(k)] -= inverse(i, j) * f[j].c[static_cast<std::size_t>(k)];
      }
    }
    for (const RoughSeries& x : y) cell.c.push_back(x.c);
  }

  /// The polynomials as functions on the disc, each with an error.
  static std::vector<DiscSeries> functions(const LoopCell& cell, const std::vector<double>& error) {
    std::vector<DiscSeries> out(cell.c.size());
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].c = cell.c[i];
      out[i].terms = LoopCell::order + 1;
      out[i].error = error[i];
    }
    return out;
  }

  /// |Y F| at the polynomials.
  std::vector<double> residual(const LoopCell& cell, const Square<double>& inverse) const {
    const std::size_t n = curve_.size();
    const std::vector<DiscSeries> f =
        curve_.values(functions(cell, std::vector<double>(n)), DiscSeries::time(cell.middle, cell.radius));
    std::vector<double> out;
    for (std::size_t i = 0; i < n; ++i) {
      DiscSeries sum = DiscSeries::constant(0.0);
      for (std::size_t j = 0; j < n; ++j) sum = sum + f[j] * Ball<double>::exact(inverse(i, j));
      out.push_back(sum.norm());
    }
    return out;
  }

  /// Krawczyk's test among the analytic functions on the disc; it holds for each time by itself, too.
  bool prove_tube(LoopCell& cell, const std::vector<double>& wrong, const Balls<double>& last,
                  const Square<double>& inverse) const {
    const std::size_t n = curve_.size();
    // As narrow as the beginning allows: near a dead point, another branch is near.
    for (std::size_t i = 0; i < n; ++i)
      cell.tube.push_back(4 * std::max(wrong[i], last[i].rad) + 0x1p-40 * weights_[i]);
    const auto f = columns(curve_, functions(cell, cell.tube), DiscSeries::time(cell.middle, cell.radius));
    Square<double> bound(n);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) {
        DiscSeries entry = DiscSeries::constant(i == j ? 1.0 : 0.0);
        for (std::size_t k = 0; k < n; ++k) entry = entry - f[j][k] * Ball<double>::exact(inverse(i, k));
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
  static bool continues(const LoopCell& cell, const Balls<double>& last) {
    LoopCell polynomial = cell;
    std::fill(polynomial.error.begin(), polynomial.error.end(), 0.0);
    for (std::size_t i = 0; i < last.size(); ++i) {
      const Ball<double> value = polynomial.about<0>(i, Ball<double>::exact(cell.from)).c[0];
      if (!((last[i] - value).magnitude() < cell.tube[i])) return false;
    }
    return true;
  }

  /// Is the error hardly more than rounding? How much longer the next cell should be, in any case.
  bool is_fine(const LoopCell& cell, const Square<double>& inverse, double& factor) const {
    Balls<double> middle;
    for (const LoopCell::Coefficients& c : cell.c) middle.push_back(Ball<double>::exact(c[0]));
    const std::vector<double> noise =
        magnitudes(product(inverse, values_of(curve_, middle, Ball<double>::exact(cell.middle))));
    double worst = 0x1p-60;
    for (std::size_t i = 0; i < middle.size(); ++i) {
      const double share = cell.error[i] / std::max(fine * weights_[i], 64 * noise[i]);
      if (!(share <= worst)) worst = share;
    }
    factor = std::clamp(0.9 / sixteenth_root(worst), 0.25, 1.5);
    return worst <= 1;
  }

  Balls<double> at_end(const LoopCell& cell) const {
    Balls<double> out;
    for (std::size_t i = 0; i < cell.c.size(); ++i) out.push_back(cell.about<0>(i, Ball<double>::exact(cell.to)).c[0]);
    return out;
  }

  LoopCurve curve_;
  std::vector<double> weights_;
};

}  // namespace

LoopPath follow(const LoopEquations& equations, std::size_t piece, double from, double to, const Balls<double>& first) {
  return Follower(equations, piece).follow(from, to, first);
}

}  // namespace taut::internal
