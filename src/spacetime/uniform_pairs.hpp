// One body that moves evenly among several others: their first contact, or whether there is any.
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

/// One of the bodies that the mover is asked about. It plays P, and the mover Q.
struct Other {
  const PairGeometry* geometry = nullptr;
  const Hierarchy* tree = nullptr;
};

/// The motion in both its forms: for boxes, and as the segment that exact tests take, which is made when one is needed.
class UniformSegment {
 public:
  /// Seen from one frame; the chains must stay where they are. `mover` is the tree of Q.
  UniformSegment(const PieceChain& p, const PieceChain& q, const Hierarchy& mover, double start, double end)
      : p_(p), q_(q), start_(start), end_(end), motion_(p, q, reach_of(mover)) {}

  UniformStretch stretch(double start, double end) const { return motion_.stretch(start, end); }
  const MotionSegment& segment() const;

 private:
  const PieceChain &p_, &q_;
  double start_, end_;
  UniformMotion motion_;
  mutable std::optional<MotionSegment> segment_;
};

/// The others share the segment, so that each stretch of time is made once for all of them; pairs of boxes are divided
/// as in the search for one pair. Keeps its memory from question to question.
class UniformPairsSearch {
 public:
  struct Found {
    std::size_t other = 0;
    double lo = 0, hi = 0;  ///< encloses the contact
  };
  /// What is known of the first contact in (from, to], given that nothing overlaps at `from`. With `any`, the search
  /// ends with the first contact that it sees, and `lo` is nothing but a time before it that is proved free.
  /// Throws Undecidable and Interrupted; proved() then says up to when there certainly is none.
  std::optional<Found> run(const UniformSegment& segment, std::span<const Other> others, const Hierarchy& mover,
                           double from, double to, bool any);
  double proved() const { return proved_; }

 private:
  struct Boxes {
    std::uint32_t other, p, q;
  };
  void cover(std::size_t first, double start, double end);
  void look(UniformStretch& s, const Boxes& pair, double start, double end, bool divisible);
  void settle(const Stretch& s, const RelativePose& relative_pose, std::uint32_t other, const VertexEdge& pair,
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
  int put_off_ = 0;  ///< edges that were left to shorter stretches in the hope that these tell
  std::optional<Found> best_;
  std::vector<Boxes> pairs_, todo_;
  std::vector<FrameWindow> windows_;  ///< of the stretch at hand, for its leaves
  std::optional<QAtPose> middle_;     ///< of the stretch at hand
};

/// Are all edges of the two certainly apart at all times of the stretch?
bool apart(const Stretch& stretch, const Hierarchy& p, const Hierarchy& q);

}  // namespace taut::internal::spacetime
