// In which directions, or along which ways, do bodies come apart, and in which order does an assembly?
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "taut/check.hpp"

namespace taut {

/// An angle from the x axis, counterclockwise, in degrees in [0, 360): an interval that certainly contains it.
struct DirectionInterval {
  double lo = 0, hi = 0;
};

/// A vertex of one body that comes to an edge of the other just where the travel ends.
struct VertexAtEdge {
  VertexRef vertex;
  EdgeRef edge;
};

/// A maximal closed arc of directions, counterclockwise from `from` to `to`.
struct DirectionArc {
  DirectionInterval from, to;
  /// A single direction, as far as doubles can show: a slot that fits exactly.
  bool point = false;
  /// What ends the arc: in that direction, a vertex of the moving body comes to a vertex of another one,
  std::optional<std::array<VertexRef, 2>> from_vertices, to_vertices;
  /// or the travel ends just there. None of these if the arc is all directions.
  std::optional<VertexAtEdge> from_reach, to_reach;
};

/// Where one body can go by itself.
struct BodyDirections {
  BodyId body = 0;
  std::vector<DirectionArc> free;  ///< in order of `from`; empty: it is locked
  bool all = false;                ///< free in every direction: `free` is one arc, from 0 to 0
};

/// One body taken away, straight.
struct RemovalStep {
  BodyId body = 0;
  DirectionArc free;         ///< one of the arcs in which it leaves those that are left
  double direction_deg = 0;  ///< within it, about its middle
};

/// A place on a way: a point p of the body, where the body stands at the start, is then at
/// R (p - pivot) + pivot + (x, y), where R turns by `deg` degrees counterclockwise.
struct WayPoint {
  double x = 0, y = 0, deg = 0;
};

/// One body taken away along a way on which it may turn. Between two points x, y and deg change evenly.
struct RemovalWay {
  BodyId body = 0;
  Point pivot;
  /// From the start, (0, 0, 0), to where the body's box and the common box of all that block it have no inner point in
  /// common. From there on the body can leave straight.
  std::vector<WayPoint> points;
};

/// What is known of the ways apart.
enum class SeparationOutcome {
  free,              ///< bodies come apart; if there are more than two, all of them one by one
  locked,            ///< they do not: the second of two has no direction or way, or of more some are `stuck`
  overlap_at_start,  ///< two bodies overlap, so there is no question
  undecided,         ///< a limit was reached, or the highest precision does not decide
  untested,          ///< no pair of bodies was tested
};

/// "free", "locked", "overlap_at_start", "undecided" or "untested".
const char* to_string(SeparationOutcome outcome);

/// The answer of separate().
struct Separation {
  SeparationOutcome outcome = SeparationOutcome::undecided;
  /// The pair that overlaps at the start, if one does: nothing else is said then.
  std::optional<std::array<BodyId, 2>> overlap;
  /// Of two bodies, the second one's directions against the first; of more, each one's against all others, in order.
  std::vector<BodyDirections> bodies;
  /// An order in which bodies leave one by one, as far as one goes; of more than two bodies.
  std::vector<RemovalStep> order;
  /// With SeparateOptions::turns: an order in which bodies leave one by one along ways, as far as one goes. Each way is
  /// proved free: check() of removal_scene() is.
  std::vector<RemovalWay> ways;
  /// Those that are left and cannot be taken away one by one: not straight, or with SeparateOptions::turns, along no
  /// way of any shape. Several might still leave together.
  std::vector<BodyId> stuck;
  /// With SeparateOptions::turns: those that are left, and of which that is not known.
  std::vector<BodyId> unsure;
  /// With SeparateOptions::turns: `ways`, `stuck` and `unsure` are about bodies whose boundaries lie within this of
  /// those meant, since where they stand at the start is rounded to doubles; towards the material, if some fit
  /// exactly. 0 if all are drawn where they stand.
  double rounded = 0;
  std::string reason;                          ///< why it is undecided or untested; empty otherwise
  Coverage coverage;                           ///< `at_rest` and `moving_alike` are 0: bodies stand still but for one
  std::optional<CurveGeometry> geometry = {};  ///< of a scene with curves
  /// Why ends of free arcs are enclosed less narrowly than to 1e-7 degrees, as curves may demand; else empty.
  std::string wide = {};
};

/// How to ask.
struct SeparateOptions {
  /// How far bodies move straight, in the scene's units; > 0. Infinite: any distance. Ways with turns go as far as they
  /// have to.
  double travel = std::numeric_limits<double>::infinity();
  /// Ask, too, whether bodies come apart if the one that is taken away may turn on its way. Not for bodies with curves.
  bool turns = false;
  /// With `turns`: places and angles are divided down to this share of their ranges, which are as large as everything
  /// together, and 360 degrees. In [1e-9, 1].
  double tolerance = 1e-4;
  /// With `turns`: a body is left undecided at so many cells: some 700 bytes each.
  std::uint64_t max_cells = 4'000'000;
  Limits limits = {};
};

/// Bodies stand as at the start of the scene's time, whatever they do later, and one of them is moved straight, without
/// turning, any distance: in which directions does it overlap nothing on the way? Touching and sliding are allowed, as
/// in check() with open touching. Pairs that the scene ignores do not block each other.
///
/// A direction is blocked by two edges if it leads from a point within the one to a point within the other, so the
/// blocked directions are a union of open arcs between differences of vertices; which of two differences comes first is
/// decided exactly. Decided by exact signs; degrees are enclosed. With a travel that ends, one at whose end bodies only
/// touch is free.
///
/// With SeparateOptions::turns, bodies that cannot leave straight are also moved along ways, as find_path() finds them:
/// one at a time, anywhere in the plane, turning as they like. A body that can leave can leave later, too, so the order
/// matters to nothing but the length of the ways. A body that only fits exactly is decided where it leaves straight;
/// turns that fit exactly stay undecided. Throws InputError.
Separation separate(const Scene& scene, const SeparateOptions& options = {});

/// Of an answer with SeparateOptions::turns about the scene: an ordinary scene in which the bodies go along their ways,
/// one after the other, one unit of time from each point to the next. Those that have left are moved out of the way of
/// the others; the rest stands as at the start.
Scene removal_scene(const Scene& scene, const Separation& answer);

/// The answer of separate() as `taut separate --json` prints it. `removal`: with turns, removal_scene(), too.
std::string separation_json(const Scene& scene, const Separation& answer, const SeparateOptions& options = {},
                            bool removal = false);
/// The bodies as they stand at the start, each with a rose of the directions in which it can leave: in SVG.
std::string separation_svg(const Scene& scene, const Separation& answer, int width = 800);

}  // namespace taut
