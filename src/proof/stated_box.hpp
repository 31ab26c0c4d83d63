// The boxes that a log of separations states around moving bodies, and whether the bodies stay within them.
#pragma once

#include <limits>
#include <optional>

#include "geometry/axis_box.hpp"
#include "proof/bytes.hpp"
#include "proof/verifier_scene.hpp"

namespace taut::internal::proof {

/// A stretch of the world's time, without its beginning unless it begins with the scene: stretches that follow each
/// other have each joint once.
struct WorldTime {
  double from = 0, to = 0;
  bool first = true;

  double middle() const { return from + (to - from) / 2; }
  bool divisible() const { return from < middle() && middle() < to; }
  WorldTime first_half() const { return {from, middle(), first}; }
  WorldTime second_half() const { return {middle(), to, false}; }
};

/// Along the axes of the world's frame, in internal coordinates; its borders belong to it. Everywhere at first.
struct StatedBox {
  float lo_x = -std::numeric_limits<float>::infinity(), lo_y = lo_x;
  float hi_x = std::numeric_limits<float>::infinity(), hi_y = hi_x;
};

/// Around a box has to be so much room, besides the margin: far more than any vertex is displaced by, so that bodies
/// whose boxes do not meet do not meet however they are displaced.
inline constexpr double box_room = 0x1p-60;

/// Throws ProofError unless it is a box.
StatedBox read_box(ByteReader& in);

/// Does everything that is nearer to the body than `room`, along x or y, stay within the box at all instants of that
/// time? At a joint also where a part of the chain of motions, the outermost ones, is before it still: from there
/// bodies go straight to where they are after it. False where that is so, but by so little that doubles do not decide.
bool stays_within(const VerifierBody& body, const WorldTime& time, double room, const StatedBox& box);

/// A box in which the body, without room around it, stays. Nothing where its motion is too wild to decide.
std::optional<AxisBox> box_around(const VerifierBody& body, const WorldTime& time);

/// Does what is nearer than `room` to such a box stay within a stated one? Then stays_within() says so of the body.
bool has_room(const StatedBox& box, double room, const AxisBox& reach);

}  // namespace taut::internal::proof
