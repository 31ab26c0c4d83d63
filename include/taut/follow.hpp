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
  /// Also what touches what at all times: see FollowAnswer::contacts.
  bool contacts = false;
  /// Of the contacts: how long a change of them may be left open, as a share of the scene's time; in [1e-13, 1].
  double tolerance = 1e-9;
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

/// A vertex of the follower on an edge of another body, or a vertex of another body on an edge of the follower.
struct FollowContact {
  VertexRef vertex;
  EdgeRef edge;
  friend bool operator==(const FollowContact&, const FollowContact&) = default;
};

/// What a stretch of time is known for.
enum class FollowState : unsigned char {
  carried,  ///< at all of its instants, these contacts hold the follower, all of them, and no others do
  low,      ///< at all of its instants, nothing reaches up to where the scene has the follower: the lift is below 0
  change,   ///< no longer than the tolerance: contacts change here
  open      ///< longer than that, and not decided
};

/// A stretch of the time of a contact sequence.
struct FollowStretch {
  FollowState state;
  TimeInterval time;
  std::array<double, 2> lift;  ///< encloses the lift at all of its instants; 0 stands for lower ones
  /// Of `carried`: what touches; several contacts only where they have the same lift at all times, as those of an edge
  /// on an edge. Of `change` and `open`: all that may touch there; that it is in contact is not proved.
  std::vector<FollowContact> contacts;
  bool once = false;   ///< of `change`: proved to be one change, of the contacts before to those after
  bool jumps = false;  ///< of `change`: the lift is proved to jump there, as of a follower that falls off an edge
};

/// The answer of follow().
struct FollowAnswer {
  std::vector<Lift> lifts;  ///< in order of time
  /// If asked for: stretches of time in order, each of which begins where the last one ended, from the scene's start to
  /// its end. Adjacent ones differ.
  std::vector<FollowStretch> contacts;
  std::string contacts_reason;                 ///< why the first open one of these is; empty if none is
  std::vector<TimeInterval> undecided;         ///< stretches of time whose instants are not decided, in order
  std::string reason;                          ///< why the first of these is not; empty if there are none
  Coverage coverage;                           ///< of pairs with the follower; the others are not asked about
  std::optional<CurveGeometry> geometry = {};  ///< of a scene with curves
};

/// The lift of a follower, which has no motion of its own, at about so many instants. In each of as many equal
/// stretches of the scene's time it comes down evenly, from `reach` to 0 along the direction, which may have any length
/// but 0 and is seen from its parent if it has one, and where it meets another body is an instant and a lift: both
/// enclosed, for the motions as they are given. Where it meets none there is no entry: at the end of that stretch the
/// lift is 0 or less. Each time it is also proved that nothing stood in its way from `reach` down to there at that
/// instant, up to rounding; what passes over it while it comes down is met later in the stretch.
/// Assumes that a spring presses the follower onto the cam at all times. What touches only between two instants is not
/// among the lifts.
///
/// With `contacts`, nothing is missed: the lift is the greatest one up to `reach` at which a vertex of one body lies on
/// an edge of another one. The answer has all of the scene's time in stretches. In each of them it is proved which
/// contacts have the greatest lift, at all of its instants, or it is shorter than the tolerance, and lists all contacts
/// that may have it. Sides along the direction, at which a body only slides, are no contacts. Requires that the
/// follower is free at `reach` at all times, which is proved, up to rounding of its place; and polygons: throws
/// InputError for curves.
///
/// What a limit, or a coincidence, leaves open is listed as undecided. Throws InputError, also where the follower does
/// not clear the others at `reach`, or no pair with it is tested.
FollowAnswer follow(const Scene& scene, BodyId follower, Point direction, double reach,
                    const FollowOptions& options = {});

/// A direction by its angle in degrees, counterclockwise from the x axis: exact for multiples of 90.
Point direction_of(double degrees);

/// {"body": name, "instants": n, "lifts": [{"t": [lo, hi], "lift": [lo, hi], "vertex": {...}, "edge": {...}}, ...]},
/// with what was tested and, if some of the time is undecided, "undecided" and "reason", on one line.
/// With contacts, also "tolerance" and "contacts": [{"t": [from, to], "state": "carried", "lift": [lo, hi],
/// "touching": [{"vertex": {...}, "edge": {...}}, ...]}, ...]; a change has "once" and "jumps", where they are true.
std::string follow_json(const Scene& scene, BodyId follower, const FollowOptions& options, const FollowAnswer& answer);
/// "carried", "low", "change" or "open".
const char* to_string(FollowState state);
/// "cam 2 on plate 0": vertex 2 of the cam on edge 0 of the plate.
std::string contact_text(const Scene& scene, const FollowContact& contact);
/// A table with the columns t_lo, t_hi, lift_lo and lift_hi.
std::string follow_csv(const FollowAnswer& answer);
/// A table of the contacts, with the columns t_lo, t_hi, state, lift_lo, lift_hi, once, jumps and touching: "cam 2 on
/// plate 0", separated by semicolons.
std::string follow_contacts_csv(const Scene& scene, const FollowAnswer& answer);

}  // namespace taut
