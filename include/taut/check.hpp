// The question taut answers: when do moving shapes first touch?
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "taut/coverage.hpp"
#include "taut/error.hpp"
#include "taut/feature.hpp"
#include "taut/limits.hpp"
#include "taut/scene.hpp"
#include "taut/tracer.hpp"

namespace taut {
/// What is known about the first collision.
enum class Outcome {
  free,              ///< proved: no collision at any time of the interval
  contact,           ///< the first collision, with its witness
  overlap_at_start,  ///< the bodies overlap already at the start
  undecided,         ///< a stated limit was hit; nothing is claimed beyond `Answer::free_until`
  untested,          ///< no pair of bodies was tested, so there is no verdict; `reason` says why
  locked,            ///< no collision before `Answer::free_until`, right before a mechanism locks: Scene::lock
  closer_at_start,   ///< of check_clearance(): no bodies overlap, and two are closer than the clearance at the start
};

/// "free", "contact", "overlap_at_start", "closer_at_start", "undecided", "untested" or "locked".
const char* to_string(Outcome outcome);
/// "open" or "closed".
const char* to_string(Touch touch);

/// An engine, in an answer. The engines share the arithmetic and the description of motion, and no idea beyond these.
enum class EngineName {
  kinetic,    ///< the kinetic data structure: a tiling of the free space, kept valid from event to event
  spacetime,  ///< bounding volumes over the edges, followed through time
};

/// "kinetic" or "spacetime".
const char* to_string(EngineName engine);

/// Whom to ask.
enum class EngineChoice {
  kinetic,    ///< this engine
  spacetime,  ///< this engine
  both,       ///< both, compared; a difference is a defect of taut and throws EngineDisagreement
  either,     ///< both in slices, longer and longer, until one of them has the answer, which says whose it is
  usual,      ///< either, for each pair of a world; kinetic for two polygons where events are limited
};

/// "kinetic", "spacetime", "both", "either" or "usual".
const char* to_string(EngineChoice engine);

/// An interval of time that certainly contains the instant meant.
struct TimeInterval {
  double lo = 0;
  double hi = 0;
};

/// What touches what, where. Point and normal are approximate (a few ulps), in world coordinates at the contact.
struct Contact {
  /// Encloses the contact. Nearly always a few ulps wide; wider if `grazing`.
  TimeInterval time;
  VertexRef vertex;
  EdgeRef edge;
  Point point;
  Point normal;  ///< unit outward normal of the edge's body at the contact
  /// The features meet so slowly that whether they overlap or just touch is below what taut distinguishes (2^-150 of
  /// the size of the scene) for a while: `time` is that while, from when they may touch to when they certainly have
  /// overlapped, or have parted again.
  bool grazing = false;
};

/// How well curves were known for an answer about bodies that are bounded by some.
struct CurveGeometry {
  /// No curve was farther from the polygons that decided, where it mattered: of `free`, anywhere; else at what the
  /// answer names. 0 if only straight edges did.
  double tolerance = 0;
  std::uint64_t segments = 0;  ///< edges of the polygons around the bodies, in the end
};

/// How to check; the defaults are those of `taut check`.
struct CheckOptions {
  Touch touch = Touch::open;
  EngineChoice engine = EngineChoice::usual;
  /// Stop with `undecided` after this many events (of the kinetic engine).
  std::uint64_t max_events = UINT64_MAX;
  /// Where open touching gives `free` only by what is below the resolution of doubles, ask for closed touching as well,
  /// to say whether the bodies touch: see Answer::touching.
  bool tell_touching = true;
  /// Go on to each pair's own first contact, as if the other pairs did not collide.
  bool all_pairs = false;
  /// If positive: bodies are shrunk on each side by between `fit` and twice as much, in the scene's units, before
  /// anything is asked, so that what overlaps by rounding does not. The answer is about the shrunk bodies, whose
  /// vertices have the numbers of those given. The union of a body's parts is shrunk: no seam opens at which parts
  /// touch or overlap, or are less than fit/512 apart; features there are named by the nearest ones given. InputError
  /// where a body has features that are finer.
  double fit = 0;
  /// Of a scene with curves: how wide the time of a contact may be, as a share of the scene's time. Polygons are
  /// refined until they enclose it that closely, or the resolution of doubles is reached.
  double time_tolerance = 1e-9;
  /// Notified of every event of the kinetic engine, which are all events of the motion if that engine is asked alone
  /// (EngineChoice::kinetic); may be null. Not owned. The scene must be two bodies, each one polygon in the
  /// world's frame; otherwise InputError. Of a scene with curves, events are those of the polygons that stand for
  /// them, run after run.
  Tracer* tracer = nullptr;
  /// The wall time is that of each engine; with `either`, of both in sum.
  Limits limits = {};
};

/// What is known of one pair of bodies.
struct PairAnswer {
  std::array<BodyId, 2> bodies{};  ///< in the order of the scene
  Outcome outcome = Outcome::free;
  std::optional<Contact> contact;  ///< present for `contact`
  double free_until = 0;           ///< proved free of collisions before this time
  std::string reason;              ///< why it is `undecided`
};

/// What check() and prove() found out.
struct Answer {
  Outcome outcome = Outcome::undecided;
  /// Who answered; of a world whose pairs have several engines, who answered about the pair that is named, and where
  /// none is, the kinetic one if it did about any.
  EngineName engine = EngineName::kinetic;
  /// The other engine was asked too, and contradicts nothing of this (EngineChoice::both).
  bool compared = false;
  /// Present for `contact`, and for nothing else.
  std::optional<Contact> contact;
  /// With `free` and open touching: the bodies touch, here for the first time, and overlap by no more than 2^-150 of
  /// the size of the scene. What CheckOptions::tell_touching found.
  std::optional<Contact> touching;
  /// Why it is not known whether there is such a contact; empty if it is.
  std::string touching_undecided;
  /// For `overlap_at_start`: a point that certainly lies inside both bodies at the start, in world coordinates. The two
  /// doubles are exact, and so are the bodies: as they are written, where their motions put them, without the
  /// displacement. Absent where none was found, since an overlap may be too thin for any pair of doubles to lie in it.
  std::optional<Point> overlap_point;
  /// The motion is proved free of collisions before this time.
  double free_until = 0;
  /// Of the kinetic engine; the other one has neither events nor certificates.
  std::uint64_t events = 0;
  std::uint64_t certificates_initial = 0;
  std::uint64_t certificates_max = 0;
  /// Seconds spent on validation and on building the tiling, and on the events after it.
  double build_seconds = 0;
  double run_seconds = 0;
  /// Why the answer is `undecided` or `untested`; empty otherwise.
  std::string reason;
  /// The pair that the outcome is about, unless it is `free`.
  std::optional<std::array<BodyId, 2>> pair;
  /// Other pairs whose first contacts come so close to that one that their order is not decided: in the order of the
  /// scene.
  std::vector<PairAnswer> also;
  /// Which pairs the answer is about. `free` says nothing about the others.
  Coverage coverage;
  /// What the bodies were shrunk by: CheckOptions::fit.
  double fit = 0;
  /// With CheckOptions::all_pairs: every pair that was tested, in the order of the scene. Pairs that are kept apart by
  /// bounding boxes are free as well; they are only counted in `coverage`.
  std::optional<std::vector<PairAnswer>> pairs;
  /// Of a scene with curves. An `undecided` one may then name a `contact`: the instant, at the earliest, and the place
  /// at which polygons around the bodies meet.
  std::optional<CurveGeometry> geometry = {};
};

/// Decides whether and when bodies of `scene` first collide.
/// `free` and `contact` are proofs: every sign and every order of events behind them is certified.
/// Throws InputError if the scene is not valid; EngineDisagreement with EngineChoice::both.
Answer check(const Scene& scene, const CheckOptions& options = {});

/// The JSON object of `taut check --json` (see the README), on one line, without a line break.
std::string answer_json(const Scene& scene, const Answer& answer, Touch touch);

}  // namespace taut
