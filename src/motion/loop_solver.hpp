// Certified solutions of a mechanism's equations: Krawczyk's test, and Taylor coefficients by implicit differentiation.
//
// R. Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken, Computing 4 (1969), pp. 187-201.
// With Y near the inverse of the Jacobian F', the box x + W holds exactly one zero of F if
//   |Y F(x)| + |1 - Y F'(x + W)| |W| < |W|.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "motion/loop_equations.hpp"

namespace taut::internal {

template <class Real>
using Balls = std::vector<Ball<Real>>;

/// The curve F = 0 in the space of all unknowns and the time, by one of these as its parameter s: the time, or, near a
/// dead point, the unknown that changes fastest. The others are y; where an unknown is the parameter, the time has its
/// place in y.
struct LoopCurve {
  const LoopEquations& equations;
  std::size_t piece;  ///< of the drives
  int parameter;      ///< the number of the unknown; that of the unknowns stands for the time
  GapFrame seen = GapFrame::ground;

  bool by_time() const { return parameter == equations.unknowns; }
  std::size_t size() const { return static_cast<std::size_t>(equations.unknowns); }

  template <class J>
  std::vector<J> drives_at(const J& time) const {
    std::vector<J> drives;
    drives.reserve(equations.drives.size());
    for (const Drive& drive : equations.drives) drives.push_back(drive_value(drive.pieces[piece], time));
    return drives;
  }
  /// How fast the drives change with the time.
  template <class J>
  std::vector<J> rates_at(const J& time) const {
    std::vector<J> rates;
    for (const Drive& drive : equations.drives) rates.push_back(drive_rate(drive.pieces[piece], time));
    return rates;
  }
  template <class J>
  std::vector<J> values(std::vector<J> y, const J& s) const {
    if (by_time()) return residuals_at(y, s);
    J& place = y[static_cast<std::size_t>(parameter)];
    const J time = place;
    place = s;
    return residuals_at(y, time);
  }

 private:
  template <class J>
  std::vector<J> residuals_at(const std::vector<J>& unknowns, const J& time) const {
    const std::vector<J> drives = drives_at(time);
    return residuals(equations, link_poses(equations, unknowns, drives), unknowns, drives, seen);
  }
};

/// A square matrix, row by row.
template <class Number>
struct Square {
  std::size_t n = 0;
  std::vector<Number> entries;
  explicit Square(std::size_t size) : n(size), entries(size * size) {}
  Number& operator()(std::size_t i, std::size_t j) { return entries[i * n + j]; }
  const Number& operator()(std::size_t i, std::size_t j) const { return entries[i * n + j]; }
};

/// An approximate inverse, if there is one in doubles.
std::optional<Square<double>> approximate_inverse(const Square<double>& a);

/// F' for numbers of any kind, by its columns: by y, and, where the time is among these, by the time.
template <class J>
std::vector<std::vector<J>> columns(const LoopCurve& curve, std::vector<J> y, const J& s) {
  using Real = typename J::Number;
  const LoopEquations& equations = curve.equations;
  J time = s;
  if (!curve.by_time()) std::swap(time, y[static_cast<std::size_t>(curve.parameter)]);
  const auto by_joint = derivatives(equations, link_poses(equations, y, curve.drives_at(time)), curve.seen);
  std::vector<std::vector<J>> out;
  for (int j = 0; j < equations.unknowns; ++j) {
    if (j == curve.parameter) {
      const std::vector<J> rates = curve.rates_at(time);
      out.push_back(change_of<J>(equations, by_joint, [&](const LinearForm& form) -> std::optional<J> {
        if (form.drives.empty()) return std::nullopt;
        J sum = J::constant(0.0);
        for (const auto& term : form.drives) sum = sum + rates[static_cast<std::size_t>(term.of)] * term.as<Real>();
        return sum;
      }));
      continue;
    }
    out.push_back(change_of<J>(equations, by_joint, [&](const LinearForm& form) -> std::optional<J> {
      for (const auto& term : form.unknowns) {
        if (term.of == j) return J::constant(term.as<Real>());
      }
      return std::nullopt;
    }));
  }
  return out;
}

/// F' over a box of y and s.
template <class Real>
Square<Ball<Real>> jacobian(const LoopCurve& curve, const Balls<Real>& y, const Ball<Real>& s) {
  using J = Series<Real, 0>;
  std::vector<J> at;
  for (const Ball<Real>& x : y) at.push_back(J::constant(x));
  const std::vector<std::vector<J>> f = columns(curve, std::move(at), J::constant(s));
  Square<Ball<Real>> out(curve.size());
  for (std::size_t j = 0; j < out.n; ++j) {
    for (std::size_t i = 0; i < out.n; ++i) out(i, j) = f[j][i].c[0];
  }
  return out;
}

template <class Real>
Balls<Real> values_of(const LoopCurve& curve, const Balls<Real>& y, const Ball<Real>& s) {
  using J = Series<Real, 0>;
  std::vector<J> at;
  for (const Ball<Real>& x : y) at.push_back(J::constant(x));
  Balls<Real> out;
  for (const J& f : curve.values(at, J::constant(s))) out.push_back(f.c[0]);
  return out;
}

/// Y times a vector.
template <class Real>
Balls<Real> product(const Square<double>& y, const Balls<Real>& v) {
  Balls<Real> out;
  for (std::size_t i = 0; i < y.n; ++i) {
    Ball<Real> sum = v[0] * y(i, 0);
    for (std::size_t j = 1; j < y.n; ++j) sum = sum + v[j] * y(i, j);
    out.push_back(sum);
  }
  return out;
}

/// |1 - Y F'|, from above.
struct Contraction {
  Square<double> bound;
  std::vector<double> weights;  ///< of what sizes the unknowns are
  double norm = 0;              ///< in the norm with these weights

