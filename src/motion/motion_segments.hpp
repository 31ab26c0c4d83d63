// The segments of a relative motion, each constructed on demand.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "motion/motion_segment.hpp"
#include "motion/piece_list.hpp"

namespace taut::internal {

/// The place of a segment, which is known before the segment is constructed.
struct SegmentPlace {
  double start = 0, end = 0;  ///< in time; for a bridge both are the joint
  bool bridge = false;
  std::uint32_t stretch = 0;  ///< the number of the interval between joints; for a bridge, of the one before it
};

/// All segments from start to end, in order. A segment has more than a thousand bytes, and between a hundred thousand
/// keyframes there are two hundred thousand segments. Engines, verifiers and queries visit them one after the other. So
/// only their places are stored, and the segments used last. Copies share places and pieces, and the segments that were
/// constructed before.
///
/// A reference to a segment is valid until sixteen others have been requested. A caller that needs it longer holds it
/// (hold()), and then all callers share the same object. Not thread-safe.
class MotionSegments {
 public:
  /// An empty sequence.
  MotionSegments() = default;
  /// A sequence of one existing segment.
  explicit MotionSegments(MotionSegment segment);
  /// One segment for each interval without a joint, and a bridge at each joint where a piece changes. p and q must have
  /// at least one motion each.
  MotionSegments(MotionChain p, MotionChain q, double start, double end);
  MotionSegments(const MotionSegments& other)
      : route_(other.route_), dropped_(other.dropped_), only_(other.only_), window_(other.window_) {}
  MotionSegments(MotionSegments&&) noexcept = default;
  MotionSegments& operator=(const MotionSegments& other) { return *this = MotionSegments(other); }
  MotionSegments& operator=(MotionSegments&&) noexcept = default;
  ~MotionSegments() = default;

  std::size_t size() const { return only_ ? 1 : route_size() - dropped_; }
  const MotionSegment& operator[](std::size_t k) const { return *kept(k); }
  const MotionSegment& front() const { return (*this)[0]; }
  std::shared_ptr<const MotionSegment> hold(std::size_t k) const { return kept(k); }
  SegmentPlace place(std::size_t k) const;
  /// The number of the first segment that ends at t or later; size() if there is none.
  std::size_t first_until(double t) const;
  /// From when on bodies are only where they have been before: see motion/far_pieces.hpp.
  double repeats_from() const;
  /// Drops the segments that nobody holds. They are constructed again, identically, when they are asked for.
  void give_back() const;
  /// Removes the first segment; the others are renumbered.
  void drop_first();
  /// The segments of the same motion with the roles of P and Q exchanged. Not for a sequence of one existing segment.
  MotionSegments exchanged() const;
  /// For loops over all of them.
  class Iterator {
   public:
    Iterator(const MotionSegments& segments, std::size_t k) : segments_(&segments), k_(k) {}
    const MotionSegment& operator*() const { return (*segments_)[k_]; }
    Iterator& operator++() {
      ++k_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return k_ != other.k_; }

   private:
    const MotionSegments* segments_;
    std::size_t k_;
  };
  Iterator begin() const { return {*this, 0}; }
  Iterator end() const { return {*this, size()}; }
  /// Are the functions of mixed triples linear on all segments? Then there is only one segment.
  bool straight() const;

 private:
  struct Route;
  static constexpr std::size_t window = 16;
  struct Kept {
    std::size_t number = SIZE_MAX;
    std::shared_ptr<const MotionSegment> segment;
  };

  std::size_t route_size() const;
  const std::shared_ptr<const MotionSegment>& kept(std::size_t k) const;
  void replace(Kept& place, std::size_t k) const;

  std::shared_ptr<const Route> route_;
  std::size_t dropped_ = 0;  ///< the number of the route's segments that come before the first one
  std::shared_ptr<const MotionSegment> only_;
  mutable std::vector<Kept> window_;  ///< indexed by the last bits of the segment's number
  /// Segments that had to leave the window but are still held. As long as they are, no other copy of them is
  /// constructed.
  mutable std::vector<std::pair<std::size_t, std::weak_ptr<const MotionSegment>>> held_;
};

// Converts the motions of two bodies to the segments of their relative motion.

/// The segments from start to end: one for each interval without a joint, and a bridge at each joint where a piece
/// changes.
inline MotionSegments make_segments(const PieceList& p, const PieceList& q, double start, double end) {
  return MotionSegments(MotionChain{p}, MotionChain{q}, start, end);
}
/// The segments for bodies with parents.
inline MotionSegments make_segments(const MotionChain& p, const MotionChain& q, double start, double end) {
  return MotionSegments(p, q, start, end);
}

}  // namespace taut::internal
