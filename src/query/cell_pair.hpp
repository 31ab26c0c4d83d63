// Two bodies over a cell of joint values: apart, overlapping, or undecided.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "joints/pose_model.hpp"
#include "solver/pair_solver.hpp"
#include "taut/geometry.hpp"

namespace taut::internal {

/// A point of one body, by its number, that lies inside the other body, deep enough to be so for all of some cell.
struct InnerPoint {
  bool of_p = false;
  std::uint32_t index = 0;
};

/// One pair. A cell is *free* if directions separate all ranges of edges of the one body from all of the other, for all
/// joint values in it, and no outline is inside the other body at the middle. It *collides* if for all values some two
/// edges cross, or a point of one body is inside the other: a vertex, or a point inside of one, which shows this of
/// bodies whose outlines lie on each other. Everything is bounded in doubles with certified errors.
class CellPair {
 public:
  CellPair(const PairGeometry& geometry, const spacetime::TreePair& trees)
      : geometry_(geometry),
        trees_(trees),
        outlines_{outlines(*geometry.p()), outlines(*geometry.q())},
        probes_{probes(true), probes(false)} {}

  /// Q's pose is seen from P. `hint` is an inner vertex that was found in a larger cell around, or none, and becomes
  /// one that was found now.
  CellState evaluate(const PoseModel& of_q, std::optional<InnerPoint>& hint) const;

 private:
  struct Seen;
  enum class Ranges : unsigned char { apart, crossing, open };
  static std::vector<std::uint32_t> outlines(const DisplacedPolygon& body);
  std::vector<Vector> probes(bool of_p) const;
  /// How far the point is inside the body; 0 if it is not, or if that is not certain.
  double depth_in(bool p, Vector at) const;
  Ranges look_at_ranges(const Seen& seen) const;
  bool separated(const Seen& seen, const spacetime::Box& p, const spacetime::Box& q) const;
  bool cross(const Seen& seen, std::uint32_t p, std::uint32_t q) const;
  CellState containment(const Seen& seen) const;
  bool stays_inside(const Seen& seen, const InnerPoint& inner) const;
  bool find_inner(const Seen& seen, std::optional<InnerPoint>& hint) const;
  Vector point(bool of_p, std::uint32_t index) const {
    const DisplacedPoint& d = geometry_.point(VertexId(of_p ? index : geometry_.np + index));
    return {d.x, d.y};
  }
  std::uint32_t next(bool of_p, std::uint32_t index) const {
    const std::uint32_t first = of_p ? 0 : geometry_.np;
    return geometry_.next(VertexId(first + index)).value - first;
  }

  const PairGeometry& geometry_;
  spacetime::TreePair trees_;
  std::vector<std::uint32_t> outlines_[2];  ///< a vertex of each outline, of P and of Q
  std::vector<Vector> probes_[2];           ///< points that may be inside the other body, of P and of Q
};

// Cells near a polygon at rest.

/// Collects cells, each once. A cell is a square of side 1 here: coordinates are in cells.
class CellRaster {
 public:
  /// Rings of one body, placed; `margin` > 0. Adds every cell that is at most `margin` away from the body, and none
  /// that is more than margin + slack away. The slack covers the rounding of coordinates of that magnitude. Throws
  /// InputError where there are too many.
  void add(const std::vector<std::vector<Polygon>>& parts, double margin, double slack);

  /// By rows, then columns.
  std::vector<std::array<int, 2>> sorted() const;

 private:
  void add_edge(const Point& a, const Point& b, double margin);
  void add_inside(const std::vector<Polygon>& rings);
  void mark(int i, int j);

  std::unordered_set<std::uint64_t> marked_;
};

}  // namespace taut::internal
