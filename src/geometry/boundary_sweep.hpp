// Does a closed polygonal boundary meet itself? A plane sweep (Shamos and Hoey 1976) on exact predicates.
#pragma once

#include <cstdint>
#include <optional>

#include "taut/geometry.hpp"

namespace taut::internal {

/// How two edges of a boundary meet where they must not.
enum class Meeting : std::uint8_t {
  none,
  crossing,   ///< in one point, inside both edges
  touch,      ///< in one point, a vertex of one edge inside the other
  overlap,    ///< along a segment
  fold_back,  ///< along a segment that begins at their common vertex
};

/// Two edges that meet, `first` < `second`; edge j joins vertices j and j + 1 (modulo n).
struct SelfMeeting {
  Meeting kind = Meeting::none;
  int first = 0, second = 0;
  int vertex = -1;  ///< touch: the vertex inside the other edge; fold_back: the common vertex
  Point from, to;   ///< where, rounded; equal unless the edges overlap
};

/// Two edges of the boundary that meet outside common vertices, or nothing if there are none: exact, O(n log n).
/// The vertices must be distinct, at least 3, and in the range of predicates.hpp. `order` lists all vertices in
/// lexicographic order.
std::optional<SelfMeeting> find_self_meeting(const Polygon& polygon, const std::vector<int>& order);

/// How edges i and j, not neighbours along the boundary, meet: exact. No vertex may be repeated.
SelfMeeting classify_edges(const Polygon& polygon, int i, int j);

}  // namespace taut::internal
