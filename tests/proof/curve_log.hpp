// A proof log about curves in parts, and put together again as one would who wants it to be believed.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "proof/curved_scene.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;

struct CurveLog {
  struct Side {
    proof::PolygonsOfBodies polygons;
    std::string log;  ///< about these, without its checksum
  };
  std::vector<Side> sides;  ///< around the bodies, and within them if there are two
};

/// A valid log, taken apart.
CurveLog curve_log_of(const Scene& scene, const std::string& log);
/// A log of these parts about that scene, with right headers, sizes and checksums, its own and those of its sides.
std::string put_together(const CurveLog& parts, const Scene& scene, Touch touch);
/// A log of a side about polygons has their fingerprint: so that one about others has theirs. False, and nothing
/// done, if they make no valid scene, or the log has none.
bool name_polygons(CurveLog::Side& side, const Scene& scene, Touch touch);

/// Numbers from 0 to below n, for n up to 256.
using Choice = std::function<int(int)>;
/// The log with something wrong about it, as choices have it, and all checksums right: bytes of a side's log, polygons
/// whose corners are moved, or that are shrunk or grown as a whole, under their right name, sides that are exchanged,
/// left out or doubled, or any byte.
std::string damaged(CurveLog parts, const Scene& scene, Touch touch, const Choice& below);

}  // namespace taut::testing
