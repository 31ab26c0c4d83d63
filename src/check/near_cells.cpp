#include "check/near_cells.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/vector.hpp"
#include "pair/ring_set.hpp"
#include "taut/pose.hpp"

namespace taut {
namespace {

struct NearBox {
  double lo_x = INFINITY, lo_y = INFINITY, hi_x = -INFINITY, hi_y = -INFINITY;
  void add(const NearBox& b) {
    lo_x = std::min(lo_x, b.lo_x);
    lo_y = std::min(lo_y, b.lo_y);
    hi_x = std::max(hi_x, b.hi_x);
    hi_y = std::max(hi_y, b.hi_y);
  }
  bool meets(const NearBox& b) const { return lo_x <= b.hi_x && b.lo_x <= hi_x && lo_y <= b.hi_y && b.lo_y <= hi_y; }
};

/// A cell, or an edge of a polygon, where its body is.
struct PosedCell {
  std::vector<Vector> corners;
  double thickness = 0;
  int* mark = nullptr;  ///< of a cell that can become finer
  bool marked = false;
  NearBox box;
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

double distance_between(const PosedCell& a, const PosedCell& b) {
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
class PosedCells {
 public:
  PosedCells(const CurvedWorld& world, BodyId body, const BodyPose& pose, double reach, CurvedWorld::Halvings& marks)
      : pose_(pose), reach_(reach) {
    const auto id = static_cast<std::size_t>(body);
    for (std::size_t p = 0; p < world.parts(body).size(); ++p) {
      const auto& bands = world.parts(body)[p].bands();
      for (std::size_t ring = 0; ring < bands.size(); ++ring) {
        for (std::size_t k = 0; k < bands[ring].cells().size(); ++k) {
          const curve::Cell& cell = bands[ring].cells()[k];
          add(bands[ring].corners(k), cell.thickness, cell.settled ? nullptr : &marks[id][p][ring][k]);
        }
      }
    }
    if (world.parts(body).empty()) {
      for (const Part& part : parts_of(world.scene().bodies[id])) {
        add_ring(part.outline);
        for (const Polygon& hole : part.holes) add_ring(hole);
      }
    }
    around_.resize(4 * cells_.size());
    build(1, 0, cells_.size());
  }

  /// Visits pairs of cells whose boxes meet.
  template <class Visit>
  static void meet(PosedCells& a, PosedCells& b, const Visit& visit) {
    across(a, {1, 0, a.cells_.size()}, b, {1, 0, b.cells_.size()}, visit);
  }

 private:
  struct Run {
    std::size_t node, lo, hi;
    std::size_t size() const { return hi - lo; }
    Run half(bool second) const {
      const std::size_t middle = (lo + hi) / 2;
      return second ? Run{2 * node + 1, middle, hi} : Run{2 * node, lo, middle};
    }
  };

  void add_ring(const Polygon& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) add({ring[i], ring[(i + 1) % ring.size()]}, 0, nullptr);
  }

  void add(const std::vector<Point>& corners, double thickness, int* mark) {
    PosedCell cell;
    cell.thickness = thickness;
    cell.mark = mark;
    const double room = thickness + reach_;
    for (const Point& p : corners) {
      const Vector at = Vector{pose_.origin.x, pose_.origin.y} + Vector{pose_.axis.x, pose_.axis.y} * Vector{p.x, p.y};
      cell.corners.push_back(at);
      cell.box.add({at.x - room, at.y - room, at.x + room, at.y + room});
    }
    cells_.push_back(std::move(cell));
  }

  const NearBox& build(std::size_t node, std::size_t lo, std::size_t hi) {
    if (hi - lo == 1) return around_[node] = cells_[lo].box;
    const std::size_t middle = (lo + hi) / 2;
    NearBox box = build(2 * node, lo, middle);
    box.add(build(2 * node + 1, middle, hi));
    return around_[node] = box;
  }

  template <class Visit>
  static void across(PosedCells& a, const Run& i, PosedCells& b, const Run& k, const Visit& visit) {
    if (!a.around_[i.node].meets(b.around_[k.node])) return;
    if (i.size() == 1 && k.size() == 1) return visit(a.cells_[i.lo], b.cells_[k.lo]);
    for (const bool second : {false, true}) {
      if (i.size() >= k.size()) {
        across(a, i.half(second), b, k, visit);
      } else {
        across(a, i, b, k.half(second), visit);
      }
    }
  }

  const BodyPose& pose_;
  double reach_;
  std::vector<PosedCell> cells_;
  std::vector<NearBox> around_;
};

}  // namespace

std::size_t mark_near(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, double reach,
                      CurvedWorld::Halvings& marks) {
  const std::vector<BodyPose> poses = poses_at(world.scene(), t);
  const auto pose = [&](int k) { return poses[static_cast<std::size_t>(pair[static_cast<std::size_t>(k)])]; };
  const BodyPose first_pose = pose(0), second_pose = pose(1);
  // Room for what doubles round.
  double size = 0;
  for (const BodyPose& p : {first_pose, second_pose})
    size = std::max({size, std::fabs(p.origin.x), std::fabs(p.origin.y)});
  for (const BodyId body : pair) {
    for (const curve::BandedPart& part : world.parts(body)) size = std::max(size, part.bands()[0].resolution().size);
  }
  const double room = reach + size * 0x1p-46;
  PosedCells first(world, pair[0], first_pose, room, marks), second(world, pair[1], second_pose, room, marks);
  std::size_t count = 0;
  const auto mark = [&count](PosedCell& cell) {
    if (!cell.mark || cell.marked) return;
    cell.marked = true;
    *cell.mark = 1;
    ++count;
  };
  PosedCells::meet(first, second, [&](PosedCell& a, PosedCell& b) {
    // Beside a coarse cell a fine one need not become finer.
    const bool first_matters = a.mark && !a.marked && 4 * a.thickness >= b.thickness;
    const bool second_matters = b.mark && !b.marked && 4 * b.thickness >= a.thickness;
    if (!first_matters && !second_matters) return;
    if (distance_between(a, b) > a.thickness + b.thickness + room) return;
    if (first_matters) mark(a);
    if (second_matters) mark(b);
  });
  return count;
}

}  // namespace taut
