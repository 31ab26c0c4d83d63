// The first contact of one uniformly moving body with several others, or whether there is any.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "spacetime/at_pose.hpp"
#include "spacetime/first_contact.hpp"
#include "spacetime/leaf_test.hpp"
#include "spacetime/uniform_motion.hpp"

namespace taut::internal::spacetime {

/// One of the bodies against which the mover is tested. It plays P, and the mover Q.
struct Other {
  const PairGeometry* geometry = nullptr;
  const Hierarchy* tree = nullptr;
};

/// The motion in both representations: for boxes, and as the segment that exact tests require, which is made on demand.
class UniformSegment {
 public:
  /// Both chains are in one frame; the caller must keep them in place. `mover` is the tree of Q.
  UniformSegment(const PieceChain& p, const PieceChain& q, const Hierarchy& mover, double start, double end)
      : p_(p), q_(q), start_(start), end_(end), motion_(p, q, reach_of(mover)) {}

  UniformStretch stretch(double start, double end) const { return motion_.stretch(start, end); }
  Stretch instant(double t) const { return motion_.instant(t); }
  const MotionSegment& segment() const;

 private:
  const PieceChain &p_, &q_;
  double start_, end_;
  UniformMotion motion_;
  mutable std::optional<MotionSegment> segment_;
};

/// The others share the segment, so that each stretch of time is made once for all of them. Pairs of boxes are divided
/// as in the search for one pair. Keeps its memory between queries.
class UniformPairsSearch {
 public:
  struct Found {
    std::size_t other = 0;
    double lo = 0, hi = 0;  ///< encloses the contact
  };
  /// The first contact in (from, to], provided that nothing overlaps at `from`. With `any`, the search ends with the
  /// first contact that it finds, and `lo` is merely a time before it that is proved free. Throws Undecidable and
  /// Interrupted; proved() then returns the time up to which there is certainly no contact.
  std::optional<Found> run(const UniformSegment& segment, std::span<const Other> others, const Hierarchy& mover,
                           double from, double to, bool any);
  double proved() const { return proved_; }

 private:
  struct Boxes {
    std::uint32_t other, p, q;
  };
  void cover(std::size_t first, double start, double end);
  void evaluate(UniformStretch& s, const Boxes& pair, double start, double end, bool divisible);
  void resolve(const Stretch& s, const RelativePose& relative_pose, std::uint32_t other, const VertexEdge& pair,
               double start, double end);
  void note(LeafTest& leaves, std::uint32_t other, Crossing& found);
  FrameWindow& window_at(double t, double end);
  static bool miss(const Stretch& s, const PairGeometry& g, VertexId of_p, VertexId of_q);
  bool crosses_in_the_middle(const Stretch& s, std::uint32_t other, VertexId of_p, VertexId of_q);
  bool ended() const { return any_ && best_; }

  const UniformSegment* segment_ = nullptr;
  std::span<const Other> others_;
  const Hierarchy* mover_ = nullptr;
  bool any_ = false;
  double shortest_ = 0, shallow_ = 0, proved_ = 0;
  int put_off_ = 0;  ///< edges deferred to shorter stretches, which may decide
  std::optional<Found> best_;
  std::vector<Boxes> pairs_, todo_;
  std::vector<FrameWindow> windows_;  ///< of the current stretch, for its leaves
  std::optional<QAtPose> middle_;     ///< of the current stretch
};

/// Are all edges of the two bodies certainly disjoint at all times of the stretch?
bool apart(const Stretch& stretch, const Hierarchy& p, const Hierarchy& q);

}  // namespace taut::internal::spacetime
