// Growth laws fitted to measurements.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

namespace taut::paper {

using Samples = std::vector<std::pair<double, double>>;

/// The exponent b of y = a x^b, by least squares on logarithms.
inline double exponent(const Samples& samples) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const auto& [x, y] : samples) {
    if (!(x > 0 && y > 0)) continue;
    const double u = std::log(x), v = std::log(y);
    ++n, sx += u, sy += v, sxx += u * u, sxy += u * v;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

struct Fit {
  double factor = 0;  ///< y is about factor * law(x)
  double error = 0;   ///< root mean square of the relative deviation
};

/// The factor that fits y = factor * law(x) best, relative deviations counting alike for small and large x.
template <class Law>
Fit fit(const Samples& samples, const Law& law) {
  double ss = 0, s = 0, n = 0;
  for (const auto& [x, y] : samples) {
    const double r = law(x) / y;
    ++n, s += r, ss += r * r;
  }
  const double factor = s / ss;
  return {factor, std::sqrt(std::max(0.0, (n - 2 * factor * s + factor * factor * ss) / n))};
}

}  // namespace taut::paper
