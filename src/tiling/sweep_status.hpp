// The edges that the sweep line meets, bottom to top: a treap with threads, in flat arrays.
#pragma once

#include <cstdint>
#include <vector>

namespace taut::internal {

/// An ordered sequence with O(log n) insertion after a known element, removal, and binary search by a predicate.
/// Elements are slots; `edge` is the caller's business and may be replaced in place.
class SweepStatus {
 public:
  using Slot = std::uint32_t;
  static constexpr Slot nil = 0;

  SweepStatus() : slots_(1) {}
  void reserve(std::size_t n) {
    slots_.reserve(n + 1);
    free_.reserve(n);
  }

  std::uint32_t edge(Slot s) const { return slots_[s].edge; }
  void set_edge(Slot s, std::uint32_t e) { slots_[s].edge = e; }
  Slot above(Slot s) const { return slots_[s].above; }
  Slot below(Slot s) const { return slots_[s].below; }

  /// The highest element for which is_below(edge) holds, where the predicate holds for a lower part; nil if none.
  template <class IsBelow>
  Slot last_below(const IsBelow& is_below) const {
    Slot best = nil;
    for (Slot s = root_; s != nil;) {
      if (is_below(slots_[s].edge)) {
        best = s;
        s = slots_[s].right;
      } else {
        s = slots_[s].left;
      }
    }
    return best;
  }

  /// Inserts just above `position` (nil: at the very bottom).
  Slot insert_above(Slot position, std::uint32_t e) {
    const Slot s = allocate(e);
    const Slot up = position == nil ? lowest_ : slots_[position].above;
    slots_[s].below = position;
    slots_[s].above = up;
    (position == nil ? lowest_ : slots_[position].above) = s;
    if (up != nil) slots_[up].below = s;
    if (root_ == nil) {
      root_ = s;
    } else if (position != nil && slots_[position].right == nil) {
      slots_[position].right = s;
      slots_[s].parent = position;
    } else {
      slots_[up].left = s;  // the successor has no left child then
      slots_[s].parent = up;
    }
    while (slots_[s].parent != nil && slots_[slots_[s].parent].priority < slots_[s].priority) rotate_up(s);
    if (slots_[s].parent == nil) root_ = s;
    return s;
  }

  void erase(Slot s) {
    while (slots_[s].left != nil || slots_[s].right != nil) {
      const Slot l = slots_[s].left, r = slots_[s].right;
      const Slot up = l == nil ? r : (r == nil ? l : (slots_[l].priority > slots_[r].priority ? l : r));
      rotate_up(up);
      if (slots_[up].parent == nil) root_ = up;
    }
    replace_child(slots_[s].parent, s, nil);
    if (slots_[s].parent == nil) root_ = nil;
    const Slot down = slots_[s].below, up = slots_[s].above;
    (down == nil ? lowest_ : slots_[down].above) = up;
    if (up != nil) slots_[up].below = down;
    free_.push_back(s);
  }

 private:
  struct Node {
    std::uint32_t edge = 0, priority = 0;
    Slot left = nil, right = nil, parent = nil, above = nil, below = nil;
  };

  Slot allocate(std::uint32_t e) {
    Slot s;
    if (free_.empty()) {
      s = static_cast<Slot>(slots_.size());
      slots_.emplace_back();
    } else {
      s = free_.back();
      free_.pop_back();
      slots_[s] = Node{};
    }
    random_ ^= random_ << 13;
    random_ ^= random_ >> 17;
    random_ ^= random_ << 5;
    slots_[s].edge = e;
    slots_[s].priority = random_;
    return s;
  }
  void replace_child(Slot parent, Slot from, Slot to) {
    if (parent == nil) return;
    (slots_[parent].left == from ? slots_[parent].left : slots_[parent].right) = to;
  }
  void rotate_up(Slot s) {
    const Slot p = slots_[s].parent, g = slots_[p].parent;
    const bool is_left = slots_[p].left == s;
    const Slot moved = is_left ? slots_[s].right : slots_[s].left;
    (is_left ? slots_[p].left : slots_[p].right) = moved;
    if (moved != nil) slots_[moved].parent = p;
    (is_left ? slots_[s].right : slots_[s].left) = p;
    slots_[p].parent = s;
    slots_[s].parent = g;
    replace_child(g, p, s);
  }

  std::vector<Node> slots_;
  std::vector<Slot> free_;
  Slot root_ = nil, lowest_ = nil;
  std::uint32_t random_ = 2463534242u;
};

}  // namespace taut::internal
