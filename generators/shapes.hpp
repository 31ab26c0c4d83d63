// Small tools of the generators.
#pragma once

#include <cstdint>
#include <string>

#include "taut/geometry.hpp"
#include "taut/motion.hpp"

namespace taut::gen {

inline constexpr double pi = 3.14159265358979323846;

/// Throws InputError unless low <= value <= high.
void require_range(const std::string& option, double value, double low, double high);

Point polar(double radius, double angle);

/// scale * T_degree(t) + offset, the Chebyshev polynomial: `degree` extrema of size 1 on [-1, 1].
Coefficients chebyshev(int degree, double scale, double offset);

/// A piece that only translates.
MotionPiece translation(Coefficients x, Coefficients y);

/// Random numbers that are the same everywhere, which the distributions of the standard library are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// Uniform in [low, high).
  double uniform(double low, double high);

 private:
  std::uint64_t state_;
};

}  // namespace taut::gen
