// Corners that need no test on every segment: those that keep their sign wherever the motion goes for many segments.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "certificate/frame_range.hpp"
#include "motion/motion_segments.hpp"
#include "numeric/budget.hpp"

namespace taut::internal::proof {

/// Half-edges, any of which can be taken away at once. Their order is that of the log.
class HalfedgeList {
 public:
  void resize(std::size_t halfedges) { place_.resize(halfedges, nowhere); }
  std::size_t size() const { return list_.size(); }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  bool has(HalfedgeId h) const { return place_[h.value] != nowhere; }
  void add(HalfedgeId h) {
    if (has(h)) return;
    place_[h.value] = static_cast<std::uint32_t>(list_.size());
    list_.push_back(h);
  }
  void remove(HalfedgeId h) {
    if (!has(h)) return;
    const std::uint32_t place = place_[h.value];
    const HalfedgeId last = list_.back();
    list_[place] = last;
    place_[last.value] = place;
    list_.pop_back();
    place_[h.value] = nowhere;
  }
  void clear() {
    for (const HalfedgeId h : list_) place_[h.value] = nowhere;
    list_.clear();
  }

 private:
  static constexpr std::uint32_t nowhere = 0xffffffffu;
  std::vector<HalfedgeId> list_;
  std::vector<std::uint32_t> place_;  ///< by half-edge
};

/// Some segments, and where the motion is on them. Many segments and many corners are then not tested in all pairs.
class StretchOfSegments {
 public:
  explicit StretchOfSegments(const PairGeometry& geometry) : geometry_(geometry) {}

  /// True if a new stretch begins with this segment: then all corners are to be asked about anew.
  bool enter(const MotionSegments& segments, std::size_t segment, std::size_t corners) {
    if (segment < end_) return false;
    range_.reset();
    end_ = segment + 1;
    if (corners < few_corners) return true;
    // So many that the new test of all corners costs each segment a few of them.
    length_ = std::clamp<std::size_t>(length_, 1, corners / 8);
    end_ = std::min(segment + length_, segments.size());
    range_ = range_of(segments[segment]);
    for (std::size_t k = segment + 1; k < end_; ++k) {
      checkpoint();
      range_->include(range_of(segments[k]));
    }
    return true;
  }

  /// Does the corner certainly have this sign at all times of the stretch?
  bool decides(VertexId u, VertexId v, VertexId w, int sign) const {
    checkpoint();
    return range_ && range_->keeps_sign(geometry_, CertificateFunction::of(geometry_, u, v, w), sign);
  }

  /// What came of it: a motion that goes far is better divided into short stretches.
  void judge(std::size_t open, std::size_t corners) { length_ = 2 * open > corners ? length_ / 4 : 2 * length_; }

 private:
  static constexpr std::size_t few_corners = 64, first_length = 16;
  static FrameRange range_of(const MotionSegment& segment) {
    return FrameRange::over(segment, segment.start, segment.end);
  }

  const PairGeometry& geometry_;
  std::size_t end_ = 0;  ///< the first segment that is not part of it
  std::size_t length_ = first_length;
  std::optional<FrameRange> range_;
};

}  // namespace taut::internal::proof
