// Follows the solution of a mechanism's equations through time, cell by cell.
#include <cmath>

#include "motion/joint_functions.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// x^(1/16) by square roots, which are the same on all platforms.
double sixteenth_root(double x) { return std::sqrt(std::sqrt(std::sqrt(std::sqrt(x)))); }

class Follower {
 public:
  /// Gives up where the first cells say that it would need so many times the values that it may have.
  Follower(const LoopEquations& equations, std::size_t piece, GapFrame seen, double patience)
      : curve_{equations, piece, equations.unknowns, seen}, patience_(patience), weights_(weights_of(equations)) {}

  /// Nothing if too many cells would be needed.
  std::optional<LoopPath> follow(double from, double to, const Balls<double>& first) {
    LoopPath path;
    path.until = from;
    path.last = first;
    // A path of length 0 has a cell as well.
    double length = to - from;
    // Shorter ones, as near a dead point, might not move a time in doubles on.
    const double least = std::max(length * 0x1p-42, std::max(std::fabs(from), std::fabs(to)) * 0x1p-50);
    while (path.until < to || path.cells.empty()) {
      checkpoint();
      if (path.cells.size() * curve_.size() > most_values || is_hopeless(path, from, to)) return std::nullopt;
      const double end = length >= to - path.until ? to : path.until + length;
      double factor = 0.5;
      const auto cell = try_cell(path, path.until, end, factor);
      if (cell) {
        path.last = values_at_end(*cell);
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
    const double values = static_cast<double>(path.cells.size() * curve_.size());
    return path.cells.size() >= enough &&
           values * ((to - from) / (path.until - from)) > patience_ * static_cast<double>(most_values);
  }

  /// How small the error has to be, as a share of an unknown's weight: one rounding of an angle of a radian.
  static constexpr double fine = 0x1p-46;

  std::optional<LoopCell> try_cell(const LoopPath& path, double from, double to, double& factor) {
    LoopCell cell = LoopCell::between(from, to);
    std::vector<double> middle;
    for (std::size_t i = 0; i < curve_.size(); ++i)
      middle.push_back(path.cells.empty() ? path.last[i].mid : path.cells.back().approximate(i, cell.middle));
    const auto inverse = newton(curve_, middle, cell.middle);
    if (!inverse) return std::nullopt;
    approximate(cell, middle, *inverse);
    const auto proved_by = certify(cell, curve_, path.last);
    return proved_by && is_fine(cell, *proved_by, factor) ? std::optional(std::move(cell)) : std::nullopt;
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

  LoopCurve curve_;
  double patience_;
  std::vector<double> weights_;
};

}  // namespace

LoopPath follow(const LoopEquations& equations, std::size_t piece, double from, double to, const Balls<double>& first) {
  constexpr double soon = 0.125, late = 16;
  for (const auto& [seen, patience] :
       {std::pair{GapFrame::ground, soon}, std::pair{GapFrame::turning, soon}, std::pair{GapFrame::ground, late}}) {
    if (auto path = Follower(equations, piece, seen, patience).follow(from, to, first)) return std::move(*path);
  }
  throw InputError("mechanism",
                   "its motion is too long: some thousand turns, or as many changes of direction, can be followed",
                   "ask about a shorter time");
}

}  // namespace taut::internal
