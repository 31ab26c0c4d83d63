// A small random number generator whose sequence is the same everywhere (the distributions of std:: are not).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace taut::testing {

/// SplitMix64 (Steele, Lea, Flood 2014).
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  /// 0 <= result < n.
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
  /// lo <= result <= hi.
  int between(int lo, int hi) { return lo + below(hi - lo + 1); }
  /// In [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double real(double lo, double hi) { return lo + (hi - lo) * unit(); }
  bool chance(double probability) { return unit() < probability; }
  int sign() { return below(2) ? 1 : -1; }
  template <typename T>
  const T& pick(const std::vector<T>& items) {
    return items[static_cast<std::size_t>(below(static_cast<int>(items.size())))];
  }

 private:
  std::uint64_t state_;
};

}  // namespace taut::testing
