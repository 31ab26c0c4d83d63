#include "motion/local_time.hpp"

#include <algorithm>

#include "motion/far_pieces.hpp"
#include "motion/rotation_forms.hpp"

namespace taut::internal {

int highest_power(const MotionPiece& piece) {
  std::size_t terms = std::max(piece.x.size(), piece.y.size());
  terms = std::max(terms, piece.orbit.angle.size());
  for_each_polynomial(piece.rotation, [&](const Coefficients& c) { terms = std::max(terms, c.size()); });
  return std::max(static_cast<int>(terms) - 1, 1);
}

bool is_far_for(int power, double start, double end) {
  const double lengths = power == 1 ? 0x1p18 : power == 2 ? 0x1p9 : power == 3 ? 0x1p6 : far_segment;
  return is_far(start, end, lengths);
}

bool is_far_for(const MotionPiece& piece, double start, double end) {
  return is_far_for(highest_power(piece), start - piece.origin, end - piece.origin);
}

bool is_far_for(const PieceChain& chain, double start, double end) {
  return std::any_of(chain.begin(), chain.end(),
                     [=](const MotionPiece& piece) { return is_far_for(piece, start, end); });
}

}  // namespace taut::internal
