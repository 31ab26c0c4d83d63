#include "search/world_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_set>

#include "base/interruption.hpp"
#include "numeric/undecided.hpp"
#include "sign/witness.hpp"

namespace taut {
namespace {

constexpr int deepest = 30;

}  // namespace

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

WorldSearch::WorldSearch(const WorldPlan& plan, Touch touch, bool all, EngineChoice engine, std::uint64_t max_events)
    : plan_(plan),
      inwards_(touch == Touch::open),
      all_(all),
      engine_(engine),
      budget_(max_events),
      stop_(plan.end()),
      proved_(plan.start()) {
  for (const WorldBody& body : plan.bodies()) {
    const Bounds& b = body.rings->bounds();
    sizes_.push_back(diagonal(b));
  }
}

WorldSearch::~WorldSearch() = default;

WindowedPair& WorldSearch::pair(int a, int b) {
  std::unique_ptr<WindowedPair>& place = pairs_[{std::min(a, b), std::max(a, b)}];
  if (!place) place = windowed_pair(engine_, plan_, a, b, inwards_, budget_);
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
  each_meeting(bodies, boxes, [&](std::size_t i, std::size_t j) {
    WindowedPair& met = pair(bodies[i], bodies[j]);
    met.ask_start();
    if (!met.open()) stop_ = plan_.start();
  });
  return all_ || stop_ > plan_.start();
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
void WorldSearch::settle(WindowedPair& pair, double from, double to) {
  const double end = all_ ? to : std::min(to, stop_);
  if (end < from) return;
  pair.ask(from, end);
  if (pair.result().contact) stop_ = std::min(stop_, pair.result().contact->time.hi);
}

std::vector<PairResult> WorldSearch::results() const {
  std::vector<PairResult> results;
  for (const auto& [key, pair] : pairs_) results.push_back(pair->result());
  return results;
}

bool WorldSearch::doubles_sufficed() const {
  return std::all_of(pairs_.begin(), pairs_.end(), [](const auto& entry) { return entry.second->doubles_sufficed(); });
}

}  // namespace taut
