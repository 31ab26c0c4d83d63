// What is due next, where what is due when changes all the time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certificate/root.hpp"

namespace taut::internal {

/// A heap of items in one array. An item has `due`, `place` and `key`, which decides among those that are due together.
/// It stays where it is in memory while it is in the queue, and its `due` stays the same. Each node has four children:
/// there are half as many levels, and what is compared lies together.
template <class Item>
class DueQueue {
 public:
  bool empty() const { return entries_.empty(); }
  Item& first() const { return *entries_.front().item; }
  double first_due() const { return empty() ? never : entries_.front().due; }
  /// Of what comes after the first one; infinite if there is none.
  double second_due() const {
    double due = never;
    for (std::size_t k = 1; k < std::min(entries_.size(), children + 1); ++k) due = std::min(due, entries_[k].due);
    return due;
  }
  void insert(Item& item) {
    entries_.emplace_back();
    rise(entries_.size() - 1, {item.due, &item});
  }
  /// Does nothing if it is not in the queue.
  void erase(Item& item) {
    if (item.place == nowhere) return;
    const std::size_t gap = item.place;
    item.place = nowhere;
    const Entry last = entries_.back();
    entries_.pop_back();
    if (gap == entries_.size()) return;
    if (gap > 0 && last.before(entries_[parent(gap)])) {
      rise(gap, last);
    } else {
      sink(gap, last);
    }
  }
  /// The place of an item that is in no queue.
  static constexpr std::uint32_t nowhere = UINT32_MAX;

 private:
  static constexpr std::size_t children = 4;
  struct Entry {
    double due = 0;
    Item* item = nullptr;

    bool before(const Entry& other) const {
      return due < other.due || (due == other.due && item->key < other.item->key);
    }
  };

  static std::size_t parent(std::size_t k) { return (k - 1) / children; }
  void put(std::size_t k, const Entry& entry) {
    entries_[k] = entry;
    entry.item->place = static_cast<std::uint32_t>(k);
  }
  void rise(std::size_t k, const Entry& entry) {
    for (; k > 0 && entry.before(entries_[parent(k)]); k = parent(k)) put(k, entries_[parent(k)]);
    put(k, entry);
  }
  void sink(std::size_t k, const Entry& entry) {
    for (;;) {
      const std::size_t from = children * k + 1, to = std::min(from + children, entries_.size());
      if (from >= to) break;
      std::size_t least = from;
      for (std::size_t i = from + 1; i < to; ++i) {
        if (entries_[i].before(entries_[least])) least = i;
      }
      if (!entries_[least].before(entry)) break;
      put(k, entries_[least]);
      k = least;
    }
    put(k, entry);
  }

  std::vector<Entry> entries_;
};

}  // namespace taut::internal
