// Where polynomials do what a rotation must not do. Certain: what doubles cannot decide, 960 bits do.
#pragma once

#include <optional>

#include "taut/motion.hpp"

namespace taut::internal {

/// How far a cosine may exceed 1 in magnitude, on account of the rounding of its coefficients.
inline constexpr double cosine_excess = 0x1p-40;

/// Thrown where a search has looked at as many intervals as it may: nothing is known then.
struct SearchExhausted {};

/// Of intervals that one search looks at. A polynomial of degree 16 that is bounded by 1 needs a few hundred.
inline constexpr int most_intervals = 1 << 15;

/// Polynomials are in powers of t - origin.
///
/// An instant of [start, end] at which both polynomials are zero, or cannot be distinguished from zero in 960 bits.
std::optional<double> common_zero(const Coefficients& a, const Coefficients& b, double origin, double start, double end,
                                  int most = most_intervals);

/// An instant of [start, end] at which |a| is more than 1 + cosine_excess, less 2^-60 of that: without such a margin,
/// one that just reaches the bound would be looked at for ever.
std::optional<double> beyond_one(const Coefficients& a, double origin, double start, double end,
                                 int most = most_intervals);

}  // namespace taut::internal
