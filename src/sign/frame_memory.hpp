// What signs and roots of one leg have in common.
#pragma once

#include "numeric/stages.hpp"
#include "sign/kept_searches.hpp"
#include "sign/taylor_frames.hpp"
#include "sign/tie_forms.hpp"

namespace taut {

/// What is remembered of one leg's frame functions, and of which stages told what was asked, on earlier legs, too.
struct FrameMemory {
  TieFrames ties;
  TieForms forms;
  TaylorFrames models;
  KeptSearches searches;
  StageCounts stages;

  /// Makes room for what events at one instant need.
  void reserve_ties() {
    ties.reserve();
    forms.reserve();
  }
  void reset(const Leg& leg) {
    ties.reset(leg);
    forms.clear();
    models.clear();
    searches.clear();
  }
};

}  // namespace taut
