// An independent oracle: first contact by brute force over all vertex-edge pairs, in extended precision and world
// coordinates. It shares no code with the engines. Not certified, but it says how far from degenerate its verdict is.
#pragma once

#include <cstdint>

#include "taut/scene.hpp"

namespace taut::testing {

enum class Verdict : std::uint8_t {
  free,
  contact,
  overlap_at_start,
  unclear,  ///< the scene is degenerate within rounding: margin is 0
};

const char* to_string(Verdict verdict);

struct OracleAnswer {
  Verdict verdict = Verdict::unclear;
  double t = 0;           ///< of the contact, or of what was unclear
  double time_error = 0;  ///< an estimate, on the safe side, of how wrong t is from rounding
  int vertex_body = -1, vertex = -1;
  int edge_body = -1, edge = -1;

  /// How far from degenerate, 0 to 1: the least of the three below. Skip a scene if this is below the tolerance of the
  /// test, and count the skips.
  double margin = 0;
  /// Least distance of all other vertex-edge pairs until then, as a fraction of the scene's extent; a lower bound that
  /// is at most 4 times too small. Contact: also the distance from the edge's ends, and from the start and the end of
  /// the time interval at the speed of the contact.
  double gap = 1;
  /// Contact: sine of the angle at which the vertex crosses the edge (its velocity relative to the edge's body).
  double transversality = 1;
  /// Contact: relative speed there, as a fraction of the greatest speed of any vertex between start and end.
  double speed = 1;
  /// Contact: how far the next contact still has to go, as a fraction of the extent. Not part of the margin: if it is
  /// 0, several features touch at that instant, and the one named here is one of them.
  double lead = 1;
  std::uint64_t evaluations = 0;  ///< of vertex-edge pairs: the work done
};

/// The first contact of a scene with two valid bodies. Jumps between pieces of a motion are not looked at.
OracleAnswer brute_force(const Scene& scene);

}  // namespace taut::testing
