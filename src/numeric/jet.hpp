// Values with first and second derivatives in time, over balls.
#pragma once

#include "numeric/ball.hpp"
#include "numeric/trig.hpp"

namespace taut {

/// f, f' and f'' over a ball of times: if t is a ball, each member encloses the range over it.
template <class Real>
struct Jet {
  Ball<Real> v, d, dd;

  static Jet constant(const Ball<Real>& c) { return {c, Ball<Real>::exact(0), Ball<Real>::exact(0)}; }
  static Jet constant(double c) { return constant(Ball<Real>::exact(c)); }
};

template <class Real>
Jet<Real> operator-(const Jet<Real>& a) {
  return {-a.v, -a.d, -a.dd};
}
template <class Real>
Jet<Real> operator+(const Jet<Real>& a, const Jet<Real>& b) {
  return {a.v + b.v, a.d + b.d, a.dd + b.dd};
}
template <class Real>
Jet<Real> operator-(const Jet<Real>& a, const Jet<Real>& b) {
  return {a.v - b.v, a.d - b.d, a.dd - b.dd};
}
template <class Real>
Jet<Real> operator*(const Jet<Real>& a, const Jet<Real>& b) {
  return {a.v * b.v, a.d * b.v + a.v * b.d, a.dd * b.v + (a.d * b.d) * 2.0 + a.v * b.dd};
}
template <class Real>
Jet<Real> operator*(const Jet<Real>& a, const Ball<Real>& b) {
  return {a.v * b, a.d * b, a.dd * b};
}
template <class Real>
Jet<Real> operator/(const Jet<Real>& a, const Jet<Real>& b) {
  // q b = a, differentiated twice.
  const Ball<Real> q = a.v / b.v;
  const Ball<Real> qd = (a.d - q * b.d) / b.v;
  const Ball<Real> qdd = (a.dd - (qd * b.d) * 2.0 - q * b.dd) / b.v;
  return {q, qd, qdd};
}
template <class Real>
Jet<Real> sqrt(const Jet<Real>& a) {
  const Ball<Real> r = sqrt(a.v);
  const Ball<Real> rd = a.d / (r * 2.0);
  const Ball<Real> rdd = (a.dd - (rd * rd) * 2.0) / (r * 2.0);
  return {r, rd, rdd};
}

/// cos and sin of an angle that moves.
template <class Real>
void sin_cos(const Jet<Real>& a, Jet<Real>& sine, Jet<Real>& cosine) {
  const SinCos<Real> sc = sin_cos(a.v);
  const Ball<Real> square = a.d * a.d;
  sine = {sc.sin, sc.cos * a.d, sc.cos * a.dd - sc.sin * square};
  cosine = {sc.cos, -(sc.sin * a.d), -(sc.sin * a.dd) - sc.cos * square};
}

/// A polynomial with the given coefficients (ascending) at the ball t, by Horner's rule.
template <class Real, class Coefficients>
Jet<Real> polynomial(const Coefficients& c, const Ball<Real>& t) {
  using B = Ball<Real>;
  if (c.empty()) return Jet<Real>::constant(0.0);
  B v = B::exact(c[c.size() - 1]), d = B::exact(0), dd = B::exact(0);
  for (std::size_t i = c.size() - 1; i-- > 0;) {
    dd = dd * t + d;
    d = d * t + v;
    v = v * t + B::exact(c[i]);
  }
  return {v, d, dd * 2.0};
}

}  // namespace taut
