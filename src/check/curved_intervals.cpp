#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "check/curved_questions.hpp"
#include "check/near_cells.hpp"
#include "check/run.hpp"

namespace taut {
namespace {

std::string time_words(double t) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", t);
  return text;
}

/// What polygons around the bodies say of one stretch of time, and those within them.
struct OverlapBracket {
  OverlapInterval outer;
  std::vector<OverlapInterval> inner;

  bool decided(double wanted) const {
    if (inner.size() != 1) return false;
    const auto narrow = [&](const TimeInterval& a, const TimeInterval& b) {
      const double lo = std::min(a.lo, b.lo), hi = std::max(a.hi, b.hi);
      return hi - lo <= std::max({wanted, 2 * (a.hi - a.lo), 0x1p-49 * std::fabs(hi)});
    };
    return narrow(inner[0].from, outer.from) && narrow(inner[0].to, outer.to);
  }
};

class CurvedIntervals {
 public:
  CurvedIntervals(const Scene& scene, const CheckOptions& options)
      : options_(options), began_(std::chrono::steady_clock::now()), world_(scene), limit_(world_) {
    wanted_ = options.time_tolerance * (scene.end - scene.start);
  }

  Intervals run() {
    for (;;) {
      Intervals outer = ask(CurveSide::outer);
      if (outer.outcome == Outcome::untested) return outer;
      const Intervals inner = ask(CurveSide::inner);
      const std::vector<OverlapBracket> brackets = brackets_of(outer, inner);
      CurvedWorld::Halvings marks = world_.no_halvings();
      std::size_t count = 0;
      for (const OverlapBracket& bracket : brackets) {
        if (!bracket.decided(wanted_)) count += mark(bracket, marks);
      }
      if (count == 0 || limit_.reached(world_) || !refine_marked(world_, std::move(marks), count))
        return concluded(std::move(outer), inner, brackets);
    }
  }

 private:
  Intervals ask(CurveSide side) const {
    CheckOptions options = options_;
    options.max_seconds -= seconds_since(began_);
    return intervals(world_.polygons(side), options);
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

  /// Near the ends that are not told well, and where nothing is known in between.
  std::size_t mark(const OverlapBracket& bracket, CurvedWorld::Halvings& marks) const {
    const OverlapInterval& o = bracket.outer;
    std::vector<double> instants{o.from.lo, o.to.hi};
    if (bracket.inner.empty()) instants.push_back(o.from.lo + (o.to.hi - o.from.lo) / 2);
    for (const OverlapInterval& i : bracket.inner) {
      instants.push_back(i.from.hi);
      instants.push_back(i.to.lo);
    }
    std::size_t count = 0;
    for (const double t : instants)
      count += mark_near(world_, o.pair, std::clamp(t, world_.scene().start, world_.scene().end), 0, marks);
    return count;
  }

  Intervals concluded(Intervals outer, const Intervals& inner, const std::vector<OverlapBracket>& brackets) const {
    Intervals answer;
    answer.coverage = outer.coverage;
    answer.undecided = std::move(outer.undecided);
    answer.undecided.insert(answer.undecided.end(), inner.undecided.begin(), inner.undecided.end());
    answer.geometry = CurveGeometry{0, world_.segments()};
    std::set<std::array<BodyId, 2>> open;
    for (const PairAnswer& pair : answer.undecided) open.insert(pair.bodies);
    for (const OverlapBracket& bracket : brackets) {
      if (bracket.decided(wanted_) || !open.insert(bracket.outer.pair).second) continue;
      const TimeInterval& from = bracket.outer.from;
      answer.undecided.push_back({bracket.outer.pair,
                                  Outcome::undecided,
                                  {},
                                  from.lo,
                                  "between t = " + time_words(from.lo) + " and t = " + time_words(bracket.outer.to.hi) +
                                      " curves touch, or overlap by less than doubles tell: `taut flatten` makes "
                                      "polygons, about which it is decided"});
    }
    for (const OverlapBracket& bracket : brackets) {
      if (open.count(bracket.outer.pair) == 0) answer.intervals.push_back(named(bracket, *answer.geometry));
    }
    conclude(answer);
    return answer;
  }

  OverlapInterval named(const OverlapBracket& bracket, CurveGeometry& geometry) const {
    OverlapInterval found = bracket.inner[0];
    found.from.lo = std::min(found.from.lo, bracket.outer.from.lo);
    found.to.hi = std::max(found.to.hi, bracket.outer.to.hi);
    const auto name = [&](std::optional<Contact>& contact) {
      if (contact) geometry.tolerance = std::max(geometry.tolerance, world_.name_curves(CurveSide::inner, *contact));
    };
    name(found.enter);
    name(found.exit);
    return found;
  }

  const CheckOptions& options_;
  std::chrono::steady_clock::time_point began_;
  CurvedWorld world_;
  RefinementLimit limit_;
  double wanted_ = 0;
};

}  // namespace

Intervals intervals_of_curves(const Scene& scene, const CheckOptions& options) {
  return CurvedIntervals(scene, options).run();
}

}  // namespace taut
