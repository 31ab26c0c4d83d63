// The number of roots that an interval can have, by the signs of the derivatives at its ends: the theorem of Budan and
// Fourier.
//
// Where shapes touch to a high order, a certificate function and its first derivatives are zero at one instant except
// for the contribution of the displacement. No range of the function over an interval near that instant decides its
// sign. Intervals have to be halved until they are as short as the distances of the roots that this contribution
// admits, which takes a hundred steps. But some derivative keeps its sign over a long interval. The number of roots
// there is at most the decrease, from start to end, of the number of sign changes in the sequence of derivatives up to
// that one. Outside the neighbourhood of the zero of the preceding derivative in which the roots can lie, this excludes
// a whole interval at once. (The theorem is about polynomials. Its proof uses the sequence only near the zeros of its
// members, and there are few of them if the last member has none.)
//
// F. D. Budan de Boislaurent, Nouvelle methode pour la resolution des equations numeriques, 1807; J. B. J. Fourier,
// Analyse des equations determinees, 1831.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "numeric/jet.hpp"

namespace taut::internal {

/// A function on an interval, given by its Taylor polynomial about a middle of it. The last coefficient is a range that
/// makes the expansion valid over the whole interval.
template <class Real>
class RootCount {
 public:
  /// `lo` and `hi` are the ends, relative to the middle. The polynomial must outlive this object.
  RootCount(const BallPolynomial<Real>& about_middle, const Ball<Real>& lo, const Ball<Real>& hi)
      : c_(about_middle), lo_(lo), hi_(hi), steady_(steady_derivative()) {}

  static constexpr int many = 64;
  /// An upper bound of the number of roots in (lo, hi], counted with multiplicity; `many` if nothing is known. `sign`
  /// is the sign of the function just after `lo`.
  int most(int sign) const {
    if (steady_ == 0) return many;
    return variations(expanded(c_, lo_), sign, Bound::upper) - variations(expanded(c_, hi_), 0, Bound::lower);
  }

  /// Roots near one place: within the radius of it, except for others that are far away.
  struct Cluster {
    Real centre;  ///< relative to the middle
    double radius;
  };
  /// The cluster around the zero of the derivative before the steady one, if that is within the interval, or nearly. It
  /// is only an estimate.
  std::optional<Cluster> cluster() const {
    if (steady_ == 0) return std::nullopt;
    const Real centre = zero_of_derivative(steady_ - 1);
    const double far = reach();
    if (!(RealTraits<Real>::magnitude(centre) <= 2 * far)) return std::nullopt;
    const BallPolynomial<Real> about = expanded(c_, Ball<Real>(centre, 0.0));
    // The roots of a polynomial are bounded by twice the largest of these.
    const int leading = std::ilogb(about[steady_].magnitude());
    int exponent = -1000;
    for (std::size_t k = 0; k < steady_; ++k) {
      const double size = about[k].magnitude();
      if (!(size > 0)) continue;
      const int excess = std::ilogb(size) + 1 - leading, power = static_cast<int>(steady_ - k);
      exponent = std::max(exponent, excess >= 0 ? (excess + power - 1) / power : -(-excess / power));
    }
    const double radius = std::ldexp(1.0, exponent + 1);
    if (!(radius < far)) return std::nullopt;
    return Cluster{centre, radius};
  }

 private:
  enum class Bound : unsigned char { lower, upper };

  double reach() const { return std::max(lo_.magnitude(), hi_.magnitude()); }
  /// The lowest order of a derivative that keeps its sign; 0 if none does.
  std::size_t steady_derivative() const {
    for (std::size_t k = 2; k < c_.size; ++k) {
      if (detail::range_about_zero(c_, k, reach()).sign() != 0) return k;
    }
    return 0;
  }
  /// The number of sign changes in the sequence of derivatives at an end, or a bound where signs are not known. If
  /// `first` is not 0, it is the sign of the function.
  int variations(const BallPolynomial<Real>& at, int first, Bound bound) const {
    const bool most = bound == Bound::upper;
    const int excluded = most ? -many : many;
    const auto better = [most](int a, int b) { return most ? std::max(a, b) : std::min(a, b); };
    // The number of changes if the last sign so far is -1, or 1.
    int negative = 0, positive = 0;
    for (std::size_t k = 0; k <= steady_; ++k) {
      const int sign = k == 0 && first != 0 ? first : at[k].sign();
      const int to_negative = k == 0 ? 0 : better(negative, positive + 1);
      const int to_positive = k == 0 ? 0 : better(positive, negative + 1);
      negative = sign > 0 ? excluded : to_negative;
      positive = sign < 0 ? excluded : to_positive;
    }
    return better(negative, positive);
  }
  /// Uses Newton steps from the middle.
  Real zero_of_derivative(std::size_t order) const {
    Real h(0);
    const double far = 2 * reach();
    for (int step = 0; step < 12; ++step) {
      const Real slope = derivative(order + 1, h);
      if (slope == Real(0)) break;
      const Real change = derivative(order, h) / slope * (1 / static_cast<double>(order + 1));
      h = h - change;
      const double size = RealTraits<Real>::magnitude(h);
      if (!(size <= far)) return Real(far);
      if (RealTraits<Real>::magnitude(change) <= 16 * unit_roundoff<Real>() * size) break;
    }
    return h;
  }
  /// The derivative divided by the factorial of its order.
  Real derivative(std::size_t order, const Real& h) const {
    Real sum(0);
    for (std::size_t k = c_.size; k-- > order;) sum = sum * h + c_[k].mid * binomial(k, order);
    return sum;
  }
  static double binomial(std::size_t n, std::size_t k) {
    double product = 1;
    for (std::size_t i = 0; i < k; ++i) product = product * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return product;
  }

  const BallPolynomial<Real>& c_;
  Ball<Real> lo_, hi_;
  std::size_t steady_;
};

}  // namespace taut::internal
