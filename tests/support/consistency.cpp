#include "support/consistency.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

/// A bracket of the first contact, and who says so.
struct FirstContact {
  std::string who;
  TimeInterval time;
};

class ConsistencyJudge {
 public:
  ConsistencyJudge(const Scene& scene, Touch touch, double max_seconds) : scene_(scene) {
    options_.touch = touch;
    options_.tell_touching = false;
    options_.limits.max_seconds = max_seconds;
  }

  std::string run() {
    for (const EngineChoice engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
      options_.engine = engine;
      note(std::string("check by ") + to_string(engine), check(scene_, options_));
      std::stringstream log;
      const Answer proved = prove(scene_, log, options_);
      note(std::string("prove by ") + to_string(engine), proved);
      if (proved.outcome != Outcome::contact) continue;
      const Verified verified = verify(scene_, log);
      require(verified.outcome == Outcome::contact, "the log proves something else");
      if (verified.contact) meet({std::string("verify by ") + to_string(engine), verified.contact->time});
    }
    compare_intervals();
    if (outcome_) compare_range();
    if (outcome_ && options_.touch == Touch::closed) compare_distances();
    return faults_;
  }

 private:
  void require(bool holds, const std::string& otherwise) {
    if (!holds) faults_ += (faults_.empty() ? "" : "; ") + otherwise;
  }

  void note(const std::string& who, const Answer& answer) {
    require_counted(who, answer.coverage, answer.outcome != Outcome::undecided);
    if (answer.outcome == Outcome::undecided) return;
    if (!outcome_) outcome_ = answer.outcome;
    require(answer.outcome == *outcome_,
            fmt::format("{}: {}, others: {}", who, to_string(answer.outcome), to_string(*outcome_)));
    if (answer.contact) meet({who, answer.contact->time});
  }

  /// Each pair is counted once, and a decided answer reaches all of them.
  void require_counted(const std::string& who, const Coverage& c, bool decided) {
    require(c.pairs == c.tested + c.apart + c.untested() && (!decided || c.not_reached == 0),
            fmt::format("{}: of {} pairs {} tested, {} apart, {} untested, {} of these not reached", who, c.pairs,
                        c.tested, c.apart, c.untested(), c.not_reached));
  }

  /// Without any tolerance: each bracket holds the instant.
  void meet(const FirstContact& one) {
    for (const FirstContact& other : said_)
      require(one.time.lo <= other.time.hi && other.time.lo <= one.time.hi,
              fmt::format("{}: [{}, {}], {}: [{}, {}]", one.who, one.time.lo, one.time.hi, other.who, other.time.lo,
                          other.time.hi));
    said_.push_back(one);
  }

  void compare_intervals() {
    const Intervals all = intervals(scene_, options_);
    require_counted("intervals", all.coverage, all.undecided.empty());
    if (!outcome_ || !all.undecided.empty()) return;
    require(all.intervals.empty() == (*outcome_ == Outcome::free),
            fmt::format("{} intervals, and {}", all.intervals.size(), to_string(*outcome_)));
    TimeInterval first{INFINITY, INFINITY};
    for (const OverlapInterval& o : all.intervals) {
      if (o.from.lo < first.lo) first = o.from;
      require(o.from.lo <= o.to.hi, "an interval that ends before it begins");
    }
    if (*outcome_ == Outcome::contact && !all.intervals.empty()) meet({"intervals", first});
    for (int k = 0; k <= 8; ++k) compare_range_at(scene_.start + (scene_.end - scene_.start) * k / 8, all.intervals);
  }

  /// A range lies between intervals, and ends where these do: their brackets share an instant.
  void compare_range_at(double t, const std::vector<OverlapInterval>& all) {
    const auto any = [&](const auto& holds) { return std::any_of(all.begin(), all.end(), holds); };
    const auto share = [](const TimeInterval& a, const TimeInterval& b) { return a.lo <= b.hi && b.lo <= a.hi; };
    const std::string where = fmt::format("range from {}", t);
    try {
      const Range free = range(scene_, t, options_);
      require_counted(where, free.coverage, free.outcome == Outcome::free);
      if (free.outcome != Outcome::free) return;
      require(!any([&](const OverlapInterval& o) { return o.from.hi < t && t < o.to.lo; }),
              where + ": within an interval");
      const double from = free.from ? free.from->hi : scene_.start, to = free.to ? free.to->lo : scene_.end;
      require(!any([&](const OverlapInterval& o) { return from < o.from.lo && o.to.hi < to; }),
              where + ": an interval within it");
      require(!free.to || any([&](const OverlapInterval& o) { return share(o.from, *free.to); }),
              where + ": no interval begins where it ends");
      require(!free.from || any([&](const OverlapInterval& o) { return share(o.to, *free.from); }),
              where + ": no interval ends where it begins");
    } catch (const InputError& error) {
      require(any([&](const OverlapInterval& o) { return o.from.lo <= t && t <= o.to.hi; }),
              where + ": " + error.what());
    }
  }

  void compare_range() {
    try {
      const Range found = range(scene_, scene_.start, options_);
      if (found.outcome != Outcome::free) return;
      require(*outcome_ != Outcome::overlap_at_start, "a range from the start, at which bodies overlap");
      require(found.to.has_value() == (*outcome_ == Outcome::contact), "the range ends elsewhere than at the contact");
      if (found.to) meet({"range", *found.to});
    } catch (const InputError& error) {
      require(*outcome_ == Outcome::overlap_at_start || (!said_.empty() && said_[0].time.lo <= scene_.start),
              std::string("range: ") + error.what());
    }
  }

  void compare_distances() {
    const Clearance least = clearance(scene_);
    require_counted("clearance", least.coverage, least.reason.empty());
    if (!least.reason.empty() || !least.nearest) return;
    const double lo = least.nearest->lo, hi = least.nearest->hi;
    // Closures that have a distance do not touch; 0 as the lower end says that it is not known.
    require(*outcome_ == Outcome::free ? hi > 0 : lo == 0,
            fmt::format("clearance [{}, {}], and {}", lo, hi, to_string(*outcome_)));
    const double more = std::max(hi * 1.001, 1e-9), less = lo * 0.999;
    const MarginAnswer closer = check_clearance(scene_, more, options_);
    require_counted("a larger clearance", closer.coverage, closer.outcome != Outcome::undecided);
    require(closer.outcome != Outcome::free, fmt::format("{} is kept, clearance [{}, {}]", more, lo, hi));
    // Who comes into contact comes closer than any clearance before, or just then.
    if (closer.outcome == Outcome::contact && !said_.empty())
      require(closer.first->time.lo <= said_[0].time.hi, "closer than a clearance only after the contact");
    if (!(less > 0)) return;
    const MarginAnswer kept = check_clearance(scene_, less, options_);
    require(kept.outcome == Outcome::free || kept.outcome == Outcome::undecided,
            fmt::format("{} is not kept, clearance [{}, {}]", less, lo, hi));
  }

  const Scene& scene_;
  CheckOptions options_;
  std::optional<Outcome> outcome_;
  std::vector<FirstContact> said_;
  std::string faults_;
};

}  // namespace

std::string inconsistency(const Scene& scene, Touch touch, double max_seconds) {
  return ConsistencyJudge(scene, touch, max_seconds).run();
}

}  // namespace taut::testing