  Contraction(const Square<double>& y, const Square<Ball<double>>& derivative, std::vector<double> given_weights);
  Contraction(Square<double> given_bound, std::vector<double> given_weights);
  /// The bound times a vector of nonnegative numbers.
  std::vector<double> times(const std::vector<double>& v) const;
  /// A bound of |x| for all x with |x| <= |g| + bound |x|; infinite if there is none.
  std::vector<double> closure(const std::vector<double>& g) const;
};

std::vector<double> magnitudes(const Balls<double>& v);

/// Ranges in doubles.
template <class Real>
Balls<double> in_doubles(const Balls<Real>& v) {
  Balls<double> out;
  for (const Ball<Real>& x : v) out.push_back(detail::in_doubles(x));
  return out;
}
inline const Balls<double>& in_doubles(const Balls<double>& v) { return v; }

/// Newton's method without any bound, with a fresh inverse in each step, for F' and F as `linearize` has them for exact
/// y. The inverse of the last step, if it converges.
template <class Linearize>
std::optional<Square<double>> newton_by(const Linearize& linearize, std::vector<double>& y) {
  double last = INFINITY;
  for (int k = 0; k < 30; ++k) {
    Balls<double> at;
    for (const double x : y) at.push_back(Ball<double>::exact(x));
    const auto [slope, values] = linearize(at);
    Square<double> middle(slope.n);
    for (std::size_t i = 0; i < slope.entries.size(); ++i) middle.entries[i] = slope.entries[i].mid;
    auto inverse = approximate_inverse(middle);
    if (!inverse) return std::nullopt;
    const Balls<double> step = product(*inverse, values);
    double size = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      y[i] -= step[i].mid;
      size = std::max(size, std::fabs(step[i].mid));
    }
    if (!(size < INFINITY)) return std::nullopt;
    // Where steps do not become shorter any more, rounding is what is left.
    if (size == 0 || (k > 1 && size > last / 2)) return inverse;
    last = size;
  }
  return std::nullopt;
}

/// Along a curve.
std::optional<Square<double>> newton(const LoopCurve& curve, std::vector<double>& y, double s);

/// The zero near `about` for the exact parameter s, with a proof that no other is within `tube` of it. Nothing if there
/// is no proof.
template <class Real>
std::optional<Balls<Real>> solve_at(const LoopCurve& curve, const std::vector<double>& about, const Real& s,
                                    const Square<double>& inverse, const std::vector<double>& weights) {
  const std::size_t n = curve.size();
  const Ball<Real> at(s, 0.0);
  Balls<Real> x;
  for (const double value : about) x.push_back(Ball<Real>::exact(value));
  std::vector<double> step;
  // Each step gains some 40 bits or, from doubles, the last few.
  const int steps = 2 + RealTraits<Real>::bits / 32;
  for (int k = 0; k <= steps; ++k) {
    const Balls<Real> change = product(inverse, values_of(curve, x, at));
    step = magnitudes(in_doubles(change));
    if (k == steps) break;
    for (std::size_t i = 0; i < n; ++i) x[i] = Ball<Real>(Real(x[i].mid - change[i].mid), 0.0);
  }
  // In a box twice as large as the last step, in the norm with the weights.
  double most = 0;
  for (std::size_t i = 0; i < n; ++i) most = std::max(most, step[i] / weights[i]);
  Balls<double> box = in_doubles(x);
  for (std::size_t i = 0; i < n; ++i)
    box[i].rad = detail::inflate(box[i].rad + 2 * most * weights[i] + underflow_slack);
  const Contraction e(inverse, jacobian(curve, box, detail::in_doubles(at)), weights);
  if (!(e.norm < 0.5)) return std::nullopt;
  const std::vector<double> radius = e.closure(step);
  for (std::size_t i = 0; i < n; ++i) x[i].rad = detail::inflate(radius[i]);
  return x;
}

