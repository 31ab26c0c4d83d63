#include "geometry/banded_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/band.hpp"
#include "geometry/part_validation.hpp"
#include "taut/error.hpp"

namespace taut::internal::curve {
namespace {

const Cell& cell_of(const std::vector<Band>& bands, const CellId& id) {
  return bands[at(id.band)].cells()[at(id.cell)];
}

std::string place_text(const Point& p) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.9g, %.9g)", p.x, p.y);
  return text;
}

[[noreturn]] void refuse(const std::vector<Band>& bands, const std::array<CellId, 2>& pair, const std::string& name,
                         const std::vector<std::string>& places) {
  std::array<std::string, 2> texts;
  Culprits culprits;
  for (const std::size_t i : {0u, 1u}) {
    const Cell& cell = cell_of(bands, pair[i]);
    texts[i] = "segment " + std::to_string(cell.piece.segment) + places[at(pair[i].band)];
    culprits.edges.push_back({0, cell.piece.segment, 0, pair[i].band});
  }
  const Cell& where = cell_of(bands, pair[0]);
  const std::string itself = texts[0] == texts[1] ? texts[0] + " meets itself" : texts[0] + " meets " + texts[1];
  throw InputError(name, itself + " near " + place_text(where.piece.first().rounded()),
                   "curves must neither cross nor touch, also not at a tangency, nor come closer than 2^-40 of the "
                   "largest coordinate: leave a gap, or make it two parts",
                   std::move(culprits));
}

std::vector<const Band*> pointers(const std::vector<Band>& bands) {
  std::vector<const Band*> all;
  for (const Band& band : bands) all.push_back(&band);
  return all;
}

std::size_t count_of(const std::vector<Band>& bands) {
  std::size_t count = 0;
  for (const Band& band : bands) count += band.cells().size();
  return count;
}

}  // namespace

void make_apart(std::vector<Band>& bands, const std::string& name, const std::vector<std::string>& places) {
  const std::size_t enough = 8 * count_of(bands) + 10000;
  for (;;) {
    const auto meetings = meeting_cells(pointers(bands));
    if (meetings.empty()) return;
    std::vector<std::vector<int>> halvings;
    for (const Band& band : bands) halvings.emplace_back(band.cells().size(), 0);
    for (const auto& pair : meetings) {
      bool hopeless = true;
      for (const CellId& id : pair) {
        const bool is_final = cell_of(bands, id).is_final;
        if (!is_final) halvings[at(id.band)][at(id.cell)] = 1;
        hopeless = hopeless && is_final;
      }
      // Curves that run along each other make more cells meet, the finer these are.
      if (hopeless || count_of(bands) > enough) refuse(bands, pair, name, places);
    }
    for (std::size_t i = 0; i < bands.size(); ++i) bands[i].refine(halvings[i]);
  }
}

BandedPart::BandedPart(const CurvedPart& part, const std::string& name) {
  std::vector<std::string> places{part.holes.empty() ? "" : " of the outline"};
  bands_.emplace_back(part.outline, name);
  for (std::size_t i = 0; i < part.holes.size(); ++i) {
    places.push_back(" of hole " + std::to_string(i + 1));
    bands_.emplace_back(part.holes[i], name + ": hole " + std::to_string(i + 1));
  }
  make_apart(bands_, name, places);
  for (std::size_t ring = 0; ring < bands_.size(); ++ring) {
    const bool counterclockwise = bands_[ring].orientation() > 0;
    left_is_inner_.push_back(counterclockwise == (ring == 0));
  }
  if (!part.holes.empty()) validate_holes(polygons(CurveSide::inner), name);
}

Part BandedPart::polygons(CurveSide side) const {
  Part part;
  for (std::size_t ring = 0; ring < bands_.size(); ++ring) {
    Polygon wall = bands_[ring].wall(left_is(ring, side));
    if (ring == 0) {
      part.outline = std::move(wall);
    } else {
      part.holes.push_back(std::move(wall));
    }
  }
  return part;
}

double BandedPart::tolerance() const {
  double worst = 0;
  for (const Band& band : bands_) {
    for (const Cell& cell : band.cells()) worst = std::max(worst, cell.thickness);
  }
  return worst;
}

}  // namespace taut::internal::curve
