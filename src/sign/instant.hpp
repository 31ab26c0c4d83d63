// Instants of a segment, and what is between what then.
#pragma once

#include <memory>

#include "numeric/first_decisive.hpp"
#include "sign/precise_triple.hpp"

namespace taut::internal {

/// A double, or the root of a form: the instant at which the corner u, v, w changes its sign. A root is enclosed by two
/// doubles; where these do not tell what is asked, it is enclosed again, from stage to stage, by what it is the root
/// of.
struct Instant {
  double lo = 0, hi = 0;  ///< of the segment's parameter
  bool event = false;     ///< it is a root: of the orientation of
  VertexId u, v, w;
  int sign = 0;                              ///< which has this sign before
  std::shared_ptr<const PreciseTime> known;  ///< set where doubles cannot tell it from roots of the same corner

  static Instant exactly(double t) {
    Instant i;
    i.lo = i.hi = t;
    return i;
  }
  /// An instant that is known to no end.
  static Instant exactly(const PreciseTime& t) {
    Instant i;
    i.lo = t.floor();
    i.hi = t.ceiling();
    i.known = std::make_shared<const PreciseTime>(t);
    return i;
  }
  /// The same instant of the same segment?
  bool is(const Instant& o) const {
    return lo == o.lo && hi == o.hi && event == o.event && u == o.u && v == o.v && w == o.w;
  }
  /// Are these the three vertices that are on one line then?
  bool concerns(VertexId a, VertexId b, VertexId c) const {
    const auto in = [this](VertexId x) { return x == u || x == v || x == w; };
    return event && in(a) && in(b) && in(c);
  }
  /// What is known of it so far.
  PreciseTime enclosure() const { return known ? *known : PreciseTime::between(lo, hi); }
  /// Encloses it, t, as well as a stage can; false if that does not do.
  bool refine(const MotionSegment& segment, const PairGeometry& g, Stage stage, PreciseTime& t,
              FrameMemory* memory = nullptr) const {
    return !event || PreciseTriple(segment, g, CertificateFunction::of(g, u, v, w), memory).refine(sign, t, stage);
  }
};

/// The sign of a form at an instant, enclosed by t, by the first stage that can tell; 0 if none can.
inline int sign_at(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function,
                   const Instant& instant, PreciseTime& t, FrameMemory* memory = nullptr) {
  const PreciseTriple f(segment, g, function, memory);
  const auto sign = [&](Stage stage) { return instant.refine(segment, g, stage, t, memory) ? f.sign_at(t, stage) : 0; };
  return first_decisive(sign, Stage::beside);
}

/// Of three vertices that are on one line, the middle one: sign(form) tells the sign of a form at that instant.
template <class Sign>
VertexId middle_of(const PairGeometry& g, VertexId u, VertexId v, VertexId w, const Sign& sign) {
  const CertificateFunction f = CertificateFunction::of(g, u, v, w);
  // c beyond a, or beyond b, or between.
  if (sign(f.along()) < 0) return f.a;
  if (sign(f.back()) < 0) return f.b;
  return f.c;
}

}  // namespace taut::internal
