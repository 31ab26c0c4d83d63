// Runs two methods for one answer in alternating slices, if it is not known beforehand which one is faster.
#pragma once

#include <algorithm>
#include <cstdint>

#include "numeric/budget.hpp"

namespace taut::internal {

/// The result of a slice.
enum class SliceResult : unsigned char { open, given_up, decided };

/// One of the two methods, and the work that it has done. Neither may be ahead of the other by more than an eighth of
/// its work, so an answer costs little more than twice the cost of the better one alone. A method pauses
/// between two steps only. It may leave its slices unused until there is room for a long step; for the other one,
/// unused slices count as used.
class PortfolioMember {
 public:
  /// The first slice: the work of a small query.
  static constexpr std::uint64_t first_turn = 256;

  /// Calls `begin` and counts its work.
  template <class Begin>
  void begin(const Begin& begin) {
    const std::uint64_t before = work_spent();
    begin();
    spent_ += work_spent() - before;
  }
  /// Continues, by work(effort), until the total work reaches `total`.
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
  /// The total work up to which the other method may continue now: unlimited if this one has given up.
  std::uint64_t share_of_other() const {
    const std::uint64_t used = std::max(spent_, granted_);
    return is_open() && used < UINT64_MAX / 2 ? used + used / 8 + first_turn : UINT64_MAX;
  }

 private:
  std::uint64_t spent_ = 0, granted_ = 0;
  SliceResult end_ = SliceResult::open;
};

/// Alternates until one method has decided: returns 1 or 2, or 0 if both have given up.
template <class Work1, class Work2>
int take_turns(PortfolioMember& first, const Work1& work1, PortfolioMember& second, const Work2& work2) {
  for (;;) {
    if (first.work_until(second.share_of_other(), work1) == SliceResult::decided) return 1;
    if (second.work_until(first.share_of_other(), work2) == SliceResult::decided) return 2;
    if (!first.is_open() && !second.is_open()) return 0;
  }
}

}  // namespace taut::internal
