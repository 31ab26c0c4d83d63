#include "tiling/separator_window.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/errors.hpp"
#include "tiling/root_faces.hpp"

namespace taut::internal {
namespace {

/// Where the line leaves the free space: the left and the right end of the edge it hits, and the ends on the side
/// ahead of all edges that it crosses before.
struct Exit {
  Point left, right;
  std::vector<Point> ahead;
};

Exit follow(const Arena& arena, const DirectedLine& line, std::uint32_t edge, bool ahead_is_right) {
  Exit exit;
  for (std::size_t steps = 0; steps <= arena.triangulation.origin.size(); ++steps) {
    // Crossed from inside, an edge has its right end as origin.
    const VertexId right = arena.origin(edge), left = arena.target(edge);
    exit.ahead.push_back(arena.at(ahead_is_right ? right : left));
    const std::uint32_t behind = arena.twin(edge);
    if (behind == FreeTriangulation::none) {
      exit.left = arena.at(left);
      exit.right = arena.at(right);
      return exit;
    }
    edge = line.side(arena.at(arena.apex(behind))) > 0 ? FreeTriangulation::next(behind)
                                                       : FreeTriangulation::previous(behind);
  }
  throw StructureError("a line of sight goes round in circles");
}

/// A point on the line or ahead of it, and on the edge left-right or beyond it, such that the segment from the foot
/// passes through the edge.
Point head_of(const DirectedLine& line, const Point& foot, const Point& left, const Point& right, bool ahead_is_right) {
  const auto offset = [&](const Point& p) {
    return (line.to.x - line.from.x) * (p.y - line.from.y) - (line.to.y - line.from.y) * (p.x - line.from.x);
  };
  const double at_left = offset(left), at_right = offset(right);
  const double share = at_left == at_right ? 0.5 : std::clamp(at_left / (at_left - at_right), 0.0, 1.0);
  const double ex = right.x - left.x, ey = right.y - left.y, length = std::sqrt(ex * ex + ey * ey);
  const Point middle{left.x + share * ex, left.y + share * ey};
  const Point& corner = ahead_is_right ? right : left;
  const double forward = ahead_is_right ? 1 : -1;
  const double size = std::fabs(middle.x) + std::fabs(middle.y) + std::fabs(ex) + std::fabs(ey);
  const double fx = forward * ex / length, fy = forward * ey / length, ox = -ey / length, oy = ex / length;
  // Beyond the edge by rounding errors only, for that may lead back over the line; then along the edge.
  const double beyond = 0x1p-51 * size;
  for (double nudge = 0; nudge < length; nudge = nudge == 0 ? 0x1p-54 * size : 2 * nudge) {
    const Point head{tidy(middle.x + nudge * fx + beyond * ox), tidy(middle.y + nudge * fy + beyond * oy)};
    const bool ahead = ahead_is_right ? line.side(head) <= 0 : line.side(head) >= 0;
    const bool through = ahead_is_right ? orientation(foot, head, right) <= 0 : orientation(foot, head, left) >= 0;
    if (ahead && through && orientation(left, right, head) >= 0) return head;
  }
  return corner;
}

}  // namespace

Window open_window(const Arena& arena, const DirectedLine& line, std::vector<Point> foot_side, Gate g,
                   bool blocked_by_left) {
  Window window;
  window.line = line;
  const Exit exit = follow(arena, line, side_edge(g, blocked_by_left), blocked_by_left);
  std::vector<Point> head_side{head_of(line, foot_side.front(), exit.left, exit.right, blocked_by_left)};
  head_side.insert(head_side.end(), exit.ahead.rbegin(), exit.ahead.rend());
  window.left = blocked_by_left ? std::move(head_side) : std::move(foot_side);
  window.right = blocked_by_left ? std::move(foot_side) : std::move(head_side);
  return window;
}

}  // namespace taut::internal
