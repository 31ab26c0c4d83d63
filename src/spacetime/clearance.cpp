#include "spacetime/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/closest.hpp"

namespace taut::spacetime {
namespace {

struct NodePair {
  std::uint32_t p, q;
};

/// Boxes that move farther than this share of their size are left to shorter stretches of time.
constexpr double patience_of_clearance = 0.75;
/// In stretches shorter than this share of the leg, errors have become as small as they get.
constexpr double shortest_of_clearance = 0x1p-30;
/// An error that is no more than this share of all lengths is that of rounding, and does not shrink with the stretch.
constexpr double error_of_rounding = 0x1p-42;
/// Of the windows in which the frame at an instant is computed, as a share of the leg.
constexpr double length_of_instant = 0x1p-20;

class LegClearance {
 public:
  LegClearance(const PairGeometry& geometry, const TreePair& trees, const Leg& leg, std::size_t index,
               const TimeWindow& window, const ClearanceTolerance& tolerance, Nearest& best)
      : geometry_(geometry),
        trees_(trees),
        leg_(leg),
        index_(index),
        from_(window.from),
        to_(window.to),
        tolerance_(tolerance),
        best_(best),
        polynomial_(leg) {}

  void run() {
    if (leg_.translation) return from_root(from_, to_);
    if (!(from_ < to_)) return at_instant();
    for (double t = from_;;) {
      const double wanted = window_ ? 2 * window_->length() : to_ - from_;
      window_.emplace(leg_, t, to_, std::min(wanted, to_ - from_));
      from_root(t, window_->end());
      t = window_->end();
      if (!(t < to_)) break;
    }
  }

