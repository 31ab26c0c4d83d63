// Instants of a segment, and the middle of three collinear vertices at an instant.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "certificate/contact_bracket.hpp"
#include "certificate/precise_triple.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {

/// A double, or the root of a certificate function: the instant at which the corner u, v, w changes its sign. Two
/// doubles enclose a root. Where they do not decide a query, the root is enclosed again, stage by stage, from its
/// function.
struct Instant {
  double lo = 0, hi = 0;  ///< in the segment's parameter
  bool event = false;     ///< it is a root of the orientation of u, v, w
  VertexId u, v, w;
  int sign = 0;                              ///< the sign before the root
  std::shared_ptr<const PreciseTime> known;  ///< set where doubles cannot distinguish it from other roots of the same
                                             ///< corner

  static Instant exactly(double t) {
    Instant i;
    i.lo = i.hi = t;
    return i;
  }
  /// An instant given by an enclosure of arbitrary precision.
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
  /// Are these the three vertices that are collinear at this instant?
  bool concerns(VertexId a, VertexId b, VertexId c) const {
    const auto in = [this](VertexId x) { return x == u || x == v || x == w; };
    return event && in(a) && in(b) && in(c);
  }
  /// The enclosure known so far.
  PreciseTime enclosure() const { return known ? *known : PreciseTime::between(lo, hi); }
  /// Encloses the instant in t as tightly as a stage can; false if the stage fails.
  bool refine(const MotionSegment& segment, const PairGeometry& g, Stage stage, PreciseTime& t,
              FrameMemory* memory = nullptr) const {
    return !event || PreciseTriple(segment, g, CertificateFunction::of(g, u, v, w), memory).refine(sign, t, stage);
  }
};

/// The sign of a certificate function at an instant enclosed by t, by the first stage that decides; 0 if none does.
inline int sign_at(const MotionSegment& segment, const PairGeometry& g, const CertificateFunction& function,
                   const Instant& instant, PreciseTime& t, FrameMemory* memory = nullptr) {
  const PreciseTriple f(segment, g, function, memory);
  const auto sign = [&](Stage stage) { return instant.refine(segment, g, stage, t, memory) ? f.sign_at(t, stage) : 0; };
  return first_decisive(sign, Stage::relative);
}

/// The middle one of three collinear vertices. sign(function) returns the sign of a certificate function at that
/// instant.
template <class Sign>
VertexId middle_of(const PairGeometry& g, VertexId u, VertexId v, VertexId w, const Sign& sign) {
  const CertificateFunction f = CertificateFunction::of(g, u, v, w);
  // The vertex c lies beyond a, or beyond b, or between them.
  if (sign(f.along()) < 0) return f.a;
  if (sign(f.back()) < 0) return f.b;
  return f.c;
}

// The order of several contacts, of any pairs of bodies.

/// A contact found by an engine for bodies displaced as the geometry is.
struct ContactInstant {
  std::shared_ptr<const MotionSegment> segment;
  const PairGeometry* geometry;
  FoundContact contact;
};

/// The order in world time: -1 if a is certainly before b, 1 if it is after, 0 if even the highest precision does not
/// decide. The segments may be those of different pairs. On one bridge, its parameter decides; on different bridges at
/// one joint, nothing does.
int order_of(const ContactInstant& a, const ContactInstant& b);

/// One of many contacts of bodies as given. Doubles enclose it; if its certificate function is known, its root gives a
/// more precise enclosure.
struct ContactCandidate {
  TimeInterval time;
  std::optional<ContactInstant> instant;
};

/// The contacts that are not certain to come after another one. Where doubles leave several, each is enclosed at high
/// precision, with room for its shift due to the displacement. The remaining ones differ by less.
std::vector<std::size_t> possibly_first(const std::vector<ContactCandidate>& contacts);

}  // namespace taut::internal
