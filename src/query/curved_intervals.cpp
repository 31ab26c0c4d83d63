// All intervals in which bodies with curves overlap.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "query/bracket.hpp"

namespace taut::internal {
namespace {

std::string time_words(double t) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", t);
  return text;
}

/// The results for one time interval from polygons around the bodies, and from polygons within them.
struct OverlapBracket {
  OverlapInterval outer;
  std::vector<OverlapInterval> inner;

  static bool narrow(const TimeInterval& a, const TimeInterval& b, double wanted) {
    const double lo = std::min(a.lo, b.lo), hi = std::max(a.hi, b.hi);
    return hi - lo <= std::max({wanted, 2 * (a.hi - a.lo), 0x1p-49 * std::fabs(hi)});
  }
  bool begin_decided(double wanted) const { return narrow(inner[0].from, outer.from, wanted); }
  bool end_decided(double wanted) const { return narrow(inner[0].to, outer.to, wanted); }
  bool decided(double wanted) const { return inner.size() == 1 && begin_decided(wanted) && end_decided(wanted); }
};

class CurvedIntervals {
 public:
  /// Ends are determined to the accuracy `wanted`, in time. With `in_windows`, each end is determined separately, once
  /// its approximate time is known.
  CurvedIntervals(const Scene& scene, const CheckOptions& options, double wanted, bool in_windows)
      : options_(options),
        run_(scene, options.limits),
        wanted_(wanted),
        in_windows_(in_windows),
        start_(scene.start),
        end_(scene.end) {}

  Intervals ask(CurveSide side) const {
    CheckOptions options = options_;
    options.limits = run_.limits_left();
    Scene polygons = run_.world().polygons(side);
    polygons.start = start_;
    polygons.end = end_;
    polygons.ignore.insert(polygons.ignore.end(), finished_.begin(), finished_.end());
    // Crossings within an overlap, of which finer polygons have ever more, need no precise instants.
    return intervals_of_polygons(polygons, options, false);
  }

  std::optional<Intervals> decided_by(const Intervals& outer) {
    const bool first = !std::exchange(is_begun_, true);
    if (first && outer.outcome == Outcome::untested) return outer;
    if (first) answer_.coverage = outer.coverage;
    return std::nullopt;
  }

  /// Nothing is decided of all pairs at once: refine() goes on with those that are open.
  std::optional<Intervals> decided_by(const Intervals&, const Intervals&) const { return std::nullopt; }

  /// Pairs are decided one after the other, and not tested again: others may need curves that are far finer.
  bool refine(const Intervals& outer, const Intervals& inner) {
    resolve_undecided(outer);
    resolve_undecided(inner);
    brackets_ = brackets_of(outer, inner);
    if (in_windows_) {
      for (OverlapBracket& bracket : brackets_) report_ends(bracket);
    }
    open_ = open_pairs(brackets_);
    Marks marks(run_.world());
    for (const OverlapBracket& bracket : brackets_) {
      if (open_.count(bracket.outer.pair) == 0) {
        resolve(bracket);
      } else if (!bracket.decided(wanted_)) {
        mark(bracket, marks);
      }
    }
    if (!run_.refine(std::move(marks))) return false;
    ask_only(open_);
    if (!in_windows_ && brackets_.size() == 1) shorten_window(brackets_[0]);
    return true;
  }

  Intervals too_fine(const Intervals&, const Intervals&) { return concluded(brackets_, open_); }

 private:
  /// Of a window around the only end in it: what is farther from that end than it is uncertain need not be asked about
  /// again. Finer polygons have many crossings there, within the overlap.
  void shorten_window(const OverlapBracket& bracket) {
    if (bracket.inner.size() != 1) return;
    const OverlapInterval &inner = bracket.inner[0], &outer = bracket.outer;
    if (inner.enter.has_value() == inner.exit.has_value()) return;
    const TimeInterval end =
        inner.enter ? TimeInterval{outer.from.lo, inner.from.hi} : TimeInterval{inner.to.lo, outer.to.hi};
    const double room = end.hi - end.lo;
    start_ = std::max(start_, end.lo - room);
    end_ = std::min(end_, end.hi + room);
  }

