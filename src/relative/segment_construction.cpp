// Constructs segments from the pieces that bodies follow, and moves parts of their motion into the bodies' coordinates.
#include <cmath>

#include "motion/far_pieces.hpp"
#include "numeric/exact_sum.hpp"
#include "relative/motion_segment.hpp"

namespace taut::internal {
namespace {

/// Computes to[0] + to[1] - from[0] - from[1], of which at most three are nonzero: three doubles suffice.
void exact_difference(const std::array<double, 2>& to, const std::array<double, 2>& from, double& hi, double& low,
                      double& rest) {
  if (to[1] == 0 && from[1] == 0) {
    const TwoDoubles sum = two_sum(to[0], -from[0]);
    hi = sum.hi;
    low = sum.lo;
    return;
  }
  ExactSum<4> sum;
  for (const double x : {to[0], to[1], -from[0], -from[1]}) sum.add(x);
  const std::size_t n = sum.size();
  hi = n > 0 ? sum.term(n - 1) : 0;
  low = n > 1 ? sum.term(n - 2) : 0;
  rest = n > 2 ? sum.term(n - 3) : 0;
}

/// The difference of two polynomials, each coefficient as an exact sum of two doubles, without trailing zeros.
void exact_difference(const Coefficients& q, const Coefficients& p, Coefficients& hi, Coefficients& low) {
  for (std::size_t k = 0; k < std::max(p.size(), q.size()); ++k) {
    const TwoDoubles d = two_sum(coefficient(q, k), -coefficient(p, k));
    hi.push_back(d.hi);
    low.push_back(d.lo);
  }
  for (Coefficients* c : {&hi, &low}) {
    while (!c->empty() && c->back() == 0) c->pop_back();
  }
}

int last_nonzero_power(const Coefficients& q, const Coefficients& p) {
  for (std::size_t k = std::max(p.size(), q.size()); k-- > 0;) {
    if (coefficient(q, k) != coefficient(p, k)) return static_cast<int>(k);
  }
  return 0;
}

/// The piece, for this instant alone. A cosine that is 1 or -1 there gives the sine exactly; as a root of a number near
/// zero, the sine would be known to only half the digits.
MotionPiece at_joint(MotionPiece piece, double joint) {
  const auto* cosine = std::get_if<CosineRotation>(&piece.rotation);
  if (!cosine) return piece;
  const auto singular = singular_at(*cosine, joint);
  if (singular && singular->order > 0) piece.rotation = DirectionRotation{{singular->extreme}, {0.0}};
  return piece;
}
PieceChain at_joint(PieceChain chain, double joint) {
  for (MotionPiece& piece : chain) piece = at_joint(std::move(piece), joint);
  return chain;
}

}  // namespace

MotionSegment MotionSegment::motion_of_chains(const PieceChain& p, const PieceChain& q, double start, double end) {
  const auto plain = [](const PieceChain& chain) { return chain.size() == 1 && !orbits(chain.back()); };
  if (plain(p) && plain(q)) return motion(p.back(), q.back(), start, end);
  MotionSegment segment;
  segment.p = p.back();
  segment.q = q.back();
  segment.composed = true;
  segment.p_chain = p;
  segment.q_chain = q;
  segment.start = start;
  segment.end = end;
  if (is_far_for(std::max(highest_power(p), highest_power(q)), start, end))
    segment.local_ = std::make_shared<const LocalPolynomials>(start + (end - start) / 2);
  for (std::size_t link = 0; link < p.size(); ++link) segment.find_singular_ends(true, link, p[link]);
  for (std::size_t link = 0; link < q.size(); ++link) segment.find_singular_ends(false, link, q[link]);
  return segment;
}

MotionSegment MotionSegment::motion(const MotionPiece& p, const MotionPiece& q, double start, double end) {
  if (orbits(p) || orbits(q)) return motion_of_chains(PieceChain{p}, PieceChain{q}, start, end);
  MotionSegment segment;
  segment.p = p;
  segment.q = q;
  segment.start = start;
  segment.end = end;
  segment.translation = !turns(p) && !turns(q);
  segment.aligned = same_rotation(p.rotation, q.rotation);
  const auto *p_angle = std::get_if<AngleRotation>(&p.rotation), *q_angle = std::get_if<AngleRotation>(&q.rotation);
  segment.angles = p_angle && q_angle;
  if (segment.angles) exact_difference(q_angle->angle, p_angle->angle, segment.turn, segment.turn_low);
  segment.pivots = pivot_of(p) != Point{} || pivot_of(q) != Point{};
  segment.degree = std::max(last_nonzero_power(q.x, p.x), last_nonzero_power(q.y, p.y));
  segment.shift_p = !turns(p);
  segment.shift_q = turns(p) && !turns(q);
  const Point a = pivot_of(p), b = pivot_of(q);
  segment.offset_p = {-a.x, 0, -a.y};
  segment.offset_q = {-b.x, 0, -b.y};
  if (segment.shift_p || segment.shift_q) {
    exact_difference({coefficient(q.x, 0), b.x}, {coefficient(p.x, 0), a.x}, segment.shift.x, segment.shift.x_low,
                     segment.shift.x_rest);
    exact_difference({coefficient(q.y, 0), b.y}, {coefficient(p.y, 0), a.y}, segment.shift.y, segment.shift.y_low,
                     segment.shift.y_rest);
    (segment.shift_p ? segment.offset_p : segment.offset_q) = segment.shift_p ? -segment.shift : segment.shift;
  }
  if (is_far_for(std::max(highest_power(p), highest_power(q)), start, end)) segment.take_far_offsets();
  segment.find_singular_ends(true, 0, p);
  segment.find_singular_ends(false, 0, q);
  return segment;
}

void MotionSegment::find_singular_ends(bool of_p, std::size_t link, const MotionPiece& piece) {
  const auto* cosine = std::get_if<CosineRotation>(&piece.rotation);
  if (!cosine) return;
  for (const double t : {start, end}) {
    if (auto singular = internal::singular_at(*cosine, t))
      singular_.push_back({of_p, link, std::make_shared<const SingularCosine>(std::move(*singular))});
  }
}

/// Replaces the shift by D about the segment's middle, in two doubles.
void MotionSegment::take_far_offsets() {
  far_offset_p = offset_p;
  far_offset_q = offset_q;
  const auto local = std::make_shared<const LocalPolynomials>(start + (end - start) / 2);
  local_ = local;
  if (!shift_p && !shift_q) return;
  const auto way = [&](const Coefficients& to, const Coefficients& from, double to_pivot, double from_pivot, double& hi,
                       double& low) {
    DyadicPolynomial d = local->exact(to) + -local->exact(from);
    if (d.empty()) d.emplace_back();
    d[0] = d[0] + (Dyadic::exact(to_pivot) - Dyadic::exact(from_pivot));
    for (double* part : {&hi, &low}) {
      *part = RealTraits<RealMax>::to_double(ball_of<RealMax>(d[0]).mid);
      d[0] = d[0] - Dyadic::exact(*part);
    }
    trim(d);
    return LocalPolynomials::Known(std::move(d));
  };
  const Point a = pivot_of(p), b = pivot_of(q);
  shift = {};
  ways_ = std::make_shared<const std::array<LocalPolynomials::Known, 2>>(std::array<LocalPolynomials::Known, 2>{
      way(q.x, p.x, b.x, a.x, shift.x, shift.x_low), way(q.y, p.y, b.y, a.y, shift.y, shift.y_low)});
  (shift_p ? offset_p : offset_q) = shift_p ? -shift : shift;
}

std::array<double, 7> MotionSegment::constant_left(bool of_x) const {
  const Point a = pivot_of(p), b = pivot_of(q);
  if (of_x) return {coefficient(q.x, 0), -coefficient(p.x, 0), b.x, -a.x, -shift.x, -shift.x_low, -shift.x_rest};
  return {coefficient(q.y, 0), -coefficient(p.y, 0), b.y, -a.y, -shift.y, -shift.y_low, -shift.y_rest};
}

MotionSegment MotionSegment::bridging(const MotionPiece& p, const MotionPiece& q, const MotionPiece& p_next,
                                      const MotionPiece& q_next, double joint, bool far) {
  if (orbits(p) || orbits(q) || orbits(p_next) || orbits(q_next))
    return bridging_chains(PieceChain{p}, PieceChain{q}, PieceChain{p_next}, PieceChain{q_next}, joint, far);
  MotionSegment segment;
  segment.p = at_joint(p, joint);
  segment.q = at_joint(q, joint);
  segment.p_next = at_joint(p_next, joint);
  segment.q_next = at_joint(q_next, joint);
  segment.bridge = true;
  segment.joint = segment.joint_before = joint;
  segment.start = 0;
  segment.end = 1;
  if (far) segment.local_ = std::make_shared<const LocalPolynomials>(joint);
  return segment;
}

MotionSegment MotionSegment::bridging_between(const MotionPiece& p, const MotionPiece& q, double before,
                                              const MotionPiece& p_next, const MotionPiece& q_next, double joint,
                                              bool far) {
  MotionSegment segment = bridging(p, q, p_next, q_next, joint, far);
  segment.joint_before = before;
  segment.p = at_joint(p, before);
  segment.q = at_joint(q, before);
  return segment;
}

MotionSegment MotionSegment::bridging_chains(const PieceChain& p, const PieceChain& q, const PieceChain& p_next,
                                             const PieceChain& q_next, double joint, bool far) {
  MotionSegment segment;
  segment.p = p.back();
  segment.q = q.back();
  segment.p_next = p_next.back();
  segment.q_next = q_next.back();
  segment.bridge = true;
  segment.joint = segment.joint_before = joint;
  segment.start = 0;
  segment.end = 1;
  segment.composed = true;
  segment.p_chain = at_joint(p, joint);
  segment.q_chain = at_joint(q, joint);
  segment.p_chain_next = at_joint(p_next, joint);
  segment.q_chain_next = at_joint(q_next, joint);
  if (far) segment.local_ = std::make_shared<const LocalPolynomials>(joint);
  return segment;
}

}  // namespace taut::internal
