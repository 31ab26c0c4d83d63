#include "motion/polynomial_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "numeric/budget.hpp"
#include "numeric/jet.hpp"

namespace taut::internal {
namespace {

using Big = Ball<RealMax>;
using Double = Ball<double>;

/// Intervals that doubles look at first, and how often they are halved: they decide nearly every motion, those that
/// reach 1 at an instant too, around which intervals get ever shorter.
constexpr int double_intervals = 4000, double_depth = 40;

BallPolynomial<double> in_doubles(const Coefficients& c) {
  BallPolynomial<double> out;
  for (const double x : c) out.push_back(Double::exact(x));
  if (c.empty()) out.push_back(Double::exact(0));
  return out;
}

/// The same polynomial, of the time itself, up to a positive factor, with times that are at most 1 in magnitude: within
/// the range of a ball's radius, however large the numbers are that the user wrote.
class BigPolynomial {
 public:
  /// `constant` + `sign` * c, in units of 2^exponent of time.
  BigPolynomial(const Coefficients& c, double origin, double constant, int sign, int exponent)
      : origin_(ldexp(RealTraits<RealMax>::from_double(origin), -exponent), 0.0) {
    std::vector<RealMax> all(std::max<std::size_t>(c.size(), 1), RealMax(0));
    for (std::size_t k = 0; k < c.size(); ++k)
      all[k] = ldexp(RealTraits<RealMax>::from_double(sign * c[k]), static_cast<int>(k) * exponent);
    all[0] += RealTraits<RealMax>::from_double(constant);
    int largest = 0;
    bool found = false;
    for (const RealMax& x : all) {
      if (x.is_zero()) continue;
      const int e = x.exponent();
      largest = found ? std::max(largest, e) : e;
      found = true;
    }
    for (const RealMax& x : all) c_.push_back(Big(ldexp(x, -largest), 0.0));
    unit_ = ldexp(RealMax(1), -largest);
  }
  Big over(const Big& t) const { return polynomial_value(c_, origin_.mid.is_zero() ? t : t - origin_); }
  /// 1 after the scaling.
  const RealMax& unit() const { return unit_; }

 private:
  BallPolynomial<RealMax> c_;
  Big origin_;
  RealMax unit_;
};

/// The exponent that takes both times, and the origin, to at most 1 in magnitude.
int time_exponent(double origin, double start, double end) {
  int exponent = 0;
  std::frexp(std::max({std::fabs(start), std::fabs(end), std::fabs(origin)}), &exponent);
  return exponent;
}

/// Doubles are certain that `fine` holds all over [lo, hi].
template <class Fine>
bool fine_in_doubles(const Fine& fine, double lo, double hi, int& left, int depth = 0) {
  if (--left < 0) return false;
  if (fine(Double::between(lo, hi))) return true;
  const double middle = lo + (hi - lo) / 2;
  if (depth == double_depth || !(lo < middle && middle < hi)) return false;
  return fine_in_doubles(fine, lo, middle, left, depth + 1) && fine_in_doubles(fine, middle, hi, left, depth + 1);
}
template <class Fine>
bool fine_in_doubles(const Fine& fine, double lo, double hi) {
  int left = double_intervals;
  return fine_in_doubles(fine, lo, hi, left);
}

/// A time at which `wrong` holds, or around which `fine` fails over the shortest interval there is; nothing if `fine`
/// holds over all parts.
template <class Fine, class Wrong>
std::optional<RealMax> search(const RealMax& lo, const RealMax& hi, const Fine& fine, const Wrong& wrong, int most) {
  for (const RealMax& end : {lo, hi}) {
    if (wrong(Big(end, 0.0))) return end;
  }
  std::vector<std::pair<RealMax, RealMax>> open{{lo, hi}};
  for (int left = most; !open.empty(); --left) {
    checkpoint();
    if (left == 0) throw SearchExhausted{};
    const auto [from, to] = open.back();
    open.pop_back();
    if (fine(Big::between(from, to))) continue;
    const RealMax middle = (from + to) / 2;
    if (wrong(Big(middle, 0.0)) || !(from < middle && middle < to)) return middle;
    open.emplace_back(middle, to);
    open.emplace_back(from, middle);
  }
  return std::nullopt;
}

/// The same for times in the user's units.
template <class Fine, class Wrong>
std::optional<double> search_time(double origin, double start, double end, const Fine& fine, const Wrong& wrong,
                                  int most) {
  const int exponent = time_exponent(origin, start, end);
  const auto in_units = [exponent](double t) { return RealMax(ldexp(RealTraits<RealMax>::from_double(t), -exponent)); };
  const auto found = search(in_units(start), in_units(end), fine, wrong, most);
  if (!found) return std::nullopt;
  return RealTraits<RealMax>::to_double(RealMax(ldexp(*found, exponent)));
}

}  // namespace

std::optional<double> common_zero(const Coefficients& a, const Coefficients& b, double origin, double start, double end,
                                  int most) {
  const BallPolynomial<double> quick_a = in_doubles(a), quick_b = in_doubles(b);
  const auto certain = [&](const Double& time) {
    const Double t = time_since(time, origin);
    return polynomial_value(quick_a, t).sign() != 0 || polynomial_value(quick_b, t).sign() != 0;
  };
  if (fine_in_doubles(certain, start, end)) return std::nullopt;
  const int exponent = time_exponent(origin, start, end);
  const BigPolynomial big_a(a, origin, 0, 1, exponent), big_b(b, origin, 0, 1, exponent);
  const auto fine = [&](const Big& t) { return big_a.over(t).sign() != 0 || big_b.over(t).sign() != 0; };
  const auto wrong = [&](const Big& t) { return !fine(t); };
  return search_time(origin, start, end, fine, wrong, most);
}

std::optional<double> beyond_one(const Coefficients& a, double origin, double start, double end, int most) {
  constexpr double bound = 1 + cosine_excess;
  const BallPolynomial<double> quick = in_doubles(a);
  const auto within = [&](const Double& t) {
    const Double value = polynomial_value(quick, time_since(t, origin));
    return (Double::exact(bound) - value).sign() > 0 && (Double::exact(bound) + value).sign() > 0;
  };
  if (fine_in_doubles(within, start, end)) return std::nullopt;
  const int exponent = time_exponent(origin, start, end);
  const BigPolynomial below(a, origin, bound, -1, exponent), above(a, origin, bound, 1, exponent);
  const auto fine = [&](const Big& t) { return below.over(t).sign() > 0 && above.over(t).sign() > 0; };
  const auto beyond = [](const BigPolynomial& room, const Big& t) {
    return (room.over(t) - Big(room.unit(), 0.0) * 0x1p-60).sign() <= 0;
  };
  const auto wrong = [&](const Big& t) { return beyond(below, t) || beyond(above, t); };
  return search_time(origin, start, end, fine, wrong, most);
}

}  // namespace taut::internal
