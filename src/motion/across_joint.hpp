// Two bodies of a mechanism that a joint joins which is not in the tree of joints, or that are on one pin.
#pragma once

#include <optional>

#include "motion/piece_list.hpp"

namespace taut::internal {

/// The motions of two bodies, seen from a frame that both have.
struct MotionsFrom {
  MotionChain frame;  ///< the frame's own motions, the outermost first
  MotionChain p, q;
};

/// Seen from the one link, the other one follows their joint: that holds exactly, which chains of other joints from the
/// ground show in digits only. Nothing if no closing joint joins their links, or one of the tree does.
std::optional<MotionsFrom> across_joint(const MotionChain& p, const MotionChain& q);

}  // namespace taut::internal
