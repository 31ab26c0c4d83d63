#include "spacetime/first_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "motion/placement.hpp"
#include "numeric/interruption.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/leaf_test.hpp"

namespace taut::spacetime {
namespace {

/// Two boxes, or a vertex and an edge, that are certainly apart before `free_until`.
struct Item {
  double free_until;
  std::uint32_t first, second;  ///< nodes of P's and Q's trees, or a vertex and an edge
  bool leaf;

  /// The heap's top is the earliest; ties by name, so that runs repeat.
  friend bool operator<(const Item& a, const Item& b) {
    if (a.free_until != b.free_until) return a.free_until > b.free_until;
    if (a.leaf != b.leaf) return a.leaf;
    return a.first != b.first ? a.first > b.first : a.second > b.second;
  }
};

/// A step shorter than this share of the window is not worth taking: smaller boxes see farther.
constexpr double worthwhile = 0x1p-4;

/// The search on one leg, window by window.
class LegSearch {
 public:
  LegSearch(const PairGeometry& geometry, const Hierarchy& p, const Hierarchy& q, const Leg& leg,
            std::vector<Item>& heap)
      : p_(p), q_(q), leg_(leg), leaves_(geometry, leg), heap_(heap), proved_(leg.start) {}

  /// The first contact on the leg.
  std::optional<Crossing> run() {
    double length = leg_.end - leg_.start;
    for (double t = leg_.start; t < leg_.end && !best_;) {
      FrameWindow window(leg_, t, leg_.end, length);
      search(window);
      length = window.length() * 2;
      t = window.end();
    }
    if (best_) leaves_.precise().tighten(*best_);
    return best_;
  }
  /// Up to when there is certainly no contact on the leg.
  double proved() const { return proved_; }
  void count(SpacetimeResult& result) {
    result.pairs += pairs_;
    result.roots += leaves_.roots();
    result.precise += leaves_.precise().calls();
  }

 private:
  void push(const Item& item) {
    heap_.push_back(item);
    std::push_heap(heap_.begin(), heap_.end());
  }
  /// What happens after this does not matter.
  double limit(const FrameWindow& window) const {
    return best_ ? std::min(window.end(), std::nextafter(best_->hi, std::numeric_limits<double>::infinity()))
                 : window.end();
  }
  void search(FrameWindow& window) {
    heap_.clear();
    push({window.start(), 0, 0, false});
    while (!heap_.empty()) {
      interruption_point();
      const Item item = heap_.front();
      proved_ = item.free_until;
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.pop_back();
      const double end = limit(window);
      if (item.free_until >= end) return;
      item.leaf ? advance_leaf(window, item, end) : advance_boxes(window, item, end);
    }
  }
  void advance_leaf(FrameWindow& window, const Item& item, double end) {
    const VertexEdge pair{VertexId(item.first), VertexId(item.second)};
    LeafProgress progress = leaves_.advance(window, pair, item.free_until, end);
    if (progress.contact) {
      if (!best_ || leaves_.precise().before(*progress.contact, *best_)) best_ = std::move(progress.contact);
    } else if (progress.free_until < end) {
      push({progress.free_until, item.first, item.second, true});
    }
  }
  void advance_boxes(FrameWindow& window, const Item& item, double end) {
    ++pairs_;
    const BoxNode &p = p_.node(item.first), &q = q_.node(item.second);
    const double t = apart_until(leg_, window, p.box, q.box, item.free_until, end);
    if (t >= end) return;
    if (t - item.free_until > worthwhile * window.length()) return push({t, item.first, item.second, false});
    split(item, p, q, t);
  }
  /// Of the two, the larger is divided. Two single edges become two leaves: each edge stands for its first vertex.
  void split(const Item& item, const BoxNode& p, const BoxNode& q, double t) {
    if (p.count == 1 && q.count == 1) {
      push({t, p.first, q.first, true});
      push({t, q.first, p.first, true});
    } else if (q.count == 1 || (p.count > 1 && p.box.size >= q.box.size)) {
      push({t, p.left, item.second, false});
      push({t, p.right, item.second, false});
    } else {
      push({t, item.first, q.left, false});
      push({t, item.first, q.right, false});
    }
  }

  const Hierarchy &p_, &q_;
  const Leg& leg_;
  LeafTest leaves_;
  std::vector<Item>& heap_;
  std::optional<Crossing> best_;
  double proved_;
  std::uint64_t pairs_ = 0;
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

SpacetimeResult first_contact(const PairGeometry& geometry, const std::vector<Leg>& legs) {
  SpacetimeResult result;
  const Hierarchy p(geometry, true), q(geometry, false);
  std::vector<Item> heap;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    LegSearch search(geometry, p, q, legs[i], heap);
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

}  // namespace taut::spacetime
