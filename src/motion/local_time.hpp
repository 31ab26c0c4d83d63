// Motions far from time 0: their polynomials about an instant nearby.
//
// Coefficients are in powers of the time since a piece's origin, which may be far away. Of 5 - t + 0.3 t^2 moved to t
// = 1.7e9 the terms are 8.7e17, and their sum is 5: in doubles nothing of it is left, and over an interval of length r
// the terms vary by 1e9 r each. About an instant T of the segment, p(T + h) = sum c_k h^k has coefficients as small as
// the motion itself. The c_k are sums of products of doubles, hence dyadic numbers, and are computed as these, without
// any rounding: the meaning of a scene is what its coefficients say. What is computed with is each c_k rounded once, to
// the precision of whoever asks. The times of a segment that is far from 0 are within a factor of two of T, so that h =
// t - T is exact for doubles.
#pragma once

#include <forward_list>
#include <optional>
#include <vector>

#include "numeric/dyadic.hpp"
#include "numeric/jet.hpp"
#include "taut/motion.hpp"

namespace taut::internal {

/// Coefficients that are balls, without memory of their own to allocate.
template <class Real>
struct BallCoefficients {
  BallPolynomial<Real> p;
  std::size_t size() const { return p.size; }
  bool empty() const { return p.size == 0; }
  const Ball<Real>& operator[](std::size_t k) const { return p[k]; }
};

/// Polynomials about one instant, each made when it is first asked for; not for several threads at once.
class LocalPolynomials {
 public:
  explicit LocalPolynomials(double about) : about_(about) {}
  double about() const { return about_; }
  /// By its coefficients in powers of the time since `origin`. As the angle of a turn it may be less by whole turns.
  template <class Real>
  BallCoefficients<Real> of(const Coefficients& given, double origin, bool angle = false) const;
  /// Drops them all.
  void forget() const { entries_.clear(); }
  /// The same polynomial, exactly; the last coefficient is not zero.
  DyadicPolynomial exact(const Coefficients& given, double origin) const;
  /// In powers of the time since the instant, not looked for again: the caller keeps the place.
  class Known {
   public:
    explicit Known(DyadicPolynomial exact);
    /// As an angle it may be less by whole turns.
    static Known angle(DyadicPolynomial exact);
    template <class Real>
    BallCoefficients<Real> rounded() const;
    const DyadicPolynomial& exact() const { return exact_; }
    /// One coefficient, as a ball or an ExactNumber.
    template <class N>
    N coefficient(std::size_t k) const {
      if (!(k < exact_.size())) return N::exact(0);
      if constexpr (requires(N n) { n.mid; }) {
        return rounded<decltype(N::mid)>()[k];
      } else {
        return N::of(exact_[k]);
      }
    }

   private:
    void take_off_turns();
    DyadicPolynomial exact_;
    BallCoefficients<double> near_;
    mutable std::vector<Ball<RealMax>> wide_;  ///< none before a precision beyond doubles was asked for
  };

 private:
  struct Entry {
    Coefficients given;
    double origin;
    bool angle;
    Known known;
  };
  const Known& find(const Coefficients& given, double origin, bool angle) const;

  double about_;
  mutable std::forward_list<Entry> entries_;
};

/// How many times its length an interval has to be from time 0: a segment, for which polynomials are made once; and a
/// window, for each of which they are.
inline constexpr double far_segment = 32, far_window = 4096;
/// Is [start, end] so far from 0 that terms in powers of the time cancel for no other reason? Then all its instants are
/// within a factor of two of each other. An instant has no length; of those, late ones are far.
inline bool is_far(double start, double end, double lengths = far_segment) {
  const double length = end > start ? end - start : 1;
  return std::fabs(start) >= lengths * length && std::fabs(start) <= 0x1p200;
}

/// A time; of a motion far from time 0 with its polynomials about an instant nearby. Both are one type, so that what is
/// a function of time is compiled once for the two.
template <class Real>
struct LocalTime {
  const LocalPolynomials* polynomials = nullptr;  ///< null where polynomials are used as they are given
  Ball<Real> t, since;                            ///< since their origin, and since the instant of `polynomials`
  double origin = 0;

  explicit LocalTime(const Ball<Real>& time) : t(time), since(time) {}
  LocalTime(const LocalPolynomials& local, const Ball<Real>& time)
      : polynomials(&local), t(time), since(time_since(time, local.about())) {}
  BallCoefficients<Real> local(const Coefficients& c) const { return polynomials->of<Real>(c, origin); }
  BallCoefficients<Real> local_angle(const Coefficients& c) const { return polynomials->of<Real>(c, origin, true); }
};

/// The time for polynomials that are given in powers of the time since `origin`.
template <class Real>
inline LocalTime<Real> since_origin(LocalTime<Real> t, double origin) {
  if (origin == 0) return t;
  t.t = time_since(t.t, origin);
  t.origin = origin;
  return t;
}
template <class Time>
Time since_origin(Time t, double origin) {
  t.origin = origin;
  return t;
}

/// A polynomial of which whole turns do not count.
template <class J, class Time>
J angle_at(const Coefficients& c, const Time& t) {
  if constexpr (requires { t.local_angle(c); }) {
    if (t.polynomials) return J::polynomial(t.local_angle(c), t.since);
  }
  return J::polynomial(c, t);
}

/// The time since the polynomials' origin, or the time as it is.
template <class Time>
const auto& absolute(const Time& t) {
  if constexpr (requires { t.since; }) {
    return t.t;
  } else {
    return t;
  }
}

}  // namespace taut::internal
