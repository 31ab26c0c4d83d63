// Does a vertex cross an edge? Decided in doubles with error bounds, step by step, and in multi-precision where these
// fail.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>

#include "certificate/fast_function.hpp"
#include "spacetime/crossing.hpp"
#include "spacetime/frame_window.hpp"

namespace taut::internal::spacetime {

/// Value, slope and second derivative of a function at t, with the orientation in which `sign` is positive.
struct LocalExpansion {
  Bounded value, slope, second;
  LocalExpansion(const FastFunction& f, FrameWindow& window, double t, int sign);
  /// The largest h <= limit such that the function is certainly positive on [0, h); 0 if it is not certain at 0.
  double positive_until(double limit) const;
  /// Some h at which the function is certainly negative, soon after its first root, if the function certainly falls on
  /// [0, h]; infinite if there is none up to `limit`. `falls_until` is the time for which it certainly falls.
  double negative_from(double limit, double& falls_until) const;
};

/// The tests on one window of a segment.
class LeafTest {
 public:
  LeafTest(const PairGeometry& geometry, const MotionSegment& segment,
           CrossingDirections directions = CrossingDirections::into)
      : geometry_(geometry),
        segment_(segment),
        directions_(directions),
        precise_(geometry, segment, directions),
        near_end_(segment, directions, precise_) {}

  /// The pair's first crossing in (t, limit], which must lie within the window.
  std::optional<Crossing> first(FrameWindow& window, const VertexEdge& pair, double t, double limit);
  PreciseCrossings& precise() { return precise_; }
  StageCounts stages() const {
    StageCounts sum = stages_;
    return sum += precise_.stages();
  }
  std::uint64_t roots() const { return roots_; }

 private:
  /// The line's function is positive to the left of the edge's line. The others are negative beyond its start, and
  /// beyond its end.
  struct Functions {
    FastFunction line, from_start, from_end;
  };
  Functions functions(const VertexEdge& pair) const;
  const FastFunction* first_order(const VertexEdge& pair);
  bool excluded_in_range(const FrameWindow& window, const VertexEdge& pair) const;
  bool isolate(FrameWindow& window, const Functions& f, double t, double limit, int sign, Crossing& root,
               double& falls_until);
  double beyond_ends(FrameWindow& window, const Functions& f, double t, double limit) const;
  enum class Ahead : unsigned char { unknown, passed, crossing };
  Ahead look_ahead(FrameWindow& window, const Functions& f, double limit, int sign, double& t, Crossing& root);
  Ahead leave_zero(FrameWindow& window, const Functions& f, double limit, double& t, Crossing& root);
  Ahead leave_short_steps(FrameWindow& window, const Functions& f, double limit, int sign, double& t, double& stride,
                          Crossing& root);
  void newton(FrameWindow& window, const FastFunction& line, int sign, Crossing& root) const;
  OnEdge on_edge(FrameWindow& window, const Functions& f, const Crossing& root) const;

  const PairGeometry& geometry_;
  const MotionSegment& segment_;
  CrossingDirections directions_;
  PreciseCrossings precise_;
  CrossingsNearEnd near_end_;
  /// For pairs that doubles once failed to decide: the line's function in the first order of the displacement, if it is
  /// zero without it, as where a vertex slides along an edge.
  std::unordered_map<std::uint64_t, std::optional<FastFunction>> first_orders_;
  StageCounts stages_;  ///< counts of the cases that these functions decided
  std::uint64_t roots_ = 0;
};

}  // namespace taut::internal::spacetime
