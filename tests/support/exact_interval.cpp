#include "support/exact_interval.hpp"

namespace taut::testing::exact {

Wide operator*(const Wide& a, const Wide& b) {
  if (!a.is_finite() || !b.is_finite()) return Wide::whole();
  Wide r{Wide::Uninitialised{}};
  const int sa = mpfr_sgn(a.lo_) >= 0 ? 1 : mpfr_sgn(a.hi_) <= 0 ? -1 : 0;
  const int sb = mpfr_sgn(b.lo_) >= 0 ? 1 : mpfr_sgn(b.hi_) <= 0 ? -1 : 0;
  if (sa == 0 && sb == 0) {
    Wide other{Wide::Uninitialised{}};
    mpfr_mul(r.lo_, a.lo_, b.hi_, MPFR_RNDD);
    mpfr_mul(other.lo_, a.hi_, b.lo_, MPFR_RNDD);
    mpfr_min(r.lo_, r.lo_, other.lo_, MPFR_RNDD);
    mpfr_mul(r.hi_, a.lo_, b.lo_, MPFR_RNDU);
    mpfr_mul(other.hi_, a.hi_, b.hi_, MPFR_RNDU);
    mpfr_max(r.hi_, r.hi_, other.hi_, MPFR_RNDU);
    return r;
  }
  // The ends that give the least and the largest product.
  const bool low_a = sb > 0 || (sb == 0 && sa < 0), low_b = sa > 0 || (sa == 0 && sb < 0);
  if (sa == 0) {
    mpfr_mul(r.lo_, sb > 0 ? a.lo_ : a.hi_, sb > 0 ? b.hi_ : b.lo_, MPFR_RNDD);
    mpfr_mul(r.hi_, sb > 0 ? a.hi_ : a.lo_, sb > 0 ? b.hi_ : b.lo_, MPFR_RNDU);
  } else if (sb == 0) {
    mpfr_mul(r.lo_, sa > 0 ? a.hi_ : a.lo_, sa > 0 ? b.lo_ : b.hi_, MPFR_RNDD);
    mpfr_mul(r.hi_, sa > 0 ? a.hi_ : a.lo_, sa > 0 ? b.hi_ : b.lo_, MPFR_RNDU);
  } else {
    mpfr_mul(r.lo_, low_a ? a.lo_ : a.hi_, low_b ? b.lo_ : b.hi_, MPFR_RNDD);
    mpfr_mul(r.hi_, low_a ? a.hi_ : a.lo_, low_b ? b.hi_ : b.lo_, MPFR_RNDU);
  }
  return r;
}

Wide operator/(const Wide& a, const Wide& b) {
  if (b.sign() == 0 || !b.is_finite()) return Wide::whole();
  Wide r{Wide::Uninitialised{}};
  mpfr_ui_div(r.lo_, 1, b.hi_, MPFR_RNDD);
  mpfr_ui_div(r.hi_, 1, b.lo_, MPFR_RNDU);
  return a * r;
}

Wide sqrt(const Wide& a) {
  Wide r{Wide::Uninitialised{}};
  if (mpfr_sgn(a.lo_) > 0) {
    mpfr_sqrt(r.lo_, a.lo_, MPFR_RNDD);
  } else {
    mpfr_set_zero(r.lo_, 1);
  }
  if (mpfr_sgn(a.hi_) > 0) {
    mpfr_sqrt(r.hi_, a.hi_, MPFR_RNDU);
  } else {
    mpfr_set_zero(r.hi_, 1);
  }
  return r;
}

void sin_cos(const Wide& a, Wide& s, Wide& c) {
  if (!a.is_finite()) {
    s = c = Wide::whole();
    return;
  }
  const Wide middle = a.middle();
  Wide radius = Wide::hull(a - middle, middle - a);
  Wide sine{Wide::Uninitialised{}}, cosine{Wide::Uninitialised{}};
  mpfr_sin(sine.lo_, middle.lo_, MPFR_RNDD);
  mpfr_sin(sine.hi_, middle.lo_, MPFR_RNDU);
  mpfr_cos(cosine.lo_, middle.lo_, MPFR_RNDD);
  mpfr_cos(cosine.hi_, middle.lo_, MPFR_RNDU);
  s = sine + radius;
  c = cosine + radius;
}

}  // namespace taut::testing::exact
