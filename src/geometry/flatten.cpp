// Curves as polygons, for people.
#include <cmath>

#include "geometry/flat_part.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;

Outline outline_of(const Polygon& polygon) {
  Outline outline;
  if (polygon.empty()) return outline;
  outline.start = polygon[0];
  for (std::size_t i = 1; i < polygon.size(); ++i) outline.segments.emplace_back(LineTo{polygon[i]});
  return outline;
}

std::optional<Part> polygons_of(const CurvedPart& part) {
  const auto polygon_of_lines = [](const Outline& outline) -> std::optional<Polygon> {
    Polygon polygon{outline.start};
    for (const CurveSegment& segment : outline.segments) {
      if (!std::holds_alternative<LineTo>(segment)) return std::nullopt;
      if (!(end_of(segment) == polygon.back())) polygon.push_back(end_of(segment));
    }
    if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
    return polygon;
  };
  Part polygons;
  const auto outline = polygon_of_lines(part.outline);
  if (!outline) return std::nullopt;
  polygons.outline = *outline;
  for (const Outline& ring : part.holes) {
    const auto hole = polygon_of_lines(ring);
    if (!hole) return std::nullopt;
    polygons.holes.push_back(*hole);
  }
  return polygons;
}

void curve::refine_to(BandedPart& part, double tolerance, const std::string& name) {
  constexpr std::size_t most_cells = 1000000;
  for (std::size_t ring = 0; ring < part.bands().size(); ++ring) {
    if (tolerance < part.bands()[ring].resolution().size * 0x1p-41)
      throw InputError(name, "doubles do not allow a tolerance that small",
                       "choose one of at least 2^-40 of the largest coordinate");
    for (;;) {
      const Band& band = part.bands()[ring];
      if (band.cells().size() > most_cells)
        throw InputError(name, "polygons that near to the curves have more than a million edges",
                         "choose a larger tolerance");
      std::vector<int> halvings;
      bool finer = false;
      for (const Cell& cell : band.cells()) {
        const bool thick = cell.thickness > tolerance;
        if (thick && cell.is_final)
          throw InputError(name, "doubles do not allow a tolerance that small",
                           "choose one of at least 2^-40 of the largest coordinate");
        halvings.push_back(thick ? 1 : 0);
        finer = finer || thick;
      }
      if (!finer) break;
      part.band(ring).refine(halvings);
    }
  }
}

std::vector<Part> flatten(const std::vector<CurvedPart>& parts, CurveSide side, double tolerance,
                          const std::string& name) {
  if (!(tolerance > 0 && std::isfinite(tolerance)))
    throw InputError(name, "the tolerance is not a positive number", "choose how far polygons may be from the curves");
  std::vector<Part> polygons;
  for (const CurvedPart& part : parts) {
    curve::BandedPart banded(part, name);
    curve::refine_to(banded, tolerance, name);
    polygons.push_back(banded.polygons(side));
    polygons.back().z = part.z;
  }
  return polygons;
}

}  // namespace taut
