#include "tiling/sleeve.hpp"

#include <algorithm>

#include "numeric/errors.hpp"
#include "tiling/root_faces.hpp"

namespace taut::internal {
namespace {

constexpr std::uint32_t no_edge = FreeTriangulation::none;

std::uint32_t half_edges(const Arena& arena) { return static_cast<std::uint32_t>(arena.triangulation.origin.size()); }
bool touches_box(const Arena& arena, Gate g) { return arena.in_box(arena.apex(g)); }
/// The gate behind the triangle of g, with the apex as its new left (right) end.
Gate step(const Arena& arena, Gate g, bool new_left) {
  return arena.twin(new_left ? FreeTriangulation::next(g) : FreeTriangulation::previous(g));
}

/// Around infinity behind gate g, whose apex is a corner of the box, and back to where it started.
OpenSleeve::Tail around_infinity(const Arena& arena, Gate g, bool left) {
  OpenSleeve::Tail tail;
  // The box stays on the left (right): its corners are new left (right) ends.
  for (Gate at = step(arena, g, left);; at = step(arena, at, arena.in_box(arena.apex(at)) == left)) {
    if (!tail.gates.empty() && at == tail.gates.front()) return tail;
    tail.gates.push_back(at);
    tail.exit.push_back(touches_box(arena, at));
    if (tail.gates.size() > half_edges(arena)) throw StructureError("no path around the bodies");
  }
}

/// The gates from the triangle of `start` (a gate) to one with a corner of the box, through the region behind `start`;
/// empty if there is none.
std::vector<Gate> way_to_box(const Arena& arena, Gate start) {
  struct Visit {
    Gate gate;
    std::size_t parent;
  };
  std::vector<Visit> visits{{start, 0}};
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Gate g = visits[i].gate;
    if (touches_box(arena, g)) {
      std::vector<Gate> path;
      for (std::size_t k = i; k != 0; k = visits[k].parent) path.push_back(visits[k].gate);
      path.push_back(start);
      std::reverse(path.begin(), path.end());
      return path;
    }
    for (const bool left : {true, false}) {
      const Gate next = step(arena, g, left);
      // The region is a pocket: a tree of triangles, unless it holds the other polygon.
      if (next != no_edge && arena.owner(arena.origin(next)) == arena.owner(arena.target(next)))
        visits.push_back({next, i});
    }
  }
  return {};
}

/// All edges from P to Q between the two places where the free space between them opens to infinity.
std::vector<Gate> core_of_bay(const Arena& arena, Gate first) {
  std::vector<Gate> core{first};
  while (!touches_box(arena, core.back()))
    core.push_back(step(arena, core.back(), arena.owner(arena.apex(core.back())) == 0));
  return core;
}

/// The edges from P to Q form a loop, because one polygon lies in a pocket of the other. In through the mouth of the
/// pocket, around the loop, and out.
std::vector<Gate> core_of_pocket(const Arena& arena, Gate any) {
  std::vector<Gate> loop;
  for (Gate g = any; loop.empty() || g != any; g = step(arena, g, arena.owner(arena.apex(g)) == 0)) loop.push_back(g);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const bool left = arena.owner(arena.apex(loop[k])) == 0;
    const std::uint32_t mouth = side_edge(loop[k], left);
    if (arena.twin(mouth) == no_edge) continue;
    const std::vector<Gate> out = way_to_box(arena, arena.twin(mouth));
    if (out.empty()) continue;
    std::vector<Gate> core = reversed(arena, out);
    for (std::size_t i = 1; i <= loop.size(); ++i) core.push_back(loop[(k + i) % loop.size()]);
    core.insert(core.end(), out.begin(), out.end());
    return core;
  }
  throw StructureError("no path from between the bodies to infinity");
}

}  // namespace

std::vector<Gate> reversed(const Arena& arena, const std::vector<Gate>& gates) {
  std::vector<Gate> out;
  out.reserve(gates.size());
  for (std::size_t i = gates.size(); i-- > 0;) out.push_back(arena.twin(gates[i]));
  return out;
}

std::vector<Gate> loop_gates(const Arena& arena, int owner) {
  std::vector<Gate> loop;
  std::size_t edges = 0;
  Gate start = no_edge;
  for (std::uint32_t h = 0; h < half_edges(arena); ++h) {
    if (arena.owner(arena.origin(h)) != owner || arena.owner(arena.target(h)) == owner) continue;
    ++edges;
    start = h;
  }
  if (start == no_edge) return loop;
  for (Gate g = start; loop.empty() || g != start; g = step(arena, g, arena.owner(arena.apex(g)) == owner))
    loop.push_back(g);
  if (loop.size() != edges) loop.clear();
  return loop;
}

OpenSleeve open_sleeve(const Arena& arena) {
  OpenSleeve sleeve;
  Gate first = no_edge, any = no_edge;
  for (std::uint32_t h = 0; h < half_edges(arena) && first == no_edge; ++h) {
    if (arena.owner(arena.origin(h)) != 0 || arena.owner(arena.target(h)) != 1) continue;
    any = h;
    if (touches_box(arena, arena.twin(h))) first = h;
  }
  if (any == no_edge) throw StructureError("no edge between the bodies");
  sleeve.core = first != no_edge ? core_of_bay(arena, first) : core_of_pocket(arena, any);
  for (const bool left : {true, false}) {
    sleeve.tails.push_back(around_infinity(arena, sleeve.core.back(), left));
    const OpenSleeve::Tail back = around_infinity(arena, arena.twin(sleeve.core.front()), left);
    for (std::size_t k = 0; k < back.gates.size(); ++k) {
      if (!back.exit[k]) continue;
      std::vector<Gate> head{side_edge(back.gates[k], left)};
      const std::vector<Gate> in(back.gates.begin(), back.gates.begin() + static_cast<std::ptrdiff_t>(k) + 1);
      const std::vector<Gate> turned = reversed(arena, in);
      head.insert(head.end(), turned.begin(), turned.end());
      sleeve.heads.push_back(head);
    }
  }
  return sleeve;
}

}  // namespace taut::internal
