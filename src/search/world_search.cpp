#include "search/world_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_set>

#include "base/interruption.hpp"
#include "numeric/undecided.hpp"
#include "search/pair_search.hpp"
#include "sign/witness.hpp"

namespace taut {
namespace {

constexpr int deepest = 30;

}  // namespace

/// A pair that boxes do not tell apart.
struct WorldSearch::Pair : PairSearch {
  Pair(const WorldPlan& world, int a, int b, bool inwards) : PairSearch(world, a, b, inwards) {
    result.a = a;
    result.b = b;
    result.free_until = world.end();
  }

  bool open() const { return result.outcome == Outcome::free; }

  PairResult result;
};

/// The pairs that windows around this one have settled.
struct WorldSearch::Settled {
  const Settled* above;
  std::unordered_set<std::uint64_t> pairs;

  static std::uint64_t key(int a, int b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
  }
  bool has(std::uint64_t key) const { return pairs.count(key) > 0 || (above && above->has(key)); }
  bool any() const { return !pairs.empty() || (above && above->any()); }
};

WorldSearch::WorldSearch(const WorldPlan& plan, Touch touch, bool all)
    : plan_(plan), inwards_(touch == Touch::open), all_(all), stop_(plan.end()), proved_(plan.start()) {
  for (const WorldBody& body : plan.bodies()) {
    const Bounds& b = body.rings->bounds();
    sizes_.push_back(diagonal(b));
  }
}

WorldSearch::~WorldSearch() = default;

WorldSearch::Pair& WorldSearch::pair(int a, int b) {
  std::unique_ptr<Pair>& place = pairs_[{std::min(a, b), std::max(a, b)}];
  if (!place) place = std::make_unique<Pair>(plan_, std::min(a, b), std::max(a, b), inwards_);
  return *place;
}

/// Calls visit(i, j) for all pairs of boxes that meet and are asked about: a sweep along x.
void WorldSearch::each_meeting(const std::vector<int>& bodies, const std::vector<SweptBox>& boxes,
                               const std::function<void(std::size_t, std::size_t)>& visit) const {
  std::vector<std::size_t> order(bodies.size()), active;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return std::pair(boxes[i].lo_x, i) < std::pair(boxes[j].lo_x, j); });
  for (const std::size_t i : order) {
    std::erase_if(active, [&](std::size_t j) { return boxes[j].hi_x < boxes[i].lo_x; });
    for (const std::size_t j : active) {
      interruption_point();
      if (boxes[i].meets(boxes[j]) && plan_.asked(bodies[i], bodies[j])) visit(i, j);
    }
    active.push_back(i);
  }
}

bool WorldSearch::start() {
  std::vector<int> bodies(plan_.bodies().size());
  std::iota(bodies.begin(), bodies.end(), 0);
  std::vector<SweptBox> boxes;
  for (const WorldBody& body : plan_.bodies()) boxes.push_back(swept_box(body, plan_.start(), plan_.start()));
  bool overlap = false;
  each_meeting(bodies, boxes, [&](std::size_t i, std::size_t j) {
    Pair& met = pair(bodies[i], bodies[j]);
    start_of(met);
    overlap = overlap || met.result.outcome == Outcome::overlap_at_start;
    if (!met.open()) stop_ = plan_.start();
  });
  return all_ || stop_ > plan_.start();
}

void WorldSearch::start_of(Pair& pair) {
  const double t = plan_.start();
  try {
    const auto overlap = spacetime::overlapping(pair.geometry, pair.trees(), pair.legs[0], t, &precise_);
    if (!overlap) return;
    pair.result.free_until = t;
    pair.result.outcome = Outcome::overlap_at_start;
    if (inwards_) return;
    // Touching makes the outward shapes overlap; only if the inward ones do as well is it an overlap.
    const PairGeometry inner = displaced_pair(pair.plan, true);
    if (spacetime::overlapping(inner, pair.legs[0], t)) return;
    pair.result.outcome = Outcome::contact;
    pair.result.touching = overlap;
    const Witness witness(pair.plan, pair.geometry, inwards_);
    pair.result.contact = overlap->crossing
                              ? witness.contact_of_crossing(overlap->edge_p, overlap->edge_q, pair.legs[0], t)
                              : witness.contact_of_vertex(overlap->inside, pair.legs[0], t);
  } catch (const Undecidable& limit) {
    pair.result.free_until = t;
    pair.result.outcome = Outcome::undecided;
    pair.result.reason = not_decided(limit);
  }
}

