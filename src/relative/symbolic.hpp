// Functions of time as exact expressions: a number type for the derivation of a segment's frame functions.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "numeric/dyadic.hpp"

namespace taut::internal {

/// What the expressions of one segment share: the square roots, angles and denominators that have come up.
///
/// An expression is a sum of polynomials, each times a product of square roots of polynomials and the sine or cosine of
/// one polynomial, divided by a product of polynomials. All coefficients are rational. Where two expressions are equal
/// as functions their sums have the same terms, as far as the relations that are looked for tell: roots of squares,
/// roots whose product is one, angles that differ in sign. So an expression without terms is certainly zero everywhere,
/// and hardly ever is another one zero: exponentials of different polynomials are linearly independent over algebraic
/// functions (Lindemann and Weierstrass, for the constants), and so are roots of polynomials no product of which is a
/// square.
class SymbolicSegment {
 public:
  SymbolicSegment(double start, double end) : start_(start), end_(end) {}

  struct Root {
    DyadicPolynomial square;
    bool clamped;  ///< taken for zero where the square is negative
  };
  const Root& root(int i) const { return roots_[static_cast<std::size_t>(i)]; }
  const DyadicPolynomial& angle(int i) const { return angles_[static_cast<std::size_t>(i)]; }
  const DyadicPolynomial& factor(std::size_t i) const { return factors_[i]; }

  static constexpr std::size_t most_factors = 8;

  int roots() const { return static_cast<int>(roots_.size()); }
  /// The numbers of a root, an angle, a factor, which may be new. Too many factors get most_factors.
  int root_of(const DyadicPolynomial& square, bool clamped);
  int angle_of(const DyadicPolynomial& angle);
  std::size_t factor_of(const DyadicPolynomial& factor);
  /// The sign that the polynomial certainly has all over the segment, but for the ends, where it may be zero; 0 if that
  /// is not shown easily.
  int sign_over(const DyadicPolynomial& p) const;

 private:
  /// The same with the ends.
  int sign_with_ends(const DyadicPolynomial& p) const;

  double start_, end_;
  std::vector<Root> roots_;
  std::vector<DyadicPolynomial> angles_{{}};  ///< number 0 is none
  std::vector<DyadicPolynomial> factors_;
};

/// Stands for the time in SymbolicSegment.
struct SymbolicTime {
  SymbolicSegment* segment;
};

class Symbolic {
 public:
  /// What a polynomial is multiplied with.
  struct Key {
    int angle = 0;  ///< of which the sine or cosine is taken; 0: none
    bool sine = false;
    std::uint8_t roots = 0;  ///< a bit for each
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
    s.add({}, std::move(p));
    return s;
  }

  /// Is there an operation in it that expressions do not have? Then nothing is known of it.
  bool known() const { return known_; }
  const std::vector<Term>& terms() const { return terms_; }
  const Exponents& denominator() const { return denominator_; }
  /// The same with a larger denominator.
  Symbolic over(const Exponents& denominator, const SymbolicSegment& segment) const;

  friend Symbolic operator-(const Symbolic& a);
  friend Symbolic operator+(const Symbolic& a, const Symbolic& b);
  friend Symbolic operator-(const Symbolic& a, const Symbolic& b) { return a + -b; }
  friend Symbolic operator*(const Symbolic& a, const Symbolic& b);
  /// By a polynomial, or a root.
  friend Symbolic operator/(const Symbolic& a, const Symbolic& b);
  /// Of a polynomial. It is taken for zero where the polynomial is negative.
  friend Symbolic sqrt(const Symbolic& a);
  /// Of a polynomial.
  friend void sin_cos(const Symbolic& a, Symbolic& sine, Symbolic& cosine);

 private:
  static Symbolic unknown(SymbolicSegment* segment);
  static Symbolic of(SymbolicSegment* segment, const Key& key, DyadicPolynomial p);
  void add(const Key& key, DyadicPolynomial p);
  void add_product(const Term& a, const Term& b);
  /// The polynomial that it is, if it is one.
  const DyadicPolynomial* as_polynomial() const;

  SymbolicSegment* segment_ = nullptr;
  bool known_ = true;
  std::vector<Term> terms_;
  Exponents denominator_{};
};

}  // namespace taut::internal
