#include "tiling/link_paths.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "tiling/root_faces.hpp"

namespace taut::internal {
namespace {

/// Follows one sleeve; each time the line of sight ends, its last window starts the next link.
class Follower {
 public:
  Follower(const Arena& arena, Hourglass start, std::vector<DirectedLine> lines)
      : arena_(arena), view_(std::move(start)), lines_(std::move(lines)) {}

  /// The step from gate `a` to gate `b`.
  void pass(Gate a, Gate b) {
    const bool left = new_left_end(arena_, a, b);
    const Point& end = arena_.at(arena_.apex(a));
    const Hourglass::Blocked blocked = left ? view_.add_left(end) : view_.add_right(end);
    if (blocked == Hourglass::Blocked::no) return;
    const DirectedLine line = left ? view_.clockwise() : view_.counterclockwise();
    std::vector<Point> foot = left ? view_.right_from_clockwise() : view_.left_from_counterclockwise();
    Window window = open_window(arena_, line, std::move(foot), a, left);
    lines_.push_back(line);
    view_ = Hourglass(std::move(window.left), std::move(window.right));
  }
  /// Can the side edge of gate a's triangle be seen, that is passed if the next step brings a new left (right) end?
  bool sees_side(Gate a, bool left) const {
    const int side = (left ? view_.counterclockwise() : view_.clockwise()).side(arena_.at(arena_.apex(a)));
    return left ? side <= 0 : side >= 0;
  }
  /// Ends through that edge.
  std::vector<DirectedLine> leave_by_side(Gate a, bool left) {
    const Point& end = arena_.at(arena_.apex(a));
    left ? view_.add_right(end) : view_.add_left(end);
    lines_.push_back(view_.middle());
    return std::move(lines_);
  }
  Hourglass& view() { return view_; }
  std::vector<DirectedLine>& lines() { return lines_; }

 private:
  const Arena& arena_;
  Hourglass view_;
  std::vector<DirectedLine> lines_;
};

std::vector<DirectedLine> follow_open(const Arena& arena, const std::vector<Gate>& head, const std::vector<Gate>& core,
                                      const OpenSleeve::Tail& tail, bool left, std::size_t give_up) {
  Follower f(arena, Hourglass({arena.at(arena.origin(head[0]))}, {arena.at(arena.target(head[0]))}), {});
  Gate at = head[0];
  const auto pass = [&](Gate next) {
    f.pass(at, next);
    at = next;
    return f.lines().size() < give_up;
  };
  for (std::size_t i = 1; i < head.size(); ++i) {
    if (!pass(head[i])) return {};
  }
  for (const Gate g : core) {
    checkpoint();
    if (!pass(g)) return {};
  }
  for (std::size_t k = 0; k < tail.gates.size(); ++k) {
    if (!pass(tail.gates[k])) return {};
    if (tail.exit[k] && f.sees_side(at, left)) return f.leave_by_side(at, left);
  }
  return {};
}

/// The line through an edge u -> v of the closed geodesic of a loop, drawn out to windows on both its ends.
struct StartLine {
  DirectedLine line;
  std::size_t anchor = 0;  ///< a gate that it crosses
  Window forward;          ///< beyond v
  Window backward;         ///< before u, seen from there, along the reversed gates
};

class Loop {
 public:
  Loop(const Arena& arena, int owner) : arena_(arena), owner_(owner), gates_(loop_gates(arena, owner)) {
    back_ = reversed(arena, gates_);
  }
  bool empty() const { return gates_.empty(); }

  std::optional<StartLine> draw_out(VertexId u, VertexId v) const {
    const VertexId own = arena_.owner(u) == owner_ ? u : v;
    const DirectedLine line{arena_.at(u), arena_.at(v)};
    // An edge that leaves the polygon at `own`, to the other side of the line than the polygon.
    std::size_t anchor = 0;
    while (anchor < gates_.size() && !(arena_.origin(gates_[anchor]) == own && line.side(right_end(anchor)) <= 0))
      ++anchor;
    if (anchor == gates_.size()) return std::nullopt;
    StartLine start;
    start.line = line;
    start.anchor = anchor;
    start.forward = extend(gates_, anchor, line, v);
    start.backward = extend(back_, gates_.size() - 1 - anchor, {line.to, line.from}, u);
    return start;
  }

  /// From the forward window around to the backward one: the lines of all links, the start line first.
  std::vector<DirectedLine> go_round(const StartLine& start, std::size_t give_up) const {
    const std::size_t m = gates_.size();
    // The first gate that the line crosses, counted from the anchor backwards, and one turn later; the gate before it
    // is the last one that a link has to pass.
    const std::size_t crossed = start.anchor + m - (start.backward.last - (m - 1 - start.anchor));
    const std::size_t target = crossed - 1;
    Follower f(arena_, Hourglass(start.forward.left, start.forward.right), {start.line});
    for (std::size_t k = start.forward.last + 1; k < target; ++k) {
      checkpoint();
      f.pass(gates_[k % m], gates_[(k + 1) % m]);
      if (f.lines().size() > give_up) return {};
    }
    // Seen from the other end, left is right.
    std::vector<Point> left(start.backward.right.rbegin(), start.backward.right.rend());
    std::vector<Point> right(start.backward.left.rbegin(), start.backward.left.rend());
    Hourglass before = f.view();
    if (f.view().finish(left, right)) {
      f.lines().push_back(f.view().middle());
      return std::move(f.lines());
    }
    // One link ends in front of the start line's gate, and from there all of it can be seen.
    const DirectedLine into = before.middle();
    f.lines().push_back(into);
    f.lines().push_back(last_link(into, start, gates_[target % m]));
    return std::move(f.lines());
  }

