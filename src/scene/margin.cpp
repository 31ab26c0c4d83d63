#include "scene/margin.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "motion/polynomial_search.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

double middle_of(double from, double to) { return from + (to - from) / 2; }

/// Nothing negative and nothing that changes its sign in powers of the time after an instant, or before it.
bool shows_no_negative(const DyadicPolynomial& about, bool before) {
  for (std::size_t k = 0; k < about.size(); ++k) {
    if (about[k].sign() * (before && k % 2 == 1 ? -1 : 1) < 0) return false;
  }
  return true;
}

bool negative_there(const Margin& margin, double t) {
  const LocalPolynomials::Known known = expanded_about(margin, t);
  return !known.exact().empty() && known.exact()[0].sign() < 0;
}

bool nowhere_negative(const Margin& margin, double from, double to) {
  if (shows_no_negative(expanded_about(margin, from).exact(), false) ||
      shows_no_negative(expanded_about(margin, to).exact(), true))
    return true;
  const double middle = middle_of(from, to);
  const BallPolynomial<RealMax> c = expanded_about(margin, middle).rounded<RealMax>().p;
  const double reach = std::max(to - middle, middle - from) * (1 + 0x1p-50);
  return c.size > 0 && polynomial_value(c, Ball<RealMax>(RealMax(0), reach)).sign() > 0;
}

}  // namespace

bool is_constant(const Margin& margin) {
  const Coefficients& c = margin.coefficients;
  return c.empty() || std::all_of(c.begin() + 1, c.end(), [](double x) { return x == 0; });
}

bool same_margin(const Margin& a, const Margin& b) {
  if (is_constant(a) && is_constant(b)) return constant_term(a) == constant_term(b);
  return a.coefficients == b.coefficients && a.origin == b.origin;
}

Margin scaled(Margin margin, int exponent) {
  for (double& c : margin.coefficients) c = std::ldexp(c, exponent);
  return margin;
}

LocalPolynomials::Known expanded_about(const Margin& margin, double instant) {
  return LocalPolynomials::Known(LocalPolynomials(instant).exact(margin.coefficients, margin.origin));
}

Ball<double> margin_over(const Margin& margin, double from, double to) {
  if (is_constant(margin)) return Ball<double>::exact(constant_term(margin));
  const double middle = middle_of(from, to), reach = std::max(to - middle, middle - from) * (1 + 0x1p-50);
  return polynomial_value(expanded_about(margin, middle).rounded<double>().p, Ball<double>(0, reach));
}

double margin_at(const Margin& margin, double t) {
  const LocalPolynomials::Known known = expanded_about(margin, t);
  if (known.exact().empty()) return 0;
  const Dyadic& exact = known.exact()[0];
  double above = nearest_double(exact);
  while ((exact - Dyadic::exact(above)).sign() > 0) above = std::nextafter(above, INFINITY);
  return above;
}

std::optional<double> negative_at(const Margin& margin, double start, double end) {
  for (const double t : {start, end}) {
    if (negative_there(margin, t)) return t;
  }
  if (!(start < end)) return std::nullopt;
  std::vector<std::pair<double, double>> open{{start, end}};
  for (int left = most_intervals; !open.empty(); --left) {
    checkpoint();
    const auto [from, to] = open.back();
    open.pop_back();
    if (nowhere_negative(margin, from, to)) continue;
    const double middle = middle_of(from, to);
    if (left == 0 || !(from < middle && middle < to) || negative_there(margin, middle)) return middle;
    open.insert(open.end(), {{middle, to}, {from, middle}});
  }
  return std::nullopt;
}

}  // namespace taut::internal
