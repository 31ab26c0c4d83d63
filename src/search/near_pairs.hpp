// Which pairs of a world are near each other, window after window?
#pragma once

#include <climits>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

#include "world/changing_boxes.hpp"
#include "world/meeting_boxes.hpp"

namespace taut::internal {

/// Goes through time as WorldSearch does, but for those who want to stand still in it: in the window of the present the
/// pairs that are near are those whose boxes meet in it, or in one of the windows around it that would not be told
/// apart by shorter ones. No other pair meets in it. What is far costs nothing within a window, and where some bodies
/// change their plans, only they are looked at anew: windows, boxes and pairs of all others stay.
class NearPairs {
 public:
  /// The plan must outlive it.
  explicit NearPairs(const WorldPlan& plan) : plan_(plan) {}

  /// Begins, with all bodies, at that time.
  void begin(double from);
  /// These bodies, in order, have other motions from that time on, which lies in the present window: it begins there.
  void change(const std::vector<int>& changed, double from);
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
      for (const auto& [a, b] : window.pairs) {
        if (a < b) visit(a, b);
      }
    }
  }
  /// Calls visit(other) for all that are near to a body.
  template <class Visit>
  void each_of(int body, const Visit& visit) const {
    for (const Window& window : stack_) {
      for (auto pair = window.pairs.lower_bound({body, INT_MIN}); pair != window.pairs.end() && pair->first == body;)
        visit((pair++)->second);
    }
  }
  bool has(int a, int b) const;

 private:
  /// One around the next one in the stack.
  struct Window {
    double middle, to;
    bool divisible;
    ChangingBoxes boxes;                  ///< of the bodies that are looked at in it
    std::set<std::pair<int, int>> pairs;  ///< near all over it, both ways round
    std::unordered_set<int> rest;         ///< bodies of pairs about which its halves tell more
  };
  void descend(double from, double to, std::vector<int> bodies);
  void look(int body, Window& window, std::vector<int>& deeper);
  static void add(Window& window, int a, int b);
  static void forget(Window& window, int body);

  const WorldPlan& plan_;
  double from_ = 0;
  std::vector<Window> stack_;
};

}  // namespace taut::internal
