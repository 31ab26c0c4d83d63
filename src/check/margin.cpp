#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "check/nearest_points.hpp"
#include "numeric/undecided.hpp"
#include "pair/validate_world.hpp"
#include "spacetime/margin.hpp"
#include "taut/clearance.hpp"
#include "world/swept_box.hpp"

namespace taut {
namespace {

using spacetime::MarginResult;

class MarginSearch {
 public:
  MarginSearch(const Scene& scene, double clearance, const CheckOptions& options)
      : options_(options), plan_(scene), margin_(std::ldexp(clearance, plan_.exponent())), stop_(plan_.end()) {
    answer_.coverage = plan_.coverage();
    answer_.free_until = plan_.end();
  }

  MarginAnswer run() {
    const int n = static_cast<int>(plan_.bodies().size());
    boxes_ = boxes_over_windows(plan_);
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) {
        interruption_point();
        if (plan_.asked(a, b)) ask(a, b);
      }
    }
    Coverage& c = answer_.coverage;
    c.apart = c.pairs - c.ignored - c.at_rest - c.checked;
    take_first();
    return std::move(answer_);
  }

 private:
  bool never_near(int a, int b) const {
    const auto &first = boxes_[static_cast<std::size_t>(a)], &second = boxes_[static_cast<std::size_t>(b)];
    for (std::size_t k = 0; k < first.size(); ++k) {
      SweptBox grown = first[k];
      const double more = margin_ * (1 + 0x1p-40);
      grown.lo_x -= more;
      grown.lo_y -= more;
      grown.hi_x += more;
      grown.hi_y += more;
      if (grown.meets(second[k])) return false;
    }
    return true;
  }

  void ask(int a, int b) {
    PairMargin pair;
    pair.bodies = {a, b};
    pair.free_until = plan_.end();
    if (!never_near(a, b)) {
      ++answer_.coverage.checked;
      settle(PairSearch(plan_, a, b, false), pair);
    }
    if (options_.all_pairs) answer_.pairs.push_back(pair);
    if (pair.outcome == Outcome::free) return;
    // Others are followed a little farther, so that those that come closer at the same time are seen to.
    const double room = 0x1p-30 * (plan_.end() - plan_.start());
    if (pair.outcome == Outcome::contact && !options_.all_pairs) stop_ = std::min(stop_, pair.time.hi + room);
    events_.push_back(std::move(pair));
  }

  void settle(const PairSearch& search, PairMargin& pair) const {
    try {
      if (spacetime::overlapping(search.geometry, search.trees(), search.legs()[0], plan_.start())) {
        pair.outcome = Outcome::overlap_at_start;
        pair.free_until = plan_.start();
        return;
      }
    } catch (const Undecidable& limit) {
      pair.outcome = Outcome::undecided;
      pair.reason = not_decided(limit);
      pair.free_until = plan_.start();
      return;
    }
    const auto until = [&](double end) {
      return spacetime::first_closer(search.geometry, search.trees(), search.legs(), margin_, end);
    };
    const MarginResult start = until(plan_.start());
    take(search, start.outcome == MarginResult::close ? start : until(stop_), pair);
  }

  void take(const PairSearch& search, const MarginResult& found, PairMargin& pair) const {
    if (found.outcome == MarginResult::free) return;
    const Leg& leg = search.legs()[found.leg];
    const auto time_at = [&](double t) { return std::clamp(leg.time(t), plan_.start(), plan_.end()); };
    pair.free_until = time_at(found.lo);
    if (found.outcome == MarginResult::undecided) {
      pair.outcome = Outcome::undecided;
      pair.reason = "the bodies come as close as the clearance, as far as doubles can tell";
      return;
    }
    pair.time = {time_at(found.lo), time_at(found.hi)};
    pair.outcome = pair.time.hi <= plan_.start() ? Outcome::overlap_at_start : Outcome::contact;
    NearestPoints nearest = nearest_points_of(search, found.leg, found.hi, found.edge_p, found.edge_q);
    nearest.hi = std::ldexp(found.distance, -plan_.exponent());
    nearest.time = {pair.time.hi, pair.time.hi};
    pair.nearest = nearest;
  }

  /// What happens first, and what cannot be told from it.
  void take_first() {
    if (events_.empty()) return;
    const auto rank = [](const PairMargin& p) {
      return std::pair(p.outcome != Outcome::overlap_at_start, p.free_until);
    };
    const auto first = std::min_element(events_.begin(), events_.end(),
                                        [&](const PairMargin& x, const PairMargin& y) { return rank(x) < rank(y); });
    const auto together = [&](const PairMargin& p) {
      if (p.outcome != first->outcome) return false;
      return p.outcome == Outcome::overlap_at_start ||
             (p.outcome == Outcome::contact && p.time.lo <= first->time.hi && first->time.lo <= p.time.hi);
    };
    answer_.outcome = first->outcome;
    answer_.free_until = first->free_until;
    answer_.reason = first->reason;
    for (const PairMargin& pair : events_) {
      if (&pair != &*first && !together(pair)) continue;
      if (answer_.first) {
        answer_.also.push_back(pair);
      } else {
        answer_.first = pair;
      }
    }
  }

  const CheckOptions& options_;
  WorldPlan plan_;
  double margin_, stop_;
  std::vector<std::vector<SweptBox>> boxes_;
  std::vector<PairMargin> events_;
  MarginAnswer answer_;
};

}  // namespace

MarginAnswer check_clearance(const Scene& scene, double clearance, const CheckOptions& options) {
  if (!(clearance > 0 && std::isfinite(clearance)))
    throw InputError("clearance", "it is not a positive number", "check() asks whether bodies touch");
  const InterruptionScope scope(options.stop, options.max_seconds);
  MarginAnswer answer;
  try {
    validate_world(scene);
    return MarginSearch(scene, clearance, options).run();
  } catch (const Interrupted& limit) {
    answer.reason = limit.reason;
  }
  answer.outcome = Outcome::undecided;
  answer.free_until = scene.start;
  return answer;
}

}  // namespace taut
