// Points on curves, as the verifier knows them: to the last bit, or with a bound of their error; and signs that are
// certain, zero included.
#pragma once

#include <array>
#include <optional>

#include "numeric/ball.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::proof {

using CurveReal = WideFloat<192>;
using CurveNumber = Ball<CurveReal>;

/// A sign, 0 included; nothing if it is not certain.
using CertainSign = std::optional<int>;

inline bool is_exact(const CurveNumber& x) { return x.rad == 0 && x.mid.is_defined(); }
inline bool is_zero(const CurveNumber& x) { return is_exact(x) && x.mid.is_zero(); }

/// The sum; exact if both are, and 192 bits hold it.
CurveNumber sum_of(const CurveNumber& a, const CurveNumber& b);
/// The sign of a - b.
CertainSign order_of(const CurveNumber& a, const CurveNumber& b);

struct CurvePoint {
  CurveNumber x, y;

  static CurvePoint of(const Point& p) { return {CurveNumber::exact(p.x), CurveNumber::exact(p.y)}; }
  Point rounded() const { return {x.mid.to_double(), y.mid.to_double()}; }
};

CurvePoint middle_of(const CurvePoint& a, const CurvePoint& b);

/// The sign of (b - a) x (c - a): is c to the left (1) or to the right (-1) of the line from a to b, or on it (0)?
CertainSign side_of(const CurvePoint& a, const CurvePoint& b, const CurvePoint& c);

}  // namespace taut::internal::proof
