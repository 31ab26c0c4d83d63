#include "geometry/band.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/hull.hpp"
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

}  // namespace taut::internal::curve
