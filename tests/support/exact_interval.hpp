// Intervals that certainly contain the number meant: of doubles, for filters, and of MPFR's numbers, whose rounding is
// directed in software, for everything else. They share nothing with the balls of the library.
#pragma once

#include <gmpxx.h>
#include <mpfr.h>
#include <functional>

#include <algorithm>
#include <cmath>
#include <utility>

namespace taut::testing::exact {

using Rational = mpq_class;

/// Between two doubles. Every operation rounds to nearest and then moves the ends outwards by a unit in the last place,
/// which is more than that rounding; NaN makes every question's answer no.
class Narrow {
 public:
  Narrow(double x = 0) : lo_(x), hi_(x) {}
  Narrow(double lo, double hi) : lo_(lo), hi_(hi) {}
  static Narrow of(const Rational& q) {
    const double d = q.get_d();  // rounds towards zero
    return d == q ? Narrow(d) : Narrow(down(d), up(d));
  }

  double lo() const { return lo_; }
  double hi() const { return hi_; }
  bool positive() const { return lo_ > 0; }
  bool negative() const { return hi_ < 0; }

  friend Narrow operator+(const Narrow& a, const Narrow& b) { return {down(a.lo_ + b.lo_), up(a.hi_ + b.hi_)}; }
  friend Narrow operator-(const Narrow& a, const Narrow& b) { return {down(a.lo_ - b.hi_), up(a.hi_ - b.lo_)}; }
  friend Narrow operator*(const Narrow& a, const Narrow& b) {
    const double p = a.lo_ * b.lo_, q = a.lo_ * b.hi_, r = a.hi_ * b.lo_, s = a.hi_ * b.hi_;
    if (std::isnan(p + q + r + s)) return {-INFINITY, INFINITY};
    return {down(std::min({p, q, r, s})), up(std::max({p, q, r, s}))};
  }
  friend Narrow operator/(const Narrow& a, const Narrow& b) {
    if (!(b.lo_ > 0) && !(b.hi_ < 0)) return {-INFINITY, INFINITY};
    return a * Narrow(down(1 / b.hi_), up(1 / b.lo_));
  }
  friend Narrow sqrt(const Narrow& a) {
    return {down(std::sqrt(std::max(0.0, a.lo_))), up(std::sqrt(std::max(0.0, a.hi_)))};
  }
  /// The C library is off by less than four units in the last place of 1.
  friend void sin_cos(const Narrow& a, Narrow& s, Narrow& c) {
    const double middle = (a.lo_ + a.hi_) / 2, r = up(std::max(a.hi_ - middle, middle - a.lo_)) + 0x1p-50;
    s = {down(std::sin(middle) - r), up(std::sin(middle) + r)};
    c = {down(std::cos(middle) - r), up(std::cos(middle) + r)};
  }

 private:
  static double down(double x) { return x - (std::fabs(x) * 0x1p-52 + 0x1p-1060); }
  static double up(double x) { return x + (std::fabs(x) * 0x1p-52 + 0x1p-1060); }

  double lo_, hi_;
};

/// Between two numbers of as many bits as the scope asks for.
class Wide {
 public:
  /// Precision of new numbers, of this thread.
  static int& bits() {
    thread_local int value = 192;
    return value;
  }

  Wide(double x = 0) : Wide(Uninitialised{}) {
    mpfr_set_d(lo_, x, MPFR_RNDD);
    mpfr_set_d(hi_, x, MPFR_RNDU);
  }
  Wide(const Wide& o) : Wide(Uninitialised{}) {
    mpfr_set(lo_, o.lo_, MPFR_RNDD);
    mpfr_set(hi_, o.hi_, MPFR_RNDU);
  }
  Wide(Wide&& o) noexcept {
    *lo_ = *o.lo_;
    *hi_ = *o.hi_;
    o.lo_->_mpfr_d = nullptr;
  }
  Wide& operator=(Wide o) noexcept {
    std::swap(*lo_, *o.lo_);
    std::swap(*hi_, *o.hi_);
    return *this;
  }
  ~Wide() {
    if (!lo_->_mpfr_d) return;
    mpfr_clear(lo_);
    mpfr_clear(hi_);
  }
  static Wide of(const Rational& q) {
    Wide r{Uninitialised{}};
    mpfr_set_q(r.lo_, q.get_mpq_t(), MPFR_RNDD);
    mpfr_set_q(r.hi_, q.get_mpq_t(), MPFR_RNDU);
    return r;
  }
  /// All numbers: what is known after a division by zero.
  static Wide whole() {
    Wide r{Uninitialised{}};
    mpfr_set_inf(r.lo_, -1);
    mpfr_set_inf(r.hi_, 1);
    return r;
  }
  static Wide hull(const Wide& a, const Wide& b) {
    Wide r{Uninitialised{}};
    mpfr_min(r.lo_, a.lo_, b.lo_, MPFR_RNDD);
    mpfr_max(r.hi_, a.hi_, b.hi_, MPFR_RNDU);
    return r;
  }

