#include "taut/clearance.hpp"

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"
#include "base/interruption.hpp"
#include "check/curved_questions.hpp"
#include "check/nearest_points.hpp"
#include "check/run.hpp"
#include "numeric/undecided.hpp"
#include "pair/validate_world.hpp"
#include "search/pair_search.hpp"
#include "sign/witness.hpp"
#include "spacetime/settle_nearest.hpp"
#include "taut/error.hpp"
#include "world/swept_box.hpp"

namespace taut {
namespace {

/// A lower bound of the distance of two boxes.
double distance_of(const SweptBox& a, const SweptBox& b) {
  const double x = std::max({0.0, a.lo_x - b.hi_x, b.lo_x - a.hi_x});
  const double y = std::max({0.0, a.lo_y - b.hi_y, b.lo_y - a.hi_y});
  return std::sqrt(x * x + y * y) * (1 - 0x1p-45);
}

/// Whether bodies touch is not told: why.
struct TouchUndecided {
  std::string reason;
};

class ClearanceSearch {
 public:
  ClearanceSearch(const Scene& scene, const ClearanceOptions& options)
      : options_(options), plan_(scene), best_(INFINITY) {
    // A little less than what is allowed: the rest is for rounding.
    tolerance_ = {options.relative * 0.99, 0.99e-12 * plan_.largest()};
    answer_.coverage = plan_.coverage();
  }

  Clearance run() {
    const std::vector<BoxedPair> pairs = pairs_by_distance();
    answer_.coverage.checked = 0;
    for (const BoxedPair& pair : pairs) {
      if (!options_.all_pairs && pair.bound > tolerance_.least(best_)) break;
      ++answer_.coverage.checked;
      search(pair);
    }
    answer_.coverage.apart =
        answer_.coverage.pairs - answer_.coverage.ignored - answer_.coverage.at_rest - answer_.coverage.checked;
    if (answer_.nearest) {
      answer_.nearest->lo = std::min(answer_.nearest->lo, std::ldexp(certain_, -plan_.exponent()) * (1 - 0x1p-50));
      if (is_wide(*answer_.nearest)) answer_.wide = why_;
    }
    std::sort(answer_.pairs.begin(), answer_.pairs.end(),
              [](const NearestPoints& a, const NearestPoints& b) { return a.pair < b.pair; });
    return std::move(answer_);
  }

 private:
  struct BoxedPair {
    double bound;
    int a, b;
  };

  bool is_wide(const NearestPoints& found) const {
    return found.hi - found.lo > options_.relative * found.hi + 1e-12 * std::ldexp(plan_.largest(), -plan_.exponent());
  }

  /// All pairs, those first whose boxes come nearest.
  std::vector<BoxedPair> pairs_by_distance() const {
    const std::vector<std::vector<SweptBox>> boxes = boxes_over_windows(plan_);
    std::vector<BoxedPair> pairs;
    const int n = static_cast<int>(boxes.size());
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) {
        interruption_point();
        if (!plan_.asked(a, b)) continue;
        double bound = INFINITY;
        for (std::size_t k = 0; k < coarse_windows; ++k)
          bound = std::min(bound,
                           distance_of(boxes[static_cast<std::size_t>(a)][k], boxes[static_cast<std::size_t>(b)][k]));
        pairs.push_back({bound, a, b});
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const BoxedPair& x, const BoxedPair& y) { return x.bound < y.bound; });
    return pairs;
  }

  void search(const BoxedPair& pair) {
    const PairSearch search(plan_, pair.a, pair.b, false);
    NearestPoints found;
    found.pair = {pair.a, pair.b};
    if (!touching(search, found)) {
      spacetime::Nearest nearest;
      nearest.distance = options_.all_pairs ? INFINITY : best_;
      const double before = nearest.distance;
      spacetime::find_nearest(search.geometry, search.trees(), search.legs(), tolerance_, nearest);
      const std::string why = spacetime::settle_nearest(search.geometry, search.trees(), search.legs(),
                                                        {plan_.start(), plan_.end()}, tolerance_, nearest);
      certain_ = std::min(certain_, nearest.unresolved);
      if (!why.empty()) why_ = why;
      if (!options_.all_pairs && !(nearest.distance < before)) return;
      describe(search, nearest, found);
    }
    if (options_.all_pairs) answer_.pairs.push_back(found);
    if (answer_.nearest && !(found.hi < answer_.nearest->hi)) return;
    answer_.nearest = found;
    best_ = std::ldexp(found.hi, plan_.exponent());
  }

  /// Bodies that touch have no distance.
  bool touching(const PairSearch& search, NearestPoints& found) const {
    const Leg& first = search.legs()[0];
    if (spacetime::overlapping(search.geometry, search.trees(), first, plan_.start())) {
      found.time = {plan_.start(), plan_.start()};
      return true;
    }
    const spacetime::SpacetimeResult contact = spacetime::first_contact(search.geometry, search.trees(), search.legs());
    if (contact.outcome == spacetime::SpacetimeResult::free) return false;
    if (contact.outcome == spacetime::SpacetimeResult::undecided) throw TouchUndecided{contact.reason};
    const Leg& leg = search.legs()[contact.leg];
    const Contact said = Witness(search.plan, search.geometry, false).contact(contact.found, leg);
    found.time = said.time;
    found.points = {said.point, said.point};
    return true;
  }

  void describe(const PairSearch& search, const spacetime::Nearest& nearest, NearestPoints& found) const {
    found = nearest_points_of(search, nearest.leg, nearest.parameter, nearest.edge_p, nearest.edge_q);
    const Leg& leg = search.legs()[nearest.leg];
    const double t = std::clamp(leg.time(nearest.parameter), plan_.start(), plan_.end());
    found.time = {t, t};
    found.hi = std::ldexp(nearest.distance, -plan_.exponent());
    const double least = std::min(tolerance_.least(nearest.distance), nearest.unresolved);
    found.lo = std::max(0.0, std::ldexp(least, -plan_.exponent()) * (1 - 0x1p-50));
  }

  const ClearanceOptions& options_;
  WorldPlan plan_;
  spacetime::ClearanceTolerance tolerance_;
  double best_;                ///< internal units
  double certain_ = INFINITY;  ///< no pair comes closer than this where that is not told as well as was asked for
  std::string why_;            ///< that is so
  Clearance answer_;
};

}  // namespace

Clearance clearance(const Scene& scene, const ClearanceOptions& options) {
  if (!(options.relative >= 1e-12)) throw InputError("tolerance", "it is below 1e-12", "doubles do not tell more");
  if (has_curves(scene)) return clearance_of_curves(scene, options);
  const InterruptionScope scope(options.stop, options.max_seconds);
  Clearance answer;
  try {
    validate_world(scene);
    return ClearanceSearch(scene, options).run();
  } catch (const TouchUndecided& limit) {
    answer.reason = limit.reason;
  } catch (const Undecidable& limit) {
    answer.reason = not_decided(limit);
  } catch (const Interrupted& limit) {
    answer.reason = limit.reason;
  }
  return answer;
}

}  // namespace taut
