#include "generators/shapes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "taut/error.hpp"

namespace taut::gen {

void require_range(const std::string& option, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw InputError(option, fmt::format("{} is out of range", value), fmt::format("choose from {} to {}", low, high));
}

Point polar(double radius, double angle) { return {radius * std::cos(angle), radius * std::sin(angle)}; }

Coefficients chebyshev(int degree, double scale, double offset) {
  Coefficients before{1}, current{0, 1};
  if (degree == 0) current = before;
  for (int k = 2; k <= degree; ++k) {
    Coefficients next(current.size() + 1, 0.0);
    for (std::size_t i = 0; i < current.size(); ++i) next[i + 1] = 2 * current[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::exchange(current, next);
  }
  for (double& c : current) c *= scale;
  current[0] += offset;
  return current;
}

MotionPiece translation(Coefficients x, Coefficients y) {
  MotionPiece piece;
  piece.x = std::move(x);
  piece.y = std::move(y);
  return piece;
}

// splitmix64
std::uint64_t Random::next() {
  std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

double Random::uniform(double low, double high) {
  return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
}

}  // namespace taut::gen
