#include "numeric/errors.hpp"

#include <fmt/format.h>

#include "numeric/real.hpp"

namespace taut::internal {

std::string not_decided(const Undecidable& limit) {
  return fmt::format("not decided at {} bits: {}", RealTraits<RealMax>::bits, limit.what);
}

}  // namespace taut::internal
