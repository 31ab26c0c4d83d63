#include "spacetime/first_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/interruption.hpp"
#include "numeric/undecided.hpp"
#include "pair/placement.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/leaf_test.hpp"
#include "taut/check.hpp"

namespace taut::spacetime {
namespace {

/// Two boxes, as nodes of P's and Q's trees.
struct BoxPair {
  std::uint32_t p, q;
};

/// Boxes that move farther than this share of their size are left to shorter stretches of time; others are divided.
constexpr double patience = 0.75;
/// Two edges that are apart in this middle share of a stretch will be so throughout in a few halvings.
constexpr double hopeful = 0x1p-5;
/// Stretches as short as this share of the leg are not divided any more.
constexpr double shortest_stretch = 0x1p-40;
/// After a window could not be made longer than the one before, this many do not try to be.
constexpr int windows_before_growing = 8;

/// The search on one leg. Stretches of time are halved, each with the pairs of boxes that are not yet proved apart in
/// it, and worked on in their order: the motion is evaluated once for all pairs of a stretch.
class LegSearch {
 public:
  /// On [from, to] of the leg's parameter.
  LegSearch(const PairGeometry& geometry, const Hierarchy& p, const Hierarchy& q, const Leg& leg, double from,
            double to, Ways ways = Ways::into)
      : geometry_(geometry),
        p_(p),
        q_(q),
        leg_(leg),
        leaves_(geometry, leg, ways),
        ways_(ways),
        polynomial_(leg),
        from_(from),
        to_(to),
        shortest_(shortest_stretch * (leg.end - leg.start)),
        proved_(from) {}

  /// The first contact.
  std::optional<Crossing> run() {
    if (leg_.translation) {
      start(from_, to_);
    } else {
      for (double t = from_; t < to_ && !best_; t = window_->end()) {
        next_window(t);
        start(t, window_->end());
      }
    }
    if (best_) leaves_.precise().tighten(*best_);
    return best_;
  }
  /// All crossings instead, each once.
  std::vector<Crossing> run_through() {
    run();
    for (Crossing& c : found_) leaves_.precise().tighten(c);
    return std::move(found_);
  }
  /// Up to when there is certainly no contact.
  double proved() const { return proved_; }
  void count(SpacetimeResult& result) {
    result.pairs += looks_;
    result.roots += leaves_.roots();
    result.precise += leaves_.precise().calls();
  }

 private:
  /// The next window of a leg that turns. Motions seldom change their character: the last length will do.
  void next_window(double start) {
    const double whole = to_ - from_;
    double wanted = whole;
    if (window_) wanted = std::min(whole, window_->length() * (window_->smooth() && resting_ > 0 ? 1 : 2));
    window_.emplace(leg_, start, to_, wanted);
    resting_ = window_->length() < 0.75 * wanted ? windows_before_growing : std::max(0, resting_ - 1);
  }
  /// The window around t for the leaves of the stretch that ends at `end`.
  FrameWindow& window_at(double t, double end) {
    if (!leg_.translation) return *window_;
    for (FrameWindow& w : leaf_windows_) {
      if (w.start() <= t && t < w.end()) return w;
    }
    return leaf_windows_.emplace_back(leg_, t, end, end - t);
  }
  void start(double from, double to) {
    pairs_.assign(1, {0, 0});
    cover(0, from, to);
  }
  Stretch stretch(double start, double end) {
    if (leg_.translation) return Stretch::of_translation(leg_, polynomial_, start, end);
    return window_->smooth() ? Stretch::of_window(leg_, *window_, start, end) : Stretch::of_range(leg_, *window_);
  }
  /// What happens after this does not matter.
  double limit(double end) const {
    return best_ ? std::min(end, std::nextafter(best_->hi, std::numeric_limits<double>::infinity())) : end;
  }

