#include "import/chains.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "taut/error.hpp"

namespace taut::drawing {

namespace {

constexpr int unpaired = -1;
/// More come of a distance as large as the drawing, and would fill the memory.
constexpr std::size_t most_pairs = 10000000;

/// The ends of open chains: chain k has 2k, its first point, and 2k + 1.
class EndPairing {
 public:
  EndPairing(const std::vector<Chain>& chains, double distance)
      : chains_(chains), distance_(distance), partner_(2 * chains.size(), unpaired) {}

  std::vector<int> pair(JoinCounts& counts) {
    pair_equal();
    if (distance_ > 0) pair_near(counts);
    return std::move(partner_);
  }

 private:
  const Point& at(int end) const {
    const std::vector<Point>& points = chains_[static_cast<std::size_t>(end / 2)].points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  /// Both ends of one line are not joined to each other: that encloses nothing.
  bool may_meet(int a, int b) const {
    return a / 2 != b / 2 || chains_[static_cast<std::size_t>(a / 2)].points.size() > 2;
  }

  void join(int a, int b) {
    partner_[static_cast<std::size_t>(a)] = b;
    partner_[static_cast<std::size_t>(b)] = a;
  }

  void pair_equal() {
    std::map<std::pair<double, double>, std::vector<int>> waiting;
    for (int end = 0; end < static_cast<int>(partner_.size()); ++end) {
      // -0 and 0 are one place.
      std::vector<int>& here = waiting[{at(end).x + 0.0, at(end).y + 0.0}];
      const auto other = std::find_if(here.begin(), here.end(), [&](int e) { return may_meet(e, end); });
      if (other == here.end()) {
        here.push_back(end);
      } else {
        join(*other, end);
        here.erase(other);
      }
    }
  }

  /// All pairs that are near enough, the nearest first. Cells as wide as the distance: only neighbours are looked at.
  void pair_near(JoinCounts& counts) {
    std::map<std::pair<double, double>, std::vector<int>> cells;
    std::vector<std::pair<double, std::pair<int, int>>> pairs;
    for (int end = 0; end < static_cast<int>(partner_.size()); ++end) {
      if (partner_[static_cast<std::size_t>(end)] != unpaired) continue;
      const double column = std::floor(at(end).x / distance_), row = std::floor(at(end).y / distance_);
      for (int k = 0; k < 9; ++k) {
        const auto cell = cells.find({column + k % 3 - 1, row + k / 3 - 1});
        if (cell == cells.end()) continue;
        for (const int other : cell->second) {
          const double apart = std::hypot(at(end).x - at(other).x, at(end).y - at(other).y);
          if (apart <= distance_ && may_meet(other, end)) pairs.push_back({apart, {other, end}});
          if (pairs.size() > most_pairs)
            throw InputError("--join", "too many ends of lines are so near to each other", "give a smaller distance");
        }
      }
      cells[{column, row}].push_back(end);
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [apart, ends] : pairs) {
      const auto [a, b] = ends;
      if (partner_[static_cast<std::size_t>(a)] != unpaired || partner_[static_cast<std::size_t>(b)] != unpaired)
        continue;
      join(a, b);
      ++counts.joins;
      counts.longest = std::max(counts.longest, apart);
    }
  }

  const std::vector<Chain>& chains_;
  double distance_;
  std::vector<int> partner_;
};

/// From the end `start` of an open chain, along chains and joins, until there is no further one.
Chain walk(const std::vector<Chain>& chains, const std::vector<int>& partner, std::vector<bool>& used, int start) {
  Chain whole{{}, false, chains[static_cast<std::size_t>(start / 2)].place};
  int end = start;
  for (;;) {
    const std::size_t k = static_cast<std::size_t>(end / 2);
    used[k] = true;
    std::vector<Point> points = chains[k].points;
    if (end % 2 == 1) std::reverse(points.begin(), points.end());
    // The point where this chain begins is there already, as the end of the one before.
    whole.points.insert(whole.points.end(), points.begin() + (whole.points.empty() ? 0 : 1), points.end());
    const int next = partner[static_cast<std::size_t>(end ^ 1)];
    if (next == unpaired) return whole;
    if (next == start) {
      whole.points.pop_back();
      whole.closed = true;
      return whole;
    }
    end = next;
  }
}

}  // namespace

std::vector<Chain> join_chains(std::vector<Chain> chains, double distance, JoinCounts& counts,
                               std::vector<Chain>& open) {
  std::vector<Chain> closed, pieces;
  for (Chain& chain : chains) (chain.closed ? closed : pieces).push_back(std::move(chain));
  const std::vector<int> partner = EndPairing(pieces, distance).pair(counts);
  std::vector<bool> used(pieces.size(), false);
  // First what has an end that is joined to none, then what goes round.
  for (int pass = 0; pass < 2; ++pass) {
    for (int end = 0; end < static_cast<int>(partner.size()); ++end) {
      if (used[static_cast<std::size_t>(end / 2)]) continue;
      if (pass == 0 && partner[static_cast<std::size_t>(end)] != unpaired) continue;
      Chain whole = walk(pieces, partner, used, end);
      (whole.closed ? closed : open).push_back(std::move(whole));
    }
  }
  return closed;
}

}  // namespace taut::drawing
