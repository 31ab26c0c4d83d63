// Data shared by the signs and roots of one segment.
#pragma once

#include "certificate/expansion_cache.hpp"
#include "certificate/taylor_frames.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {

/// Cached data of one segment's frame functions, and counts of the stages that decided, also on earlier segments.
struct FrameMemory {
  FrameExpansionCache expansions;
  ExpansionCache functions;
  TaylorFrames models;
  StageCounts stages;

  /// Makes room for the needs of events at one instant.
  void reserve_expansions() {
    expansions.reserve();
    functions.reserve();
  }
  /// Gives the room back, for others in this thread to use.
  void release() {
    expansions.release();
    functions.release();
    models.clear();
  }
  void reset(const MotionSegment& segment) {
    expansions.reset(segment);
    functions.clear();
    models.clear();
  }
};

}  // namespace taut::internal
