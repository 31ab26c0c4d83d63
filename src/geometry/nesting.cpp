#include "geometry/nesting.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/banded_part.hpp"
#include "geometry/predicates.hpp"

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
