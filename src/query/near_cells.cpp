#include "query/bracket.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "geometry/box_tree.hpp"
#include "geometry/vector.hpp"
#include "scene/ring_set.hpp"
#include "taut/pose.hpp"

namespace taut::internal {
namespace {

/// A cell, or an edge of a polygon, at the pose of its body.
struct CellAtPose {
  const curve::Piece* piece = nullptr;
  std::vector<Vector> corners;
  double thickness = 0;
  int* mark = nullptr;  ///< of a cell that can be refined
  bool marked = false;
  AxisBox box;  ///< around it, enlarged by its thickness
};

double distance_to_edge(Vector p, Vector a, Vector b) {
  const Vector e = b - a, v = p - a;
  const double length = dot(e, e), along = length > 0 ? std::clamp(dot(v, e) / length, 0.0, 1.0) : 0;
  const Vector d{v.x - along * e.x, v.y - along * e.y};
  return std::sqrt(dot(d, d));
}

bool crossing_edges(Vector a, Vector b, Vector c, Vector d) {
  const auto side = [](Vector p, Vector q, Vector r) { return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x); };
  return (side(a, b, c) > 0) != (side(a, b, d) > 0) && (side(c, d, a) > 0) != (side(c, d, b) > 0);
}

double distance_between(const CellAtPose& a, const CellAtPose& b) {
  double least = INFINITY;
  for (std::size_t i = 0; i < a.corners.size(); ++i) {
    const Vector p = a.corners[i], q = a.corners[(i + 1) % a.corners.size()];
    for (std::size_t k = 0; k < b.corners.size(); ++k) {
      const Vector r = b.corners[k], s = b.corners[(k + 1) % b.corners.size()];
      if (crossing_edges(p, q, r, s)) return 0;
      least = std::min({least, distance_to_edge(p, r, s), distance_to_edge(r, p, q)});
    }
  }
  return least;
}

/// All cells of a body at an instant, and boxes around runs of them.
class CellsAtPose {
 public:
  CellsAtPose(const CurvedWorld& world, BodyId body, const BodyPose& pose, CurvedWorld::Halvings& marks) : pose_(pose) {
    const auto id = static_cast<std::size_t>(body);
    for (std::size_t p = 0; p < world.parts(body).size(); ++p) {
      const auto& bands = world.parts(body)[p].bands();
      for (std::size_t ring = 0; ring < bands.size(); ++ring) {
        for (std::size_t k = 0; k < bands[ring].cells().size(); ++k) {
          const curve::Cell& cell = bands[ring].cells()[k];
          add(bands[ring].corners(k), cell.thickness, cell.is_final ? nullptr : &marks[id][p][ring][k]);
          cells_.back().piece = &cell.piece;
        }
      }
    }
    if (world.parts(body).empty()) {
      for (const Part& part : parts_of(world.scene().bodies[id])) {
        add_ring(part.outline);
        for (const Polygon& hole : part.holes) add_ring(hole);
      }
    }
    std::vector<AxisBox> boxes;
    for (const CellAtPose& cell : cells_) boxes.push_back(cell.box);
    around_ = BoxTree(boxes);
  }

  /// Visits pairs of cells whose boxes are at most `reach` apart.
  template <class Visit>
  static void near(CellsAtPose& a, CellsAtPose& b, double reach, const Visit& visit) {
    a.around_.each_near(b.around_, reach, [&](int i, int k) {
      visit(a.cells_[static_cast<std::size_t>(i)], b.cells_[static_cast<std::size_t>(k)]);
    });
  }

  Vector placed(const Point& p) const {
    return Vector{pose_.origin.x, pose_.origin.y} + Vector{pose_.axis.x, pose_.axis.y} * Vector{p.x, p.y};
  }
  std::size_t number_of(const CellAtPose& cell) const { return static_cast<std::size_t>(&cell - cells_.data()); }
  std::size_t size() const { return cells_.size(); }

 private:
  void add_ring(const Polygon& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) add({ring[i], ring[(i + 1) % ring.size()]}, 0, nullptr);
  }

  void add(const std::vector<Point>& corners, double thickness, int* mark) {
    CellAtPose cell;
    cell.thickness = thickness;
    cell.mark = mark;
    for (const Point& p : corners) {
      const Vector at = placed(p);
      cell.corners.push_back(at);
      cell.box.include(AxisBox({at.x, at.y}, {at.x, at.y}, thickness));
    }
    cells_.push_back(std::move(cell));
  }

  const BodyPose& pose_;
  std::vector<CellAtPose> cells_;
  BoxTree around_;
};

/// Three points on a curve, its ends and its middle, or on an edge.
using ThreePoints = std::array<Vector, 3>;

