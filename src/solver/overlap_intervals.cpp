#include "solver/overlap_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "certificate/feature_map.hpp"
#include "numeric/budget.hpp"
#include "solver/pair_solver.hpp"
#include "spacetime/crossing.hpp"
#include "spacetime/first_contact.hpp"

namespace taut::internal {
namespace {

using spacetime::SegmentCrossing;

/// Enclosures of this relative width are as tight as doubles allow.
constexpr double rounding_of_doubles = 0x1p-55;

/// Clusters with more doubles than this are chains of crossings. They are searched for freedom at the first ones only.
constexpr int most_doubles = 16;

/// Crossings that their enclosures do not separate.
struct Cluster {
  double lo, hi;  ///< in world time
  SegmentCrossing first, last;
  bool alone = true;  ///< first and last are one crossing, which may have a rough enclosure
};

class IntervalSearch {
 public:
  IntervalSearch(const Instance& instance, int a, int b, const std::vector<TimeInterval>& near, Offset offset,
                 bool precisely)
      : instance_(instance),
        near_(near),
        precisely_(precisely),
        pair_(instance, a, b, offset),
        offset_(offset),
        bodies_{a, b} {}

  std::vector<OverlapInterval> run() {
    find_clusters();
    bool inside = near_.front().lo == instance_.start() && overlapping_at(instance_.start());
    if (inside) begin_at(instance_.start());
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      checkpoint();
      Cluster& c = clusters_[i];
      const double next = i + 1 < clusters_.size() ? clusters_[i + 1].lo : instance_.end();
      // If crossings extend to the very end, no later instant is left. They need not be counted: a corner that leaves
      // may leave others inside, and of two crossings in one double only one is known.
      const bool after = overlapping_at(c.hi < next ? c.hi + (next - c.hi) / 2 : instance_.end());
      if (!inside || !after) tighten_ends(c);
      // The bodies are free on both sides of a crossing: an overlap shorter than doubles resolve.
      if (!inside) begin(c, c.first);
      if (!after) end(c, c.last);
      if (inside && after && free_within(c)) {
        end(c, c.first);
        begin(c, c.last);
      }
      inside = after;
    }
    if (inside) found_.back().to = {instance_.end(), instance_.end()};
    return std::move(found_);
  }

