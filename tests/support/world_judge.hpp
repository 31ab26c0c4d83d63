// Answers about worlds against their definition: bodies are posed at many instants and compared by arithmetic that
// shares nothing with the library. Each function returns what is wrong, or nothing.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "support/made_world.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"

namespace taut::testing {

/// A world at equally spaced instants, and at others when asked.
class WorldJudge {
 public:
  WorldJudge(const MadeWorld& world, int samples);

  /// No overlap before the pair's first contact, whose vertex lies on the edge; an overlap at the start is one.
  std::string pair_fault(const PairAnswer& pair);
  /// Clear overlap within no other time than the intervals', and no clear gap within them. They are those of one pair,
  /// in order.
  std::string intervals_fault(const std::array<BodyId, 2>& pair, const std::vector<OverlapInterval>& intervals);
  /// No sampled distance below it.
  std::string clearance_fault(const std::array<BodyId, 2>& pair, double lo);
  /// Distances at the judge's instants, and the curve's own, are within its brackets.
  std::string curve_fault(const std::array<BodyId, 2>& pair, const DistanceCurve& curve);

  /// How many pairs overlapped clearly soon after their contacts.
  std::uint64_t entered = 0;

 private:
  struct Placed {
    BodyAtPose rings;
    double lo_x = 0, hi_x = 0, lo_y = 0, hi_y = 0;
  };
  Placed placed(int body, double t) const;
  const Placed& sampled(int body, int k) const {
    return samples_[static_cast<std::size_t>(body)][static_cast<std::size_t>(k)];
  }
  double instant(int k) const { return world_.end * k / count_; }
  bool overlap_at(const std::array<BodyId, 2>& pair, double t, double margin) const;
  bool overlap_sampled(const std::array<BodyId, 2>& pair, int k, double margin) const;
  bool meet_at(const std::array<BodyId, 2>& pair, double t) const;
  double distance_at(const std::array<BodyId, 2>& pair, double t) const;
  std::string witness_fault(const PairAnswer& pair) const;

  const MadeWorld& world_;
  int count_;
  std::vector<std::vector<Placed>> samples_;
};

/// The world's answer is that of its first pair.
std::string earliest_fault(const Answer& headline, const std::vector<PairAnswer>& pairs);

}  // namespace taut::testing
