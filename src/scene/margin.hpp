// A distance that bodies keep, as a function of time.
#pragma once

#include <algorithm>
#include <optional>

#include "motion/local_time.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

inline Margin constant_margin(double m) { return {{m}, 0}; }
/// The value of a constant one, or the first coefficient.
inline double constant_term(const Margin& margin) { return margin.coefficients.empty() ? 0 : margin.coefficients[0]; }
/// Is it the same at all times, as its coefficients show?
bool is_constant(const Margin& margin);
/// The same function of time, as the coefficients show it?
bool same_margin(const Margin& a, const Margin& b);
/// The same margin in lengths multiplied by 2^exponent, exactly.
Margin scaled(Margin margin, int exponent);
/// In powers of the time since an instant, exactly.
LocalPolynomials::Known expanded_about(const Margin& margin, double instant);
/// Encloses the margin at all times of [from, to].
Ball<double> margin_over(const Margin& margin, double from, double to);
/// The least double that is certainly not below the margin at that instant, or one next to it.
double margin_at(const Margin& margin, double t);
/// An instant of [start, end] at which it is negative, or so close to 0 that no precision decides.
std::optional<double> negative_at(const Margin& margin, double start, double end);

}  // namespace taut::internal