 private:
  /// Windows have a length: this one begins with the instant, or ends with the leg. Where the motion is singular, it
  /// moves the less the shorter the window is.
  void at_instant() {
    for (double some = (leg_.end - leg_.start) * length_of_instant;; some *= 0x1p-10) {
      window_.emplace(leg_, std::max(leg_.start, std::min(from_, leg_.end - some)), leg_.end, some);
      while (window_->end() < from_) window_.emplace(leg_, window_->end(), leg_.end, some);
      if (window_->smooth() || some < (leg_.end - leg_.start) * 0x1p-45) break;
    }
    from_root(from_, from_);
  }
  void from_root(double from, double to) {
    pairs_.assign(1, {0, 0});
    cover(0, from, to, 0);
  }
  Stretch stretch(double from, double to) {
    if (leg_.translation) return Stretch::of_translation(leg_, polynomial_, from, to);
    return window_->smooth() ? Stretch::of_window(leg_, *window_, from, to) : Stretch::of_range(leg_, *window_);
  }
  /// All pairs from `first` on, throughout [from, to].
  void cover(std::size_t first, double from, double to, int depth) {
    const Stretch s = stretch(from, to);
    const double middle = from + (to - from) / 2;
    const bool divisible = from < middle && middle < to && depth < 60;
    const std::size_t last = pairs_.size();
    for (std::size_t i = first; i < last; ++i) {
      todo_.assign(1, pairs_[i]);
      while (!todo_.empty()) {
        interruption_point();
        const NodePair pair = todo_.back();
        todo_.pop_back();
        look(s, pair, divisible);
      }
    }
    if (pairs_.size() > last) {
      cover(last, from, middle, depth + 1);
      cover(last, middle, to, depth + 1);
    }
    pairs_.resize(last);
  }
  void look(const Stretch& s, const NodePair& pair, bool divisible) {
    const BoxNode &p = trees_.p.node(pair.p), &q = trees_.q.node(pair.q);
    const bool leaf = p.count == 1 && q.count == 1;
    const Path way = s.in_p.place(q.box.centre, p.box.centre);
    Vector towards{way.x.a, way.y.a};
    if (leaf) towards = measure(s, VertexId(p.first), VertexId(geometry_.np + q.first));
    if (farther(s, p.box, q.box, towards, tolerance_.least(best_.distance))) return;
    if (leaf || motion(s, p.box, q.box) > patience_of_clearance * (p.box.radius + q.box.radius)) {
      if (divisible && !(leaf && is_resolved(s, p.box, q.box, towards))) pairs_.push_back(pair);
      if (!divisible && !(leaf && is_resolved(s, p.box, q.box, towards))) best_.unresolved = 0;
    } else if (q.count == 1 || (p.count > 1 && p.box.radius >= q.box.radius)) {
      descend({p.right, pair.q}, {p.left, pair.q}, s);
    } else {
      descend({pair.p, q.right}, {pair.p, q.left}, s);
    }
  }
  /// Are the bounds of doubles all that keeps the two from being farther apart than the tolerance wants? Then still
  /// shorter stretches would not help, and what is certain is noted. Neither would they where next to nothing moves: on
  /// a bridge, say, all over which bodies may nearly touch.
  bool is_resolved(const Stretch& s, const Box& p, const Box& q, Vector towards) {
    const bool is_short = s.r <= shortest_of_clearance * (leg_.end - leg_.start);
    const bool is_rounding = s.in_p.error <= error_of_rounding * s.in_p.reach;
    if (!is_short && !(is_rounding && motion(s, p, q) <= s.in_p.error)) return false;
    for (const double errors : {1, 2, 4, 8}) {
      const double margin = tolerance_.least(best_.distance) - errors * s.in_p.error;
      if (!farther(s, p, q, towards, margin)) continue;
      best_.unresolved = std::min(best_.unresolved, std::max(0.0, margin));
      return true;
    }
    return false;
  }
  /// The nearer one first: it may spare the other.
  void descend(const NodePair& a, const NodePair& b, const Stretch& s) {
    const auto distance = [&](const NodePair& pair) {
      const Path way = s.in_p.place(trees_.q.node(pair.q).box.centre, trees_.p.node(pair.p).box.centre);
      return way.x.a * way.x.a + way.y.a * way.y.a;
    };
    const bool first = distance(a) < distance(b);
    todo_.push_back(first ? b : a);
    todo_.push_back(first ? a : b);
  }
  /// The distance of two edges in the middle of the stretch; the direction of the shortest_of_clearance way, in P's
  /// frame.
  Vector measure(const Stretch& s, VertexId of_p, VertexId of_q) {
    const auto point = [&](VertexId v) { return Vector{geometry_.point(v).x, geometry_.point(v).y}; };
    const auto placed = [&](VertexId v) {
      const Path path = s.in_p.place(point(v), {0, 0});
      return Vector{path.x.a, path.y.a};
    };
    const Closest found =
        Closest::of(point(of_p), point(geometry_.next(of_p)), placed(of_q), placed(geometry_.next(of_q)));
    // No direction is wrong by more than the stretch's error, so neither is the distance.
    const double distance = found.distance * (1 + 0x1p-48) + s.in_p.error;
    if (distance < best_.distance) best_ = {distance, index_, s.middle, of_p, of_q, best_.unresolved};
    return found.on_q - found.on_p;
  }

  const PairGeometry& geometry_;
  TreePair trees_;
  const Leg& leg_;
  std::size_t index_;
  double from_, to_;
  ClearanceTolerance tolerance_;
  Nearest& best_;
  TranslationPolynomial polynomial_;
  std::optional<FrameWindow> window_;
  std::vector<NodePair> pairs_, todo_;
};

}  // namespace

void find_nearest(const PairGeometry& geometry, const TreePair& trees, const std::vector<Leg>& legs,
                  const ClearanceTolerance& tolerance, Nearest& best) {
  for (std::size_t i = 0; i < legs.size(); ++i)
    LegClearance(geometry, trees, legs[i], i, {legs[i].start, legs[i].end}, tolerance, best).run();
}

void find_nearest_within(const PairGeometry& geometry, const TreePair& trees, const std::vector<Leg>& legs, double from,
                         double to, const ClearanceTolerance& tolerance, Nearest& best) {
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const TimeWindow window{std::max(from, legs[i].start), std::min(to, legs[i].end)};
    if (legs[i].bridge || window.to < window.from) continue;
    LegClearance(geometry, trees, legs[i], i, window, tolerance, best).run();
  }
}

}  // namespace taut::spacetime
