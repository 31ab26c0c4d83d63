// What a log about paths is made of; docs/path-logs.md describes it in full.
#pragma once

#include <cstdint>
#include <vector>

#include "proof/bytes.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::proof {

inline constexpr char of_paths = '6';

/// The first byte of a node of the partition. Nodes come in order, each before its halves.
enum class PathNode : std::uint8_t {
  halved,      ///< across a joint (u8): the two halves follow, the lower one first
  open,        ///< nothing is said of this cell
  crossing,    ///< two edges cross for all values in it
  inside,      ///< a point of one body stays inside another one
  near,        ///< a vertex stays nearer to an edge than the clearance
  conditions,  ///< one of several conditions fails for each value in it
};

/// An edge by its first vertex, or a vertex, of a body: by its number among all vertices of the body in the order of
/// the scene, each part's outline before its holes.
struct PathFeature {
  std::uint32_t body = 0, vertex = 0;
};

/// Two edges. Of a condition also the end that is to be on the other side (0, 1: of the first edge, 2, 3: of the second
/// one), and what the condition is multiplied with.
struct PathCrossing {
  PathFeature first, second;
  std::uint8_t end = 0;
  double weight = 0;
};

/// What is said of one cell.
struct PathClaim {
  PathNode kind = PathNode::open;
  std::uint8_t joint = 0;               ///< halved
  std::vector<PathCrossing> crossings;  ///< crossing: one; conditions: all
  std::uint32_t body = 0, other = 0;    ///< inside: whose point, and in whom
  Point point = {};                     ///< inside: in that body's coordinates
  PathFeature vertex = {}, edge = {};   ///< near
};

void write(ByteWriter& out, const PathClaim& claim);
/// Throws ProofError for a node that makes no sense.
PathClaim read_path_claim(ByteReader& in);

}  // namespace taut::internal::proof
