// How long two boxes on different bodies certainly stay apart.
#pragma once

#include "spacetime/hierarchy.hpp"
#include "spacetime/motion_bound.hpp"

namespace taut::spacetime {

/// The largest t' found such that the boxes are certainly disjoint on [t, t'), t <= t' <= limit; t itself if they may
/// not be disjoint at t. `limit` lies within the window. In a window that is not smooth: limit or t.
double apart_until(const Leg& leg, FrameWindow& window, const Box& p, const Box& q, double t, double limit);

/// Are the boxes certainly disjoint at t?
bool apart_at(const Leg& leg, FrameWindow& window, const Box& p, const Box& q, double t);

}  // namespace taut::spacetime
