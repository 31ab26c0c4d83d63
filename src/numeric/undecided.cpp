#include "numeric/undecided.hpp"

#include <fmt/format.h>

#include <iterator>

#include "numeric/real.hpp"

namespace taut {

std::string not_decided(const Undecidable& limit) {
  return fmt::format("not decided at {} bits: {}", precision_ladder[std::size(precision_ladder) - 1], limit.what);
}

}  // namespace taut
