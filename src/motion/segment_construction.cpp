// Constructs segments from the pieces that bodies follow, and moves parts of their motion into the bodies' coordinates.
#include <cmath>
#include <utility>

#include "motion/far_pieces.hpp"
#include "motion/local_time.hpp"
#include "motion/motion_segment.hpp"
#include "motion/pieces.hpp"
#include "numeric/exact_sum.hpp"

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
/// Does the piece consist of more than polynomials and a rotation?
bool is_composed(const MotionPiece& piece) { return orbits(piece) || followed_joint(piece); }

MotionPiece at_joint(MotionPiece piece, double joint) {
  const auto* cosine = std::get_if<CosineRotation>(&piece.rotation);
  if (!cosine) return piece;
  const auto singular = singular_at(*cosine, piece.origin, joint);
  if (singular && singular->order > 0) piece.rotation = DirectionRotation{{singular->extreme}, {0.0}};
  return piece;
}
PieceChain at_joint(PieceChain chain, double joint) {
  for (MotionPiece& piece : chain) piece = at_joint(std::move(piece), joint);
  return chain;
}

}  // namespace

MotionSegment MotionSegment::motion_of_chains(const PieceChain& p, const PieceChain& q, double start, double end) {
  const auto plain = [](const PieceChain& chain) { return chain.size() == 1 && !is_composed(chain.back()); };
  if (plain(p) && plain(q)) return motion(p.back(), q.back(), start, end);
  MotionSegment segment;
  segment.p = p.back();
  segment.q = q.back();
  segment.composed = true;
  segment.p_chain = p;
  segment.q_chain = q;
  segment.start = start;
  segment.end = end;
  if (is_far_for(p, start, end) || is_far_for(q, start, end))
    segment.local_ = std::make_shared<const LocalPolynomials>(start + (end - start) / 2);
  for (std::size_t link = 0; link < p.size(); ++link) segment.find_singular_ends(true, link, p[link]);
  for (std::size_t link = 0; link < q.size(); ++link) segment.find_singular_ends(false, link, q[link]);
  return segment;
}

MotionSegment MotionSegment::motion(MotionPiece of_p, MotionPiece of_q, double start, double end) {
  if (is_composed(of_p) || is_composed(of_q)) return motion_of_chains(PieceChain{of_p}, PieceChain{of_q}, start, end);
  MotionSegment segment;
  segment.p = std::move(of_p);
  segment.q = std::move(of_q);
  const MotionPiece &p = segment.p, &q = segment.q;
  segment.start = start;
  segment.end = end;
  segment.translation = !turns(p) && !turns(q);
  // Constants have any origin.
  segment.origin = varies(p) ? p.origin : q.origin;
  const bool one_origin = !varies(q) || segment.origin == q.origin;
  segment.aligned = same_rotation(p.rotation, q.rotation) && (one_origin || !varies(p.rotation));
  segment.angles =
      std::holds_alternative<AngleRotation>(p.rotation) && std::holds_alternative<AngleRotation>(q.rotation);
  segment.pivots = pivot_of(p) != Point{} || pivot_of(q) != Point{};
  segment.shift_p = !turns(p);
  segment.shift_q = turns(p) && !turns(q);
  const Point a = pivot_of(p), b = pivot_of(q);
  segment.offset_p = {-a.x, 0, -a.y};
  segment.offset_q = {-b.x, 0, -b.y};
  if (!one_origin ||
      is_far_for(std::max(highest_power(p), highest_power(q)), start - segment.origin, end - segment.origin)) {
    segment.take_far_difference();
  } else {
    segment.take_difference();
  }
  if (segment.shift_p || segment.shift_q)
    (segment.shift_p ? segment.offset_p : segment.offset_q) = segment.shift_p ? -segment.shift : segment.shift;
  segment.find_singular_ends(true, 0, p);
  segment.find_singular_ends(false, 0, q);
  return segment;
}

