#include "motion/far_pieces.hpp"

#include <algorithm>
#include <cmath>

#include "motion/local_time.hpp"
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

namespace {

/// 2 pi, rounded up.
constexpr double full_turn = 0x1.921fb54442d19p+2;

/// The greatest common divisor of two doubles; remainders of doubles are exact.
double common_divisor(double a, double b) {
  while (b != 0) {
    const double rest = std::fmod(a, b);
    a = b;
    b = rest;
  }
  return a;
}

}  // namespace

double repeats_from(const MotionChain& p, const MotionChain& q, double start, double end) {
  double begin = start, divisor = 0;
  for (const MotionChain* const chain : {&p, &q}) {
    for (const PieceList& motion : *chain) {
      const auto last = motion.last_rates(end);
      if (!last) return INFINITY;
      begin = std::fmax(begin, last->begin);
      for (const double rate : {last->turn, last->orbit}) divisor = common_divisor(divisor, std::fabs(rate));
    }
  }
  if (divisor == 0) return INFINITY;
  const double period = full_turn / divisor * (1 + 0x1p-50);
  const double from = (begin + period) + 0x1p-51 * (std::fabs(begin) + period);
  return from < end ? from : INFINITY;
}

}  // namespace taut::internal
