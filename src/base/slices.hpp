// Two ways to one answer, of which nobody knows beforehand which is the shorter one.
#pragma once

#include <algorithm>
#include <cstdint>

#include "base/budget.hpp"

namespace taut::internal {

/// What came of a turn.
enum class SliceResult : unsigned char { open, given_up, decided };

/// One of the two, and the work that it has done. Neither may be ahead of the other by more than an eighth of its work:
/// so an answer costs little more than twice what the better one takes alone. Who has something long to do that cannot
/// be left in the middle may leave its turns unused until there is room for that: it then counts for the other one as
/// if it had used them.
class PortfolioMember {
 public:
  /// A first turn: as long as a small question takes.
  static constexpr std::uint64_t first_turn = 256;

  /// Counts what `begin` does.
  template <class Begin>
  void begin(const Begin& begin) {
    const std::uint64_t before = work_spent();
    begin();
    spent_ += work_spent() - before;
  }
  /// Goes on, by work(effort), until its work in all is so much.
  template <class Work>
  SliceResult work_until(std::uint64_t total, const Work& work) {
    granted_ = total;
    if (end_ == SliceResult::open && total > spent_) {
      const std::uint64_t before = work_spent();
      end_ = work(total - spent_);
      spent_ += work_spent() - before;
    }
    return end_;
  }
  std::uint64_t spent() const { return spent_; }
  bool is_open() const { return end_ == SliceResult::open; }
  /// How far the other one may go now: to the end, if this one has given up.
  std::uint64_t share_of_other() const {
    const std::uint64_t used = std::max(spent_, granted_);
    return is_open() && used < UINT64_MAX / 2 ? used + used / 8 + first_turn : UINT64_MAX;
  }

 private:
  std::uint64_t spent_ = 0, granted_ = 0;
  SliceResult end_ = SliceResult::open;
};

/// Turns until one has decided: 1 or 2; 0 if both have given up.
template <class Work1, class Work2>
int take_turns(PortfolioMember& first, const Work1& work1, PortfolioMember& second, const Work2& work2) {
  for (;;) {
    if (first.work_until(second.share_of_other(), work1) == SliceResult::decided) return 1;
    if (second.work_until(first.share_of_other(), work2) == SliceResult::decided) return 2;
    if (!first.is_open() && !second.is_open()) return 0;
  }
}

}  // namespace taut::internal
