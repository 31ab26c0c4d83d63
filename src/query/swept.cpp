#include "taut/swept.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "geometry/axis_box.hpp"
#include "geometry/part_rings.hpp"
#include "geometry/predicates.hpp"
#include "geometry/region_union.hpp"
#include "motion/far_pieces.hpp"
#include "motion/pose.hpp"
#include "numeric/budget.hpp"
#include "scene/curved_world.hpp"
#include "scene/instance.hpp"
#include "scene/ring_set.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

// How the tolerance is divided. A region reaches beyond what is covered by at most
//   overreach + sqrt(2) (bend + room) + what unions move < (7/16 + 1.42 (3/16 + 32/512) + 31/512) tolerance
//                                                        < 0.86 tolerance,
// and by an eighth more where polygons stand for curves.
constexpr double share_of_bend = 3.0 / 16;
constexpr double share_of_overreach = 7.0 / 16;
constexpr double share_of_curves = 1.0 / 8;
constexpr double share_of_grid = 1.0 / 512;
/// In grid units: what unions may move edges by, and joints take away.
constexpr double room_in_grids = RegionUnion::most_moved_in_grids + 1, lost_at_joints_in_grids = 1;
/// The tolerance, if none is given, as a share of the diagonal of the body's box.
constexpr double default_share = 1e-3;
/// Halving time so often ends where a body turns with infinite speed, too: half as many bits of the way are left.
constexpr int deepest_halving_of_way = 200;
/// Of coordinates: what the operations on them may round away, generously.
constexpr double rounding_of_places = 0x1p-44;

double distance_from_line(const Point& p, const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y, far = length(x, y);
  if (far == 0) return length(p.x - a.x, p.y - a.y);
  return std::fabs(x * (p.y - a.y) - y * (p.x - a.x)) / far;
}

/// A piece of an edge at the two ends of a time: its first end goes straight from a to a_then, the other one from b to
/// b_then.
struct EdgeOverTime {
  Point a, b, a_then, b_then;

  std::array<Point, 4> corners() const { return {a, b, a_then, b_then}; }
  /// The hull of the corners contains all that is covered. This bounds how far it reaches beyond that. Of the hull's
  /// sides only those are covered by nothing that join one end before to the other one then. What lies between such a
  /// side and what is covered is in both triangles over that side.
  double overreach() const { return std::max(beyond(a, b_then, b, a_then), beyond(b, a_then, a, b_then)); }
  /// The place along the edge, as a share, that stays on its line, where the ends leave it to different sides.
  std::optional<double> pivot() const {
    const double x = b.x - a.x, y = b.y - a.y;
    const double of_a = x * (a_then.y - a.y) - y * (a_then.x - a.x), of_b = x * (b_then.y - b.y) - y * (b_then.x - b.x);
    if (!(of_a < 0 ? of_b > 0 : of_a > 0 && of_b < 0)) return std::nullopt;
    return of_a / (of_a - of_b);
  }
  std::array<EdgeOverTime, 2> cut_at(double share) const {
    const auto between = [&](const Point& p, const Point& q) {
      return Point{p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)};
    };
    const Point at = between(a, b), then = between(a_then, b_then);
    return {{{a, at, a_then, then}, {at, b, then, b_then}}};
  }

 private:
  static double side(const Point& p, const Point& a, const Point& b) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  /// Over the side from p to q, if both others are on one side of it; else it is inside the hull.
  static double beyond(const Point& p, const Point& q, const Point& r, const Point& s) {
    const double of_r = side(r, p, q), of_s = side(s, p, q);
    if ((of_r > 0 && of_s < 0) || (of_r < 0 && of_s > 0)) return 0;
    return std::min(distance_from_line(r, p, q), distance_from_line(s, p, q));
  }
};

