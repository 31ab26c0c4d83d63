// Proofs that can be checked by a program that knows nothing of how they were found.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>

#include "taut/check.hpp"

namespace taut {

/// Answers as check() does (by the kinetic engine), and writes a proof log for `free` and `contact`, and for what an
/// `undecided` run has proved; nothing useful for `overlap_at_start`. The log is written event by event, so that
/// memory does not grow with it. Format: docs/proof-format.md. Throws InputError.
Answer prove(const Scene& scene, std::ostream& log, const CheckOptions& options = {});

/// A SHA-256 digest.
using Fingerprint = std::array<std::uint8_t, 32>;

/// Where in the course of a motion a contact was proved.
enum class ContactAt : std::uint8_t {
  start,   ///< at the scene's start
  motion,  ///< while a piece of the motion runs
  joint,   ///< in the jump between two pieces, which rounding leaves: at their joint
};

/// What a log proves about the scene that it was checked against.
struct Verified {
  /// free: on the whole interval. contact: `contact` is the first one. undecided: free before `free_until`, no more.
  Outcome outcome = Outcome::undecided;
  Touch touch = Touch::open;
  std::optional<Contact> contact;
  /// Of the contact, if there is one.
  ContactAt contact_at = ContactAt::motion;
  double free_until = 0;
  std::uint64_t events = 0;
  /// Identifies what was proved about: see scene_fingerprint().
  Fingerprint fingerprint{};
};

/// Checks a log: that the tiling at the start is one of pseudo-triangles around both bodies, that every corner of it
/// keeps its sign until an event changes the corner, and that each event turns one such tiling into the next. It
/// accepts any such tiling, whoever made it. Throws ProofError if the proof fails, InputError if the scene is not
/// valid. A Verified result is a proof, as far as this function, the validation of scenes and the arithmetic of
/// src/numeric, src/geometry and src/motion can be trusted; src/tiling and src/kinetic are not used.
Verified verify(const Scene& scene, std::istream& log);

/// The SHA-256 digest of what a proof is about: the touch mode, and the exact numbers of time, polygons and motions.
/// What means nothing does not enter: names, the sign of a zero, a pivot without a rotation or an orbit, zeros that are
/// a polynomial's last coefficients, pieces of a motion outside of the scene's time. Throws InputError for what is not
/// two bodies of one polygon each, in the world's frame.
Fingerprint scene_fingerprint(const Scene& scene, Touch touch);

/// In 64 hexadecimal digits.
std::string to_hex(const Fingerprint& fingerprint);

}  // namespace taut