  /// All of [start, end], for the pairs from `first` on. Those before belong to longer stretches.
  void cover(std::size_t first, double start, double end) {
    if (best_ && start > best_->hi) return;
    proved_ = best_ ? proved_ : start;
    const Stretch s = stretch(start, end);
    const double middle = start + (end - start) / 2;
    const bool divisible = s.r > shortest_ && start < middle && middle < end;
    const std::size_t last = pairs_.size();
    leaf_windows_.clear();
    for (std::size_t i = first; i < last; ++i) {
      todo_.assign(1, pairs_[i]);
      while (!todo_.empty()) {
        interruption_point();
        const BoxPair pair = todo_.back();
        todo_.pop_back();
        look(s, pair, start, end, divisible);
      }
    }
    if (pairs_.size() > last) {
      cover(last, start, middle);
      cover(last, middle, end);
    }
    pairs_.resize(last);
  }
  /// Drops the pair if it is apart throughout, else divides it, or leaves it to the halves of the stretch.
  void look(const Stretch& s, const BoxPair& pair, double start, double end, bool divisible) {
    ++looks_;
    const BoxNode &p = p_.node(pair.p), &q = q_.node(pair.q);
    if (apart(s, p.box, q.box)) return;
    const bool leaf = p.count == 1 && q.count == 1;
    if (divisible && (motion(s, p.box, q.box) > patience * (p.box.radius + q.box.radius) ||
                      (leaf && apart_around_middle(s, hopeful, p.box, q.box)))) {
      pairs_.push_back(pair);
    } else if (leaf) {
      // Each edge stands for its first vertex.
      const VertexId of_p(p.first), of_q(geometry_.np + q.first);
      settle(s, s.in_q, {of_p, of_q}, start, end);
      settle(s, s.in_p, {of_q, of_p}, start, end);
    } else if (q.count == 1 || (p.count > 1 && p.box.radius >= q.box.radius)) {
      todo_.push_back({p.right, pair.q});
      todo_.push_back({p.left, pair.q});
    } else {
      todo_.push_back({pair.p, q.right});
      todo_.push_back({pair.p, q.left});
    }
  }
  /// The pair's first contact within [start, end] becomes the best if it is.
  void settle(const Stretch& s, const Carriage& carriage, const VertexEdge& pair, double start, double end) {
    const DisplacedPoint &v = geometry_.point(pair.vertex), &a = geometry_.point(pair.edge),
                         &b = geometry_.point(geometry_.next(pair.edge));
    if (misses(s, carriage, {v.x, v.y}, {a.x, a.y}, {b.x, b.y})) return;
    for (double t = start, next = end; t < limit(end); t = next) {
      FrameWindow& window = window_at(t, end);
      next = std::min(end, window.end());
      std::optional<Crossing> found = leaves_.first(window, pair, t, limit(next));
      if (!found) continue;
      if (ways_ == Ways::both) {
        next = std::min(next, std::max(found->hi, std::nextafter(t, end)));
        found_.push_back(std::move(*found));
        continue;
      }
      if (!best_ || leaves_.precise().before(*found, *best_)) best_ = std::move(found);
      return;
    }
  }

  const PairGeometry& geometry_;
  const Hierarchy &p_, &q_;
  const Leg& leg_;
  LeafTest leaves_;
  Ways ways_;
  std::vector<Crossing> found_;
  TranslationPolynomial polynomial_;
  std::optional<FrameWindow> window_;      ///< around the stretch at hand, unless the leg is a translation:
  std::vector<FrameWindow> leaf_windows_;  ///< then the leaves of a stretch make their own
  int resting_ = 0;
  std::vector<BoxPair> pairs_, todo_;
  std::optional<Crossing> best_;
  double from_, to_, shortest_, proved_;
  std::uint64_t looks_ = 0;
};

void note(const Crossing& found, std::size_t leg, double end, SpacetimeResult& result) {
  result.outcome = SpacetimeResult::contact;
  result.vertex = found.pair.vertex;
  result.edge = found.pair.edge;
  result.lo = found.lo;
  result.hi = std::min(found.hi, end);
  result.leg = leg;
}

}  // namespace

namespace {

/// What of a leg lies in the window, as an interval of its parameter.
std::optional<TimeInterval> clipped(const Leg& leg, const TimeWindow& window) {
  if (leg.bridge) {
    if (leg.joint > window.from && leg.joint <= window.to) return TimeInterval{leg.start, leg.end};
    return std::nullopt;
  }
  const double from = std::max(leg.start, window.from), to = std::min(leg.end, window.to);
  if (from < to || (from == to && window.first)) return TimeInterval{from, to};
  return std::nullopt;
}

}  // namespace

SpacetimeResult first_contact(const PairGeometry& geometry, const TreePair& trees, const std::vector<Leg>& legs) {
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  return first_contact(geometry, trees, legs, {-everywhere, everywhere, true});
}

SpacetimeResult first_contact(const PairGeometry& geometry, const TreePair& trees, const std::vector<Leg>& legs,
                              const TimeWindow& window) {
  SpacetimeResult result;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const std::optional<TimeInterval> part = clipped(legs[i], window);
    if (!part) continue;
    LegSearch search(geometry, trees.p, trees.q, legs[i], part->lo, part->hi);
    try {
      const std::optional<Crossing> found = search.run();
      search.count(result);
      if (!found) continue;
      note(*found, i, legs[i].end, result);
      return result;
    } catch (const Undecidable& limit) {
      result.reason = not_decided(limit);
    } catch (const Interrupted& limit) {
      result.reason = limit.reason;
    }
    search.count(result);
    result.outcome = SpacetimeResult::undecided;
    result.leg = i;
    result.lo = search.proved();
    return result;
  }
  result.outcome = SpacetimeResult::free;
  return result;
}

std::vector<LegCrossing> all_crossings(const PairGeometry& geometry, const TreePair& trees,
                                       const std::vector<Leg>& legs) {
  std::vector<LegCrossing> all;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    LegSearch search(geometry, trees.p, trees.q, legs[i], legs[i].start, legs[i].end, Ways::both);
    for (const Crossing& c : search.run_through()) all.push_back({c.pair.vertex, c.pair.edge, c.out, i, c.lo, c.hi});
  }
  return all;
}

}  // namespace taut::spacetime
