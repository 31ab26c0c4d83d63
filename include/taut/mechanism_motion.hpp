// How a mechanism moves: what its joints do over the time.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "taut/limits.hpp"
#include "taut/scene.hpp"

namespace taut {

/// An extreme of a function of time: it is in [lo, hi], and a value in there is taken at `t`.
struct Extreme {
  double lo = 0, hi = 0, t = 0;
};

/// What one joint of a mechanism does.
struct JointRange {
  std::string joint;
  std::string first, second;  ///< the value is that of the second body, as the first one sees it
  bool slides = false;        ///< values are lengths, not degrees
  Extreme least, greatest;
};

/// The angle at which two links meet at the pin that closes a loop, in degrees, at most 90: near 0, hardly any force is
/// passed on, and at 0 the links are in line.
struct TransmissionAngle {
  std::string joint;
  std::array<std::string, 2> links;
  Extreme least, greatest;
};

/// What mechanism_motion() found out, from the start of the scene's time to its end, or to a lock.
struct MechanismMotion {
  /// How far the motion goes.
  enum class Outcome {
    moves,      ///< to the end of the time
    locked,     ///< before: see `lock`
    undecided,  ///< it is not known how it goes on, or a limit was reached: see `reason`
  };
  Outcome outcome = Outcome::moves;
  int mobility = 0;  ///< independent ways to move, couplings counted
  int loops = 0;
  std::vector<JointRange> joints;  ///< in the order of the mechanism
  std::vector<TransmissionAngle> transmission;
  std::optional<MechanismLock> lock;
  /// Of MechanismOptions::instants: times, and of each the values of all joints in order, as [lo, hi].
  std::vector<double> instants;
  std::vector<std::vector<std::array<double, 2>>> values;
  std::string reason;
};

/// "moves", "locked", "undecided".
const char* to_string(MechanismMotion::Outcome outcome);

/// How to ask mechanism_motion().
struct MechanismOptions {
  std::size_t instants = 0;  ///< evenly over the time, both ends included; 0, or 2 to 1,000,000
  Limits limits = {};
};

/// How the scene's mechanism moves. Every number is an enclosure; those of extremes are as narrow as doubles resolve,
/// or 1e-9 of the range. Throws InputError for a scene without a mechanism.
MechanismMotion mechanism_motion(const Scene& scene, const MechanismOptions& options = {});

/// The answer as one JSON object, without a line break.
std::string mechanism_json(const Scene& scene, const MechanismMotion& answer);
/// The table of the instants as CSV: t, and for each joint its least and greatest value.
std::string mechanism_csv(const Scene& scene, const MechanismMotion& answer);

}  // namespace taut