/// Solves linear systems with a matrix of balls by an approximate inverse.
template <class Real>
class LinearSolver {
 public:
  LinearSolver(const Square<double>& inverse, const Square<Ball<Real>>& matrix, const std::vector<double>& weights)
      : inverse_(inverse), rest_(matrix.n), error_(inverse, rounded(matrix), weights) {
    for (std::size_t i = 0; i < matrix.n; ++i) {
      for (std::size_t j = 0; j < matrix.n; ++j) {
        Ball<Real> sum = Ball<Real>::exact(i == j ? 1 : 0);
        for (std::size_t k = 0; k < matrix.n; ++k) sum = sum - matrix(k, j) * inverse(i, k);
        rest_(i, j) = sum;
      }
    }
  }
  bool certain() const { return error_.norm < 0.9; }
  /// x = Y b + (1 - Y A) x, from above by the last step of its iteration.
  Balls<Real> solve(const Balls<Real>& b) const {
    const Balls<Real> first = product(inverse_, b);
    Balls<Real> x = first;
    const int steps = std::is_same_v<Real, double> ? 1 : RealTraits<Real>::bits / 32;
    for (int k = 0; k < steps; ++k) {
      for (Ball<Real>& c : x) c.rad = 0;
      x = next(first, x);
    }
    Balls<Real> middle = x;
    for (Ball<Real>& c : middle) c.rad = 0;
    const Balls<Real> again = next(first, middle);
    Balls<Real> change;
    for (std::size_t i = 0; i < x.size(); ++i) change.push_back(again[i] - middle[i]);
    const std::vector<double> radius = error_.closure(magnitudes(in_doubles(change)));
    for (std::size_t i = 0; i < x.size(); ++i) middle[i].rad = detail::inflate(radius[i]);
    return middle;
  }

 private:
  static Square<Ball<double>> rounded(const Square<Ball<Real>>& matrix) {
    Square<Ball<double>> out(matrix.n);
    out.entries = in_doubles(matrix.entries);
    return out;
  }
  Balls<Real> next(const Balls<Real>& first, const Balls<Real>& x) const {
    Balls<Real> out = first;
    for (std::size_t i = 0; i < rest_.n; ++i) {
      for (std::size_t j = 0; j < rest_.n; ++j) out[i] = out[i] + rest_(i, j) * x[j];
    }
    return out;
  }

  const Square<double>& inverse_;
  Square<Ball<Real>> rest_;
  Contraction error_;
};

/// y and its Taylor coefficients in s up to N, where `y` encloses it over the ball s.
template <class Real, int N>
std::optional<std::vector<Series<Real, N>>> series_of(const LoopCurve& curve, const Balls<Real>& y, const Ball<Real>& s,
                                                      const Square<double>& inverse,
                                                      const std::vector<double>& weights) {
  using J = Series<Real, N>;
  const LinearSolver<Real> solver(inverse, jacobian(curve, y, s), weights);
  if (!solver.certain()) return std::nullopt;
  std::vector<J> out;
  for (const Ball<Real>& x : y) {
    out.push_back(J::constant(x));
    out.back().terms = 1;
  }
  for (int k = 1; k <= N; ++k) {
    for (J& x : out) x.terms = k + 1;
    Balls<Real> right;
    for (const J& f : curve.values(out, J::variable(s)))
      right.push_back(k < f.terms ? -f.c[static_cast<std::size_t>(k)] : Ball<Real>::exact(0));
    const Balls<Real> c = solver.solve(right);
    for (std::size_t i = 0; i < c.size(); ++i) out[i].c[static_cast<std::size_t>(k)] = c[i];
  }
  return out;
}

}  // namespace taut::internal
