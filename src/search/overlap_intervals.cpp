#include "search/overlap_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "base/interruption.hpp"
#include "search/pair_search.hpp"
#include "sign/witness.hpp"
#include "spacetime/first_contact.hpp"

namespace taut {
namespace {

using spacetime::LegCrossing;

/// Crossings that enclosures do not tell apart.
struct Cluster {
  double lo, hi;  ///< in the world's time
  LegCrossing first, last;
};

class IntervalSearch {
 public:
  IntervalSearch(const WorldPlan& plan, int a, int b, bool inwards)
      : plan_(plan), pair_(plan, a, b, inwards), inwards_(inwards), bodies_{a, b} {}

  std::vector<OverlapInterval> run() {
    find_clusters();
    bool inside = overlapping_at(plan_.start());
    if (inside) begin({plan_.start(), plan_.start()}, std::nullopt);
    for (std::size_t i = 0; i < clusters_.size(); ++i) {
      interruption_point();
      const Cluster& c = clusters_[i];
      const double next = i + 1 < clusters_.size() ? clusters_[i + 1].lo : plan_.end();
      const bool after = c.hi < next ? overlapping_at(c.hi + (next - c.hi) / 2) : inside_at_end(c, inside);
      // Free on both sides, with a crossing: an overlap shorter than doubles tell.
      if (!inside) begin({c.lo, c.hi}, contact_of(c.first));
      if (!after) end({c.lo, c.hi}, contact_of(c.last));
      inside = after;
    }
    if (inside) end({plan_.end(), plan_.end()}, std::nullopt);
    return std::move(found_);
  }

 private:
  void find_clusters() {
    std::vector<LegCrossing> all = all_crossings(pair_.geometry, pair_.trees(), pair_.legs());
    const auto time = [this](const LegCrossing& c, double parameter) {
      return std::clamp(pair_.legs()[c.leg].time(parameter), plan_.start(), plan_.end());
    };
    std::sort(all.begin(), all.end(), [](const LegCrossing& a, const LegCrossing& b) {
      return std::pair(a.leg, a.lo) < std::pair(b.leg, b.lo);
    });
    for (const LegCrossing& c : all) {
      const double lo = time(c, c.lo), hi = time(c, c.hi);
      // Some double must lie strictly between, at which the overlap can be asked for.
      if (!clusters_.empty() && !(std::nextafter(clusters_.back().hi, plan_.end()) < lo)) {
        clusters_.back().hi = std::max(clusters_.back().hi, hi);
        clusters_.back().last = c;
      } else {
        clusters_.push_back({lo, hi, c, c});
      }
    }
  }
  /// At an instant that no crossing is at.
  bool overlapping_at(double t) const {
    const auto leg = std::find_if(pair_.legs().begin(), pair_.legs().end(),
                                  [t](const Leg& l) { return !l.bridge && l.start <= t && t <= l.end; });
    return spacetime::overlapping(pair_.geometry, pair_.trees(), *leg, t).has_value();
  }
  /// Crossings up to the very end: nothing is left after them.
  bool inside_at_end(const Cluster& c, bool before) const { return c.first.out == c.last.out ? !c.last.out : before; }

  std::optional<Contact> contact_of(const LegCrossing& c) const {
    return Witness(pair_.plan, pair_.geometry, inwards_).contact({c.vertex, c.edge, c.lo, c.hi}, pair_.legs()[c.leg]);
  }
  void begin(const TimeInterval& from, const std::optional<Contact>& enter) {
    OverlapInterval next;
    next.pair = bodies_;
    next.from = from;
    next.enter = enter;
    found_.push_back(next);
  }
  void end(const TimeInterval& to, const std::optional<Contact>& exit) {
    found_.back().to = to;
    found_.back().exit = exit;
  }

  const WorldPlan& plan_;
  PairSearch pair_;
  bool inwards_;
  std::array<BodyId, 2> bodies_;
  std::vector<Cluster> clusters_;
  std::vector<OverlapInterval> found_;
};

}  // namespace

std::vector<OverlapInterval> overlap_intervals(const WorldPlan& plan, int a, int b, bool inwards) {
  return IntervalSearch(plan, a, b, inwards).run();
}

}  // namespace taut