void WorldSearch::run() {
  std::vector<int> bodies(plan_.bodies().size());
  std::iota(bodies.begin(), bodies.end(), 0);
  cover(plan_.start(), plan_.end(), bodies, nullptr, 0);
  proved_ = plan_.end();
}

/// Would shorter windows help to tell the two apart?
bool WorldSearch::wants_halves(int a, int b, const SweptBox& box_a, const SweptBox& box_b, int depth) const {
  if (depth >= deepest) return false;
  return is_long(box_a, box_b, sizes_[static_cast<std::size_t>(a)] + sizes_[static_cast<std::size_t>(b)]);
}

void WorldSearch::cover(double from, double to, const std::vector<int>& bodies, const Settled* above, int depth) {
  if (over(from)) return;
  // Pairs that windows around this one have settled come after it.
  if (!above || !above->any()) proved_ = std::max(proved_, from);
  std::vector<SweptBox> boxes;
  boxes.reserve(bodies.size());
  for (const int b : bodies) {
    interruption_point();
    boxes.push_back(swept_box(plan_.bodies()[static_cast<std::size_t>(b)], from, to));
  }
  const double middle = from + (to - from) / 2;
  const bool divisible = from < middle && middle < to;
  Settled here{above, {}};
  std::vector<std::pair<int, int>> now;
  std::vector<bool> again(bodies.size(), false);
  each_meeting(bodies, boxes, [&](std::size_t i, std::size_t j) {
    const std::uint64_t key = Settled::key(bodies[i], bodies[j]);
    if (above && above->has(key)) return;
    if (divisible && wants_halves(bodies[i], bodies[j], boxes[i], boxes[j], depth)) {
      again[i] = again[j] = true;
    } else {
      now.emplace_back(std::min(bodies[i], bodies[j]), std::max(bodies[i], bodies[j]));
      here.pairs.insert(key);
    }
  });
  std::vector<int> rest;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (again[i]) rest.push_back(bodies[i]);
  }
  if (!rest.empty()) {
    cover(from, middle, rest, &here, depth + 1);
    cover(middle, to, rest, &here, depth + 1);
  }
  std::sort(now.begin(), now.end());
  for (const auto& [a, b] : now) settle(pair(a, b), from, to);
}

/// The pair's first contact within the window, if there is one that matters.
void WorldSearch::settle(Pair& pair, double from, double to) {
  if (!pair.open() && pair.result.free_until <= from) return;
  const double end = all_ ? to : std::min(to, stop_);
  if (end < from) return;
  const spacetime::SpacetimeResult found =
      spacetime::first_contact(pair.geometry, pair.trees(), pair.legs, {from, end, from == plan_.start()});
  precise_ += found.precise;
  if (found.outcome == spacetime::SpacetimeResult::free) return;
  const Leg& leg = pair.legs[found.leg];
  PairResult result = pair.result;
  result.free_until = std::clamp(leg.time(found.lo), plan_.start(), plan_.end());
  if (found.outcome == spacetime::SpacetimeResult::contact) {
    result.outcome = Outcome::contact;
    result.found = FoundContact{found.vertex, found.edge, found.lo, found.hi};
    result.leg = found.leg;
    result.contact = Witness(pair.plan, pair.geometry, inwards_).contact(*result.found, leg);
    result.contact->time.lo = std::max(result.contact->time.lo, plan_.start());
    result.free_until = result.contact->time.lo;
    stop_ = std::min(stop_, result.contact->time.hi);
  } else {
    result.outcome = Outcome::undecided;
    result.reason = found.reason;
  }
  if (pair.open() || result.free_until < pair.result.free_until) pair.result = result;
}

std::vector<PairResult> WorldSearch::results() const {
  std::vector<PairResult> results;
  for (const auto& [key, pair] : pairs_) results.push_back(pair->result);
  return results;
}

}  // namespace taut
