// Rotations given by their cosines, and the pieces that they are cut into, as JSON lines: for cosine_cuts_test.py.
// `taut_cosine_cuts COUNT`.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "motion/cosine_pieces.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

Coefficients product(const Coefficients& a, const Coefficients& b) {
  Coefficients c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k < b.size(); ++k) c[i + k] += a[i] * b[k];
  }
  return c;
}

/// T_degree, which reaches 1 and -1 at most of its extremes between doubles.
Coefficients chebyshev(int degree) {
  Coefficients before{1}, now{0, 1};
  for (int k = 1; k < degree; ++k) {
    Coefficients next = product(now, {0, 2});
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = now;
    now = next;
  }
  return now;
}

/// 1 - s (t - place)^order, or its negative: it touches, or for odd orders crosses, 1 at the place.
Coefficients dip(Rng& rng) {
  const double place = rng.chance(0.5) ? rng.between(-8, 8) / 16.0 : rng.real(-0.5, 0.5);
  Coefficients c{rng.chance(0.7) ? rng.between(1, 8) / 8.0 : rng.real(0, 1)};
  for (int order = rng.between(1, 6); order > 0; --order) c = product(c, {-place, 1});
  for (double& x : c) x = -x;
  c[0] += 1;
  if (rng.chance(0.5)) {
    for (double& x : c) x = -x;
  }
  return c;
}

/// The same of p + q t: its coefficients are rounded, and its extremes a little within 1, or beyond.
Coefficients moved_chebyshev(Rng& rng) {
  const Coefficients given = chebyshev(rng.between(1, 9)), inner{rng.real(-0.3, 0.3), rng.real(0.3, 0.6)};
  Coefficients moved{0};
  for (std::size_t k = given.size(); k-- > 0;) {
    moved = product(moved, inner);
    moved[0] += given[k];
  }
  moved.resize(given.size());
  return moved;
}

Coefficients random_cosine(Rng& rng) {
  switch (rng.below(6)) {
    case 0:
      return chebyshev(rng.between(1, 16));
    case 4:
      return moved_chebyshev(rng);
    case 1:
      return {rng.chance(0.5) ? 1.0 : rng.chance(0.5) ? -1.0 : rng.real(-1, 1)};
    case 2:
      return {rng.real(-1, 1), rng.real(-1, 1), rng.real(-1, 1), rng.real(-0.5, 0.5)};
    default:
      return dip(rng);
  }
}

const char* rotation_name(const MotionPiece& piece) {
  const auto* rest = std::get_if<DirectionRotation>(&piece.rotation);
  if (!rest) return "cosine";
  return rest->a.front() > 0 ? "not turned" : "half a turn";
}

void print_numbers(const Coefficients& numbers) {
  for (std::size_t k = 0; k < numbers.size(); ++k) fmt::print("{}{}", k ? "," : "", numbers[k]);
}

void print_cosine(Rng& rng) {
  MotionPiece piece;
  piece.rotation = CosineRotation{random_cosine(rng)};
  const double origin = rng.chance(0.7) ? 0 : rng.chance(0.5) ? rng.real(-9, 9) : 1790000000.25;
  const double from = origin + (rng.chance(0.7) ? -1 : rng.real(-1, -0.5));
  const double to = origin + (rng.chance(0.7) ? 1 : rng.real(0.5, 1));
  piece.origin = origin;
  fmt::print("{{\"from\":{},\"to\":{},\"origin\":{},\"cosine\":[", from, to, origin);
  print_numbers(std::get<CosineRotation>(piece.rotation).a);
  fmt::print("],\"pieces\":[");
  const char* separator = "";
  for (const MotionPiece& part : cut_at_extremes(piece, from, to)) {
    const bool last = part.until == std::numeric_limits<double>::infinity();
    fmt::print("{}[{},\"{}\"]", separator, last ? "null" : fmt::format("{}", part.until), rotation_name(part));
    separator = ",";
  }
  fmt::print("]}}\n");
}

}  // namespace
}  // namespace taut::testing

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  taut::testing::Rng rng(12);
  for (int k = std::atoi(argv[1]); k > 0; --k) taut::testing::print_cosine(rng);
  return 0;
}
