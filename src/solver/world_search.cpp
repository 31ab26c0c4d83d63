#include "solver/world_search.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_set>

#include "numeric/budget.hpp"
#include "scene/meeting_boxes.hpp"

namespace taut::internal {

/// The pairs that enclosing windows have decided.
struct WorldSearch::DecidedPairs {
  const DecidedPairs* above;
  std::unordered_set<std::uint64_t> pairs;

  static std::uint64_t key(int a, int b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
  }
  bool has(std::uint64_t key) const { return pairs.count(key) > 0 || (above && above->has(key)); }
  bool any() const { return !pairs.empty() || (above && above->any()); }
};

WorldSearch::WorldSearch(const Instance& instance, Touch touch, bool all, const SolverChoice& choice,
                         std::uint64_t max_events)
    : instance_(instance),
      offset_(offset_for(touch)),
      all_(all),
      choice_(choice),
      budget_(max_events),
      stop_(instance.end()),
      proved_(instance.start()) {}

WorldSearch::~WorldSearch() = default;

PairSolver& WorldSearch::pair(int a, int b) {
  const std::pair<int, int> key(std::min(a, b), std::max(a, b));
  auto known = pairs_.find(key);
  // Constructed first, because a limit may interrupt that.
  if (known == pairs_.end()) known = pairs_.emplace(key, pair_solver(choice_, instance_, a, b, offset_, budget_)).first;
  return *known->second;
}

bool WorldSearch::start() {
  if (instance_.is_single_pair()) {
    PairSolver& only = pair(0, 1);
    only.ask_start();
    return only.open();
  }
  std::vector<int> bodies(instance_.bodies().size());
  std::iota(bodies.begin(), bodies.end(), 0);
  MeetingBoxes(instance_, bodies, instance_.start(), instance_.start()).each([&](int a, int b, bool) {
    PairSolver& met = pair(a, b);
    met.ask_start();
    if (!met.open()) stop_ = instance_.start();
  });
  return all_ || stop_ > instance_.start();
}

/// Nothing happens after the start to bodies that move alike.
void WorldSearch::search_single_pair() {
  if (instance_.bodies()[0].group == instance_.bodies()[1].group) return;
  pair(0, 1).ask(instance_.start(), std::min(instance_.end(), instance_.repeats_from(0, 1)));
}

void WorldSearch::run() {
  if (instance_.is_single_pair()) {
    search_single_pair();
    proved_ = instance_.end();
    return;
  }
  std::vector<int> bodies(instance_.bodies().size());
  std::iota(bodies.begin(), bodies.end(), 0);
  cover(instance_.start(), instance_.end(), bodies, nullptr, 0);
  proved_ = instance_.end();
}

void WorldSearch::cover(double from, double to, const std::vector<int>& bodies, const DecidedPairs* above, int depth) {
  if (over(from)) return;
  // Pairs that enclosing windows decide come after this one.
  if (!above || !above->any()) {
    proved_ = std::max(proved_, from);
    report_time(proved_);
  }
  const double middle = from + (to - from) / 2;
  const bool divisible = from < middle && middle < to && depth < most_window_halvings;
  DecidedPairs here{above, {}};
  std::vector<std::pair<int, int>> now;
  std::unordered_set<int> again;
  MeetingBoxes(instance_, bodies, from, to).each_moving([&](int a, int b, bool longer) {
    const std::uint64_t key = DecidedPairs::key(a, b);
    if (above && above->has(key)) return;
    const bool halved = divisible && longer;
    // Earlier windows have shown all there is to see.
    if ((halved || from > instance_.start()) && instance_.repeats_from(a, b) <= from) return;
    if (halved) {
      again.insert({a, b});
    } else {
      now.emplace_back(a, b);
      here.pairs.insert(key);
    }
  });
  if (!again.empty()) {
    std::vector<int> rest(again.begin(), again.end());
    std::sort(rest.begin(), rest.end());
    cover(from, middle, rest, &here, depth + 1);
    cover(middle, to, rest, &here, depth + 1);
  }
  std::sort(now.begin(), now.end());
  to_resolve_ += now.size();
  for (const auto& [a, b] : now) {
    report_parts("pairs in a stretch of time", decided_++, to_resolve_);
    resolve(pair(a, b), from, to);
  }
}

/// Searches the pair's first contact within the window, if it matters.
void WorldSearch::resolve(PairSolver& pair, double from, double to) {
  const double end = std::min({to, all_ ? to : stop_, instance_.repeats_from(pair.result().a, pair.result().b)});
  if (end < from) return;
  pair.ask(from, end);
  if (pair.result().contact) stop_ = std::min(stop_, pair.result().contact->time.hi);
}

}  // namespace taut::internal
