// What signs and roots of one segment have in common.
#pragma once

#include "numeric/stages.hpp"
#include "sign/expansion_cache.hpp"
#include "sign/kept_searches.hpp"
#include "sign/taylor_frames.hpp"

namespace taut::internal {

/// What is remembered of one segment's frame functions, and of which stages told what was asked, on earlier segments,
/// too.
struct FrameMemory {
  FrameExpansionCache expansions;
  ExpansionCache functions;
  TaylorFrames models;
  KeptSearches searches;
  StageCounts stages;

  /// Makes room for what events at one instant need.
  void reserve_expansions() {
    expansions.reserve();
    functions.reserve();
  }
  void reset(const MotionSegment& segment) {
    expansions.reset(segment);
    functions.clear();
    models.clear();
    searches.clear();
  }
};

}  // namespace taut::internal
