#include "geometry/band.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/part_rings.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment_numbers.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::internal::curve {
namespace {

/// Of halving a piece that does not fit into a cell.
constexpr int deepest_start = 40;

/// Throws unless the numbers may be computed with.
void require_numbers(const Outline& outline, const std::string& name) {
  int index = -1;
  const auto require = [&](double x) {
    if (in_range(x)) return;
    const std::string where = index < 0 ? "the start" : "segment " + std::to_string(index);
    throw InputError(name, where + " has a number that is not 0 or of magnitude between 2^-400 and 2^400",
                     "choose another unit of length");
  };
  require(outline.start.x);
  require(outline.start.y);
  for (const CurveSegment& segment : outline.segments) {
    ++index;
    for_each_number(segment, require);
  }
}

double size_of(const std::vector<Piece>& pieces) {
  double largest = 0;
  for (const Piece& piece : pieces) {
    for (int k = 0; k < piece.size; ++k) {
      const Point p = piece.control[static_cast<std::size_t>(k)].rounded();
      largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, exponent);
}

std::string text_of(const Point& p) { return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ")"; }

}  // namespace

std::vector<CurveSegment> closed_segments(const Outline& outline) {
  std::vector<CurveSegment> segments = outline.segments;
  if (!segments.empty() && !(end_of(segments.back()) == outline.start)) segments.push_back(LineTo{outline.start});
  return segments;
}

Band::Band(const Outline& outline, const std::string& name) {
  require_numbers(outline, name);
  std::vector<Piece> pieces;
  Point from = outline.start;
  int index = 0;
  for (const CurveSegment& segment : closed_segments(outline)) {
    for (Piece& piece : pieces_of(from, segment, index)) pieces.push_back(std::move(piece));
    from = end_of(segment);
    ++index;
  }
  if (pieces.empty()) throw InputError(name, "the outline has no segments", "draw a closed curve");
  resolution_.size = size_of(pieces);
  Gate gate = gate_at_end(pieces.back(), resolution_);
  for (const Piece& piece : pieces) {
    const Gate next = gate_at_end(piece, resolution_);
    add(piece, gate, next, 0, name);
    gate = next;
  }
  if (cells_.size() == 2 && cells_[0].is_line() && cells_[1].is_line())
    throw InputError(name, "the outline encloses nothing", "draw a closed curve around an area");
}

void Band::add(const Piece& piece, const Gate& first, const Gate& last, int depth, const std::string& name) {
  if (auto cell = make_cell(piece, first, last, resolution_)) {
    cells_.push_back(std::move(*cell));
    gates_.push_back(first);
    return;
  }
  if (depth == deepest_start) {
    throw InputError(
        name,
        "segment " + std::to_string(piece.segment) + " turns back on itself near " + text_of(piece.first().rounded()),
        "split the curve at its cusp, so that a corner is there, or draw it anew");
  }
  const std::array<Piece, 2> half = halves(piece);
  const Gate gate = gate_at_end(half[0], resolution_);
  add(half[0], first, gate, depth + 1, name);
  add(half[1], gate, last, depth + 1, name);
}

std::vector<Point> Band::corners(std::size_t cell) const {
  return corners_of(cells_[cell], gate(cell), gate(cell + 1));
}

bool Band::add_split(const Cell& cell, const Gate& first, const Gate& last, int halvings, std::vector<Cell>& cells,
                     std::vector<Gate>& gates) const {
  if (halvings > 0 && !cell.is_final) {
    if (const auto parts = split(cell, first, last, resolution_)) {
      add_split(parts->first, first, parts->gate, halvings - 1, cells, gates);
      add_split(parts->last, parts->gate, last, halvings - 1, cells, gates);
      return true;
    }
  }
  cells.push_back(cell);
  gates.push_back(first);
  if (halvings > 0) cells.back().is_final = true;
  return false;
}

bool Band::refine(const std::vector<int>& halvings) {
  std::vector<Cell> cells;
  std::vector<Gate> gates;
  bool finer = false;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    checkpoint();
    finer = add_split(cells_[k], gate(k), gate(k + 1), halvings[k], cells, gates) || finer;
  }
  cells_ = std::move(cells);
  gates_ = std::move(gates);
  return finer;
}

Polygon Band::wall(bool left) const {
  Polygon polygon;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    polygon.push_back(left ? gates_[k].left : gates_[k].right);
    const std::vector<Point>& corners = left ? cells_[k].left : cells_[k].right;
    polygon.insert(polygon.end(), corners.begin(), corners.end());
  }
  return polygon;
}

std::vector<Source> Band::sources(bool left) const {
  std::vector<Source> sources;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const Piece& piece = cells_[k].piece;
    const std::size_t inner = (left ? cells_[k].left : cells_[k].right).size();
    for (std::size_t i = 0; i <= inner; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(inner + 1);
      sources.push_back({static_cast<int>(k), piece.from + share * (piece.to - piece.from)});
    }
  }
  return sources;
}

int Band::orientation() const { return polygon_orientation(wall(true)); }

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

namespace taut {

// Curves as polygons, for people.

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
