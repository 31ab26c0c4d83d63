#include "tiling/free_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "numeric/budget.hpp"
#include "tiling/sweep_status.hpp"

namespace taut::internal {
namespace {

constexpr std::uint32_t none = FreeTriangulation::none;

/// The sweep. Boundary rings have free space on their right: the polygons counterclockwise, the box clockwise. Edges
/// are named by their first vertex along the ring. An edge that runs rightwards has free space below it, an edge that
/// runs leftwards has free space above it and carries the chain of that free interval.
class TriangulationSweep {
 public:
  TriangulationSweep(const Placement& placement, FreeTriangulation& out, bool check_bodies)
      : place_(placement),
        geometry_(placement.geometry()),
        out_(out),
        n_(placement.size()),
        check_bodies_(check_bodies) {}

  std::optional<Overlap> run() {
    const std::uint32_t total = n_ + 4;
    const std::vector<VertexId> order = sorted_vertices(total);
    rank_.resize(total);
    for (std::uint32_t i = 0; i < total; ++i) rank_[order[i].value] = i;
    slot_of_.assign(total, SweepStatus::nil);
    // Few vertices have more than one node, and there are fewer than twice as many diagonals as vertices.
    nodes_.reserve(2 * std::size_t{total});
    link_half_.reserve(3 * std::size_t{total});
    link_half_.assign(total, none);
    status_.reserve(std::min(total, small));
    chains_.reserve(std::min(total, small));
    const std::size_t triangles = static_cast<std::size_t>(total) + 8;
    out_.origin.clear();
    out_.twin.clear();
    out_.origin.reserve(3 * triangles);
    out_.twin.reserve(3 * triangles);
    for (const VertexId v : order) {
      checkpoint(2);
      visit(v);
      if (overlap_) return overlap_;
    }
    out_.boundary.assign(link_half_.begin(), link_half_.begin() + n_);
    return std::nullopt;
  }

 private:
  using Slot = SweepStatus::Slot;
  /// A sweep line that crosses no more edges at once does not grow its buffers.
  static constexpr std::uint32_t small = 64;

  std::vector<VertexId> sorted_vertices(std::uint32_t total) const {
    struct Keyed {
      double key;
      VertexId vertex;
    };
    std::vector<Keyed> keyed(total);
    for (std::uint32_t i = 0; i < total; ++i) keyed[i] = {place_.key(VertexId(i)), VertexId(i)};
    const double error = place_.key_error();
    std::sort(keyed.begin(), keyed.end(), [this, error](const Keyed& a, const Keyed& b) {
      const double d = a.key - b.key;
      if (std::fabs(d) > error) return d < 0;
      checkpoint();
      return place_.before(a.vertex, b.vertex);
    });
    std::vector<VertexId> order(total);
    for (std::uint32_t i = 0; i < total; ++i) order[i] = keyed[i].vertex;
    return order;
  }

  /// A vertex of a waiting chain, linked bottom to top. `link` names the segment to the next one up.
  struct ChainNode {
    VertexId vertex;
    std::uint32_t up = none, down = none;
    std::uint32_t link = none;
  };
  struct Chain {
    std::uint32_t bottom = none, top = none, rightmost = none;
  };

  VertexId ring_next(VertexId v) const {
    if (v.value < n_) return geometry_.next(v);
    return VertexId(n_ + (v.value - n_ + 3) % 4);
  }
  VertexId ring_previous(VertexId v) const {
    if (v.value < n_) return geometry_.previous(v);
    return VertexId(n_ + (v.value - n_ + 1) % 4);
  }
  bool left_of(VertexId a, VertexId b) const { return rank_[a.value] < rank_[b.value]; }
  int owner(std::uint32_t edge) const { return edge < geometry_.np ? 0 : (edge < n_ ? 1 : 2); }

  void visit(VertexId v) {
    const VertexId p = ring_previous(v), q = ring_next(v);
    const bool p_left = left_of(p, v), q_left = left_of(q, v);
    if (p_left && !q_left) {
      regular_top(v, p);
    } else if (!p_left && q_left) {
      regular_bottom(v, p);
    } else {
      const bool convex = place_.orientation(p, v, q) > 0;
      if (!p_left) {
        convex ? split(v, p) : start(v, p);
      } else {
        convex ? merge(v, p) : finish(v, p);
      }
    }
  }

  /// The edge just below v in the sweep status.
  Slot find_below(VertexId v) const {
    return status_.last_below([this, v](std::uint32_t e) {
      const VertexId a(e), b = ring_next(a);
      return left_of(a, b) ? place_.orientation(a, b, v) > 0 : place_.orientation(b, a, v) > 0;
    });
  }
  bool free_above(Slot s) const {
    const VertexId a(status_.edge(s));
    return left_of(ring_next(a), a);
  }

