// How close do bodies come?
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "taut/check.hpp"

namespace taut {

/// Where two bodies are nearest to each other, as far as was found.
struct NearestPoints {
  std::array<BodyId, 2> pair{};    ///< in the order of the scene
  double lo = 0, hi = 0;           ///< certainly encloses the least distance of the pair's closures over all time
  TimeInterval time;               ///< in it the distance is at most `hi`
  std::array<Point, 2> points{};   ///< one on each body, in the pair's order; world coordinates, rounded
  std::array<EdgeRef, 2> edges{};  ///< on which the points lie
};

/// The answer of clearance().
struct Clearance {
  /// free: no two bodies ever touch. contact: two do, and `nearest` says which and when. Else undecided or untested.
  Outcome outcome = Outcome::undecided;
  /// Of the pair that comes closest. Absent if the outcome is undecided or untested.
  std::optional<NearestPoints> nearest;
  /// With `all_pairs`: of every pair that is asked about, and comes within ClearanceOptions::within, in the order of
  /// the scene.
  std::vector<NearestPoints> pairs;
  std::string reason;  ///< why it is undecided or untested; empty otherwise
  Coverage coverage;
  std::optional<CurveGeometry> geometry = {};  ///< of a scene with curves
  /// Why the bracket of `nearest` is wider than was asked for, relative to it: curves run along each other for long,
  /// the highest precision does not decide whether a margin is kept, or coordinates are large. Else empty.
  std::string wide = {};
};

/// How precise the bracket is to be.
struct ClearanceOptions {
  /// hi - lo <= relative * hi + 1e-12 of the largest coordinate. `wide` says why it is wider, and also if the second
  /// part is the larger one. At least 1e-12.
  double relative = 1e-9;
  bool all_pairs = false;
  /// With `all_pairs`: only pairs that may come as close as this, in the scene's units, > 0. Others are certainly
  /// farther apart all the time. Of many bodies, those that are near are few.
  double within = 1e300;
  Limits limits = {};
};

/// The least distance of the closures of any two bodies that are asked about, over the scene's time: 0 if they touch or
/// overlap. The bracket is certain, by branch and bound over time and pairs of boxes with certified bounds, and where
/// these do not decide, by roots of any precision; instants in between are in it as well. Throws InputError.
Clearance clearance(const Scene& scene, const ClearanceOptions& options = {});

/// Which features come as close as a clearance: a vertex of one body, and an edge of the other one onto which it
/// projects, or a vertex. One of `edge` and `other` is there.
struct CloseFeatures {
  VertexRef vertex;
  std::optional<EdgeRef> edge;
  std::optional<VertexRef> other;
};

/// What is known of one pair of bodies and a clearance that it should keep.
struct PairMargin {
  std::array<BodyId, 2> bodies{};  ///< in the order of the scene
  /// contact: they come closer (`closed` touching: as close), first within `time`. closer_at_start, overlap_at_start:
  /// they are, or even overlap, at the start. undecided: the highest precision does not decide, or a limit was reached.
  Outcome outcome = Outcome::free;
  TimeInterval time;  ///< of a contact: encloses the instant, as that of check() does
  /// As of a contact of check(): the bracket is wider than the clock is fine, since they come closer so slowly.
  bool grazing = false;
  std::optional<CloseFeatures> features;  ///< of a contact
  /// Where they are nearest then: `hi` is no less than the distance. Not of bodies that overlap at the start.
  std::optional<NearestPoints> nearest;
  double free_until = 0;  ///< certainly not closer before this time
  std::string reason;     ///< why it is `undecided`
  Margin margin = {};     ///< what the pair is to keep: Scene::clearances say it, or who asks
  /// An upper bound of the margin, hardly above it, at the end of a contact's `time`, or else at `free_until`.
  double margin_at = 0;
};

/// The answer of check_clearance().
struct MarginAnswer {
  Outcome outcome = Outcome::free;  ///< of the pair that comes closer first
  std::optional<PairMargin> first;  ///< that pair, unless the outcome is `free`
  std::vector<PairMargin> also;     ///< others that come closer so soon after it that the order is not decided
  std::vector<PairMargin> pairs;    ///< with CheckOptions::all_pairs, as Answer::pairs
  double free_until = 0;
  std::string reason;  ///< why it is undecided or untested; empty otherwise
  Coverage coverage;
  std::optional<CurveGeometry> geometry = {};  ///< of a scene with curves
};

/// Do all bodies keep this distance, in the scene's units, and if not, when and where do they first come closer? The
/// question of check() with a margin; `clearance` must be positive. Pairs that Scene::clearances name keep the margin
/// given there instead, which may change with time: the question is then when d(t) < m(t) first. With
/// CheckOptions::touch `open` bodies that come to the clearance and no closer, or stay at it, are free; `closed`, they
/// are in contact. Free is proved, and so is the time of a contact: certified bounds in doubles decide what stays away,
/// roots of any precision the rest. Engines, tracers and events mean nothing here. Throws InputError, also if
/// CheckOptions::fit is given.
MarginAnswer check_clearance(const Scene& scene, double clearance, const CheckOptions& options = {});

/// The distance at an instant: certainly lo <= d(t) <= hi.
struct DistanceAt {
  double t = 0, lo = 0, hi = 0;
};

/// The distance over a stretch of time: certainly lo <= d(t) <= hi for from <= t <= to.
struct DistanceWithin {
  double from = 0, to = 0, lo = 0, hi = 0;
};

/// The distance d(t) of two bodies' closures as a curve: 0 where they touch or overlap.
struct DistanceCurve {
  /// Whose distance it is, in the order of the scene. Absent: at each time the least one of all pairs asked about.
  std::optional<std::array<BodyId, 2>> pair;
  std::vector<DistanceAt> instants;       ///< evenly spaced, from the scene's start to its end
  std::vector<DistanceWithin> stretches;  ///< between an instant and the next one
  double largest_lo = 0, largest_hi = 0;  ///< certainly enclose the greatest distance over the scene's time
  double largest_at = 0;                  ///< a time at which the distance is at least `largest_lo`
  /// Is the bracket of the greatest distance as narrow as was asked for, or of curves, as can be asked for?
  bool settled = false;
  /// Why that bracket is wider than was asked for: ProfileOptions::halvings did not suffice, or doubles do not decide
  /// more, as where a body turns with infinite speed; else empty.
  std::string wide = {};
};

/// The answer of distance_profile().
struct DistanceProfile {
  /// free: no two bodies ever touch. contact: two do at some time. Else undecided or untested.
  Outcome outcome = Outcome::undecided;
  /// First the least distance of all pairs; with `all_pairs`, and if there are several, then each pair's own, in the
  /// order of the scene. None if the outcome is undecided or untested.
  std::vector<DistanceCurve> curves;
  std::string reason;  ///< why it is undecided or untested; empty otherwise
  Coverage coverage;
  /// Of a scene with curves; `tolerance` is the widest bracket of an instant.
  std::optional<CurveGeometry> geometry = {};
};

/// What is to be known of the distance, and how precisely.
struct ProfileOptions {
  int instants = 101;  ///< 2 to 1,000,000
  /// As in ClearanceOptions, for each instant, for the lower bound of each stretch, and for the greatest distance. At
  /// least 1e-12.
  double relative = 1e-9;
  /// So many times is a stretch halved, of each curve, in search of the greatest distance.
  int halvings = 20000;
  bool all_pairs = false;
  Limits limits = {};
};

/// The distance of bodies over the scene's time. Each bracket is certain: at instants and from below by branch and
/// bound, over stretches from above by a vertex and an edge that are followed. The upper bound of a stretch is as good
/// as the stretch is short; the greatest distance is found by halving those that may have it. Where bodies may touch or
/// not, within the enclosure of an instant of touching, the lower end is 0. Brackets of curves hold the curves' own
/// distance: from below that of polygons around them, from above that of polygons within, finer where bodies are near
/// at the instants. Stretches and the greatest distance of curves are known no better than to 1e-4 of it. Throws
/// InputError.
DistanceProfile distance_profile(const Scene& scene, const ProfileOptions& options = {});

/// The answer of clearance() as `taut clearance --json` prints it.
std::string clearance_json(const Scene& scene, const Clearance& answer);
/// The bodies where they are closest, in SVG, with the closest points and their distance; where nothing was found, at
/// the start.
std::string clearance_svg(const Scene& scene, const Clearance& answer, int width = 800);
/// The answer of check_clearance() as `taut check --clearance C --json` prints it. `touch` is what was asked.
std::string margin_json(const Scene& scene, double clearance, const MarginAnswer& answer, Touch touch);
/// The bodies where they first come closer, in SVG, with the points that do; at the start, if they keep the clearance.
std::string margin_svg(const Scene& scene, double clearance, const MarginAnswer& answer, int width = 800);
/// The answer of distance_profile() as `taut clearance --profile N --json` prints it.
std::string profile_json(const Scene& scene, const DistanceProfile& answer);
/// As comma-separated values, a line for each instant of each curve: first, second (the pair; empty for the least
/// distance of all pairs), t, lo, hi, and the bracket from there to the next instant, until_lo and until_hi, which are
/// empty at the end.
std::string profile_csv(const Scene& scene, const DistanceProfile& answer);
/// The curves as a plot in SVG, a panel for each: the distance over time, and between instants the box in which it
/// certainly stays.
std::string profile_svg(const Scene& scene, const DistanceProfile& answer, int width = 800);

}  // namespace taut
