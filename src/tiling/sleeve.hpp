// The gates that every curve of one class must pass, in order.
#pragma once

#include <cstdint>
#include <vector>

#include "tiling/separator_arena.hpp"

namespace taut::internal {

/// A gate is a half-edge of the triangle that is entered through it: its origin is the left end, its target the right
/// end. Two gates in a row have one end in common; the apex of the first one's triangle is the other end of the second.
using Gate = std::uint32_t;

/// Does the step from gate `a` to the next gate `b` bring a new left end (or a new right one)?
inline bool new_left_end(const Arena& arena, Gate a, Gate b) { return arena.twin(b) == FreeTriangulation::next(a); }
/// The edge of the triangle behind gate `a` that is passed by if the step from `a` brings a new left (right) end; as a
/// half-edge of that triangle.
inline std::uint32_t side_edge(Gate a, bool new_left) {
  return new_left ? FreeTriangulation::previous(a) : FreeTriangulation::next(a);
}
/// The same gates from the other end.
std::vector<Gate> reversed(const Arena& arena, const std::vector<Gate>& gates);

/// The gates of a loop around polygon `owner` (0 or 1), that polygon on the left: all edges that leave it, counter-
/// clockwise. Empty if part of the other polygon or of the box is shut in a pocket of this one.
std::vector<Gate> loop_gates(const Arena& arena, int owner);

/// A way for curves from infinity to infinity that separate the polygons, P on the left. All of them pass `core`; what
/// lies before and behind winds around the polygons in either direction, and the box can be left (entered) on the way.
struct OpenSleeve {
  std::vector<Gate> core;
  /// Where the box can be left behind the core, turning left or right. At a gate with `exit`, the side edge of its
  /// triangle joins two corners of the box.
  struct Tail {
    std::vector<Gate> gates;
    std::vector<bool> exit;
  };
  std::vector<Tail> tails;
  /// Ways from an edge of the box to the core, the box's edge included.
  std::vector<std::vector<Gate>> heads;
};
OpenSleeve open_sleeve(const Arena& arena);

}  // namespace taut::internal