/// A body's way, in stretches of time in which its points go nearly straight. What it covers is where it is at the
/// start, and what its boundary passes over afterwards.
class Sweep {
 public:
  Sweep(const Scene& scene, const Body& body, double tolerance)
      : scene_(scene),
        tolerance_(tolerance),
        grid_(std::exp2(std::floor(std::log2(share_of_grid * tolerance)))),
        parts_(parts_of(body)),
        motions_(chain_of(scene, body)) {}

  std::vector<Part> run() {
    const double end = std::min(scene_.end, repeats_from({}, motions_, scene_.start, scene_.end));
    follow(
        motions_, scene_.start, end,
        [&](const PieceChain& chain, double from, double to) {
          enter(chain);
          if (from == scene_.start) begin(chain, from);
          stretch(chain, placed(chain, from), from, placed(chain, to), to, 0);
        },
        [&](const PieceChain& before, const PieceChain& after, double t) {
          enter(after);
          join(placed(before, t), placed(after, t), t);
        });
    return region_->parts();
  }

 private:
  /// The body's vertices at an instant, ring by ring, and how far they may be from there.
  struct Placed {
    std::vector<Point> points;
    double off = 0;
  };

  /// Rings as seen from the pivot of a piece: far from it the parts of a turn about it would nearly cancel.
  void enter(const PieceChain& chain) {
    pivot_ = chain.back().pivot;
    points_.clear();
    ring_ends_.clear();
    reach_ = 0;
    for (const Part& part : parts_) {
      add_ring(part.outline, ring_direction(part.outline) < 0);
      for (const Polygon& hole : part.holes) add_ring(hole, ring_direction(hole) > 0);
    }
  }
  void add_ring(const Polygon& ring, bool backwards) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point& p = ring[backwards ? ring.size() - 1 - k : k];
      points_.push_back({p.x - pivot_.x, p.y - pivot_.y});
      reach_ = std::max(reach_, length(points_.back().x, points_.back().y));
    }
    ring_ends_.push_back(points_.size());
  }

  Placed placed(const PieceChain& chain, double t) const {
    const Pose<double> at = poses_over(chain, pivot_, t, t).middle;
    Placed found;
    for (const Point& p : points_)
      found.points.push_back({at.ox.v.mid + (at.xx.v.mid * p.x - at.xy.v.mid * p.y),
                              at.oy.v.mid + (at.xy.v.mid * p.x + at.xx.v.mid * p.y)});
    const double size = std::fabs(at.ox.v.mid) + std::fabs(at.oy.v.mid) + std::fabs(pivot_.x) + std::fabs(pivot_.y);
    found.off =
        at.ox.v.rad + at.oy.v.rad + (at.xx.v.rad + at.xy.v.rad) * reach_ + rounding_of_places * (size + 2 * reach_);
    return found;
  }

  /// Where it is at the start: its inside, and all around its boundary.
  void begin(const PieceChain& chain, double t) {
    const Placed at = placed(chain, t);
    require(at.off <= share_of_bend * tolerance_, t);
    if (!region_) region_.emplace(grid_, at.points.front());
    std::size_t first = 0, ring = 0;
    for (const Part& part : parts_) {
      Part whole;
      for (std::size_t k = 0; k <= part.holes.size(); ++k, ++ring) {
        const Polygon points(at.points.begin() + static_cast<std::ptrdiff_t>(first),
                             at.points.begin() + static_cast<std::ptrdiff_t>(ring_ends_[ring]));
        for (const Point& p : points) require_in_reach(p);
        first = ring_ends_[ring];
        if (k == 0) {
          whole.outline = points;
        } else {
          whole.holes.push_back(points);
        }
      }
      region_->add(whole);
    }
    require(add_boundary(at, at, at.off, [](std::size_t, std::size_t) { return true; }), t);
  }

  /// Where two pieces join up to rounding, all points go straight from the one place to the other. All that is near to
  /// the body is covered, too, and such a jump is far shorter than that.
  void join(const Placed& before, const Placed& after, double t) {
    const double off = before.off + after.off;
    double gap = off;
    for (std::size_t k = 0; k < before.points.size(); ++k)
      gap = std::max(gap, off + length(after.points[k].x - before.points[k].x, after.points[k].y - before.points[k].y));
    lost_ += gap;
    if (lost_ <= lost_at_joints_in_grids * grid_) return;
    require(off <= share_of_bend * tolerance_ &&
                add_boundary(before, after, off, [](std::size_t, std::size_t) { return true; }),
            t);
    lost_ = 0;
  }

  void stretch(const PieceChain& chain, const Placed& at, double from, const Placed& then, double to, int depth) {
    checkpoint();
    if (from == to) return;
    const Pose<double> over = poses_over(chain, pivot_, from, to).over;
    const double bend = std::max(at.off, then.off) + bend_of(over, to - from);
    if (bend <= share_of_bend * tolerance_ && add_boundary(at, then, bend, [&](std::size_t a, std::size_t b) {
          return !certainly_retreats(over, points_[a], points_[b]);
        }))
      return;
    const double middle = from + (to - from) / 2;
    require(from < middle && middle < to && depth < deepest_halving_of_way, from);
    const Placed half = placed(chain, middle);
    stretch(chain, at, from, half, middle, depth + 1);
    stretch(chain, half, middle, then, to, depth + 1);
  }

  /// How far a point may be from the straight way between its places at the ends: by the second derivative, or by the
  /// range of the pose itself.
  double bend_of(const Pose<double>& over, double time) const {
    const auto all = [&](auto part) {
      return length(part(over.ox), part(over.oy)) + length(part(over.xx), part(over.xy)) * reach_;
    };
    const double by_bend = all([](const Jet<double>& f) { return f.dd.magnitude(); }) * time * time / 8;
    const double by_range = 2 * all([](const Jet<double>& f) { return f.v.rad; });
    return (1 + 0x1p-40) * (by_bend <= by_range ? by_bend : by_range);
  }

  /// Does the edge go towards the material at all times? Then it uncovers, and covers nothing that was not covered.
  static bool certainly_retreats(const Pose<double>& over, const Point& a, const Point& b) {
    using B = Ball<double>;
    const double ex = b.x - a.x, ey = b.y - a.y;
    // The material is on the left. A few roundings more do not matter: what nearly stays is not left out.
    const B nx = over.xx.v * B::exact(ey) + over.xy.v * B::exact(ex),
            ny = over.xy.v * B::exact(ey) - over.xx.v * B::exact(ex);
    const auto leaves = [&](const Point& p) {
      const B vx = over.ox.d + over.xx.d * B::exact(p.x) - over.xy.d * B::exact(p.y);
      const B vy = over.oy.d + over.xy.d * B::exact(p.x) + over.xx.d * B::exact(p.y);
      const B along = vx * nx + vy * ny;
      const double slack = 0x1p-30 * (vx.magnitude() + vy.magnitude()) * (nx.magnitude() + ny.magnitude());
      return along.mid + along.rad + slack < 0;
    };
    return leaves(a) && leaves(b);
  }

  /// Adds what the edges pass over that are `wanted`. False, and nothing is added, if hulls would reach too far
  /// beyond.
  template <class Wanted>
  bool add_boundary(const Placed& at, const Placed& then, double bend, const Wanted& wanted) {
    std::vector<EdgeOverTime> edges;
    std::size_t first = 0;
    for (const std::size_t end : ring_ends_) {
      for (std::size_t k = first; k < end; ++k) {
        const std::size_t next = k + 1 < end ? k + 1 : first;
        if (!wanted(k, next)) continue;
        if (!add_edge({at.points[k], at.points[next], then.points[k], then.points[next]}, edges)) return false;
      }
      first = end;
    }
    for (const EdgeOverTime& edge : edges) add_around(edge, bend + room_in_grids * grid_);
    return true;
  }
  bool add_edge(const EdgeOverTime& edge, std::vector<EdgeOverTime>& edges) const {
    const double most = share_of_overreach * tolerance_;
    if (edge.overreach() <= most) {
      edges.push_back(edge);
      return true;
    }
    const auto pivot = edge.pivot();
    if (!pivot) return false;
    for (const EdgeOverTime& half : edge.cut_at(*pivot)) {
      if (!(half.overreach() <= most)) return false;
      edges.push_back(half);
    }
    return true;
  }
  void add_around(const EdgeOverTime& edge, double room) {
    std::vector<Point> around;
    for (const Point& p : edge.corners()) {
      require_in_reach(p);
      for (const double x : {p.x - room, p.x + room}) {
        for (const double y : {p.y - room, p.y + room}) around.push_back({x, y});
      }
    }
    Polygon hull;
    for (const int k : convex_hull(around)) hull.push_back(around[static_cast<std::size_t>(k)]);
    region_->add(hull);
  }

  void require_in_reach(const Point& p) const {
    if (region_->has_room_for(p)) return;
    throw InputError("swept", "the tolerance is too small for a region as large as this one",
                     "ask for a larger tolerance, or for a part of the time");
  }
  static void require(bool decided, double t) {
    if (decided) return;
    throw InputError(
        "swept", "doubles do not show where the body is, to a fifth of the tolerance, near t = " + std::to_string(t),
        "ask for a larger tolerance, or choose coordinates nearer to the origin");
  }

  const Scene& scene_;
  double tolerance_, grid_;
  std::optional<RegionUnion> region_;  ///< on a grid about where the body starts: it may be far from the origin
  std::vector<Part> parts_;
  MotionChain motions_;
  Point pivot_;
  std::vector<Point> points_;  ///< of all rings, relative to the pivot, with the material to the left
  std::vector<std::size_t> ring_ends_;
  double reach_ = 0;
  double lost_ = 0;  ///< of the room, at joints
};

