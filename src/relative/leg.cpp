#include "relative/leg.hpp"

#include <algorithm>
#include <cmath>

#include "relative/even_turn.hpp"
#include "relative/frame_identities.hpp"
#include "relative/frame_looks.hpp"

namespace taut {

bool Leg::singular_at(double t) const {
  return std::any_of(singular_.begin(), singular_.end(),
                     [t](const SingularLink& s) { return s.cosine->end == t && s.cosine->order % 2 == 1; });
}

const SingularCosine* Leg::singular_cosine(bool of_p, std::size_t link, double t) const {
  for (const SingularLink& s : singular_) {
    if (s.of_p == of_p && s.link == link && s.cosine->end == t) return s.cosine.get();
  }
  return nullptr;
}

namespace {

/// (re, im) of conj(a) b.
template <class J>
void conjugate_product(const J& ax, const J& ay, const J& bx, const J& by, J& re, J& im) {
  re = ax * bx + ay * by;
  im = ax * by - ay * bx;
}

/// x_P and x_Q; of a body that does not turn they are not set.
template <class J>
struct Axes {
  J px, py, qx, qy;
};

/// x of the rotation of P or Q, or of a link of its chain.
template <class J, class Time>
void axis(const Leg& leg, bool of_p, std::size_t link, const Time& t, J& x, J& y) {
  if constexpr (requires { t.direction; }) {
    if (const SingularCosine* cosine = leg.singular_cosine(of_p, link, t.end)) return cosine_from_end(*cosine, t, x, y);
  } else if constexpr (requires { absolute(t).mid; }) {
    // The nearer end of the leg, if the cosine is singular there.
    const auto& at = absolute(t);
    const bool first = at.mid - leg.start < leg.end - at.mid;
    const SingularCosine* cosine = leg.singular_cosine(of_p, link, first ? leg.start : leg.end);
    if (cosine) return cosine_near_end(*cosine, at, first ? 1.0 : -1.0, x, y);
  }
  const MotionPiece& piece = leg.composed ? (of_p ? leg.p_chain : leg.q_chain)[link] : of_p ? leg.p : leg.q;
  rotation_jet(piece.rotation, t, x, y);
}

/// conj(x_P) x_Q of two bodies that turn. Where both angles are given their difference is formed first, so that what
/// both have in common is not there to widen ranges.
template <class J, class Time>
void relative_turn(const Leg& leg, const Axes<J>& axes, const Time& t, J& c, J& s) {
  if (!leg.angles) return conjugate_product(axes.px, axes.py, axes.qx, axes.qy, c, s);
  const J turn = angle_at<J>(leg.turn, t);
  sin_cos(leg.turn_low.empty() ? turn : turn + angle_at<J>(leg.turn_low, t), s, c);
}

/// The parts that depend on how the bodies turn, each about its origin; most scenes have one that does not.
template <class J, class Time>
void turning_frame(const Leg& leg, const Axes<J>& axes, const Time& t, const J& dx, const J& dy, FrameOf<J>& f) {
  const auto& [px, py, qx, qy] = axes;
  const bool p_turns = turns(leg.p), q_turns = turns(leg.q);
  if (p_turns) {
    conjugate_product(px, py, dx, dy, f.for_pp[1], f.for_pp[2]);
  } else {
    f.for_pp[1] = dx;
    f.for_pp[2] = dy;
  }
  if (leg.aligned) {
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
    relative_turn(leg, axes, t, f.for_pp[3], f.for_pp[4]);
  } else {
    f.for_pp[3] = qx;
    f.for_pp[4] = qy;
  }
}

/// Bodies that turn about pivots a (P) and b (Q) have a - x_P a and b - x_Q b added to their origins, which adds to
/// conj(x_P) D and conj(x_Q) D. conj(x_P) x_P is 1, and conj(x_P) x_Q is c + i s, which is known: products would be
/// wider over an interval.
template <class J>
void add_pivots(const Leg& leg, const Axes<J>& axes, FrameOf<J>& f) {
  const Point a = pivot_of(leg.p), b = pivot_of(leg.q);
  const J ax = J::constant(a.x), ay = J::constant(a.y), bx = J::constant(b.x), by = J::constant(b.y);
  const J &c = f.for_pp[3], &s = f.for_pp[4];
  const J x = bx - ax, y = by - ay;
  J in_p_x = x, in_p_y = y, in_q_x = x, in_q_y = y;
  if (turns(leg.p)) conjugate_product(axes.px, axes.py, x, y, in_p_x, in_p_y);
  if (leg.aligned) {
    in_q_x = in_p_x;
    in_q_y = in_p_y;
  } else if (turns(leg.q)) {
    conjugate_product(axes.qx, axes.qy, x, y, in_q_x, in_q_y);
  }
  f.for_pp[1] = f.for_pp[1] + (in_p_x + ax - (c * bx - s * by));
  f.for_pp[2] = f.for_pp[2] + (in_p_y + ay - (s * bx + c * by));
  f.for_qq[1] = f.for_qq[1] + (in_q_x - bx + (c * ax + s * ay));
  f.for_qq[2] = f.for_qq[2] + (in_q_y - by + (c * ay - s * ax));
}

/// Of two bodies of which one, or both, have parents or orbits.
template <class J, class Time>
FrameOf<J> composed_frame(const Leg& leg, const Time& t) {
  const auto pose_of_body = [&](bool of_p) {
    return pose_of<J>(of_p ? leg.p_chain : leg.q_chain, t,
                      [&](std::size_t link, J& x, J& y) { axis(leg, of_p, link, t, x, y); });
  };
  const PoseOf<J> p = pose_of_body(true), q = pose_of_body(false);
  const bool p_turns = turns(leg.p_chain), q_turns = turns(leg.q_chain);
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

/// A coordinate of D less the shift.
template <class J, class Time>
J way(const Leg& leg, bool of_x, const Time& t) {
  if constexpr (requires { t.since; }) {
    using Real = std::decay_t<decltype(t.since.mid)>;
    if (t.polynomials) return J::polynomial(leg.way(of_x).template rounded<Real>(), t.since);
  }
  const Coefficients &q = of_x ? leg.q.x : leg.q.y, &p = of_x ? leg.p.x : leg.p.y;
  J d = J::polynomial(VaryingPart{q}, absolute(t)) - J::polynomial(VaryingPart{p}, absolute(t));
  if (!leg.far()) return d;
  for (const double c : leg.constant_left(of_x)) d = d + J::constant(c);
  return d;
}

/// D; `offset`: for coordinates with the leg's offsets, else for the bodies' own.
template <class J, class Time>
void way_between(const Leg& leg, const Time& t, bool offset, J& dx, J& dy) {
  if (offset && (leg.shift_p || leg.shift_q)) {
    dx = way<J>(leg, true, t);
    dy = way<J>(leg, false, t);
  } else {
    dx = J::polynomial(leg.q.x, t) - J::polynomial(leg.p.x, t);
    dy = J::polynomial(leg.q.y, t) - J::polynomial(leg.p.y, t);
  }
  if (offset && leg.pivots && !leg.shift_p && !leg.shift_q) {
    const Point a = pivot_of(leg.p), b = pivot_of(leg.q);
    dx = dx + (J::constant(b.x) - J::constant(a.x));
    dy = dy + (J::constant(b.y) - J::constant(a.y));
  }
}

template <class J, class Time>
FrameOf<J> motion_frame(const Leg& leg, const Time& t, bool offset) {
  if (leg.composed) return composed_frame<J>(leg, t);
  FrameOf<J> f;
  J dx, dy;
  way_between(leg, t, offset, dx, dy);
  const J one = J::constant(1.0), zero = J::constant(0.0);
  f.for_pp[0] = f.for_qq[0] = one;
  if (leg.translation) {
    f.for_pp = {one, dx, dy, one, zero};
    f.for_qq = f.for_pp;
    return f;
  }
  Axes<J> axes;
  if (turns(leg.p)) axis(leg, true, 0, t, axes.px, axes.py);
  if (turns(leg.q) && !leg.aligned) axis(leg, false, 0, t, axes.qx, axes.qy);
  turning_frame(leg, axes, t, dx, dy, f);
  if (leg.pivots && !offset) add_pivots(leg, axes, f);
  f.for_qq[3] = f.for_pp[3];
  f.for_qq[4] = f.for_pp[4];
  return f;
}

/// Where a body is that follows the piece, or the chain.
template <class J, class Real>
PoseOf<J> placed(const Leg& leg, const PieceChain& chain, const MotionPiece& piece, const Ball<Real>& t) {
  const LocalTime<Real> at = leg.local_time(t);
  return leg.composed ? pose_of<J>(chain, at) : pose_of<J>(piece, at);
}

/// Straight from one pose to the other, s in [0, 1].
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

/// Polynomials of the second degree in s.
template <class J, class Real>
FrameOf<J> bridge_frame(const Leg& leg, const Ball<Real>& s) {
  const auto at = [&](double t, const PieceChain& chain, const MotionPiece& piece) {
    return placed<Series<Real, 0>>(leg, chain, piece, Ball<Real>::exact(t));
  };
  const double before = leg.joint_before, after = leg.joint;
  const PoseOf<J> p = interpolate<J>(at(before, leg.p_chain, leg.p), at(after, leg.p_chain_next, leg.p_next), s);
  const PoseOf<J> q = interpolate<J>(at(before, leg.q_chain, leg.q), at(after, leg.q_chain_next, leg.q_next), s);
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
FrameOf<J> frame_at(const Leg& leg, const Ball<Real>& t, bool offset = true) {
  if (leg.bridge) return bridge_frame<J>(leg, t);
  return motion_frame<J>(leg, leg.local_time(t), offset);
}

}  // namespace

Pose<double> Leg::pose_of_body(bool of_p, double parameter) const {
  return placed<Jet<double>>(*this, bridge ? (of_p ? p_chain_next : q_chain_next) : (of_p ? p_chain : q_chain),
                             bridge ? (of_p ? p_next : q_next) : (of_p ? p : q), Ball<double>::exact(time(parameter)));
}

template <class Real>
Frame<Real> frame(const Leg& leg, const Ball<Real>& t) {
  return frame_at<Jet<Real>>(leg, t);
}
template <class Real>
Frame<Real> frame(const Leg& leg, const TimeFromEnd<Real>& t) {
  return motion_frame<Jet<Real>>(leg, t, true);
}
template <class Real>
FrameValues<Real> frame_values(const Leg& leg, const Ball<Real>& t) {
  const FrameOf<Series<Real, 0>> f = frame_at<Series<Real, 0>>(leg, t);
  FrameValues<Real> values;
  for (std::size_t i = 0; i < 5; ++i) {
    values.for_pp[i] = f.for_pp[i].c[0];
    values.for_qq[i] = f.for_qq[i].c[0];
  }
  return values;
}
template <class Real>
FrameOf<ModelSeries<Real>> frame_series(const Leg& leg, const Ball<Real>& t) {
  return frame_at<ModelSeries<Real>>(leg, t);
}
template <class Real>
FrameOf<SeriesFromEnd<Real>> frame_series(const Leg& leg, const TimeFromEnd<Real>& t) {
  return motion_frame<SeriesFromEnd<Real>>(leg, t, true);
}
#define TAUT_INSTANTIATE(Real)                                                     \
  template Frame<Real> frame(const Leg&, const Ball<Real>&);                       \
  template Frame<Real> frame(const Leg&, const TimeFromEnd<Real>&);                \
  template FrameValues<Real> frame_values(const Leg&, const Ball<Real>&);          \
  template FrameOf<ModelSeries<Real>> frame_series(const Leg&, const Ball<Real>&); \
  template FrameOf<SeriesFromEnd<Real>> frame_series(const Leg&, const TimeFromEnd<Real>&);
TAUT_INSTANTIATE(double)
TAUT_FOR_EACH_PRECISION(TAUT_INSTANTIATE)
#undef TAUT_INSTANTIATE

Frame<double> unshifted_frame(const Leg& leg, const Ball<double>& t) { return frame_at<Jet<double>>(leg, t, false); }
FrameOf<ThirdSeries> frame_to_third_order(const Leg& leg, const Ball<double>& t) {
  return frame_at<ThirdSeries>(leg, t);
}
template <class Real>
std::array<ModelSeries<Real>, 2> way_series(const Leg& leg, const Ball<Real>& t) {
  std::array<ModelSeries<Real>, 2> d;
  if (leg.far()) {
    way_between(leg, LocalTime<Real>(*leg.local(), t), true, d[0], d[1]);
  } else {
    way_between(leg, t, true, d[0], d[1]);
  }
  return d;
}
template std::array<ModelSeries<double>, 2> way_series(const Leg&, const Ball<double>&);
template std::array<ModelSeries<Real320>, 2> way_series(const Leg&, const Ball<Real320>&);
FrameOf<Symbolic> symbolic_frame(const Leg& leg, SymbolicLeg& symbols) {
  return motion_frame<Symbolic>(leg, SymbolicTime{&symbols}, true);
}

const FrameIdentities& Leg::identities() const {
  if (!identities_) identities_ = std::make_shared<const FrameIdentities>(*this);
  return *identities_;
}

const std::shared_ptr<const EvenTurn>& Leg::even_turn() const {
  if (!even_turn_) even_turn_ = EvenTurn::of(*this);
  return *even_turn_;
}

const FrameLooks& Leg::looks() const {
  if (!looks_) looks_ = std::make_shared<const FrameLooks>(*this);
  return *looks_;
}

}  // namespace taut
