// Is there any way from one combination of joint values to another?
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/envelope.hpp"

namespace taut {

/// A start, a goal, and what may move in between.
struct PathProblem {
  Linkage linkage;
  /// Joints whose period is the length of their range: each body that follows one must turn by whole turns over it.
  std::array<bool, max_joints> periodic{};
  JointValues start{};
  /// The least and largest value of each joint at the goal; a joint without is free there.
  std::array<std::optional<std::array<double, 2>>, max_joints> goal{};
  /// The goal is instead: the axis-aligned box of each body that moves and the box of each body that does not have no
  /// common interior. A body moves if it, or one of its parents, follows a joint.
  bool goal_outside = false;
};

/// What is known about ways from the start to the goal.
enum class PathOutcome {
  path,       ///< there is one: `waypoints`
  none,       ///< proved: no continuous way of any shape within the joints' ranges
  undecided,  ///< neither was shown at this tolerance, or before a limit
  untested,   ///< no pair of bodies was tested, so there is no verdict; `reason` says why
};

/// "path", "none", "undecided" or "untested".
const char* to_string(PathOutcome outcome);

/// A vertex of one body and an edge of the other one that come together where it is tight.
struct TightFeatures {
  VertexRef vertex;
  EdgeRef edge;
  double distance = 0;  ///< between the two, in the scene's units, rounded: an overlap has a distance, too
};

/// Where it was too tight to decide.
struct TightPlace {
  /// In a cell that would connect the start and the goal: where the bodies are likely to have most room.
  JointValues values{};
  JointValues size{};            ///< the sides of that cell
  std::array<BodyId, 2> pair{};  ///< a pair that is neither apart nor overlapping in the cell
  /// Of that pair at `values`, the vertex and the edge that are nearest to each other; and then, if there are some that
  /// were not shown to be apart either, the nearest ones that push the bodies the other way: the two sides of a slot.
  std::vector<TightFeatures> features;
};

/// How long a way is, and how long every way is at the least.
struct PathLength {
  double way = 0;                ///< of the way that was found, rounded up
  double shortest_at_least = 0;  ///< proved: no way from the start to the goal is shorter; rounded down
  /// Of each joint. The length of a segment is the square root of the sum of (weight times change)^2. A weight is the
  /// speed of the fastest vertex of any body at the start, in the scene's units, while that joint alone moves at
  /// speed 1. All are 0 if the answer is exact: the length is then that of the way of each point of what moves.
  JointValues weights{};
};

/// The answer of find_path().
struct PathAnswer {
  PathOutcome outcome = PathOutcome::undecided;
  /// Of a path: from the start to the goal. Between two of them all joints move evenly. Every instant is proved free:
  /// check() of path_scene() is. Joints with a period may leave their range, as 370 after 350.
  std::vector<JointValues> waypoints;
  /// Of a path, if it was to be short.
  std::optional<PathLength> length;
  /// Of an undecided answer, unless a limit came first.
  std::optional<TightPlace> tight;
  /// Only translations were left, and exact signs decided: no tolerance mattered.
  bool exact = false;
  /// The partition of all combinations as the search left it: it is fine where that mattered only. Cells that were not
  /// decided, and need not be, are `undecided`. Empty if the answer is exact.
  std::vector<EnvelopeCell> cells;
  /// Why it is undecided or untested, or why a path that was to be short may be longer than `within` says; else empty.
  std::string reason;
  Coverage coverage;
};

/// How to ask.
struct PathOptions {
  /// open: bodies may touch all of the way. closed: at no instant.
  Touch touch = Touch::open;
  /// If positive: bodies keep at least this distance, in the scene's units, all of the way, whatever `touch` says.
  double clearance = 0;
  /// Cells no side of which is longer than this share of its joint's range are not divided any more. In [1e-9, 1].
  double tolerance = 1e-4;
  /// Stop with `undecided` when there are so many cells: some 700 bytes each.
  std::uint64_t max_cells = 4'000'000;
  /// Make the way short, and bound from below how long any way is.
  bool shortest = false;
  /// A way that is at most this share longer than that bound is short enough. In [0, 1e6].
  double within = 0.05;
  Limits limits = {};
};

/// Searches for a way from the start to the goal along which no tested pair of bodies collides, or shows that there is
/// none. Every two bodies are tested that are not ignored and that joints move against each other; others once, if the
/// scene says so.
///
/// Where one slide, or two that are not parallel, move one body, or several alike, and no clearance is given, exact
/// signs decide, tangencies too. Else the box of all joint values is divided into cells that are free, that collide,
/// and others, which are divided further where they would connect the start and the goal. `none` is shown by cells that
/// collide for all values in them, on every way out of what the start reaches.
///
/// Throws InputError, also if the start collides (`closed`: touches; with a clearance: is too near), or the goal does
/// and is one combination.
PathAnswer find_path(const PathProblem& problem, const PathOptions& options = {});

/// Throws InputError unless the problem can be asked about.
void validate(const PathProblem& problem);

/// An ordinary scene in which the bodies go along the waypoints: one unit of time from each to the next. If all
/// waypoints are the same, pairs that no joint moves are ignored, unless the problem tests them.
Scene path_scene(const PathProblem& problem, const std::vector<JointValues>& waypoints);

/// The answer of find_path() as `taut path --json` prints it; `cells`: with the whole partition.
std::string path_json(const PathProblem& problem, const PathAnswer& answer, const PathOptions& options,
                      bool cells = false);
/// All combinations of one or two joints as an SVG picture: the cells as the search left them, the start, and the way,
/// or where it was too tight. Throws InputError if there are more joints.
std::string path_svg(const PathProblem& problem, const PathAnswer& answer, int width = 720);

}  // namespace taut