 private:
  std::vector<SegmentCrossing> crossings_until(double end) const {
    std::vector<spacetime::TimeWindow> windows;
    for (const TimeInterval& s : near_) {
      if (s.lo <= end) windows.push_back({s.lo, std::min(s.hi, end), s.lo == instance_.start()});
    }
    return all_crossings(pair_.geometry, pair_.trees(), pair_.segments(), windows);
  }
  /// Bodies that repeat their places without a crossing never have one.
  std::vector<SegmentCrossing> crossings() const {
    const double repeats = pair_.segments().repeats_from();
    if (repeats < instance_.end() / 2 + instance_.start() / 2 && crossings_until(repeats).empty()) return {};
    return crossings_until(instance_.end());
  }
  double time(const SegmentCrossing& c, double parameter) const {
    return std::clamp(pair_.segments()[c.segment].time(parameter), instance_.start(), instance_.end());
  }
  /// Some double must lie strictly between, at which the overlap can be evaluated.
  bool apart(double before, double after) const { return std::nextafter(before, instance_.end()) < after; }
  static void sort(std::span<SegmentCrossing> some) {
    std::stable_sort(some.begin(), some.end(), [](const SegmentCrossing& a, const SegmentCrossing& b) {
      return std::pair(a.segment, a.lo) < std::pair(b.segment, b.lo);
    });
  }
  void find_clusters() {
    std::vector<SegmentCrossing> all = crossings();
    if (precisely_) {
      tighten_all(all);
    } else {
      sort(all);
    }
    for (std::size_t i = 0, k = 0; i < all.size(); i = k) {
      double hi = time(all[i], all[i].hi);
      for (k = i + 1; k < all.size() && !apart(hi, time(all[k], all[k].lo)); ++k)
        hi = std::max(hi, time(all[k], all[k].hi));
      // Most crossings are isolated, and lie between others within an overlap. Precise instants are expensive.
      if (k > i + 1 || !(hi < instance_.end())) tighten_all({all.data() + i, k - i});
      add({all.data() + i, k - i});
    }
  }
  void tighten_all(std::span<SegmentCrossing> some) const {
    for (SegmentCrossing& c : some) {
      checkpoint();
      tighten(pair_.geometry, pair_.segments(), c, precisely_ ? 0 : rounding_of_doubles);
    }
    sort(some);
  }
  /// Adds ordered crossings as clusters.
  void add(std::span<const SegmentCrossing> some) {
    bool first = true;
    for (const SegmentCrossing& c : some) {
      const double lo = time(c, c.lo), hi = time(c, c.hi);
      if (!first && !apart(clusters_.back().hi, lo)) {
        clusters_.back().hi = std::max(clusters_.back().hi, hi);
        clusters_.back().last = c;
        clusters_.back().alone = false;
      } else {
        clusters_.push_back({lo, hi, c, c, true});
      }
      first = false;
    }
  }
  /// Tightens a cluster as required for an interval's end.
  void tighten_ends(Cluster& c) const {
    if (!c.alone) return;
    tighten(pair_.geometry, pair_.segments(), c.first, precisely_ ? 0 : rounding_of_doubles);
    c.last = c.first;
    c.lo = time(c.first, c.first.lo);
    c.hi = time(c.first, c.first.hi);
  }
  bool overlapping_at(double t) const {
    const MotionSegments& segments = pair_.segments();
    std::size_t k = segments.first_until(t);
    while (segments.place(k).bridge) ++k;
    return spacetime::overlapping(pair_.geometry, pair_.trees(), *segments.hold(k), t).has_value();
  }
  /// Is the vertex on the same side of the edge before and after? Then it crosses twice, of which one crossing is
  /// known.
  bool comes_back(const SegmentCrossing& c) const {
    if (!c.precise) return false;
    const std::shared_ptr<const MotionSegment> held = pair_.segments().hold(c.segment);
    spacetime::PreciseCrossings crossings(pair_.geometry, *held, spacetime::CrossingDirections::both);
    const spacetime::VertexEdge pair{c.vertex, c.edge};
    const double before = std::max(std::nextafter(c.lo, -INFINITY), held->start);
    const double after = std::min(std::nextafter(c.hi, INFINITY), held->end);
    return crossings.side(pair, before) == crossings.side(pair, after);
  }
  /// Between two crossings that doubles do not separate, the bodies may part and meet again. What lies between the
  /// overlaps is an instant of freedom if a double shows it.
  bool free_within(const Cluster& c) const {
    if (c.alone && !comes_back(c.first)) return false;
    double t = c.lo;
    for (int k = 0; k < most_doubles && t <= c.hi; ++k, t = std::nextafter(t, INFINITY)) {
      if (!overlapping_at(t)) return true;
    }
    return false;
  }
  Contact contact_of(const SegmentCrossing& c, Passage passage) const {
    Contact contact = FeatureMap(pair_.bodies, pair_.geometry, offset_)
                          .contact({c.vertex, c.edge, c.lo, c.hi}, pair_.segments()[c.segment], passage);
    contact.time = {std::max(contact.time.lo, instance_.start()), std::min(contact.time.hi, instance_.end())};
    return contact;
  }
  /// Encloses the time for the given bodies. If the displaced ones cross several times, it includes all crossings.
  TimeInterval bracket_of(const Cluster& c, const Contact& named, Passage passage) const {
    TimeInterval time{std::min(c.lo, named.time.lo), std::max(c.hi, named.time.hi)};
    if (c.alone) return time;
    const Contact other = contact_of(passage == Passage::enters ? c.last : c.first, passage);
    return {std::min(time.lo, other.time.lo), std::max(time.hi, other.time.hi)};
  }
  void begin_at(double t) {
    OverlapInterval next;
    next.pair = bodies_;
    next.from = {t, t};
    found_.push_back(next);
  }
  void begin(const Cluster& c, const SegmentCrossing& crossing) {
    OverlapInterval next;
    next.pair = bodies_;
    next.enter = contact_of(crossing, Passage::enters);
    next.from = bracket_of(c, *next.enter, Passage::enters);
    found_.push_back(next);
  }
  void end(const Cluster& c, const SegmentCrossing& crossing) {
    found_.back().exit = contact_of(crossing, Passage::leaves);
    found_.back().to = bracket_of(c, *found_.back().exit, Passage::leaves);
  }

  const Instance& instance_;
  const std::vector<TimeInterval>& near_;
  bool precisely_;
  PairInstance pair_;
  Offset offset_;
  std::array<BodyId, 2> bodies_;
  std::vector<Cluster> clusters_;
  std::vector<OverlapInterval> found_;
};

}  // namespace

std::vector<OverlapInterval> overlap_intervals(const Instance& instance, int a, int b,
                                               const std::vector<TimeInterval>& near, Offset offset, bool precisely) {
  if (near.empty()) return {};
  return IntervalSearch(instance, a, b, near, offset, precisely).run();
}

}  // namespace taut::internal
