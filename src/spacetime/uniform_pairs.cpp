#include "spacetime/uniform_pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numeric/budget.hpp"
#include "spacetime/box_separation.hpp"

namespace taut::internal::spacetime {
namespace {

/// As in the search for one pair (first_contact.cpp).
constexpr double subdivision_threshold_among = 0.75;
/// If any contact suffices, edges are deferred to shorter stretches down to this share of the whole. Such a stretch
/// shows that they miss, or has an overlap in its middle, long before a model of the motion could be made.
constexpr double among_shallow = 0x1p-8;
/// The maximum number of deferrals in a search: edges that slide on edges never miss, however short the stretch.
constexpr int most_put_off = 40;

}  // namespace

const MotionSegment& UniformSegment::segment() const {
  if (segment_) return *segment_;
  const PieceChain rests{MotionPiece{}};
  segment_ = MotionSegment::motion_of_chains(p_.empty() ? rests : p_, q_.empty() ? rests : q_, start_, end_);
  return *segment_;
}

std::optional<UniformPairsSearch::Found> UniformPairsSearch::run(const UniformSegment& segment,
                                                                 std::span<const Other> others, const Hierarchy& mover,
                                                                 double from, double to, bool any) {
  segment_ = &segment;
  others_ = others;
  mover_ = &mover;
  any_ = any;
  shortest_ = shortest_stretch * (to - from);
  shallow_ = among_shallow * (to - from);
  put_off_ = 0;
  proved_ = from;
  best_.reset();
  pairs_.clear();
  for (std::uint32_t i = 0; i < others.size(); ++i) pairs_.push_back({i, 0, 0});
  cover(0, from, to);
  return best_;
}

/// Searches all of [start, end] for the pairs from `first` on. Earlier pairs belong to longer stretches.
void UniformPairsSearch::cover(std::size_t first, double start, double end) {
  if (best_ && (any_ || start > best_->hi)) return;
  proved_ = best_ ? proved_ : start;
  UniformStretch s = segment_->stretch(start, end);
  const double middle = start + (end - start) / 2;
  const bool divisible = s.r() > shortest_ && start < middle && middle < end;
  const std::size_t last = pairs_.size();
  windows_.clear();
  middle_.reset();
  for (std::size_t i = first; i < last && !ended(); ++i) {
    todo_.assign(1, pairs_[i]);
    while (!todo_.empty() && !ended()) {
      checkpoint();
      const Boxes pair = todo_.back();
      todo_.pop_back();
      evaluate(s, pair, start, end, divisible);
    }
  }
  if (pairs_.size() > last) {
    cover(last, start, middle);
    cover(last, middle, end);
  }
  pairs_.resize(last);
}

/// Drops the pair if it is disjoint throughout. Otherwise divides it, or defers it to the halves of the stretch.
void UniformPairsSearch::evaluate(UniformStretch& even, const Boxes& pair, double start, double end, bool divisible) {
  const Other& other = others_[pair.other];
  const BoxNode &p = other.tree->node(pair.p), &q = mover_->node(pair.q);
  const Stretch& s = even.near(p.box);
  if (apart(s, p.box, q.box)) return;
  const bool leaf = p.count == 1 && q.count == 1;
  if (divisible && (motion(s, p.box, q.box) > subdivision_threshold_among * (p.box.radius + q.box.radius) ||
                    (leaf && apart_around_middle(s, worth_trying, p.box, q.box)))) {
    pairs_.push_back(pair);
  } else if (leaf) {
    const VertexId of_p(p.first), of_q(other.geometry->np + q.first);
    if (any_ && crosses_in_the_middle(s, pair.other, of_p, of_q)) return;
    if (any_ && divisible && s.r > shallow_ && put_off_ < most_put_off) {
      if (miss(s, *other.geometry, of_p, of_q)) return;
      ++put_off_;
      pairs_.push_back(pair);
      return;
    }
    resolve(s, s.in_q, pair.other, {of_p, of_q}, start, end);
    resolve(s, s.in_p, pair.other, {of_q, of_p}, start, end);
  } else if (divides_first(p, q)) {
    todo_.push_back({pair.other, p.right, pair.q});
    todo_.push_back({pair.other, p.left, pair.q});
  } else {
    todo_.push_back({pair.other, pair.p, q.right});
    todo_.push_back({pair.other, pair.p, q.left});
  }
}

/// Do both first vertices of two edges certainly miss the other edge?
bool UniformPairsSearch::miss(const Stretch& s, const PairGeometry& g, VertexId of_p, VertexId of_q) {
  const auto place = [&g](VertexId v) { return Vector{g.point(v).x, g.point(v).y}; };
  return misses(s, s.in_q, place(of_p), place(of_q), place(g.next(of_q))) &&
         misses(s, s.in_p, place(of_q), place(of_p), place(g.next(of_p)));
}

/// If any contact suffices, an overlap in the middle proves that there is one before it, and is far cheaper to find
/// than the instant of contact.
bool UniformPairsSearch::crosses_in_the_middle(const Stretch& s, std::uint32_t other, VertexId of_p, VertexId of_q) {
  if (!middle_) middle_ = QAtPose::of(segment_->instant(s.middle));
  if (edges_cross(*middle_, *others_[other].geometry, of_p, of_q) != EdgesCross::yes) return false;
  best_ = Found{other, proved_, s.middle};
  return true;
}

/// The window around t for the leaves of the stretch that ends at `end`. All other bodies share it.
FrameWindow& UniformPairsSearch::window_at(double t, double end) {
  for (FrameWindow& w : windows_) {
    if (w.start() <= t && t < w.end()) return w;
  }
  return windows_.emplace_back(segment_->segment(), t, end, end - t);
}

void UniformPairsSearch::resolve(const Stretch& s, const RelativePose& relative_pose, std::uint32_t other,
                                 const VertexEdge& pair, double start, double end) {
  if (ended()) return;
  const PairGeometry& g = *others_[other].geometry;
  const DisplacedPoint &v = g.point(pair.vertex), &a = g.point(pair.edge), &b = g.point(g.next(pair.edge));
  if (misses(s, relative_pose, {v.x, v.y}, {a.x, a.y}, {b.x, b.y})) return;
  LeafTest leaves(g, segment_->segment());
  const double limit = best_ ? std::min(end, std::nextafter(best_->hi, INFINITY)) : end;
  for (double t = start, next = end; t < limit; t = next) {
    FrameWindow& window = window_at(t, end);
    next = std::min(end, window.end());
    std::optional<Crossing> found = leaves.first(window, pair, t, std::min(limit, next));
    if (!found) continue;
    note(leaves, other, *found);
    return;
  }
}

/// Every enclosure is refined as far as possible before it is compared, so the earliest beginning of all of them is
/// proved.
void UniformPairsSearch::note(LeafTest& leaves, std::uint32_t other, Crossing& found) {
  if (any_) {
    best_ = Found{other, std::min(proved_, found.lo), found.hi};
    return;
  }
  leaves.precise().tighten(found);
  if (!best_ || found.lo < best_->lo) best_ = Found{other, found.lo, found.hi};
}

bool apart(const Stretch& stretch, const Hierarchy& p, const Hierarchy& q) {
  std::vector<std::array<std::uint32_t, 2>> todo{{0, 0}};
  while (!todo.empty()) {
    const auto [i, j] = todo.back();
    todo.pop_back();
    const BoxNode &a = p.node(i), &b = q.node(j);
    if (apart(stretch, a.box, b.box)) continue;
    if (a.count == 1 && b.count == 1) return false;
    if (divides_first(a, b)) {
      todo.insert(todo.end(), {{a.left, j}, {a.right, j}});
    } else {
      todo.insert(todo.end(), {{i, b.left}, {i, b.right}});
    }
  }
  return true;
}

}  // namespace taut::internal::spacetime
