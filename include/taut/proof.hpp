// Proofs that can be checked by a program that knows nothing of how they were found.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>

#include "taut/check.hpp"
#include "taut/clearance.hpp"

namespace taut {

/// Answers as check() does, and writes a proof log for `free` and `contact`, and for what an `undecided` run has
/// proved; nothing useful for `overlap_at_start`. The time up to which an `undecided` answer is free, and the contact
/// of another one, are those that verify() finds in the log. Where a limit stops the writing of a log of separations,
/// the answer is `undecided`, and the log proves a part of the time, if it was long enough for one.
///
/// By the kinetic engine (EngineChoice::kinetic, for two bodies of one polygon each), the log is of a tiling, written
/// event by event, so that memory does not grow with it: docs/proof-format.md. With EngineChoice::both it is the same
/// log, kept in memory until the end; if only the other engine decides, it is that engine's. By the spacetime
/// engine, and for any other scene, it is of separations, written when it is complete; where none was found, the answer
/// is `undecided`, and says so: docs/separation-logs.md. Of a scene with curves it is polygons around the bodies, and,
/// for a contact, within them, and such logs about these; where they were not shown to lie there, the answer is
/// `undecided`, too. EngineChoice::either, the usual one, takes the engine that answers first. Of worlds, the first
/// contact is proved, whatever CheckOptions::all_pairs says. Throws InputError, and EngineDisagreement with
/// EngineChoice::both.
Answer prove(const Scene& scene, std::ostream& log, const CheckOptions& options = {});

/// Answers as check_clearance() does, and writes a log of separations for `free` and `contact`, and for what an
/// `undecided` run has proved; nothing if bodies are closer, or overlap, at the start. Where no proof was found, the
/// answer is `undecided`, and says so. Throws InputError.
MarginAnswer prove_clearance(const Scene& scene, double clearance, std::ostream& log, const CheckOptions& options = {});

/// Answers as check() does with Touch::closed, and writes an exact log for `free`, for `undecided` what was proved, and
/// for `contact` up to shortly before it: docs/exact-logs.md. Such logs are checked by a program whose soundness is a
/// theorem (docs/verified.md); they are about bodies exactly as given, and need room between them. Answer::free_until
/// then is the time up to which the log proves the motion to be free. Where no log was found, the answer is
/// `undecided`, and says so. Throws InputError, also for what exact logs do not cover: curves, mechanisms.
Answer prove_exact(const Scene& scene, std::ostream& log, const CheckOptions& options = {});

/// A SHA-256 digest.
using Fingerprint = std::array<std::uint8_t, 32>;

/// Where in the course of a motion a contact was proved.
enum class ContactAt : std::uint8_t {
  start,   ///< at the scene's start
  motion,  ///< while a piece of the motion runs
  joint,   ///< in the jump between two pieces, which rounding leaves: at their joint
};

/// What a log is made of.
enum class ProofKind : std::uint8_t {
  tiling,       ///< the way of a tiling around two bodies: docs/proof-format.md
  separations,  ///< what is between the bodies, and when: docs/separation-logs.md
  curves,       ///< polygons around bodies with curves, and within, and what is proved about these, by either kind
};

/// Two features that come closer than a clearance: not before the beginning of `time`, and certainly at its end.
struct ProvedCloseness {
  CloseFeatures features;
  TimeInterval time;
};

/// What a log proves about the scene that it was checked against.
struct Verified {
  ProofKind kind = ProofKind::tiling;
  /// free: on the whole interval. contact: `contact` is the first one. undecided: free before `free_until`, no more.
  /// With a clearance, free means that it is kept, and contact that it is not: see `closer`.
  Outcome outcome = Outcome::undecided;
  Touch touch = Touch::open;
  std::optional<Contact> contact;
  /// Of the contact, if there is one.
  ContactAt contact_at = ContactAt::motion;
  double free_until = 0;
  /// In the scene's units; 0: the proof is about contact alone.
  double clearance = 0;
  /// With a clearance, if the outcome is contact.
  std::optional<ProvedCloseness> closer;
  /// Of a log of a tiling, its events; of a log of separations, how many it has.
  std::uint64_t events = 0, separations = 0;
  /// Of a log about curves: how many edges the polygons around and within them have.
  std::uint64_t segments = 0;
  /// Which pairs the log proves something about: `tested`, since `apart` is 0.
  Coverage coverage;
  /// Identifies what was proved about: see scene_fingerprint().
  Fingerprint fingerprint{};
};

/// Checks a log, of either kind, whoever made it. Of a tiling: that it is one of pseudo-triangles around both bodies,
/// that every corner of it keeps its sign until an event changes the corner, and that each event turns one such tiling
/// into the next. Of separations: that what it names separates all pairs of edges of all pairs of bodies that are asked
/// about. Of curves: that polygons lie around the bodies, and within, and what logs say of these; the features of a
/// contact are then the segments near to it, which is not proved. Throws ProofError if the proof fails, InputError if
/// the scene is not valid. A Verified result is a proof, as far as this function, the validation of scenes, and the
/// arithmetic and the description of motion in src/certificate and below can be trusted. src/tiling, src/kinetic,
/// src/spacetime and src/solver are not used, nor are bands around curves, but for holes of a path that is read.
Verified verify(const Scene& scene, std::istream& log);

/// The SHA-256 digest of what a proof is about: the touch mode, and the exact numbers of time, polygons and motions.
/// What means nothing does not enter: names, the sign of a zero, a pivot without a rotation or an orbit, zeros that are
/// a polynomial's last coefficients, pieces of a motion outside of the scene's time. The scene must be valid.
Fingerprint scene_fingerprint(const Scene& scene, Touch touch);

/// In 64 hexadecimal digits.
std::string to_hex(const Fingerprint& fingerprint);

/// What verify() returned, as `taut verify --json` prints it.
std::string verified_json(const Scene& scene, const Verified& verified);
/// The same where verify() returned nothing. `refuted`: by ProofError; else it was stopped.
std::string unverified_json(bool refuted, const std::string& reason);

}  // namespace taut
