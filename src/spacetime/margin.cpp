#include "spacetime/margin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/interruption.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/closest.hpp"

namespace taut::spacetime {
namespace {

/// Boxes that move farther than this share of their size are left to shorter stretches of time.
constexpr double patience_of_margins = 0.75;
/// Stretches in which edges move less than so many times the error of their distance are not halved.
constexpr double errors_of_motion = 8;
/// So many stretches in a row may leave open whether the margin is kept.
constexpr int doubts = 256;

class LegMargin {
 public:
  LegMargin(const PairGeometry& geometry, const TreePair& trees, const Leg& leg, double margin, double to)
      : geometry_(geometry), trees_(trees), leg_(leg), margin_(margin), to_(to), polynomial_(leg) {}

  /// True if the search ends on this leg; `doubt_` is handed from leg to leg.
  bool run(MarginResult& result) {
    if (leg_.translation) {
      from_root(leg_.start, to_, result);
    } else if (!(leg_.start < to_)) {
      window_.emplace(leg_, leg_.start, leg_.end, leg_.end - leg_.start);
      from_root(leg_.start, to_, result);
    } else {
      for (double t = leg_.start; !done_;) {
        const double wanted = window_ ? 2 * window_->length() : to_ - leg_.start;
        window_.emplace(leg_, t, to_, std::min(wanted, to_ - leg_.start));
        from_root(t, window_->end(), result);
        t = window_->end();
        if (!(t < to_)) break;
      }
    }
    if (!done_ && doubt_) give_up(result);
    return done_;
  }

 private:
  struct NodePair {
    std::uint32_t p, q;
  };

  void from_root(double from, double to, MarginResult& result) {
    pairs_.assign(1, {0, 0});
    cover(0, from, to, 0, result);
  }
  Stretch stretch(double from, double to) {
    if (leg_.translation) return Stretch::of_translation(leg_, polynomial_, from, to);
    return window_->smooth() ? Stretch::of_window(leg_, *window_, from, to) : Stretch::of_range(leg_, *window_);
  }

  /// All pairs from `first` on, throughout [from, to], in order of time.
  void cover(std::size_t first, double from, double to, int depth, MarginResult& result) {
    const Stretch s = stretch(from, to);
    const double middle = from + (to - from) / 2;
    const bool divisible = from < middle && middle < to && depth < 60;
    const std::size_t last = pairs_.size();
    bool open = false;
    for (std::size_t i = first; i < last; ++i) {
      todo_.assign(1, pairs_[i]);
      while (!todo_.empty()) {
        interruption_point();
        const NodePair pair = todo_.back();
        todo_.pop_back();
        open = look(s, pair, from, divisible, result) || open;
      }
    }
    if (pairs_.size() > last && !done_) {
      cover(last, from, middle, depth + 1, result);
      if (!done_) cover(last, middle, to, depth + 1, result);
    } else if (!done_) {
      judge(open, from, result);
    }
    pairs_.resize(last);
  }

  /// A stretch is over that was not halved: has the margin been kept?
  void judge(bool open, double from, MarginResult& result) {
    if (!open) {
      if (doubt_) give_up(result);
      return;
    }
    if (!doubt_) doubt_ = from;
    if (++doubtful_ > doubts) give_up(result);
  }
  void give_up(MarginResult& result) {
    result.outcome = MarginResult::undecided;
    result.lo = *doubt_;
    done_ = true;
  }

  /// True if it stays open whether this pair keeps the margin in the stretch. Drops the pair if it does, divides it, or
  /// leaves it to the halves of the stretch.
  bool look(const Stretch& s, const NodePair& pair, double from, bool divisible, MarginResult& result) {
    if (done_) return false;
    const BoxNode &p = trees_.p.node(pair.p), &q = trees_.q.node(pair.q);
    const bool leaf = p.count == 1 && q.count == 1;
    const Path way = s.in_p.place(q.box.centre, p.box.centre);
    Vector towards{way.x.a, way.y.a};
    Closest found;
    if (leaf) {
      found = closest(s, VertexId(p.first), VertexId(geometry_.np + q.first));
      towards = found.on_q - found.on_p;
    }
    if (farther(s, p.box, q.box, towards, margin_)) return false;
    const double moves = motion(s, p.box, q.box);
    if (!leaf && moves <= patience_of_margins * (p.box.radius + q.box.radius)) {
      divide(pair, p, q);
      return false;
    }
    const bool worth_halving = divisible && (!leaf || moves > errors_of_motion * s.in_p.error);
    if (worth_halving) {
      pairs_.push_back(pair);
      return false;
    }
    // No direction is wrong by more than the stretch's error, so neither is the distance.
    const double distance = found.distance * (1 + 0x1p-48) + s.in_p.error;
    if (!(distance < margin_)) return true;
    result = {MarginResult::close,
              result.leg,
              doubt_.value_or(from),
              s.middle,
              VertexId(p.first),
              VertexId(geometry_.np + q.first),
              distance};
    done_ = true;
    return false;
  }

  void divide(const NodePair& pair, const BoxNode& p, const BoxNode& q) {
    if (q.count == 1 || (p.count > 1 && p.box.radius >= q.box.radius)) {
      todo_.push_back({p.right, pair.q});
      todo_.push_back({p.left, pair.q});
    } else {
      todo_.push_back({pair.p, q.right});
      todo_.push_back({pair.p, q.left});
    }
  }

  /// The nearest points of two edges in the middle of the stretch, in P's frame.
  Closest closest(const Stretch& s, VertexId of_p, VertexId of_q) const {
    const auto point = [&](VertexId v) { return Vector{geometry_.point(v).x, geometry_.point(v).y}; };
    const auto placed = [&](VertexId v) {
      const Path path = s.in_p.place(point(v), {0, 0});
      return Vector{path.x.a, path.y.a};
    };
    return Closest::of(point(of_p), point(geometry_.next(of_p)), placed(of_q), placed(geometry_.next(of_q)));
  }

  const PairGeometry& geometry_;
  TreePair trees_;
  const Leg& leg_;
  double margin_, to_;
  TranslationPolynomial polynomial_;
  std::optional<FrameWindow> window_;
  std::vector<NodePair> pairs_, todo_;
  std::optional<double> doubt_;  ///< since when it is open whether the margin is kept
  int doubtful_ = 0;
  bool done_ = false;
};

}  // namespace

MarginResult first_closer(const PairGeometry& geometry, const TreePair& trees, const std::vector<Leg>& legs,
                          double margin, double until) {
  MarginResult result;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    if (leg.bridge ? leg.joint > until : leg.start > until) break;
    result.leg = i;
    if (LegMargin(geometry, trees, leg, margin, leg.bridge ? leg.end : std::min(leg.end, until)).run(result))
      return result;
  }
  return result;
}

}  // namespace taut::spacetime