  bool positive() const { return mpfr_sgn(lo_) > 0; }
  bool negative() const { return mpfr_sgn(hi_) < 0; }
  bool is_finite() const { return mpfr_number_p(lo_) && mpfr_number_p(hi_); }
  /// 1 or -1 if that is certain, else 0.
  int sign() const { return positive() ? 1 : negative() ? -1 : 0; }
  bool before(const Wide& b) const { return mpfr_less_p(hi_, b.lo_) != 0; }
  bool within(const Wide& b) const { return mpfr_greaterequal_p(lo_, b.lo_) && mpfr_lessequal_p(hi_, b.hi_); }
  bool same(const Wide& b) const { return mpfr_equal_p(lo_, b.lo_) && mpfr_equal_p(hi_, b.hi_); }
  /// Of those that are the same, the same.
  std::size_t hash() const {
    const std::hash<double> of_double;
    return of_double(mpfr_get_d(lo_, MPFR_RNDD)) * 31 + of_double(mpfr_get_d(hi_, MPFR_RNDU));
  }
  /// Of what both contain; they must meet.
  static Wide meet(const Wide& a, const Wide& b) {
    Wide r{Uninitialised{}};
    mpfr_max(r.lo_, a.lo_, b.lo_, MPFR_RNDD);
    mpfr_min(r.hi_, a.hi_, b.hi_, MPFR_RNDU);
    return r;
  }

  double lo() const { return mpfr_get_d(lo_, MPFR_RNDD); }
  double hi() const { return mpfr_get_d(hi_, MPFR_RNDU); }
  Rational exact_lo() const { return exact(lo_); }
  Rational exact_hi() const { return exact(hi_); }
  /// The ends as intervals of no width.
  Wide at_lo() const { return end(lo_); }
  Wide at_hi() const { return end(hi_); }
  /// About in the middle, as an interval of no width.
  Wide middle() const {
    Wide r{Uninitialised{}};
    mpfr_add(r.lo_, lo_, hi_, MPFR_RNDN);
    mpfr_div_2ui(r.lo_, r.lo_, 1, MPFR_RNDN);
    mpfr_set(r.hi_, r.lo_, MPFR_RNDN);
    return r;
  }
  /// log2 of the width and of the largest magnitude, roughly, from above; very negative for zero.
  long log_width() const {
    Wide r{Uninitialised{}};
    mpfr_sub(r.hi_, hi_, lo_, MPFR_RNDU);
    return log_of(r.hi_);
  }
  long log_size() const { return std::max(log_of(lo_), log_of(hi_)); }

  friend Wide operator-(const Wide& a) { return Wide(0.0) - a; }
  friend Wide operator+(const Wide& a, const Wide& b) {
    Wide r{Uninitialised{}};
    mpfr_add(r.lo_, a.lo_, b.lo_, MPFR_RNDD);
    mpfr_add(r.hi_, a.hi_, b.hi_, MPFR_RNDU);
    return r;
  }
  friend Wide operator-(const Wide& a, const Wide& b) {
    Wide r{Uninitialised{}};
    mpfr_sub(r.lo_, a.lo_, b.hi_, MPFR_RNDD);
    mpfr_sub(r.hi_, a.hi_, b.lo_, MPFR_RNDU);
    return r;
  }
  friend Wide operator*(const Wide& a, const Wide& b);
  friend Wide operator/(const Wide& a, const Wide& b);
  friend Wide sqrt(const Wide& a);
  friend void sin_cos(const Wide& a, Wide& s, Wide& c);

 private:
  struct Uninitialised {};
  explicit Wide(Uninitialised) {
    mpfr_init2(lo_, bits());
    mpfr_init2(hi_, bits());
  }
  static Rational exact(mpfr_srcptr x) {
    Rational q;
    mpfr_get_q(q.get_mpq_t(), x);
    return q;
  }
  static Wide end(mpfr_srcptr x) {
    Wide r{Uninitialised{}};
    mpfr_set_prec(r.lo_, std::max<mpfr_prec_t>(bits(), mpfr_get_prec(x)));
    mpfr_set_prec(r.hi_, std::max<mpfr_prec_t>(bits(), mpfr_get_prec(x)));
    mpfr_set(r.lo_, x, MPFR_RNDN);
    mpfr_set(r.hi_, x, MPFR_RNDN);
    return r;
  }
  static long log_of(mpfr_srcptr x) {
    if (mpfr_zero_p(x)) return -1000000000;
    return mpfr_number_p(x) ? mpfr_get_exp(x) : 1000000000;
  }

  mpfr_t lo_, hi_;
};

}  // namespace taut::testing::exact
