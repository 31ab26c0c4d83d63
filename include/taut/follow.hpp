// The lift of a follower on a cam.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut {

/// How to ask.
struct FollowOptions {
  std::size_t instants = 360;  ///< in [1, 10^6]
  Touch touch = Touch::open;
  Limits limits = {};
};

/// Where a follower lies on what is below it at one instant, and what touches what.
struct Lift {
  TimeInterval time;           ///< encloses the instant
  std::array<double, 2> lift;  ///< encloses that at the instant, along the direction, from where the scene has it
  VertexRef vertex;
  EdgeRef edge;
};

/// The lift of a follower, whose motion in the scene means nothing but for its place at the start, at about so many
/// instants. In each of as many equal stretches of the scene's time it comes down evenly, from `reach` to 0 along the
/// direction, which may have any length but 0 and is seen from its parent if it has one, and where it meets another
/// body is an instant and a lift: both enclosed, for the motions as they are given. Where it meets none there is no
/// entry: the lift is 0 or less. Assumes that a spring presses the follower onto the cam at all times. What touches
/// only between two instants is not seen.
///
/// Throws InputError, also where the follower does not clear the others at `reach`; UndecidedError.
std::vector<Lift> follow(const Scene& scene, BodyId follower, Point direction, double reach,
                         const FollowOptions& options = {});

/// A direction by its angle in degrees, counterclockwise from the x axis: exact for multiples of 90.
Point direction_of(double degrees);

/// {"body": name, "instants": n, "lifts": [{"t": [lo, hi], "lift": [lo, hi], "vertex": {...}, "edge": {...}}, ...]} on
/// one line.
std::string follow_json(const Scene& scene, BodyId follower, const FollowOptions& options,
                        const std::vector<Lift>& lifts);
/// A table with the columns t_lo, t_hi, lift_lo and lift_hi.
std::string follow_csv(const std::vector<Lift>& lifts);

}  // namespace taut
