// The lift of a follower on a cam.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
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

/// The answer of follow().
struct FollowAnswer {
  std::vector<Lift> lifts;                     ///< in order of time
  std::vector<TimeInterval> undecided;         ///< stretches of time whose instants are not decided, in order
  std::string reason;                          ///< why the first of these is not; empty if there are none
  Coverage coverage;                           ///< of pairs with the follower; the others are not asked about
  std::optional<CurveGeometry> geometry = {};  ///< of a scene with curves
};

/// The lift of a follower, which has no motion of its own, at about so many instants. In each of as many equal
/// stretches of the scene's time it comes down evenly, from `reach` to 0 along the direction, which may have any length
/// but 0 and is seen from its parent if it has one, and where it meets another body is an instant and a lift: both
/// enclosed, for the motions as they are given. Where it meets none there is no entry: at the end of that stretch the
/// lift is 0 or less. Each time it is also proved that nothing stood in its way from `reach`
/// down to there at that instant, up to rounding; what passes over it while it comes down is met later in the stretch.
/// Assumes that a spring presses the follower onto the cam at all times. What touches only between two instants is not
/// seen.
///
/// What a limit, or a coincidence, leaves open is listed as undecided. Throws InputError, also where the follower does
/// not clear the others at `reach`, or no pair with it is tested.
FollowAnswer follow(const Scene& scene, BodyId follower, Point direction, double reach,
                    const FollowOptions& options = {});

/// A direction by its angle in degrees, counterclockwise from the x axis: exact for multiples of 90.
Point direction_of(double degrees);

/// {"body": name, "instants": n, "lifts": [{"t": [lo, hi], "lift": [lo, hi], "vertex": {...}, "edge": {...}}, ...]},
/// with what was tested and, if some of the time is undecided, "undecided" and "reason", on one line.
std::string follow_json(const Scene& scene, BodyId follower, const FollowOptions& options, const FollowAnswer& answer);
/// A table with the columns t_lo, t_hi, lift_lo and lift_hi.
std::string follow_csv(const FollowAnswer& answer);

}  // namespace taut
