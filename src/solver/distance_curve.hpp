// The distance of two bodies, or the least distance of many pairs, as a function of time.
#pragma once

#include <memory>
#include <vector>

#include "solver/pair_solver.hpp"
#include "spacetime/clearance.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"

namespace taut::internal {

/// A pair of bodies, and the times when they touch.
struct PairDistance {
  std::array<BodyId, 2> pair;
  PairInstance search;
  std::vector<OverlapInterval> touching;  ///< for closed touching
};

/// Brackets of d(t), the least distance of any of the pairs at t, in the input's units. It is 0 where a pair touches.
class DistanceFunction {
 public:
  DistanceFunction(std::vector<const PairDistance*> pairs, const spacetime::ClearanceTolerance& tolerance, int exponent)
      : pairs_(std::move(pairs)), tolerance_(tolerance), exponent_(exponent) {}

  DistanceAt at(double t) const;
  /// Requires from < to.
  DistanceWithin within(double from, double to) const { return {from, to, least(from, to), most(from, to)}; }
  double most(double from, double to) const;

 private:
  double least(double from, double to) const;
  /// Searches all pairs, and returns the index of the nearest one.
  std::size_t search(double from, double to, spacetime::Nearest& best) const;
  void resolve(double from, double to, spacetime::Nearest& best) const;
  bool may_touch(double from, double to) const;
  bool overlap_throughout(double from, double to) const;
  double lower_end(const spacetime::Nearest& best) const;

  std::vector<const PairDistance*> pairs_;
  spacetime::ClearanceTolerance tolerance_;
  int exponent_;
};

}  // namespace taut::internal
