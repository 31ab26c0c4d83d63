// Which pairs of a world are near each other, window after window?
#pragma once

#include <utility>
#include <vector>

#include "world/meeting_boxes.hpp"

namespace taut {

/// Goes through time as WorldSearch does, but for those who want to stand still in it: in the window of the present the
/// pairs that are near are those whose boxes meet in it, or in one of the windows around it that would not be told
/// apart by shorter ones. No other pair meets in it. What is far costs nothing within a window.
class NearPairs {
 public:
  /// The plan must outlive it.
  explicit NearPairs(const WorldPlan& plan) : plan_(plan) {}

  /// Begins anew, with all bodies, at that time.
  void begin(double from);
  /// The present window; it ends with the world, or before.
  double from() const { return from_; }
  double until() const { return stack_.back().to; }
  bool last() const { return !(until() < plan_.end()); }
  /// Goes on to the next one.
  void next();

  /// Calls visit(a, b) for the pairs that are near; a < b.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const Window& window : stack_) {
      for (const auto& [a, b] : window.pairs) visit(a, b);
    }
  }
  bool has(int a, int b) const;

 private:
  /// One around the next one in the stack.
  struct Window {
    double middle, to;
    std::vector<std::pair<int, int>> pairs;  ///< near all over it, in order
    std::vector<int> rest;                   ///< bodies of pairs about which its halves tell more
  };
  void descend(double from, double to, std::vector<int> bodies);

  const WorldPlan& plan_;
  double from_ = 0;
  std::vector<Window> stack_;
};

}  // namespace taut