/// The difference of the two motions, whose polynomials are in powers of the time since one origin.
void MotionSegment::take_difference() {
  if (angles) {
    exact_difference(std::get<AngleRotation>(q.rotation).angle, std::get<AngleRotation>(p.rotation).angle, turn,
                     turn_low);
  }
  degree = std::max(last_nonzero_power(q.x, p.x), last_nonzero_power(q.y, p.y));
  if (!shift_p && !shift_q) return;
  const Point a = pivot_of(p), b = pivot_of(q);
  exact_difference({coefficient(q.x, 0), b.x}, {coefficient(p.x, 0), a.x}, shift.x, shift.x_low, shift.x_rest);
  exact_difference({coefficient(q.y, 0), b.y}, {coefficient(p.y, 0), a.y}, shift.y, shift.y_low, shift.y_rest);
}

/// The same about the segment's middle, where the shift is D there, rounded to two doubles.
void MotionSegment::take_far_difference() {
  using Known = LocalPolynomials::Known;
  const auto local = std::make_shared<const LocalPolynomials>(start + (end - start) / 2);
  local_ = local;
  const auto difference = [&](const Coefficients& to, const Coefficients& from) {
    return local->exact(to, q.origin) + -local->exact(from, p.origin);
  };
  if (angles) {
    far_turn_ = std::make_shared<const Known>(
        Known::angle(difference(std::get<AngleRotation>(q.rotation).angle, std::get<AngleRotation>(p.rotation).angle)));
  }
  DyadicPolynomial x = difference(q.x, p.x), y = difference(q.y, p.y);
  degree = std::max<int>({static_cast<int>(x.size()) - 1, static_cast<int>(y.size()) - 1, 0});
  if (!shift_p && !shift_q) return;
  const auto way = [](DyadicPolynomial d, double to_pivot, double from_pivot, double& hi, double& low) {
    if (d.empty()) d.emplace_back();
    d[0] = d[0] + (Dyadic::exact(to_pivot) - Dyadic::exact(from_pivot));
    for (double* part : {&hi, &low}) {
      *part = nearest_double(d[0]);
      d[0] = d[0] - Dyadic::exact(*part);
    }
    trim(d);
    return Known(std::move(d));
  };
  const Point a = pivot_of(p), b = pivot_of(q);
  ways_ = std::make_shared<const std::array<Known, 2>>(std::array<Known, 2>{
      way(std::move(x), b.x, a.x, shift.x, shift.x_low), way(std::move(y), b.y, a.y, shift.y, shift.y_low)});
}

void MotionSegment::find_singular_ends(bool of_p, std::size_t link, const MotionPiece& piece) {
  const auto* cosine = std::get_if<CosineRotation>(&piece.rotation);
  if (!cosine) return;
  for (const double t : {start, end}) {
    if (auto singular = internal::singular_at(*cosine, piece.origin, t))
      singular_.push_back({of_p, link, std::make_shared<const SingularCosine>(std::move(*singular))});
  }
}

MotionSegment MotionSegment::bridging(const MotionPiece& p, const MotionPiece& q, const MotionPiece& p_next,
                                      const MotionPiece& q_next, double joint, bool far) {
  if (is_composed(p) || is_composed(q) || is_composed(p_next) || is_composed(q_next))
    return bridging_chains(PieceChain{p}, PieceChain{q}, PieceChain{p_next}, PieceChain{q_next}, joint, far);
  MotionSegment segment;
  segment.p = at_joint(p, joint);
  segment.q = at_joint(q, joint);
  segment.p_next = at_joint(p_next, joint);
  segment.q_next = at_joint(q_next, joint);
  segment.bridge = true;
  segment.joint = joint;
  segment.start = 0;
  segment.end = 1;
  if (far) segment.local_ = std::make_shared<const LocalPolynomials>(joint);
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
  segment.joint = joint;
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
