#include "motion/local_time.hpp"

#include <algorithm>

#include "numeric/trig.hpp"

namespace taut::internal {
namespace {

/// Angles below this are left as they are.
constexpr double most_left_alone = 8;

/// One rounding of the type; from RealMax, in which one of 2^-959 has gone before.
template <class Real>
Ball<Real> narrowed(const Ball<RealMax>& x) {
  if constexpr (std::is_same_v<Real, RealMax>) {
    return x;
  } else {
    const Real mid = static_cast<Real>(x.mid);
    return Ball<Real>(mid, detail::inflate(x.rad + 2 * detail::rounding(mid)));
  }
}

}  // namespace

LocalPolynomials::Known::Known(DyadicPolynomial exact) : exact_(std::move(exact)) {
  for (const Dyadic& c : exact_) near_.p.push_back(narrowed<double>(ball_of<RealMax>(c)));
}

template <class Real>
BallCoefficients<Real> LocalPolynomials::Known::rounded() const {
  if constexpr (std::is_same_v<Real, double>) {
    return near_;
  } else {
    if (wide_.empty()) {
      for (const Dyadic& c : exact_) wide_.push_back(ball_of<RealMax>(c));
    }
    BallCoefficients<Real> c;
    for (const Ball<RealMax>& x : wide_) c.p.push_back(narrowed<Real>(x));
    return c;
  }
}

LocalPolynomials::Known LocalPolynomials::Known::angle(DyadicPolynomial exact) {
  Known known(std::move(exact));
  known.take_off_turns();
  return known;
}

/// Where the angle itself is large, doubles hold little of it without its whole rotations.
void LocalPolynomials::Known::take_off_turns() {
  if (near_.empty() || !(near_[0].magnitude() > most_left_alone && near_[0].magnitude() < 0x1p300)) return;
  const Ball<RealMax> angle = ball_of<RealMax>(exact_[0]);
  const RealMax turn = 2 * pi<RealMax>();
  const Ball<RealMax> turns(round(angle.mid / turn), 0.0);
  near_.p[0] = narrowed<double>(angle - turns * Ball<RealMax>(turn, 8 * unit_roundoff<RealMax>()));
}

DyadicPolynomial LocalPolynomials::exact(const Coefficients& given, double origin) const {
  DyadicPolynomial c;
  for (const double x : given) c.push_back(Dyadic::exact(x));
  c = expanded_about(std::move(c), Dyadic::exact(about_) - Dyadic::exact(origin));
  trim(c);
  return c;
}

const LocalPolynomials::Known& LocalPolynomials::find(const Coefficients& given, double origin, bool angle) const {
  const auto same = [&](const Entry& e) { return e.angle == angle && e.origin == origin && e.given == given; };
  const auto found = std::find_if(entries_.begin(), entries_.end(), same);
  if (found != entries_.end()) return found->known;
  DyadicPolynomial made = exact(given, origin);
  Known known = angle ? Known::angle(std::move(made)) : Known(std::move(made));
  return entries_.emplace_front(Entry{given, origin, angle, std::move(known)}).known;
}

template <class Real>
BallCoefficients<Real> LocalPolynomials::of(const Coefficients& given, double origin, bool angle) const {
  return find(given, origin, angle).template rounded<Real>();
}
#define TAUT_INSTANTIATE(Real)                                                    \
  template BallCoefficients<Real> LocalPolynomials::Known::rounded<Real>() const; \
  template BallCoefficients<Real> LocalPolynomials::of<Real>(const Coefficients&, double, bool) const;
TAUT_INSTANTIATE(double)
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE

}  // namespace taut::internal
