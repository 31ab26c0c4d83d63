// How often bodies came into contact, so that a loop of contacts in no time ends.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "taut/check.hpp"

namespace taut::internal {

/// Counts contacts by pairs of bodies. For each pair only those within a stretch of time count that begins with a
/// contact.
class ContactCount {
 public:
  ContactCount(std::uint64_t most, double stretch) : most_(most), stretch_(stretch) {}

  /// Returns whether that is one too many.
  bool add(const std::array<BodyId, 2>& pair, double time) {
    if (pairs_.size() > room_) forget_before(time - stretch_);
    Stretch& own = pairs_[pair];
    if (own.count == 0 || time - own.from > stretch_) own = {time, 0};
    return ++own.count > most_;
  }
  /// In a stretch of time.
  std::uint64_t most() const { return most_; }
  double stretch() const { return stretch_; }
  /// All contacts at all times.
  std::uint64_t total = 0;

 private:
  struct Stretch {
    double from = 0;
    std::uint64_t count = 0;
  };

  void forget_before(double time) {
    std::erase_if(pairs_, [time](const auto& entry) { return entry.second.from < time; });
    room_ = 2 * pairs_.size() + 1024;
  }

  std::uint64_t most_;
  double stretch_;
  std::size_t room_ = 1024;
  std::map<std::array<BodyId, 2>, Stretch> pairs_;
};

}  // namespace taut::internal