  void report(std::uint32_t e, std::uint32_t f) {
    if (overlap_) return;
    if (owner(f) == 2) f = e;  // a vertex that ought to start inside its own polygon lies outside of it
    overlap_ = owner(e) == 0 ? Overlap{VertexId(e), VertexId(f)} : Overlap{VertexId(f), VertexId(e)};
  }
  /// Edges of different bodies that become neighbours must not cross (nor, if asked for, those of one body).
  void check_neighbours(Slot low, Slot high) {
    if (low == SweepStatus::nil || high == SweepStatus::nil) return;
    const std::uint32_t e = status_.edge(low), f = status_.edge(high);
    const int oe = owner(e), of = owner(f);
    if ((oe == of && !check_bodies_) || oe == 2 || of == 2) return;
    const VertexId a(e), b = ring_next(a), c(f), d = ring_next(c);
    if (a == d || b == c) return;
    if (place_.orientation(a, b, c) == place_.orientation(a, b, d)) return;
    if (place_.orientation(c, d, a) == place_.orientation(c, d, b)) return;
    report(e, f);
  }
  /// Is the vertex, about to start inside the interval above `below`, where its own ring allows it?
  bool consistent_start(VertexId v, Slot below, bool in_free) {
    if (below == SweepStatus::nil) return true;  // the box's first vertex
    const std::uint32_t e = status_.edge(below);
    if (in_free == free_above(below) && (in_free || owner(e) == owner(v.value))) return true;
    report(v.value, e);
    return false;
  }

  Slot insert(Slot below, VertexId edge) {
    const Slot s = status_.insert_above(below, edge.value);
    slot_of_[edge.value] = s;
    if (chains_.size() <= s) chains_.resize(s + 1);
    return s;
  }

  // ----- the six kinds of vertices -----

  /// Both edges start here, free space all around but between them: a polygon enters a free interval.
  void split(VertexId v, VertexId p) {
    const Slot low = find_below(v);
    if (!consistent_start(v, low, true)) return;
    const Chain old = chains_[low];
    const std::uint32_t diagonal = new_link();
    const std::uint32_t r = old.rightmost;
    // Lower interval: bottom .. r, v. Upper interval: v, a copy of r, .. top.
    const std::uint32_t copy = new_node(nodes_[r].vertex), v_low = new_node(v), v_high = new_node(v);
    nodes_[copy].up = nodes_[r].up;
    nodes_[copy].link = nodes_[r].link;
    if (nodes_[copy].up != none) nodes_[nodes_[copy].up].down = copy;
    const std::uint32_t top = old.top == r ? copy : old.top;
    nodes_[r].up = none;
    connect(r, v_low, diagonal);
    connect(v_high, copy, diagonal);
    const Slot lower_edge = insert(low, v);
    const Slot upper_edge = insert(lower_edge, p);
    chains_[low] = {old.bottom, v_low, v_low};
    chains_[upper_edge] = {v_high, top, v_high};
    close_downwards(v_low);
    close_upwards(v_high);
    check_neighbours(low, lower_edge);
    check_neighbours(upper_edge, status_.above(upper_edge));
  }

  /// Both edges start here with free space between them only: a new free interval opens.
  void start(VertexId v, VertexId p) {
    const Slot low = find_below(v);
    if (!consistent_start(v, low, false)) return;
    const Slot lower_edge = insert(low, p);
    const Slot upper_edge = insert(lower_edge, v);
    const std::uint32_t node = new_node(v);
    chains_[lower_edge] = {node, node, node};
    check_neighbours(low, lower_edge);
    check_neighbours(upper_edge, status_.above(upper_edge));
  }

  /// Both edges end here, free space to the right: two free intervals become one.
  void merge(VertexId v, VertexId p) {
    const Slot lower_edge = slot_of_[p.value], upper_edge = slot_of_[v.value];
    const Slot low = status_.below(lower_edge), high = status_.above(upper_edge);
    Chain& a = chains_[low];
    const Chain b = chains_[upper_edge];
    const std::uint32_t node = new_node(v);
    connect(a.top, node, p.value);
    connect(node, b.bottom, v.value);
    a = {a.bottom, b.top, node};
    status_.erase(lower_edge);
    status_.erase(upper_edge);
    close_downwards(node);
    close_upwards(node);
    check_neighbours(low, high);
  }

