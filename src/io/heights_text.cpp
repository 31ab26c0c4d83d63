#include "io/heights_text.hpp"

#include <cmath>

#include "io/number_text.hpp"

namespace taut::internal::io {

std::string heights_text(const Layers& z) {
  if (z == Layers{}) return "all layers";
  const auto end = [](double height) { return std::isfinite(height) ? number_text(height) : std::string(); };
  return "z " + end(z.lo) + ".." + end(z.hi);
}

}  // namespace taut::internal::io
