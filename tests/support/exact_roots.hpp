// Zeros of functions over a segment, of any multiplicity.
//
// Where the j-th derivative keeps its sign, its predecessors are done one after the other: between the zeros of the
// next derivative each is monotone, so the signs there tell where it vanishes. Intervals on which no derivative keeps
// its sign are halved. A zero of multiplicity m so is the simple zero of a derivative, m - 1, at which the function and
// the derivatives before it vanish.
//
// Whether one function vanishes at the zero of another one is decided by precision: two integer polynomials without a
// common zero differ from 0 at each other's zeros by at least an explicit bound. Other functions are taken to vanish if
// they cannot be told from 0 in `assumed_bits`; that is reported.
#pragma once

#include "support/exact_segment.hpp"

namespace taut::testing::exact {

inline constexpr int assumed_bits = 2000;
/// Beyond that, polynomials are assumed to vanish, too.
inline constexpr long most_bits = 30000;

struct Root {
  Function function;
  int order = 0;  ///< the simple zero of this derivative
  Wide at;        ///< contains it, and no other one of that derivative
  std::optional<Rational> exact;
};

class RootFinder {
 public:
  explicit RootFinder(const MotionSegment& segment) : segment_(segment) {}

  /// Zeros of a function that is not identically zero, in order, from `lo` to `hi`, both included.
  std::vector<Root> zeros(const Function& f, const Rational& lo, const Rational& hi);
  /// The sign of a derivative of a function where another one vanishes.
  int sign_at(const Function& f, int order, Root& root);
  int sign_at(const Function& f, int order, const Rational& u);
  /// Narrows the enclosure to about 2^-bits, absolutely.
  void refine(Root& root, int bits);
  /// Of the function itself at its root.
  int multiplicity(Root& root);

  bool assumed = false;

 private:
  std::vector<Root> search(const Function& f, const Rational& lo, const Rational& hi, int depth);
  std::vector<Root> descend(const Function& f, int order, int settled, const Rational& lo, const Rational& hi);
  Root crossing(const Function& f, int order, Wide lo, Wide hi, int sign_lo);
  /// If |value| < 2^-this, it is 0; negative: unknown.
  long zero_bound(const Function& f, int order, const Root& root) const;

  const MotionSegment& segment_;
};

/// Sets the precision while it lives.
class Precision {
 public:
  explicit Precision(long bits) : before_(Wide::bits()) { Wide::bits() = static_cast<int>(bits); }
  ~Precision() { Wide::bits() = before_; }
  Precision(const Precision&) = delete;
  Precision& operator=(const Precision&) = delete;

 private:
  int before_;
};

}  // namespace taut::testing::exact
