#include "sign/vanishing.hpp"

#include "relative/frame_identities.hpp"
#include "sign/form.hpp"

namespace taut {
namespace {

/// A vertex as the leg sees it, before its displacement.
template <class N>
void seen(const Leg& leg, const DisplacedPoint& v, bool of_p, N& x, N& y) {
  x = N::exact(v.x);
  y = N::exact(v.y);
  add_offset(leg, of_p, x, y);
}

template <class N>
std::array<N, 5> coefficients(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, Measure measure) {
  const DisplacedPoint &a = g.point(triple.a), &b = g.point(triple.b), &c = g.point(triple.c);
  FormPoints<N> p;
  p.ex = N::exact(b.x) - N::exact(a.x);
  p.ey = N::exact(b.y) - N::exact(a.y);
  p.measure(measure);
  seen(leg, a, triple.pp, p.ax, p.ay);
  seen(leg, c, !triple.pp, p.cx, p.cy);
  return form_coefficients(triple.pp, p);
}

}  // namespace

bool vanishes_before_displacement(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, Measure measure) {
  const FrameIdentities& identities = leg.identities();
  return !identities.differs_from_zero(triple.pp, coefficients<Ball<double>>(leg, g, triple, measure)) &&
         identities.vanishes(triple.pp, coefficients<Dyadic>(leg, g, triple, measure));
}

Portion portion_of(const Leg& leg, const PairGeometry& g, const MixedTriple& triple, Measure measure) {
  if (leg.translation || leg.bridge) return Portion::whole;
  return vanishes_before_displacement(leg, g, triple, measure) ? Portion::displacement : Portion::whole;
}

}  // namespace taut
