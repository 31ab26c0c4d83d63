// Functions of time as exact expressions: a number type for the derivation of a segment's frame functions.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "numeric/dyadic.hpp"

namespace taut::internal {

/// The data shared by the expressions of one segment: the square roots, angles and denominators that have occurred.
///
/// An expression is a sum of polynomials, each times a product of square roots of polynomials and the sine or cosine of
/// one polynomial, divided by a product of polynomials. All coefficients are rational. If two expressions are equal as
/// functions, their sums have the same terms, as far as the recognized relations show it: roots of squares, roots of
/// polynomials whose product is a square, angles that differ in sign. So an expression without terms is certainly zero
/// everywhere. Hardly any other expression is zero: exponentials of different polynomials are linearly independent over
/// algebraic functions (Lindemann and Weierstrass, for the constants), and so are roots of polynomials no product of
/// which is a square.
class SymbolicSegment {
 public:
  SymbolicSegment(double start, double end) : start_(start), end_(end) {}

  struct Root {
    DyadicPolynomial square;
    bool clamped;  ///< replaced by zero where the square is negative
  };
  const Root& root(int i) const { return roots_[static_cast<std::size_t>(i)]; }
  const DyadicPolynomial& angle(int i) const { return angles_[static_cast<std::size_t>(i)]; }
  const DyadicPolynomial& factor(std::size_t i) const { return factors_[i]; }

  static constexpr std::size_t most_factors = 8;

  int roots() const { return static_cast<int>(roots_.size()); }
  /// The numbers of a root, an angle, a factor, which is added if it is new. The result is most_factors if there are
  /// too many factors.
  int root_of(const DyadicPolynomial& square, bool clamped);
  int angle_of(const DyadicPolynomial& angle);
  std::size_t factor_of(const DyadicPolynomial& factor);
  /// The sign that the polynomial certainly has over the whole segment, except for the ends, where it may be zero; 0 if
  /// that is not easily shown.
  int sign_over(const DyadicPolynomial& p) const;

 private:
  /// The sign over the whole segment including the ends.
  int sign_with_ends(const DyadicPolynomial& p) const;

  double start_, end_;
  std::vector<Root> roots_;
  std::vector<DyadicPolynomial> angles_{{}};  ///< number 0 means no angle
  std::vector<DyadicPolynomial> factors_;
};

/// Represents the time in SymbolicSegment.
struct SymbolicTime {
  SymbolicSegment* segment;
  double origin = 0;  ///< polynomials are given in powers of t - origin
};

class Symbolic {
 public:
  /// The factor of a polynomial.
  struct Key {
    int angle = 0;  ///< the number of the angle of the sine or cosine; 0: none
    bool sine = false;
    std::uint8_t roots = 0;  ///< a bit for each root
    friend bool operator==(const Key& a, const Key& b) {
      return a.angle == b.angle && a.sine == b.sine && a.roots == b.roots;
    }
  };
  struct Term {
    Key key;
    DyadicPolynomial polynomial;
  };
  using Exponents = std::array<std::uint8_t, SymbolicSegment::most_factors>;

  static Symbolic constant(double c);
  template <class Coefficients>
  static Symbolic polynomial(const Coefficients& c, const SymbolicTime& t) {
    Symbolic s;
    s.segment_ = t.segment;
    DyadicPolynomial p;
    for (std::size_t k = 0; k < c.size(); ++k) p.push_back(Dyadic::exact(c[k]));
    s.add({}, t.origin == 0 ? std::move(p) : expanded_about(std::move(p), -Dyadic::exact(t.origin)));
    return s;
  }

  /// False if the expression contains an unsupported operation. Then nothing is known about it.
  bool known() const { return known_; }
  const std::vector<Term>& terms() const { return terms_; }
  const Exponents& denominator() const { return denominator_; }
  /// The same expression with a larger denominator.
  Symbolic over(const Exponents& denominator, const SymbolicSegment& segment) const;

  friend Symbolic operator-(const Symbolic& a);
  friend Symbolic operator+(const Symbolic& a, const Symbolic& b);
  friend Symbolic operator-(const Symbolic& a, const Symbolic& b) { return a + -b; }
  friend Symbolic operator*(const Symbolic& a, const Symbolic& b);
  /// The divisor must be a polynomial, or a root.
  friend Symbolic operator/(const Symbolic& a, const Symbolic& b);
  /// The root of a polynomial, or zero where the polynomial is negative.
  friend Symbolic sqrt(const Symbolic& a);
  /// The argument must be a polynomial.
  friend void sin_cos(const Symbolic& a, Symbolic& sine, Symbolic& cosine);

 private:
  static Symbolic unknown(SymbolicSegment* segment);
  static Symbolic of(SymbolicSegment* segment, const Key& key, DyadicPolynomial p);
  void add(const Key& key, DyadicPolynomial p);
  void add_product(const Term& a, const Term& b);
  /// The expression as a polynomial, if it is one, else null.
  const DyadicPolynomial* as_polynomial() const;

  SymbolicSegment* segment_ = nullptr;
  bool known_ = true;
  std::vector<Term> terms_;
  Exponents denominator_{};
};

}  // namespace taut::internal
