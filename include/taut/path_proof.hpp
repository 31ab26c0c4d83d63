// Proofs that there is no way, which another program checks.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "taut/path.hpp"
#include "taut/proof.hpp"

namespace taut {

/// Answers as find_path() does, and writes a proof log for `none`: docs/path-logs.md. Nothing is written for other
/// outcomes: the proof of a way is that of path_scene(), by prove(). The answer is `undecided` where there is no way,
/// but no log was found that verify_path() accepts. Throws InputError.
PathAnswer prove_path(const PathProblem& problem, std::ostream& log, const PathOptions& options = {});

/// What a log proves: that there is no way.
struct VerifiedPath {
  /// No way without overlap, so none without touching either; `closed`: no way without touching.
  Touch touch = Touch::open;
  /// If it is not 0: no way that keeps at least this distance, in the scene's units.
  double clearance = 0;
  /// Of translations: the number of edges of a closed polygon that no way crosses. Else 0, and there is a partition.
  std::uint64_t barrier = 0;
  std::uint64_t cells = 0;      ///< of the partition
  std::uint64_t colliding = 0;  ///< of these, the ones that were shown to collide for all values in them
  std::uint64_t reached = 0;    ///< the others, as far as a chain of them leads there from the start
  Fingerprint fingerprint{};
};

/// Checks a log, whoever made it: that each cell that it says collides does, for all values in it, and that no chain of
/// other cells leads from the start to the goal; or that no edge of its polygon can be crossed, and that the start and
/// the goal are on different sides of it. Throws ProofError if the proof fails, InputError if the problem is not valid.
/// Uses nothing of the search in src/path, src/joints and src/query. Only the values of loops that several drives move
/// together are enclosed by code that the search uses as well (src/motion/loop_region.hpp).
VerifiedPath verify_path(const PathProblem& problem, std::istream& log);

/// Is this the beginning of a log about paths, as far as its first bytes say?
bool is_path_log(std::istream& log);

/// The SHA-256 digest of what a proof is about: the exact numbers of polygons, joints, start and goal. The problem must
/// be valid.
Fingerprint path_fingerprint(const PathProblem& problem);

/// What verify_path() returned, as `taut verify --json` prints it.
std::string verified_path_json(const PathProblem& problem, const VerifiedPath& verified);

}  // namespace taut
