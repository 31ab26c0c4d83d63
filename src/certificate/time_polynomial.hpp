// A polynomial in the time that is added to a function of the segment's parameter, at one precision.
#pragma once

#include <algorithm>

#include "motion/motion_segment.hpp"

namespace taut::internal {

/// In powers of the time since the segment's `about()`. The segment is not a bridge.
template <class Real>
struct TimePolynomial {
  BallPolynomial<Real> c;
  double about = 0;

  Jet<Real> operator()(const Ball<Real>& t) const { return polynomial_range(c, time_since(t, about)); }
  Jet<Real> operator()(const TimeFromEnd<Real>& t) const {
    return Jet<Real>::polynomial(BallCoefficients<Real>{c}, TimeFromEnd<Real>{t.end, t.direction, t.s, about});
  }
  Ball<Real> value(const Ball<Real>& t) const { return polynomial_value(c, time_since(t, about)); }
  BallPolynomial<Real> expanded_about(double place) const {
    return expanded(c, time_since(Ball<Real>::exact(place), about));
  }

  /// As in PreciseFunction: of the polynomial in s about a singular end, all terms but the last,
  BallPolynomial<Real> terms_from_end(double end, double direction) const {
    const BallPolynomial<Real> in_time = expanded_about(end);
    BallPolynomial<Real> terms;
    for (std::size_t k = 0; k < last_from_end; ++k) {
      const std::size_t power = k / 2;
      const bool there = k % 2 == 0 && power < in_time.size;
      terms.push_back(there ? signed_power(in_time[power], direction, power) : Ball<Real>::exact(0));
    }
    return terms;
  }
  /// and the last one: the range of that coefficient of the expansions about all places up to `farthest`.
  Ball<Real> last_term_from_end(double end, double direction, double farthest) const {
    constexpr std::size_t first = last_from_end / 2;
    const BallPolynomial<Real> in_time = expanded_about(end);
    const Ball<Real> square = Ball<Real>::between(Real(0), Real(detail::inflate(farthest * farthest)));
    Ball<Real> sum = Ball<Real>::exact(0);
    for (std::size_t k = in_time.size; k-- > first;)
      sum = sum * square + signed_power(in_time[k], direction, k) * binomial_of_last(2 * k);
    return sum;
  }

 private:
  /// In how many ways to choose last_from_end of n: exact, as n is at most twice the largest degree.
  static double binomial_of_last(std::size_t n) {
    double product = 1;
    for (std::size_t i = 1; i + last_from_end <= n; ++i)
      product = product * static_cast<double>(last_from_end + i) / static_cast<double>(i);
    return product;
  }
  static Ball<Real> signed_power(const Ball<Real>& x, double direction, std::size_t power) {
    return direction < 0 && power % 2 == 1 ? -x : x;
  }
};

}  // namespace taut::internal