  /// Determines ends by polygons in short windows around them. These polygons are fine only where the two bodies meet
  /// then.
  void report_ends(OverlapBracket& bracket) {
    if (bracket.inner.size() != 1) return;
    OverlapInterval& inner = bracket.inner[0];
    // Longer windows would contain more than one end of the interval, or nearly so.
    constexpr double longest = 0.25;
    const double length = inner.to.lo - inner.from.hi, middle = inner.from.hi + length / 2;
    const double early = inner.from.hi - bracket.outer.from.lo, late = bracket.outer.to.hi - inner.to.lo;
    if (!bracket.begin_decided(wanted_) && early < longest * length) {
      const auto decided =
          decided_within(inner.pair, bracket.outer.from.lo - early, std::min(inner.from.hi + early, middle));
      if (decided && decided->enter && !decided->exit) {
        bracket.outer.from = inner.from = decided->from;
        inner.enter = decided->enter;
      }
    }
    if (!bracket.end_decided(wanted_) && late < longest * length) {
      const auto decided = decided_within(inner.pair, std::max(inner.to.lo - late, middle), bracket.outer.to.hi + late);
      if (decided && !decided->enter && decided->exit) {
        bracket.outer.to = inner.to = decided->to;
        inner.exit = decided->exit;
      }
    }
  }

  /// The only interval in which the two bodies overlap in a window. Its features have the names of their curves.
  std::optional<OverlapInterval> decided_within(const std::array<BodyId, 2>& pair, double from, double to) {
    std::vector<BodyId> ids;
    Scene scene = scene_of_pair(run_.world().scene(), pair, ids);
    scene.start = std::max(scene.start, from);
    scene.end = std::min(scene.end, to);
    CheckOptions options = options_;
    options.limits = run_.limits_left();
    CurvedIntervals window(scene, options, wanted_, false);
    Intervals found = bracketed(window);
    if (found.intervals.size() != 1 || !found.undecided.empty()) return std::nullopt;
    OverlapInterval decided = found.intervals[0];
    for (std::optional<Contact>* contact : {&decided.enter, &decided.exit}) {
      if (!*contact) continue;
      for (BodyId* id : {&(*contact)->vertex.body, &(*contact)->edge.body}) *id = ids[static_cast<std::size_t>(*id)];
      tolerance_ = std::max(tolerance_, found.geometry->tolerance);
      segments_ = std::max(segments_, found.geometry->segments);
    }
    return decided;
  }

  /// The pairs with an end that is not determined accurately.
  std::set<std::array<BodyId, 2>> open_pairs(const std::vector<OverlapBracket>& brackets) const {
    std::set<std::array<BodyId, 2>> open;
    for (const OverlapBracket& bracket : brackets) {
      if (!bracket.decided(wanted_)) open.insert(bracket.outer.pair);
    }
    return open;
  }

  void resolve_undecided(const Intervals& found) {
    for (const PairAnswer& pair : found.undecided) {
      if (undecided_.insert(pair.bodies).second) answer_.undecided.push_back(pair);
    }
  }

  /// Must be called while the polygons are those of the result.
  void resolve(const OverlapBracket& bracket) {
    if (undecided_.count(bracket.outer.pair) == 0) answer_.intervals.push_back(named(bracket));
  }

