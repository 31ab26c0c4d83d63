#include "motion/repetition.hpp"

#include <cmath>

namespace taut::internal {
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
