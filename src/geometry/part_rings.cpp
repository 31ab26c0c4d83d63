#include "geometry/part_rings.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/axis_box.hpp"
#include "geometry/band.hpp"
#include "geometry/predicates.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

/// An edge of one of the rings.
struct RingEdge {
  Point a, b;
  int ring = 0, index = 0;
  double lo_x() const { return std::min(a.x, b.x); }
  double hi_x() const { return std::max(a.x, b.x); }
  double lo_y() const { return std::min(a.y, b.y); }
  double hi_y() const { return std::max(a.y, b.y); }
};

bool meet(const RingEdge& e, const RingEdge& f) {
  if (e.hi_x() < f.lo_x() || f.hi_x() < e.lo_x() || e.hi_y() < f.lo_y() || f.hi_y() < e.lo_y()) return false;
  const int a = orientation(e.a, e.b, f.a), b = orientation(e.a, e.b, f.b);
  const int c = orientation(f.a, f.b, e.a), d = orientation(f.a, f.b, e.b);
  // With boxes that meet, edges on one line do, and others unless one of them is on one side of the other.
  return a * b <= 0 && c * d <= 0;
}

std::string ring_text(int ring) { return ring == 0 ? "the outline" : "hole " + std::to_string(ring); }

const Polygon& ring_of(const Part& part, int ring) {
  return ring == 0 ? part.outline : part.holes[static_cast<std::size_t>(ring - 1)];
}

[[noreturn]] void refuse(const Part& part, const RingEdge& e, const RingEdge& f, const std::string& name) {
  const auto text = [&](const RingEdge& edge) {
    const int n = static_cast<int>(ring_of(part, edge.ring).size());
    return "edge " + std::to_string(edge.index) + "-" + std::to_string((edge.index + 1) % n) + " of " +
           ring_text(edge.ring);
  };
  throw InputError(
      name, text(e) + " meets " + text(f),
      "holes must touch neither the outline nor each other: leave a gap, or cut the hole out of the outline",
      {{}, {{0, e.index, 0, e.ring}, {0, f.index, 0, f.ring}}});
}

/// A sweep along x over the edges' boxes.
void require_rings_apart(const Part& part, const std::string& name) {
  std::vector<RingEdge> edges;
  for (int ring = 0; ring <= static_cast<int>(part.holes.size()); ++ring) {
    const Polygon& polygon = ring_of(part, ring);
    for (std::size_t i = 0; i < polygon.size(); ++i)
      edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()], ring, static_cast<int>(i)});
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const RingEdge& e, const RingEdge& f) { return e.lo_x() < f.lo_x(); });
  std::vector<const RingEdge*> active;
  for (const RingEdge& e : edges) {
    checkpoint();
    std::erase_if(active, [&](const RingEdge* f) { return f->hi_x() < e.lo_x(); });
    for (const RingEdge* f : active) {
      if (f->ring != e.ring && meet(e, *f)) {
        if (f->ring < e.ring) refuse(part, *f, e, name);
        refuse(part, e, *f, name);
      }
    }
    active.push_back(&e);
  }
}

}  // namespace

void validate_holes(const Part& part, const std::string& name) {
  if (part.holes.empty()) return;
  require_rings_apart(part, name);
  std::vector<AxisBox> boxes;
  for (const Polygon& hole : part.holes) boxes.push_back(box_around(hole));
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    if (side_of_ring(part.outline, part.holes[i][0]) <= 0)
      throw InputError(name + ": hole " + std::to_string(i + 1), "the hole lies outside of the outline",
                       "remove it, or make it a part of its own");
    for (std::size_t j = 0; j < part.holes.size(); ++j) {
      checkpoint();
      if (i != j && boxes[i].holds(boxes[j]) && side_of_ring(part.holes[i], part.holes[j][0]) > 0)
        throw InputError(name + ": hole " + std::to_string(j + 1), "the hole lies inside hole " + std::to_string(i + 1),
                         "remove it; what stands in a hole is a part of its own");
    }
  }
}

}  // namespace taut::internal

namespace taut::internal::curve {
namespace {

struct Ring {
  Polygon wall;
  int orientation = 0, winding = 0, parent = -1, part = -1, depth = 0;
};

/// Bands that are apart: any vertex of the one's wall shows whether it is within the other's.
void find_parents(std::vector<Ring>& rings) {
  std::vector<std::vector<int>> around(rings.size());
  for (std::size_t k = 0; k < rings.size(); ++k) {
    for (std::size_t j = 0; j < rings.size(); ++j) {
      if (j != k && side_of_ring(rings[j].wall, rings[k].wall[0]) > 0) around[k].push_back(static_cast<int>(j));
    }
    rings[k].depth = static_cast<int>(around[k].size());
  }
  for (std::size_t k = 0; k < rings.size(); ++k) {
    for (const int j : around[k]) {
      if (rings[static_cast<std::size_t>(j)].depth + 1 == rings[k].depth) rings[k].parent = j;
    }
  }
}

}  // namespace

std::vector<CurvedPart> nested(const std::vector<Outline>& outlines, FillRule rule, const std::string& name) {
  if (outlines.size() == 1) return {{outlines[0], {}}};
  std::vector<Band> bands;
  std::vector<std::string> places;
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    places.push_back(" of subpath " + std::to_string(k));
    bands.emplace_back(outlines[k], name + ": subpath " + std::to_string(k));
  }
  make_apart(bands, name, places);
  std::vector<Ring> rings;
  for (const Band& band : bands) rings.push_back({band.wall(true), band.orientation(), 0, -1, -1, 0});
  find_parents(rings);
  std::vector<std::size_t> order(rings.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rings[a].depth < rings[b].depth; });
  const auto filled = [rule](int w) { return rule == FillRule::nonzero ? w != 0 : w % 2 != 0; };
  std::vector<CurvedPart> parts;
  for (const std::size_t k : order) {
    Ring& ring = rings[k];
    const Ring outside = ring.parent < 0 ? Ring{} : rings[static_cast<std::size_t>(ring.parent)];
    ring.winding = outside.winding + ring.orientation;
    ring.part = outside.part;
    if (filled(outside.winding) == filled(ring.winding)) continue;
    if (filled(outside.winding)) {
      parts[static_cast<std::size_t>(outside.part)].holes.push_back(outlines[k]);
    } else {
      ring.part = static_cast<int>(parts.size());
      parts.push_back({outlines[k], {}});
    }
  }
  return parts;
}

}  // namespace taut::internal::curve
