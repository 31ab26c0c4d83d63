#include "motion/far_pieces.hpp"

#include <algorithm>

#include "motion/local_time.hpp"
#include "motion/rotation_forms.hpp"

namespace taut::internal {

int highest_power(const MotionPiece& piece) {
  std::size_t terms = std::max(piece.x.size(), piece.y.size());
  terms = std::max(terms, piece.orbit.angle.size());
  Rotation rotation = piece.rotation;
  for_each_polynomial(rotation, [&](const Coefficients& c) { terms = std::max(terms, c.size()); });
  return std::max(static_cast<int>(terms) - 1, 1);
}

int highest_power(const PieceChain& chain) {
  int power = 1;
  for (const MotionPiece& piece : chain) power = std::max(power, highest_power(piece));
  return power;
}

bool is_far_for(int power, double start, double end) {
  const double lengths = power == 1 ? 0x1p18 : power == 2 ? 0x1p9 : power == 3 ? 0x1p6 : far_segment;
  return is_far(start, end, lengths);
}

}  // namespace taut::internal
