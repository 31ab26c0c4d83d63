// The values of a mechanism's joints as functions of time, known to any precision.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "motion/curve_box.hpp"
#include "motion/disc_series.hpp"
#include "motion/loop_solver.hpp"

namespace taut::internal {

/// A part of the time on which the unknowns are polynomials in (t - middle) / radius, up to functions that are analytic
/// on the disc with that middle and radius, with `error` as a bound of the sum of their coefficients' magnitudes. No
/// other solution of the equations is within `tube` of these polynomials at any time of the cell.
struct LoopCell {
  static constexpr int order = DiscSeries::order;
  using Coefficients = std::array<double, order + 1>;

  double from, to, middle, radius;
  std::optional<CurveBox> box;  ///< right before a dead point: only the values are enclosed
  std::vector<Coefficients> c;  ///< of each unknown
  std::vector<double> error, tube;

  /// Without polynomials yet; the disc is 16/11 times as wide as the part of the time.
  static LoopCell between(double from, double to);
  /// The Taylor coefficients over the ball t, which the cell contains.
  template <int N>
  Series<double, N> about(std::size_t unknown, const Ball<double>& t) const;
  /// The polynomial's value, without bounds.
  double approximate(std::size_t unknown, double t) const;
};

/// Proves that one solution is near the cell's polynomials, and that it is the one within `last` at the cell's
/// beginning; adds error and tube. Returns the approximate inverse of the Jacobian by which this was shown; nothing if
/// it was not.
std::optional<Square<double>> certify(LoopCell& cell, const LoopCurve& curve, const Balls<double>& last);

/// The unknowns at the cell's end.
Balls<double> values_at_end(const LoopCell& cell);

/// The unknowns at the beginning of a curve, where `last` encloses them for drives that begin with the values rounded
/// to doubles. One solution for each drive between the two, all of them near each other, shows that it is the same
/// branch. Nothing if that is not shown.
std::optional<Balls<double>> for_exact_drives(const LoopCurve& curve, double start, const Balls<double>& last);

/// How far the unknowns could be followed.
struct LoopPath {
  std::vector<LoopCell> cells;
  double until = 0;  ///< the end, or where the equations become singular
  bool singular = false;
  Balls<double> last;  ///< the unknowns there
};

/// The sizes of changes of the unknowns that matter equally: a degree, and about as much for a slide.
std::vector<double> weights_of(const LoopEquations& equations);
/// Of the drives.
std::vector<double> weights_of_drives(const LoopEquations& equations);

/// Follows the one solution that is within `first` at `from`, with the drives of a piece.
LoopPath follow(const LoopEquations& equations, std::size_t piece, double from, double to, const Balls<double>& first);

class JointFunctions {
 public:
  /// The cells of each piece of the drives, in order of time. At `drawn_at`, at which the first piece begins, the pose
  /// is the drawn one.
  JointFunctions(LoopEquations equations, std::vector<std::vector<LoopCell>> cells, std::optional<double> drawn_at);

  const LoopEquations& equations() const { return equations_; }
  std::size_t pieces() const { return cells_.size(); }
  const std::vector<LoopCell>& cells(std::size_t piece) const { return cells_[piece]; }
  std::optional<double> drawn_at() const { return drawn_at_; }

  /// The value of a joint, by its number in the equations, over the ball t, with coefficients
  /// of its Taylor series. Of times outside of the piece, only those within it count.
  template <class J>
  J value(std::size_t joint, std::size_t piece, const Ball<typename J::Number>& t) const;

 private:
  template <class Real, int N>
  Series<Real, N> value_of_joint(std::size_t joint, std::size_t piece, const Ball<Real>& t) const;
  template <class Real, int N>
  const std::vector<Series<Real, N>>& all_values(std::size_t piece, const Ball<Real>& t) const;
  template <class Real, int N>
  std::vector<Series<Real, N>> unknowns(std::size_t piece, const Ball<Real>& t) const;
  template <class Real, int N>
  std::optional<std::vector<Series<Real, N>>> solved(std::size_t piece, const Real& t) const;
  template <class Real, int N>
  std::optional<std::vector<Series<Real, N>>> drawn(std::size_t piece, const Ball<Real>& t) const;
  template <int N>
  std::vector<Series<double, N>> enclosed(std::size_t piece, const Ball<double>& t) const;
  const LoopCell& cell_at(std::size_t piece, double t) const;

  LoopEquations equations_;
  std::vector<std::vector<LoopCell>> cells_;
  std::optional<double> drawn_at_;
  std::uint64_t id_;
};

}  // namespace taut::internal
