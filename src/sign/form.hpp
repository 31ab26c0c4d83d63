// The orientation of three vertices of both bodies, as coefficients of a leg's frame functions: derived here and only
// here.
#pragma once

#include <array>

#include "sign/mixed_triple.hpp"

namespace taut {

/// What the coefficients are made of, in the coordinates of the leg: the edge from a to b, and the points a and c,
/// where a and b belong to one body and c to the other. N is any kind of number.
template <class N>
struct FormPoints {
  N ex, ey, ax, ay, cx, cy;

  /// For the projection on the edge instead of the orientation: the edge turned by -90 degrees takes its place.
  void measure(Measure what) {
    if (what == Measure::orientation) return;
    const N turn = ex;
    ex = ey;
    ey = -turn;
  }
};

/// In the frame of a's body, c is at D + (c + i s) (cx + i cy), so that the orientation e x (c - a) is this combination
/// of 1, D and (c, s): see Frame in leg.hpp. In Q's frame everything that comes from D and from the angle changes sign.
/// Linear in the edge, and in the two points together.
template <class N>
std::array<N, 5> form_coefficients(bool pp, const FormPoints<N>& p) {
  const N turned = p.ex * p.cx + p.ey * p.cy;
  return {p.ey * p.ax - p.ex * p.ay, pp ? -p.ey : p.ey, pp ? p.ex : -p.ex, p.ex * p.cy - p.ey * p.cx,
          pp ? turned : -turned};
}

}  // namespace taut