ThreePoints points_on(const CellsAtPose& cells, const CellAtPose& cell) {
  if (!cell.piece) return {cell.corners[0], (cell.corners[0] + cell.corners[1]) * Vector{0.5, 0}, cell.corners[1]};
  const curve::Piece& piece = *cell.piece;
  const Vector first = cells.placed(piece.first().rounded()), last = cells.placed(piece.last().rounded());
  if (piece.is_line()) return {first, (first + last) * Vector{0.5, 0}, last};
  return {first, cells.placed(curve::halves(piece)[0].last().rounded()), last};
}

/// The distance of p from the circle through three points, or from their line: for short pieces, from the curve.
double distance_to_circle(Vector p, const ThreePoints& on) {
  const Vector u = on[1] - on[0], v = on[2] - on[0], q = p - on[0];
  const double turn = 2 * (u.x * v.y - u.y * v.x), uu = dot(u, u), vv = dot(v, v);
  // The power of p with respect to the circle, divided by |p - centre| + radius, without a division by a possible zero.
  const double cx = v.y * uu - u.y * vv, cy = u.x * vv - v.x * uu;
  const double power = turn * dot(q, q) - 2 * (cx * q.x + cy * q.y);
  const double to_p = std::hypot(turn * q.x - cx, turn * q.y - cy);
  return std::fabs(power) / (to_p + std::hypot(cx, cy));
}

/// A bound of the rounding of the bodies' positions in doubles.
double room_of(const CurvedWorld& world, const std::array<BodyId, 2>& pair, const std::array<BodyPose, 2>& poses) {
  double size = 0;
  for (const BodyPose& p : poses) size = std::max({size, std::fabs(p.origin.x), std::fabs(p.origin.y)});
  for (const BodyId body : pair) {
    for (const curve::BandedPart& part : world.parts(body)) size = std::max(size, part.bands()[0].resolution().size);
  }
  return size * 0x1p-46;
}

std::array<BodyPose, 2> poses_of_pair(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t) {
  const std::vector<BodyPose> poses = poses_at(world.scene(), t);
  return {poses[static_cast<std::size_t>(pair[0])], poses[static_cast<std::size_t>(pair[1])]};
}

}  // namespace

bool run_along(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, std::uint64_t most) {
  const std::array<BodyPose, 2> poses = poses_of_pair(world, pair, t);
  CurvedWorld::Halvings marks = world.no_halvings();
  CellsAtPose first(world, pair[0], poses[0], marks), second(world, pair[1], poses[1], marks);
  const double room = room_of(world, pair, poses);
  std::vector<double> gaps(first.size(), INFINITY);
  std::vector<std::optional<ThreePoints>> cache(second.size());
  double thickest = 0;
  CellsAtPose::near(first, second, room, [&](CellAtPose& a, CellAtPose& b) {
    if (distance_between(a, b) > a.thickness + b.thickness + room) return;
    std::optional<ThreePoints>& on = cache[second.number_of(b)];
    if (!on) on = points_on(second, b);
    double& gap = gaps[first.number_of(a)];
    gap = std::min(gap, distance_to_circle(points_on(first, a)[1], *on));
    thickest = std::max({thickest, a.thickness, b.thickness});
  });
  std::erase(gaps, INFINITY);
  if (gaps.empty()) return false;
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2), gaps.end());
  const double gap = gaps[gaps.size() / 2];
  // Thickness falls with the square of the number of cells.
  return 2 * static_cast<double>(gaps.size()) * std::sqrt(2 * thickest / std::max(gap, 16 * room)) >
         static_cast<double>(most);
}

std::size_t mark_near(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, double reach,
                      CurvedWorld::Halvings& marks) {
  const std::array<BodyPose, 2> poses = poses_of_pair(world, pair, t);
  const double room = reach + room_of(world, pair, poses);
  CellsAtPose first(world, pair[0], poses[0], marks), second(world, pair[1], poses[1], marks);
  std::size_t count = 0;
  const auto mark = [&count](CellAtPose& cell) {
    if (!cell.mark || cell.marked) return;
    cell.marked = true;
    *cell.mark = 1;
    ++count;
  };
  CellsAtPose::near(first, second, room, [&](CellAtPose& a, CellAtPose& b) {
    // Next to a coarse cell, a fine one need not be refined.
    const bool first_matters = a.mark && !a.marked && 4 * a.thickness >= b.thickness;
    const bool second_matters = b.mark && !b.marked && 4 * b.thickness >= a.thickness;
    if (!first_matters && !second_matters) return;
    if (distance_between(a, b) > a.thickness + b.thickness + room) return;
    if (first_matters) mark(a);
    if (second_matters) mark(b);
  });
  return count;
}

}  // namespace taut::internal
