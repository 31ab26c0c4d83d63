// When do bodies overlap, all of the time, and not only for the first time?
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "taut/check.hpp"

namespace taut {

/// A maximal interval of time in which two bodies overlap.
struct OverlapInterval {
  std::array<BodyId, 2> pair{};  ///< in the order of the scene
  /// Certainly enclose its beginning and its end, as Contact::time does. An overlap that is there at the scene's start
  /// begins with it, exactly, and one that is there at its end ends with it.
  TimeInterval from, to;
  /// What meets what when it begins, and parts when it ends, `grazing` where the enclosure is wide for that; absent at
  /// the scene's start and end.
  std::optional<Contact> enter, exit;
};

/// The answer of intervals().
struct Intervals {
  /// The weakest part of the answer. undecided: nothing is claimed about at least one pair. contact: all pairs are
  /// decided, and two bodies overlap at some time. free: they never do. untested: no pair was tested.
  Outcome outcome = Outcome::free;
  std::string reason;                      ///< why it is undecided or untested; empty otherwise
  std::vector<OverlapInterval> intervals;  ///< pair by pair, each pair's in order of time
  std::vector<PairAnswer> undecided;       ///< pairs about whose overlaps nothing is claimed, with the reason
  Coverage coverage;
  std::optional<CurveGeometry> geometry = {};  ///< of a scene with curves
};

/// All intervals in which bodies overlap, for each pair that is asked about. With open touching an instant of touching
/// is none; with closed touching an interval may be an instant, as far as doubles show, and ends where bodies part.
/// Crossings of edges that follow each other by less than doubles resolve are taken together: what happens between
/// them is within both enclosures. Bodies that part there and meet again have two intervals if they are free at a
/// double. Of the options, `touch`, `max_seconds` and `stop` count. Throws InputError.
Intervals intervals(const Scene& scene, const CheckOptions& options = {});

/// The answer of range().
struct Range {
  Outcome outcome = Outcome::undecided;  ///< free, undecided or untested
  /// Enclose the ends; absent at the start and the end of the scene.
  std::optional<TimeInterval> from, to;
  /// What stops it there.
  std::optional<OverlapInterval> before, after;
  std::string reason;  ///< why it is undecided or untested; empty otherwise
  Coverage coverage;
  std::optional<CurveGeometry> geometry = {};  ///< of a scene with curves
};

/// The maximal interval of time around `t` in which no two bodies that are asked about overlap. Throws InputError if t
/// is not within the scene's time, or bodies overlap then.
Range range(const Scene& scene, double t, const CheckOptions& options = {});

/// The answer of intervals() as `taut intervals --json` prints it.
std::string intervals_json(const Scene& scene, const Intervals& answer, Touch touch);
/// The answer of intervals() as a chart in SVG, a lane for each pair that overlaps or is undecided: bars of overlap
/// over time, hatched where nothing is claimed.
std::string intervals_svg(const Scene& scene, const Intervals& answer, Touch touch, int width = 800);
/// The answer of range(scene, from) as `taut range --json` prints it.
std::string range_json(const Scene& scene, double from, const Range& answer, Touch touch);
/// The answer of range(scene, from) as a chart in SVG: the interval along the scene's time, and what ends it.
std::string range_svg(const Scene& scene, double from, const Range& answer, int width = 800);

}  // namespace taut
