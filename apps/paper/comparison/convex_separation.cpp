#include "comparison/convex_separation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "taut/error.hpp"

namespace taut::paper {
namespace {

Polygon counterclockwise(Polygon ring) {
  double twice = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  if (twice < 0) std::reverse(ring.begin(), ring.end());
  return ring;
}

/// All hulls as bodies that move as their own body does: first those of one, then those of the other.
Scene scene_of_hulls(const Scene& scene, const std::array<std::vector<HierarchyLevel>, 2>& hulls) {
  Scene out = scene;
  out.bodies.clear();
  for (std::size_t body = 0; body < 2; ++body)
    for (const HierarchyLevel& level : hulls[body])
      out.bodies.push_back({"hull", level.ring, scene.bodies[body].motion});
  return out;
}

/// Whether a step from p to q leads to the left of a directed line: as Cross counts it, so that what a search found
/// does not fail at once.
bool leads_left(const Point& from, const Point& to, const Point& p, const Point& q) {
  return (to.x - from.x) * (q.y - p.y) - (to.y - from.y) * (q.x - p.x) > 0;
}

/// How far a point is to the right of a directed line.
double beyond(const Point& from, const Point& to, const Point& p) {
  const double x = to.x - from.x, y = to.y - from.y;
  return ((p.x - from.x) * y - (p.y - from.y) * x) / std::hypot(x, y);
}

}  // namespace

ConvexSeparation::ConvexSeparation(const Scene& scene)
    : hulls_{outer_hierarchy(counterclockwise(scene.bodies[0].polygon)),
             outer_hierarchy(counterclockwise(scene.bodies[1].polygon))},
      bodies_(scene_of_hulls(scene, hulls_)),
      time_(scene.start),
      end_(scene.end),
      levels_(static_cast<int>(std::max(hulls_[0].size(), hulls_[1].size()))) {
  search();
}

const HierarchyLevel& ConvexSeparation::hull(int body, int level) const {
  const auto& all = hulls_[static_cast<std::size_t>(body)];
  return all[std::min(static_cast<std::size_t>(level), all.size() - 1)];
}

int ConvexSeparation::hull_body(int body, int level) const {
  const auto& all = hulls_[static_cast<std::size_t>(body)];
  const int first = body == 0 ? 0 : static_cast<int>(hulls_[0].size());
  return first + std::min(level, static_cast<int>(all.size()) - 1);
}

/// The line of the coarsest hulls that are farther apart than they are coarse, or else of the finest.
void ConvexSeparation::search() {
  const std::vector<Point> at = bodies_.positions(time_);
  for (int level = 0; level < levels_; ++level) {
    line_ = best_line(level, at);
    const double coarse = std::max(hull(0, level).excess, hull(1, level).excess);
    if (line_.gap > (level + 1 < levels_ ? coarse : 0)) return schedule();
  }
  throw StructureError(fmt::format("two convex bodies are not separated at {}", time_));
}

ConvexSeparation::Line ConvexSeparation::best_line(int level, const std::vector<Point>& at) const {
  const Line one = best_line_of(0, level, at), other = best_line_of(1, level, at);
  return one.gap >= other.gap ? one : other;
}

/// Of the sides of the owner's hull, that from which the other hull is farthest. Both are run through once: the nearest
/// vertex moves on with the side.
ConvexSeparation::Line ConvexSeparation::best_line_of(int owner, int level, const std::vector<Point>& at) const {
  const HierarchyLevel& mine = hull(owner, level);
  const int finest = bodies_.first(hull_body(owner, levels_ - 1));
  const int count = static_cast<int>(hulls_[static_cast<std::size_t>(owner)].back().ring.size());
  const int other = hull_body(1 - owner, level), start = bodies_.first(other);
  const auto place = [&](int v) { return at[static_cast<std::size_t>(v)]; };
  Line best;
  best.gap = -INFINITY;
  int nearest = -1;
  for (const int side : mine.side) {
    const int from = finest + side, to = finest + (side + 1) % count;
    const auto distance = [&](int v) { return beyond(place(from), place(to), place(v)); };
    if (nearest < 0) {
      nearest = start;
      for (int v = start; v < bodies_.first(other + 1); ++v, ++looked_at_)
        if (distance(v) < distance(nearest)) nearest = v;
    }
    for (int next = bodies_.next(nearest); leads_left(place(from), place(to), place(nearest), place(next));
         ++looked_at_) {
      nearest = next;
      next = bodies_.next(nearest);
    }
    ++looked_at_;
    if (distance(nearest) > best.gap) best = {owner, level, from, to, nearest, distance(nearest)};
  }
  return best;
}

void ConvexSeparation::schedule() {
  const int b = line_.vertex;
  const Cross tests[] = {{line_.from, line_.to, line_.from, b},
                         {line_.from, line_.to, b, bodies_.next(b)},
                         {line_.from, line_.to, b, bodies_.previous(b)}};
  next_ = std::numeric_limits<double>::infinity();
  // All points right of the line: their cross products are negative. Pieces of motions are gone through one by one.
  const int one = bodies_.body_of(line_.from), other = bodies_.body_of(b);
  for (double t = time_; t < end_ && !std::isfinite(next_);) {
    const double until = std::min({end_, bodies_.piece_end(one, t), bodies_.piece_end(other, t)});
    for (const Cross& test : tests) next_ = std::min(next_, failure_time(bodies_, test, -1, t, until));
    t = until;
  }
}

bool ConvexSeparation::step() {
  if (!std::isfinite(next_)) return false;
  time_ = next_;
  ++events_;
  search();
  return true;
}

std::array<Point, 2> ConvexSeparation::line(double t) const {
  return {bodies_.at(line_.from, t).position, bodies_.at(line_.to, t).position};
}

}  // namespace taut::paper