double diagonal_of(const Body& body) {
  AxisBox box;
  for (const Part& part : parts_of(body)) {
    for (const Point& p : part.outline) box.include({p.x, p.y, p.x, p.y});
  }
  return length(box.hi_x - box.lo_x, box.hi_y - box.lo_y);
}

double area_of(const std::vector<Part>& parts) {
  double area = 0;
  const auto add = [&](const Polygon& ring) {
    const Point o = ring.front();
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point &p = ring[k], &q = ring[(k + 1) % ring.size()];
      area += ((p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y)) / 2;
    }
  };
  for (const Part& part : parts) {
    add(part.outline);
    for (const Polygon& hole : part.holes) add(hole);
  }
  return area;
}

SweptRegion swept_by_polygons(const Scene& scene, BodyId body, double tolerance) {
  SweptRegion region{tolerance, Sweep(scene, scene.bodies[static_cast<std::size_t>(body)], tolerance).run()};
  region.area = area_of(region.parts);
  return region;
}

}  // namespace

SweptRegion swept(const Scene& scene, BodyId body, const SweptOptions& options) {
  if (body < 0 || static_cast<std::size_t>(body) >= scene.bodies.size())
    throw InputError("swept", "there is no body " + std::to_string(body), "the first one is 0");
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance))
    throw InputError("tolerance", "it is not a positive number", "give one, or leave it out");
  try {
    const Budget scope(options.limits);
    if (!has_curves(scene)) {
      validate_polygons(scene);
      const double given = options.tolerance;
      return swept_by_polygons(
          scene, body, given > 0 ? given : default_share * diagonal_of(scene.bodies[static_cast<std::size_t>(body)]));
    }
    validate_curved_world(scene);
    CurvedWorld curved(scene);
    const Scene rough = curved.polygons(CurveSide::outer);
    const double tolerance = options.tolerance > 0
                                 ? options.tolerance
                                 : default_share * diagonal_of(rough.bodies[static_cast<std::size_t>(body)]);
    curved.refine_to(share_of_curves * tolerance);
    return swept_by_polygons(curved.polygons(CurveSide::outer), body, tolerance);
  } catch (const Interrupted& stopped) {
    throw UndecidedError(stopped.reason);
  }
}

}  // namespace taut
