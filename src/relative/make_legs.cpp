#include "relative/make_legs.hpp"

#include <algorithm>
#include <limits>

#include "motion/far_pieces.hpp"

namespace taut {

std::vector<Leg> make_legs(const std::vector<MotionPiece>& p, const std::vector<MotionPiece>& q, double start,
                           double end) {
  std::vector<Leg> legs;
  legs.reserve(2 * (p.size() + q.size()));
  std::size_t i = 0, j = 0;
  double t = start;
  // After a change of one body's plan, the other one may be in a later piece already.
  while (p[i].until <= t) ++i;
  while (q[j].until <= t) ++j;
  for (;;) {
    const double until = std::min({p[i].until, q[j].until, end});
    legs.push_back(Leg::motion(p[i], q[j], t, until));
    if (until >= end) return legs;
    t = until;
    const std::size_t old_i = i, old_j = j;
    while (p[i].until <= t) ++i;
    while (q[j].until <= t) ++j;
    if (!same_motion(p[old_i], p[i]) || !same_motion(q[old_j], q[j])) {
      const bool far = legs.back().far() || is_far_for(std::max(highest_power(p[i]), highest_power(q[j])), t,
                                                       std::min({p[i].until, q[j].until, end}));
      legs.push_back(Leg::bridging(p[old_i], q[old_j], p[i], q[j], t, far));
    }
  }
}

namespace {

/// Where a chain of motions is: the piece that each of them follows.
class ChainPlace {
 public:
  explicit ChainPlace(const MotionChain& motions) : motions_(motions), at_(motions.size(), 0) {}

  void advance(double t) {
    for (std::size_t i = 0; i < motions_.size(); ++i) {
      while (motions_[i][at_[i]].until <= t) ++at_[i];
    }
  }
  double until() const {
    double t = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < motions_.size(); ++i) t = std::min(t, motions_[i][at_[i]].until);
    return t;
  }
  PieceChain pieces() const {
    PieceChain chain;
    for (std::size_t i = 0; i < motions_.size(); ++i) chain.push_back(motions_[i][at_[i]]);
    return chain;
  }

 private:
  const MotionChain& motions_;
  std::vector<std::size_t> at_;
};

bool same_motions(const PieceChain& a, const PieceChain& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_motion);
}

}  // namespace

std::vector<Leg> make_legs(const MotionChain& p, const MotionChain& q, double start, double end) {
  if (p.size() == 1 && q.size() == 1) return make_legs(p[0], q[0], start, end);
  std::vector<Leg> legs;
  ChainPlace at_p(p), at_q(q);
  at_p.advance(start);
  at_q.advance(start);
  for (double t = start;;) {
    const PieceChain old_p = at_p.pieces(), old_q = at_q.pieces();
    const double until = std::min({at_p.until(), at_q.until(), end});
    legs.push_back(Leg::motion_of_chains(old_p, old_q, t, until));
    if (until >= end) return legs;
    t = until;
    at_p.advance(t);
    at_q.advance(t);
    const PieceChain new_p = at_p.pieces(), new_q = at_q.pieces();
    if (!same_motions(old_p, new_p) || !same_motions(old_q, new_q)) {
      const bool far = legs.back().far() || is_far_for(std::max(highest_power(new_p), highest_power(new_q)), t,
                                                       std::min({at_p.until(), at_q.until(), end}));
      legs.push_back(Leg::bridging_chains(old_p, old_q, new_p, new_q, t, far));
    }
  }
}

}  // namespace taut
