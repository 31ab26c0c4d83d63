#include "motion/motion_segment.hpp"

#include <algorithm>
#include <cmath>

#include "motion/frame_model.hpp"
#include "motion/frame_sample.hpp"
#include "motion/uniform_rotation.hpp"

namespace taut::internal {

bool MotionSegment::singular_at(double t) const {
  return std::any_of(singular_.begin(), singular_.end(),
                     [t](const SingularLink& s) { return s.cosine->end == t && s.cosine->order % 2 == 1; });
}

const SingularCosine* MotionSegment::singular_cosine(bool of_p, std::size_t link, double t) const {
  for (const SingularLink& s : singular_) {
    if (s.of_p == of_p && s.link == link && s.cosine->end == t) return s.cosine.get();
  }
  return nullptr;
}

namespace {

/// Computes (re, im) of conj(a) b.
template <class J>
void conjugate_product(const J& ax, const J& ay, const J& bx, const J& by, J& re, J& im) {
  re = ax * bx + ay * by;
  im = ax * by - ay * bx;
}

/// x_P and x_Q. For a body that does not rotate, they are not set.
template <class J>
struct Axes {
  J px, py, qx, qy;
};

/// Computes x of the rotation of P or Q, or of a link of its chain.
template <class J, class Time>
void axis(const MotionSegment& segment, bool of_p, std::size_t link, const Time& t, J& x, J& y) {
  if constexpr (requires { t.direction; }) {
    if (const SingularCosine* cosine = segment.singular_cosine(of_p, link, t.end))
      return cosine_from_end(*cosine, t, x, y);
  } else if constexpr (requires { absolute(t).mid; }) {
    // Tests the nearer end of the segment, if the cosine is singular there.
    const auto& at = absolute(t);
    const bool first = at.mid - segment.start < segment.end - at.mid;
    const SingularCosine* cosine = segment.singular_cosine(of_p, link, first ? segment.start : segment.end);
    if (cosine) return cosine_near_end(*cosine, at, first ? 1.0 : -1.0, x, y);
  }
  const MotionPiece& piece = segment.composed ? (of_p ? segment.p_chain : segment.q_chain)[link]
                             : of_p           ? segment.p
                                              : segment.q;
  rotation_jet(piece, t, x, y);
}

/// The angle of Q minus that of P.
template <class J, class Time>
J difference_of_angles(const MotionSegment& segment, const Time& t) {
  if constexpr (requires { t.since; }) {
    using Real = std::decay_t<decltype(t.since.mid)>;
    if (t.polynomials) return J::polynomial(segment.far_turn().template rounded<Real>(), t.since);
    const Time since = since_origin(t, segment.origin);
    const J turn = J::polynomial(segment.turn, since);
    return segment.turn_low.empty() ? turn : turn + J::polynomial(segment.turn_low, since);
  } else {
    const auto angle = [&](const MotionPiece& piece) {
      return J::polynomial(std::get<AngleRotation>(piece.rotation).angle, since_origin(t, piece.origin));
    };
    return angle(segment.q) - angle(segment.p);
  }
}

/// Computes conj(x_P) x_Q for two bodies that rotate. If both angles are given, their difference is formed first, so
/// that their common part cannot widen ranges.
template <class J, class Time>
void relative_turn(const MotionSegment& segment, const Axes<J>& axes, const Time& t, J& c, J& s) {
  if (!segment.angles) return conjugate_product(axes.px, axes.py, axes.qx, axes.qy, c, s);
  sin_cos(difference_of_angles<J>(segment, t), s, c);
}

/// Computes the parts that depend on the rotations of the bodies, each about its origin. Most scenes have one body that
/// does not rotate.
template <class J, class Time>
void turning_frame(const MotionSegment& segment, const Axes<J>& axes, const Time& t, const J& dx, const J& dy,
                   FrameOf<J>& f) {
  const auto& [px, py, qx, qy] = axes;
  const bool p_turns = turns(segment.p), q_turns = turns(segment.q);
  if (p_turns) {
    conjugate_product(px, py, dx, dy, f.for_pp[1], f.for_pp[2]);
  } else {
    f.for_pp[1] = dx;
    f.for_pp[2] = dy;
  }
  if (segment.aligned) {
    f.for_pp[3] = J::constant(1.0);
    f.for_pp[4] = J::constant(0.0);
    f.for_qq[1] = f.for_pp[1];
    f.for_qq[2] = f.for_pp[2];
    return;
  }
  if (!q_turns) {
    f.for_pp[3] = px;
    f.for_pp[4] = -py;
    f.for_qq[1] = dx;
    f.for_qq[2] = dy;
    return;
  }
  conjugate_product(qx, qy, dx, dy, f.for_qq[1], f.for_qq[2]);
  if (p_turns) {
    relative_turn(segment, axes, t, f.for_pp[3], f.for_pp[4]);
  } else {
    f.for_pp[3] = qx;
    f.for_pp[4] = qy;
  }
}

/// For bodies that rotate about pivots a (P) and b (Q), a - x_P a and b - x_Q b are added to their origins, which
/// changes conj(x_P) D and conj(x_Q) D. conj(x_P) x_P is 1, and conj(x_P) x_Q is c + i s, which is known: products
/// would be wider over an interval.
template <class J>
void add_pivots(const MotionSegment& segment, const Axes<J>& axes, FrameOf<J>& f) {
  const Point a = pivot_of(segment.p), b = pivot_of(segment.q);
  const J ax = J::constant(a.x), ay = J::constant(a.y), bx = J::constant(b.x), by = J::constant(b.y);
  const J &c = f.for_pp[3], &s = f.for_pp[4];
  const J x = bx - ax, y = by - ay;
  J in_p_x = x, in_p_y = y, in_q_x = x, in_q_y = y;
  if (turns(segment.p)) conjugate_product(axes.px, axes.py, x, y, in_p_x, in_p_y);
  if (segment.aligned) {
    in_q_x = in_p_x;
    in_q_y = in_p_y;
  } else if (turns(segment.q)) {
    conjugate_product(axes.qx, axes.qy, x, y, in_q_x, in_q_y);
  }
  f.for_pp[1] = f.for_pp[1] + (in_p_x + ax - (c * bx - s * by));
  f.for_pp[2] = f.for_pp[2] + (in_p_y + ay - (s * bx + c * by));
  f.for_qq[1] = f.for_qq[1] + (in_q_x - bx + (c * ax + s * ay));
  f.for_qq[2] = f.for_qq[2] + (in_q_y - by + (c * ay - s * ax));
}

/// The frame of two bodies of which at least one has parents or an orbit.
template <class J, class Time>
FrameOf<J> composed_frame(const MotionSegment& segment, const Time& t) {
  const auto pose_of_body = [&](bool of_p) {
    return pose_of<J>(of_p ? segment.p_chain : segment.q_chain, t,
                      [&](std::size_t link, J& x, J& y) { axis(segment, of_p, link, t, x, y); });
  };
  const PoseOf<J> p = pose_of_body(true), q = pose_of_body(false);
  const bool p_turns = turns(segment.p_chain), q_turns = turns(segment.q_chain);
  const J dx = q.ox - p.ox, dy = q.oy - p.oy;
  FrameOf<J> f;
  f.for_pp[0] = f.for_qq[0] = J::constant(1.0);
  f.for_pp[1] = f.for_qq[1] = dx;
  f.for_pp[2] = f.for_qq[2] = dy;
  if (p_turns) conjugate_product(p.xx, p.xy, dx, dy, f.for_pp[1], f.for_pp[2]);
  if (q_turns) conjugate_product(q.xx, q.xy, dx, dy, f.for_qq[1], f.for_qq[2]);
  f.for_pp[3] = q.xx;
  f.for_pp[4] = q.xy;
  if (p_turns) conjugate_product(p.xx, p.xy, q.xx, q.xy, f.for_pp[3], f.for_pp[4]);
  f.for_qq[3] = f.for_pp[3];
  f.for_qq[4] = f.for_pp[4];
  return f;
}

/// A coordinate of D minus the shift.
template <class J, class Time>
J way(const MotionSegment& segment, bool of_x, const Time& t) {
  const Coefficients &q = of_x ? segment.q.x : segment.q.y, &p = of_x ? segment.p.x : segment.p.y;
  const double to = segment.q.origin, from = segment.p.origin;
  if constexpr (requires { t.since; }) {
    using Real = std::decay_t<decltype(t.since.mid)>;
    if (t.polynomials) return J::polynomial(segment.way(of_x).template rounded<Real>(), t.since);
    return J::polynomial(VaryingPart{q}, time_since(t.t, to)) - J::polynomial(VaryingPart{p}, time_since(t.t, from));
  } else {
    if (!segment.far())
      return J::polynomial(VaryingPart{q}, since_origin(t, to)) - J::polynomial(VaryingPart{p}, since_origin(t, from));
    const ExactVector& s = segment.shift;
    const Point a = pivot_of(segment.p), b = pivot_of(segment.q);
    J d = J::polynomial(q, since_origin(t, to)) - J::polynomial(p, since_origin(t, from));
    for (const double c : {of_x ? b.x : b.y, of_x ? -a.x : -a.y, of_x ? -s.x : -s.y, of_x ? -s.x_low : -s.y_low})
      d = d + J::constant(c);
    return d;
  }
}

/// Computes D; with `offset`, for coordinates with the segment's offsets, otherwise for the bodies' own.
template <class J, class Time>
void way_between(const MotionSegment& segment, const Time& t, bool offset, J& dx, J& dy) {
  if (offset && (segment.shift_p || segment.shift_q)) {
    dx = way<J>(segment, true, t);
    dy = way<J>(segment, false, t);
  } else {
    const Time to = since_origin(t, segment.q.origin), from = since_origin(t, segment.p.origin);
    dx = J::polynomial(segment.q.x, to) - J::polynomial(segment.p.x, from);
    dy = J::polynomial(segment.q.y, to) - J::polynomial(segment.p.y, from);
  }
  if (offset && segment.pivots && !segment.shift_p && !segment.shift_q) {
    const Point a = pivot_of(segment.p), b = pivot_of(segment.q);
    dx = dx + (J::constant(b.x) - J::constant(a.x));
    dy = dy + (J::constant(b.y) - J::constant(a.y));
  }
}

template <class J, class Time>
FrameOf<J> motion_frame(const MotionSegment& segment, const Time& t, bool offset) {
  if (segment.composed) return composed_frame<J>(segment, t);
  FrameOf<J> f;
  J dx, dy;
  way_between(segment, t, offset, dx, dy);
  const J one = J::constant(1.0), zero = J::constant(0.0);
  f.for_pp[0] = f.for_qq[0] = one;
  if (segment.translation) {
    f.for_pp = {one, dx, dy, one, zero};
    f.for_qq = f.for_pp;
    return f;
  }
  Axes<J> axes;
  if (turns(segment.p)) axis(segment, true, 0, t, axes.px, axes.py);
  if (turns(segment.q) && !segment.aligned) axis(segment, false, 0, t, axes.qx, axes.qy);
  turning_frame(segment, axes, t, dx, dy, f);
  if (segment.pivots && !offset) add_pivots(segment, axes, f);
  f.for_qq[3] = f.for_pp[3];
  f.for_qq[4] = f.for_pp[4];
  return f;
}

/// The pose of a body that follows the piece, or the chain.
template <class J, class Real>
PoseOf<J> placed(const MotionSegment& segment, const PieceChain& chain, const MotionPiece& piece, const Ball<Real>& t) {
  const LocalTime<Real> at = segment.local_time(t);
  return segment.composed ? pose_of<J>(chain, at) : pose_of<J>(piece, at);
}

/// Linear interpolation between two poses, s in [0, 1].
template <class J, class Real>
PoseOf<J> interpolate(const PoseOf<Series<Real, 0>>& a, const PoseOf<Series<Real, 0>>& b, const Ball<Real>& s) {
  const auto line = [&s](const Series<Real, 0>& from, const Series<Real, 0>& to) {
    BallCoefficients<Real> c;
    c.p.push_back(from.c[0]);
    c.p.push_back(to.c[0] - from.c[0]);
    return J::polynomial(c, s);
  };
  return {line(a.ox, b.ox), line(a.oy, b.oy), line(a.xx, b.xx), line(a.xy, b.xy)};
}

/// The frame on a bridge: polynomials of the second degree in s.
template <class J, class Real>
FrameOf<J> bridge_frame(const MotionSegment& segment, const Ball<Real>& s) {
  const auto at = [&](double t, const PieceChain& chain, const MotionPiece& piece) {
    return placed<Series<Real, 0>>(segment, chain, piece, Ball<Real>::exact(t));
  };
  const double t = segment.joint;
  const PoseOf<J> p = interpolate<J>(at(t, segment.p_chain, segment.p), at(t, segment.p_chain_next, segment.p_next), s);
  const PoseOf<J> q = interpolate<J>(at(t, segment.q_chain, segment.q), at(t, segment.q_chain_next, segment.q_next), s);
  const J dx = q.ox - p.ox, dy = q.oy - p.oy;
  FrameOf<J> f;
  f.for_pp[0] = p.xx * p.xx + p.xy * p.xy;
  f.for_qq[0] = q.xx * q.xx + q.xy * q.xy;
  conjugate_product(p.xx, p.xy, dx, dy, f.for_pp[1], f.for_pp[2]);
  conjugate_product(q.xx, q.xy, dx, dy, f.for_qq[1], f.for_qq[2]);
  conjugate_product(p.xx, p.xy, q.xx, q.xy, f.for_pp[3], f.for_pp[4]);
  f.for_qq[3] = f.for_pp[3];
  f.for_qq[4] = f.for_pp[4];
  return f;
}

template <class J, class Real>
FrameOf<J> frame_at(const MotionSegment& segment, const Ball<Real>& t, bool offset = true) {
  if (segment.bridge) return bridge_frame<J>(segment, t);
  return motion_frame<J>(segment, segment.local_time(t), offset);
}

}  // namespace

Pose<double> MotionSegment::pose_of_body(bool of_p, double parameter) const {
  return placed<Jet<double>>(*this, bridge ? (of_p ? p_chain_next : q_chain_next) : (of_p ? p_chain : q_chain),
                             bridge ? (of_p ? p_next : q_next) : (of_p ? p : q), Ball<double>::exact(time(parameter)));
}

template <class Real>
Frame<Real> frame(const MotionSegment& segment, const Ball<Real>& t) {
  return frame_at<Jet<Real>>(segment, t);
}
template <class Real>
Frame<Real> frame(const MotionSegment& segment, const TimeFromEnd<Real>& t) {
  return motion_frame<Jet<Real>>(segment, t, true);
}
template <class Real>
FrameValues<Real> frame_values(const MotionSegment& segment, const Ball<Real>& t) {
  const FrameOf<Series<Real, 0>> f = frame_at<Series<Real, 0>>(segment, t);
  FrameValues<Real> values;
  for (std::size_t i = 0; i < 5; ++i) {
    values.for_pp[i] = f.for_pp[i].c[0];
    values.for_qq[i] = f.for_qq[i].c[0];
  }
  return values;
}
template <class Real>
FrameOf<ModelSeries<Real>> frame_series(const MotionSegment& segment, const Ball<Real>& t) {
  return frame_at<ModelSeries<Real>>(segment, t);
}
template <class Real>
FrameOf<SeriesFromEnd<Real>> frame_series(const MotionSegment& segment, const TimeFromEnd<Real>& t) {
  return motion_frame<SeriesFromEnd<Real>>(segment, t, true);
}
#define TAUT_INSTANTIATE(Real)                                                               \
  template Frame<Real> frame(const MotionSegment&, const Ball<Real>&);                       \
  template Frame<Real> frame(const MotionSegment&, const TimeFromEnd<Real>&);                \
  template FrameValues<Real> frame_values(const MotionSegment&, const Ball<Real>&);          \
  template FrameOf<ModelSeries<Real>> frame_series(const MotionSegment&, const Ball<Real>&); \
  template FrameOf<SeriesFromEnd<Real>> frame_series(const MotionSegment&, const TimeFromEnd<Real>&);
TAUT_INSTANTIATE(double)
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE

Frame<double> unshifted_frame(const MotionSegment& segment, const Ball<double>& t) {
  return frame_at<Jet<double>>(segment, t, false);
}
FrameOf<ThirdSeries> frame_to_third_order(const MotionSegment& segment, const Ball<double>& t) {
  return frame_at<ThirdSeries>(segment, t);
}
template <class Real>
std::array<ModelSeries<Real>, 2> way_series(const MotionSegment& segment, const Ball<Real>& t) {
  std::array<ModelSeries<Real>, 2> d;
  way_between(segment, segment.local_time(t), true, d[0], d[1]);
  return d;
}
template std::array<ModelSeries<double>, 2> way_series(const MotionSegment&, const Ball<double>&);
template std::array<ModelSeries<Real320>, 2> way_series(const MotionSegment&, const Ball<Real320>&);
FrameOf<Symbolic> symbolic_frame(const MotionSegment& segment, SymbolicSegment& symbols) {
  return motion_frame<Symbolic>(segment, SymbolicTime{&symbols}, true);
}

const FrameIdentities& MotionSegment::identities() const {
  if (!identities_) identities_ = std::make_shared<const FrameIdentities>(*this);
  return *identities_;
}

const std::shared_ptr<const UniformRotation>& MotionSegment::uniform_rotation() const {
  if (!uniform_rotation_) uniform_rotation_ = UniformRotation::of(*this);
  return *uniform_rotation_;
}

const FrameEvaluator& MotionSegment::looks() const {
  if (!looks_) looks_ = std::make_shared<const FrameEvaluator>(*this);
  return *looks_;
}

}  // namespace taut::internal