 private:
  const Point& right_end(std::size_t i) const { return arena_.at(arena_.target(gates_[i])); }

  static Point meet(const DirectedLine& line, const Point& a, const Point& b) {
    const double ux = line.to.x - line.from.x, uy = line.to.y - line.from.y;
    const double sa = ux * (a.y - line.from.y) - uy * (a.x - line.from.x);
    const double sb = ux * (b.y - line.from.y) - uy * (b.x - line.from.x);
    const double share = sa == sb ? 0.5 : std::clamp(sa / (sa - sb), 0.0, 1.0);
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  }

  /// From where `into` passes gate g to the part of the start line in the triangle behind it.
  DirectedLine last_link(const DirectedLine& into, const StartLine& start, Gate g) const {
    const Point l = arena_.at(arena_.origin(g)), r = arena_.at(arena_.target(g)), x = arena_.at(arena_.apex(g));
    const Point from = meet(into, l, r);
    const bool crosses_left = (start.line.side(l) > 0) != (start.line.side(x) > 0);
    const bool crosses_right = (start.line.side(r) > 0) != (start.line.side(x) > 0);
    const Point a = crosses_left ? meet(start.line, l, x) : l, b = crosses_right ? meet(start.line, r, x) : r;
    return {from, {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}};
  }

  /// The window of `line` beyond `foot`, along the gates from `anchor` on.
  Window extend(const std::vector<Gate>& gates, std::size_t anchor, const DirectedLine& line, VertexId foot) const {
    std::vector<VertexId> left{arena_.origin(gates[anchor])}, right{arena_.target(gates[anchor])};
    for (std::size_t k = anchor;; ++k) {
      checkpoint();
      if (k > anchor + 2 * gates.size()) throw StructureError("a common tangent never leaves the loop");
      const Gate g = gates[k % gates.size()];
      const bool new_left = new_left_end(arena_, g, gates[(k + 1) % gates.size()]);
      const VertexId end = arena_.apex(g);
      const int side = line.side(arena_.at(end));
      if (new_left ? side >= 0 : side <= 0) {
        (new_left ? left : right).push_back(end);
        continue;
      }
      const std::vector<VertexId>& all = new_left ? right : left;
      const auto at = std::find(all.rbegin(), all.rend(), foot);
      // The end of the string that the line touches last; a degenerate tangent may touch several.
      std::vector<Point> from_foot{arena_.at(foot)};
      if (at != all.rend()) {
        for (auto i = at.base(); i != all.end(); ++i) from_foot.push_back(arena_.at(*i));
      } else {
        from_foot.push_back(arena_.at(all.back()));
      }
      Window window = open_window(arena_, line, std::move(from_foot), g, new_left);
      window.last = k;
      return window;
    }
  }

  const Arena& arena_;
  int owner_;
  std::vector<Gate> gates_, back_;
};

constexpr std::size_t never_give_up = static_cast<std::size_t>(-1);
/// Start lines tried where no edge of the geodesic is sure to be part of a shortest separator.
constexpr std::size_t tries = 12;

}  // namespace

LinkBound open_link_bound(const Arena& arena) {
  const OpenSleeve sleeve = open_sleeve(arena);
  LinkBound best;
  std::size_t fewest = never_give_up;
  for (const std::vector<Gate>& head : sleeve.heads) {
    for (std::size_t k = 0; k < sleeve.tails.size(); ++k) {
      std::vector<DirectedLine> lines = follow_open(arena, head, sleeve.core, sleeve.tails[k], k == 0, fewest);
      if (lines.empty() || lines.size() >= fewest) continue;
      fewest = lines.size();
      best.path.lines = std::move(lines);
    }
  }
  if (fewest == never_give_up) throw StructureError("no separator from infinity to infinity");
  best.lower = static_cast<int>(fewest);
  return best;
}

LinkBound closed_link_bound(const Arena& arena, int owner) {
  LinkBound bound;
  const Loop loop(arena, owner);
  if (loop.empty()) return bound;
  const std::vector<VertexId>& hull = arena.hulls[static_cast<std::size_t>(owner)];
  const std::size_t n = hull.size();
  const auto take = [&](std::size_t i, bool certain) {
    const std::optional<StartLine> start = loop.draw_out(hull[i], hull[(i + 1) % n]);
    if (!start) return false;
    std::vector<DirectedLine> lines = loop.go_round(*start, never_give_up);
    const int count = static_cast<int>(lines.size());
    bound.lower = std::max({bound.lower, certain ? count : count - 1, 3});
    if (bound.path.lines.empty() || lines.size() < bound.path.lines.size()) bound.path = {std::move(lines), true};
    return true;
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (arena.owner(hull[i]) != arena.owner(hull[(i + 1) % n]) && take(i, true)) return bound;
  }
  for (std::size_t k = 0; k < std::min(n, tries); ++k) take(k * n / std::min(n, tries), false);
  return bound;
}

LinkBound link_bound(const Arena& arena) {
  LinkBound best = open_link_bound(arena);
  // A closed curve has at least three edges.
  if (best.lower <= 3) return best;
  for (const int owner : {0, 1}) {
    LinkBound closed = closed_link_bound(arena, owner);
    if (closed.path.lines.empty()) continue;
    best.lower = std::min(best.lower, closed.lower);
    if (closed.path.lines.size() < best.path.lines.size()) best.path = std::move(closed.path);
  }
  return best;
}

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
