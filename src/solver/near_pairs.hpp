// The pairs of a world that are near each other, window after window.
#pragma once

#include <climits>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

#include "scene/changing_boxes.hpp"
#include "scene/meeting_boxes.hpp"

namespace taut::internal {

/// Proceeds through time like WorldSearch, but for callers that stop at intermediate times. In the current window, the
/// near pairs are those whose boxes meet in it, or in one of the enclosing windows that shorter windows would not
/// separate. No other pair meets in it. Distant bodies cost nothing within a window. If some bodies change their
/// motions, only these are tested again: windows, boxes and pairs of all others stay. A single pair is near all the
/// time, also if its bodies come to move alike.
class NearPairs {
 public:
  /// The motions must outlive this object.
  explicit NearPairs(const Instance& instance) : instance_(instance) {}

  /// Begins, with all bodies, at that time.
  void begin(double from);
  /// These bodies, in order, have other motions from that time on. The time must lie in the current window, which then
  /// begins there.
  void change(const std::vector<int>& changed, double from);
  /// The current window; it ends with the world, or before.
  double from() const { return from_; }
  double until() const { return stack_.back().to; }
  bool last() const { return !(until() < instance_.end()); }
  /// Proceeds to the next window.
  void next();

  /// Calls visit(a, b) for the near pairs; a < b.
  template <class Visit>
  void each(const Visit& visit) const {
    for (const Window& window : stack_) {
      for (const auto& [a, b] : window.pairs) {
        if (a < b) visit(a, b);
      }
    }
  }
  /// Calls visit(other) for all bodies near a given one.
  template <class Visit>
  void each_of(int body, const Visit& visit) const {
    for (const Window& window : stack_) {
      for (auto pair = window.pairs.lower_bound({body, INT_MIN}); pair != window.pairs.end() && pair->first == body;)
        visit((pair++)->second);
    }
  }
  bool has(int a, int b) const;

 private:
  /// A window. On the stack, each encloses the next one.
  struct Window {
    double middle, to;
    bool divisible;
    ChangingBoxes boxes;                  ///< of the bodies that are tested in it
    std::set<std::pair<int, int>> pairs;  ///< near throughout the window, in both orders
    std::unordered_set<int> rest;         ///< bodies of pairs that its halves may separate
  };
  void begin_single_pair();
  void descend(double from, double to, std::vector<int> bodies);
  void examine(int body, Window& window, std::vector<int>& deeper);
  static void add(Window& window, int a, int b);
  static void forget(Window& window, int body);

  const Instance& instance_;
  double from_ = 0;
  std::vector<Window> stack_;
};

}  // namespace taut::internal