  void ask_only(const std::set<std::array<BodyId, 2>>& open) {
    finished_.clear();
    const std::vector<Body>& bodies = run_.world().scene().bodies;
    const int n = static_cast<int>(bodies.size());
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) {
        if (open.count({a, b}) == 0 || undecided_.count({a, b}) > 0)
          finished_.push_back({bodies[static_cast<std::size_t>(a)].name, bodies[static_cast<std::size_t>(b)].name});
      }
    }
  }

  static std::vector<OverlapBracket> brackets_of(const Intervals& outer, const Intervals& inner) {
    std::vector<OverlapBracket> brackets;
    for (const OverlapInterval& o : outer.intervals) {
      brackets.push_back({o, {}});
      for (const OverlapInterval& i : inner.intervals) {
        if (i.pair == o.pair && i.from.hi >= o.from.lo && i.to.lo <= o.to.hi) brackets.back().inner.push_back(i);
      }
    }
    return brackets;
  }

  /// Marks cells near the ends that are not determined accurately, and in the middle if nothing is known there.
  void mark(const OverlapBracket& bracket, Marks& marks) const {
    const OverlapInterval& o = bracket.outer;
    const bool one = bracket.inner.size() == 1;
    std::vector<double> instants;
    if (!one || !bracket.begin_decided(wanted_)) instants.push_back(o.from.lo);
    if (!one || !bracket.end_decided(wanted_)) instants.push_back(o.to.hi);
    if (bracket.inner.empty()) instants.push_back(o.from.lo + (o.to.hi - o.from.lo) / 2);
    for (const OverlapInterval& i : bracket.inner) {
      if (!one || !bracket.begin_decided(wanted_)) instants.push_back(i.from.hi);
      if (!one || !bracket.end_decided(wanted_)) instants.push_back(i.to.lo);
    }
    const Scene& scene = run_.world().scene();
    for (const double t : instants) marks.near(o.pair, std::clamp(t, scene.start, scene.end));
  }

  Intervals concluded(const std::vector<OverlapBracket>& brackets, const std::set<std::array<BodyId, 2>>& open) {
    for (const OverlapBracket& bracket : brackets) {
      const OverlapInterval& outer = bracket.outer;
      if (open.count(outer.pair) == 0 || bracket.decided(wanted_) || !undecided_.insert(outer.pair).second) continue;
      answer_.undecided.push_back({outer.pair,
                                   Outcome::undecided,
                                   {},
                                   outer.from.lo,
                                   "between t = " + time_words(outer.from.lo) + " and t = " + time_words(outer.to.hi) +
                                       " curves touch, or overlap by less than doubles resolve: `taut flatten` makes "
                                       "polygons, about which it is decided"});
    }
    std::stable_sort(answer_.intervals.begin(), answer_.intervals.end(),
                     [](const OverlapInterval& a, const OverlapInterval& b) { return a.pair < b.pair; });
    answer_.geometry = CurveGeometry{tolerance_, std::max(segments_, run_.world().segments())};
    conclude(answer_);
    return std::move(answer_);
  }

  OverlapInterval named(const OverlapBracket& bracket) {
    OverlapInterval found = bracket.inner[0];
    found.from.lo = std::min(found.from.lo, bracket.outer.from.lo);
    found.to.hi = std::max(found.to.hi, bracket.outer.to.hi);
    for (std::optional<Contact>* contact : {&found.enter, &found.exit}) {
      // The contacts of windows have their names already.
      if (*contact && !(*contact)->vertex.parameter && !(*contact)->edge.parameter)
        tolerance_ = std::max(tolerance_, run_.world().name_curves(CurveSide::inner, **contact));
    }
    return found;
  }

  const CheckOptions& options_;
  CurvedRun run_;
  double wanted_;
  bool in_windows_;
  double start_, end_;          ///< of the window that polygons are asked about
  std::uint64_t segments_ = 0;  ///< of the finest window
  Intervals answer_;
  std::set<std::array<BodyId, 2>> undecided_;
  std::vector<std::array<std::string, 2>> finished_;  ///< by name, in the form in which a scene ignores pairs
  double tolerance_ = 0;
  bool is_begun_ = false;
  std::vector<OverlapBracket> brackets_;  ///< of the last polygons
  std::set<std::array<BodyId, 2>> open_ = {};
};

}  // namespace

Intervals intervals_of_curves(const Scene& scene, const CheckOptions& options) {
  CurvedIntervals query(scene, options, options.time_tolerance * (scene.end - scene.start), true);
  return bracketed(query);
}

}  // namespace taut::internal