  /// Both edges end here with free space between them only: the interval closes.
  void finish(VertexId v, VertexId p) {
    const Slot lower_edge = slot_of_[v.value], upper_edge = slot_of_[p.value];
    const Slot low = status_.below(lower_edge), high = status_.above(upper_edge);
    const Chain chain = chains_[lower_edge];
    const std::uint32_t node = new_node(v);
    connect(chain.top, node, p.value);
    // All of the chain sees v; the last triangle ends on the polygon edge from v to the bottom.
    while (nodes_[node].down != chain.bottom) {
      const std::uint32_t y = nodes_[node].down;
      cut(nodes_[y].down, y, node, nodes_[y].down == chain.bottom ? v.value : new_link());
    }
    status_.erase(lower_edge);
    status_.erase(upper_edge);
    check_neighbours(low, high);
  }

  /// The edge p -> v, below which space is free, is followed by v -> next.
  void regular_top(VertexId v, VertexId p) {
    const Slot s = slot_of_[p.value];
    status_.set_edge(s, v.value);
    slot_of_[v.value] = s;
    Chain& chain = chains_[status_.below(s)];
    const std::uint32_t node = new_node(v);
    connect(chain.top, node, p.value);
    chain.top = chain.rightmost = node;
    close_downwards(node);
    check_neighbours(status_.below(s), s);
    check_neighbours(s, status_.above(s));
  }

  /// The edge v -> next, above which space is free, is followed (to the right) by p -> v.
  void regular_bottom(VertexId v, VertexId p) {
    const Slot s = slot_of_[v.value];
    status_.set_edge(s, p.value);
    slot_of_[p.value] = s;
    Chain& chain = chains_[s];
    const std::uint32_t node = new_node(v);
    connect(node, chain.bottom, v.value);
    chain.bottom = chain.rightmost = node;
    close_upwards(node);
    check_neighbours(status_.below(s), s);
    check_neighbours(s, status_.above(s));
  }

  // ----- chains and triangles -----

  std::uint32_t new_node(VertexId v) {
    nodes_.push_back({v});
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  std::uint32_t new_link() {
    link_half_.push_back(none);
    return static_cast<std::uint32_t>(link_half_.size() - 1);
  }
  void connect(std::uint32_t low, std::uint32_t high, std::uint32_t link) {
    nodes_[low].up = high;
    nodes_[low].link = link;
    nodes_[high].down = low;
  }
  bool right_turn(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return place_.orientation(nodes_[x].vertex, nodes_[y].vertex, nodes_[z].vertex) < 0;
  }
  void close_downwards(std::uint32_t top) {
    for (;;) {
      const std::uint32_t y = nodes_[top].down;
      if (y == none || nodes_[y].down == none) return;
      const std::uint32_t x = nodes_[y].down;
      if (!right_turn(x, y, top)) return;
      cut(x, y, top, new_link());
    }
  }
  void close_upwards(std::uint32_t bottom) {
    for (;;) {
      const std::uint32_t y = nodes_[bottom].up;
      if (y == none || nodes_[y].up == none) return;
      const std::uint32_t z = nodes_[y].up;
      if (!right_turn(bottom, y, z)) return;
      cut(bottom, y, z, new_link());
    }
  }
  /// Cuts y off the chain x, y, z by the triangle x, z, y.
  void cut(std::uint32_t x, std::uint32_t y, std::uint32_t z, std::uint32_t link) {
    const auto h = static_cast<std::uint32_t>(out_.origin.size());
    out_.origin.insert(out_.origin.end(), {nodes_[x].vertex, nodes_[z].vertex, nodes_[y].vertex});
    out_.twin.insert(out_.twin.end(), {none, none, none});
    attach(link, h);
    attach(nodes_[y].link, h + 1);
    attach(nodes_[x].link, h + 2);
    connect(x, z, link);
  }
  /// A half-edge on a link: the first one waits for the second, its twin; a boundary edge has only one.
  void attach(std::uint32_t link, std::uint32_t h) {
    const std::uint32_t other = link_half_[link];
    if (other == none) {
      link_half_[link] = h;
    } else {
      out_.twin[h] = other;
      out_.twin[other] = h;
    }
  }

  const Placement& place_;
  const PairGeometry& geometry_;
  FreeTriangulation& out_;
  std::uint32_t n_;
  bool check_bodies_;
  std::vector<std::uint32_t> rank_;
  SweepStatus status_;
  std::vector<Slot> slot_of_;  ///< of an edge
  std::vector<Chain> chains_;  ///< of a slot whose edge has free space above
  std::vector<ChainNode> nodes_;
  std::vector<std::uint32_t> link_half_;  ///< links 0 .. n+3 are the boundary edges
  std::optional<Overlap> overlap_;
};

}  // namespace

std::optional<Overlap> triangulate_free_space(const Placement& placement, FreeTriangulation& result,
                                              bool check_bodies) {
  return TriangulationSweep(placement, result, check_bodies).run();
}

}  // namespace taut::internal
