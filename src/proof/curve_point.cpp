#include "proof/curve_point.hpp"

#include "numeric/dyadic.hpp"

namespace taut::internal::proof {
namespace {

CurveNumber half_of(const CurveNumber& x) {
  return CurveNumber(ldexp(x.mid, -1), x.rad == 0 ? 0 : detail::inflate(x.rad / 2));
}

CertainSign certain(int sign) { return sign == 0 ? CertainSign() : CertainSign(sign); }

Dyadic dyadic_of(const CurveNumber& x) {
  if (x.mid.is_zero()) return {};
  return Dyadic::of_limbs(x.mid.mantissa(), x.mid.is_negative(),
                          static_cast<int>(x.mid.exponent()) - RealTraits<CurveReal>::bits + 1);
}

bool is_point(const CurvePoint& p) { return is_exact(p.x) && is_exact(p.y); }
bool same(const CurvePoint& a, const CurvePoint& b) {
  return is_point(a) && is_point(b) && a.x.mid == b.x.mid && a.y.mid == b.y.mid;
}
bool same(const CurveNumber& a, const CurveNumber& b) { return is_exact(a) && is_exact(b) && a.mid == b.mid; }

CertainSign product(CertainSign a, CertainSign b) {
  if ((a && *a == 0) || (b && *b == 0)) return 0;
  return a && b ? CertainSign(*a * *b) : CertainSign();
}

}  // namespace

CurveNumber sum_of(const CurveNumber& a, const CurveNumber& b) {
  CurveNumber sum = a + b;
  if (!is_exact(a) || !is_exact(b)) return sum;
  // What rounding to nearest has lost, exactly (Knuth).
  const CurveReal of_b = sum.mid - a.mid;
  const CurveReal lost = (a.mid - (sum.mid - of_b)) + (b.mid - of_b);
  if (lost.is_zero()) sum.rad = 0;
  return sum;
}

CertainSign order_of(const CurveNumber& a, const CurveNumber& b) {
  if (is_exact(a) && is_exact(b)) return a.mid == b.mid ? 0 : a.mid < b.mid ? -1 : 1;
  return certain((a - b).sign());
}

CurvePoint middle_of(const CurvePoint& a, const CurvePoint& b) {
  return {half_of(sum_of(a.x, b.x)), half_of(sum_of(a.y, b.y))};
}

CertainSign side_of(const CurvePoint& a, const CurvePoint& b, const CurvePoint& c) {
  if (same(a, b) || same(b, c) || same(a, c)) return 0;
  // Along an axis, one coordinate decides, and may do so exactly where the other one is not known so well.
  if (same(a.y, b.y)) return product(order_of(b.x, a.x), order_of(c.y, a.y));
  if (same(a.x, b.x)) return product(order_of(b.y, a.y), order_of(a.x, c.x));
  const int sign = ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)).sign();
  if (sign != 0) return sign;
  if (!is_point(a) || !is_point(b) || !is_point(c)) return std::nullopt;
  const Dyadic ax = dyadic_of(a.x), ay = dyadic_of(a.y);
  return ((dyadic_of(b.x) - ax) * (dyadic_of(c.y) - ay) - (dyadic_of(b.y) - ay) * (dyadic_of(c.x) - ax)).sign();
}

}  // namespace taut::internal::proof
