#include "taut/cells.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "motion/pose.hpp"
#include "numeric/budget.hpp"
#include "query/cell_pair.hpp"
#include "scene/instance.hpp"
#include "scene/ring_set.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

/// What cells may be away from the body; poses are as dense as that takes.
constexpr double cell_excess = 1.0 / 16;
/// Halving time so often ends where a body turns with infinite speed, too: half as many bits of the way are left.
constexpr int deepest_halving_of_time = 200;

/// A body's way over the grid: from joint to joint of any motion of its chain, in windows in which no point of it gets
/// farther from where it is in the middle than the excess. Lengths are in cells, but for the motion's own.
class CellSweep {
 public:
  CellSweep(const Scene& scene, const Body& body, const CellOptions& options) : scene_(scene), options_(options) {
    parts_ = parts_of(body);
    for (const Part& part : parts_) {
      for (const Point& p : part.outline) reach_ = std::max(reach_, length(p.x, p.y));
    }
    motions_ = chain_of(scene, body);
  }

  CoveredCells run() {
    follow(
        motions_, scene_.start, scene_.end,
        [&](const PieceChain& chain, double from, double to) { window(chain, from, to, 0); },
        [&](const PieceChain& before, const PieceChain& after, double t) { join(before, after, t); });
    return {options_.resolution, options_.origin, raster_.sorted()};
  }

 private:
  /// A pose with a bound of what a point of the body may be away from it.
  struct PoseInCells {
    double ox, oy, c, s, away;
  };

  static double most(const Ball<double>& b) { return b.magnitude(); }

  PoseInCells pose_at_instant(const PieceChain& chain, double t) const {
    const Pose<double> at = pose_of<Jet<double>>(chain, Ball<double>::exact(t));
    const double off = at.ox.v.rad + at.oy.v.rad + (at.xx.v.rad + at.xy.v.rad) * reach_;
    return {at.ox.v.mid, at.oy.v.mid, at.xx.v.mid, at.xy.v.mid, off};
  }
  /// How far a point may get from where it is in the middle: by the speed, or by the range of the pose itself.
  double way_in(const PieceChain& chain, const PoseInCells& middle, double from, double to) const {
    const double half = (to - from) / 2 * (1 + 0x1p-50);
    const Pose<double> over = pose_of<Jet<double>>(chain, Ball<double>::between(from, to));
    const auto change = [half](const Jet<double>& f, double at) {
      const double by_speed = most(f.d) * half, by_range = std::fabs(f.v.mid - at) + f.v.rad;
      return by_speed <= by_range ? by_speed : by_range;
    };
    const double rotation = change(over.xx, middle.c) + change(over.xy, middle.s);
    return change(over.ox, middle.ox) + change(over.oy, middle.oy) + rotation * reach_;
  }

  void window(const PieceChain& chain, double from, double to, int depth) {
    checkpoint();
    const double middle = from + (to - from) / 2;
    const PoseInCells pose = pose_at_instant(chain, middle);
    const double away = way_in(chain, pose, from, to) + pose.away;
    if (away <= 0.9 * cell_excess * options_.resolution) return add(pose, away);
    if (!(from < middle && middle < to) || depth == deepest_halving_of_time) too_fine(middle);
    window(chain, from, middle, depth + 1);
    window(chain, middle, to, depth + 1);
  }
  /// Where two pieces join up to rounding, all points go straight from the one place to the other.
  void join(const PieceChain& before, const PieceChain& after, double t) {
    const PoseInCells a = pose_at_instant(before, t), b = pose_at_instant(after, t);
    const double rotation = std::fabs(b.c - a.c) + std::fabs(b.s - a.s);
    const double gap = std::fabs(b.ox - a.ox) + std::fabs(b.oy - a.oy) + rotation * reach_ + a.away + b.away;
    if (!(gap <= 0.9 * cell_excess * options_.resolution)) too_fine(t);
    add(a, gap);
  }

  void add(const PoseInCells& pose, double away) {
    const double size = std::fabs(pose.ox) + std::fabs(pose.oy) + 2 * reach_ + std::fabs(options_.origin.x) +
                        std::fabs(options_.origin.y);
    // Every coordinate in cells comes of less than ten operations, and what follows in cells has as many.
    const double slack = 0x1p-46 * (size / options_.resolution + 2);
    const double margin = away / options_.resolution * (1 + 0x1p-40);
    if (!(margin + 2 * slack <= cell_excess)) too_fine(scene_.start);
    std::vector<std::vector<Polygon>> placed;
    for (const Part& part : parts_) {
      placed.emplace_back();
      placed.back().push_back(in_cells(part.outline, pose));
      for (const Polygon& hole : part.holes) placed.back().push_back(in_cells(hole, pose));
    }
    raster_.add(placed, margin + slack, slack);
  }
  Polygon in_cells(const Polygon& ring, const PoseInCells& p) const {
    Polygon out;
    for (const Point& v : ring) {
      const double x = p.ox + (p.c * v.x - p.s * v.y), y = p.oy + (p.s * v.x + p.c * v.y);
      out.push_back({(x - options_.origin.x) / options_.resolution, (y - options_.origin.y) / options_.resolution});
    }
    return out;
  }

  [[noreturn]] void too_fine(double t) const {
    throw InputError("cells",
                     "doubles do not decide where the body is to a sixteenth of a cell, near t = " + std::to_string(t),
                     "choose larger cells, or coordinates nearer to the origin");
  }

  const Scene& scene_;
  const CellOptions& options_;
  std::vector<Part> parts_;
  double reach_ = 0;
  MotionChain motions_;
  CellRaster raster_;
};

}  // namespace

CoveredCells cells(const Scene& scene, BodyId body, const CellOptions& options) {
  if (!(options.resolution > 0) || !std::isfinite(options.resolution))
    throw InputError("cells", "the resolution is not a positive number", "give the side of a cell");
  if (!std::isfinite(options.origin.x) || !std::isfinite(options.origin.y))
    throw InputError("cells", "the origin is not finite", "give the corner of cell (0, 0)");
  if (body < 0 || static_cast<std::size_t>(body) >= scene.bodies.size())
    throw InputError("cells", "there is no body " + std::to_string(body), "the first one is 0");
  validate_polygons(scene);
  try {
    const Budget scope(options.limits);
    return CellSweep(scene, scene.bodies[static_cast<std::size_t>(body)], options).run();
  } catch (const Interrupted& stopped) {
    throw UndecidedError(stopped.reason);
  }
}

}  // namespace taut
