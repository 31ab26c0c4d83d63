// Functions of time as sums that show what is identically zero: polynomial * root * exp(i angle).
//
// The roots are g_0 and g_1 (g_k^2 a polynomial, the radicand), the angles polynomials. Exponentials of different
// angles are independent over the algebraic functions; at a rational instant, by Lindemann's theorem, over the
// algebraic numbers. So a sum is zero if all its terms are; but for roots of radicands that are squares, or in a
// square's ratio, which is seen at an instant and not for functions.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "support/exact_polynomial.hpp"

namespace taut::testing::exact {

using Radicands = std::array<Poly, 2>;

class Formal {
 public:
  Formal() = default;
  explicit Formal(const Complex& c) { add({}, c); }
  static Formal term(bool root, int which, const Poly& angle, const Complex& c);

  bool zero() const { return terms_.empty(); }
  friend Formal operator+(Formal a, const Formal& b);
  friend Formal operator-(Formal a, const Formal& b);
  friend Formal operator*(const Complex& x, const Formal& a);
  friend Formal conj(const Formal& a);
  static Formal product(const Formal& a, const Formal& b, const Radicands& radicands);
  /// At a rational instant, exactly zero if it is zero.
  Formal at(const Rational& t, const Radicands& radicands) const;
  /// If it is a polynomial, that polynomial.
  const Complex* as_polynomial() const;
  /// A polynomial that vanishes wherever its real, or imaginary, part does: the product over all signs of the roots.
  /// Nothing if there are angles, or the product is zero at all times.
  std::optional<Poly> norm(bool imaginary, const Radicands& radicands) const;

 private:
  struct Key {
    std::array<bool, 2> roots{};
    Poly angle;
    bool operator<(const Key& o) const { return roots != o.roots ? roots < o.roots : angle < o.angle; }
  };
  void add(const Key& key, const Complex& c);

  std::map<Key, Complex> terms_;
};

}  // namespace taut::testing::exact
