#include "tiling/root_faces.hpp"

#include <algorithm>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "scene/placement.hpp"
#include "tiling/geodesic_faces.hpp"

namespace taut::internal {

const char* to_string(RootState state) {
  switch (state) {
    case RootState::disjoint:
      return "disjoint";
    case RootState::bridged:
      return "bridged";
    case RootState::mouth:
      return "mouth";
    default:
      return "pinched";
  }
}

namespace {

constexpr std::size_t npos = static_cast<std::size_t>(-1);

/// An index of a cycle of n that has gone around once at most.
std::size_t wrapped(std::size_t i, std::size_t n) { return i < n ? i : i - n; }

class RootBuilder {
 public:
  RootBuilder(const Placement& placement, const std::vector<HalfedgeId>& hull_p, const std::vector<HalfedgeId>& hull_q,
              PlanarMap& map)
      : place_(placement), map_(map), edges_p_(hull_p), edges_q_(hull_q) {
    p_.reserve(hull_p.size());
    q_.reserve(hull_q.size());
    for (const HalfedgeId h : hull_p) p_.push_back(map.origin(h));
    for (const HalfedgeId h : hull_q) q_.push_back(map.origin(h));
  }

  RootState run(bool apart) {
    outside_known_ = apart;
    if (apart) return disjoint();
    place_in_q_.reset(place_.size());
    for (std::size_t j = 0; j < q_.size(); ++j) place_in_q_.touch(q_[j].value) = static_cast<std::uint32_t>(j + 1);
    const bool contact = std::any_of(p_.begin(), p_.end(), [this](VertexId v) { return on_q(v); });
    if (!contact) return disjoint();
    find_contact();
    merge_contact();
    if (pinched()) return RootState::pinched;
    return bridge();
  }

 private:
  bool on_q(VertexId v) const { return place_in_q_.get(v.value) != 0; }
  std::size_t position_in_q(VertexId v) const { return place_in_q_.get(v.value) - 1; }
  int turn(VertexId a, VertexId b, VertexId c) const {
    return (a == b || b == c || c == a) ? 0 : place_.orientation(a, b, c);
  }

  // ----- hulls apart -----

  /// A convex cycle seen from a vertex outside it. `towards` is +1 if the line runs from the vertex to the cycle, -1 if
  /// it runs from the cycle to the vertex.
  struct View {
    const std::vector<VertexId>& cycle;
    int side;  ///< of the line, where the cycle is to lie
    int towards;
  };
  bool on_side(const View& view, VertexId from, std::size_t i, std::size_t other) const {
    const VertexId v = view.cycle[i], w = view.cycle[other];
    return (view.towards > 0 ? turn(from, v, w) : turn(v, from, w)) == view.side;
  }
  static std::size_t after(const View& view, std::size_t i) { return i + 1 == view.cycle.size() ? 0 : i + 1; }
  static std::size_t before(const View& view, std::size_t i) { return (i == 0 ? view.cycle.size() : i) - 1; }
  /// Moves i to the vertex where the line through `from` touches the cycle; false if it is there already.
  bool walk_to_tangent(const View& view, VertexId from, std::size_t& i) const {
    for (std::size_t steps = 0; steps < 4 * view.cycle.size(); ++steps) {
      checkpoint();
      if (!on_side(view, from, i, after(view, i))) {
        i = after(view, i);
      } else if (!on_side(view, from, i, before(view, i))) {
        i = before(view, i);
      } else {
        return steps > 0;
      }
    }
    throw StructureError("no tangent from a vertex to the other hull");
  }
  /// The one line from a vertex of P's hull to one of Q's that leaves P on its right and Q on side `side_q`: each of
  /// its ends in turn moves to where the line through the other touches, until neither moves.
  void common_tangent(int side_q, std::size_t& i, std::size_t& j) const {
    const View p{p_, -1, -1}, q{q_, side_q, 1};
    for (std::size_t rounds = 0; rounds < p_.size() + q_.size(); ++rounds) {
      walk_to_tangent(q, p_[i], j);
      if (!walk_to_tangent(p, q_[j], i)) return;
    }
    // To be safe: from each vertex of P.
    for (i = 0; i < p_.size(); ++i) {
      walk_to_tangent(q, p_[i], j);
      if (on_side(p, q_[j], i, after(p, i)) && on_side(p, q_[j], i, before(p, i))) return;
    }
    throw StructureError("no common tangent of two disjoint hulls");
  }

  /// P lies on the infinite face's side of e_i, and Q on PT's side of both edges: where both edges end at one vertex,
  /// P's hull is all around the infinite face, and Q's all around PT.
  RootState disjoint() {
    std::size_t y = 0, q = 0;
    common_tangent(-1, y, q);  // e_o: both hulls on its right
    std::size_t z = y, x = q;
    common_tangent(1, z, x);  // e_i: P on its right, Q on its left
    const HalfedgeId outer = map_.add_edge(p_[y], q_[q]), inner = map_.add_edge(p_[z], q_[x]);
    start_cycle(node::infinite_face);
    append(outer);
    append_outside(edges_q_, q, x);
    append(PlanarMap::twin(inner));
    append_outside(edges_p_, z, y, true);
    close_cycle();
    start_cycle(node::root);
    append(PlanarMap::twin(outer));
    append_clockwise(edges_p_, y, z);
    append(inner);
    append_clockwise(edges_q_, x, q, true);
    close_cycle();
    return RootState::disjoint;
  }

  // ----- hulls in contact -----

  bool shared_edge(std::size_t i) const {
    const VertexId u = p_[i], v = p_[wrapped(i + 1, p_.size())];
    return on_q(u) && on_q(v) && wrapped(position_in_q(v) + 1, q_.size()) == position_in_q(u);
  }

  /// RCH(P) leaves the contact at index exit_ (vertex z_b), where both chains begin.
  void find_contact() {
    std::size_t exits = 0;
    for (std::size_t i = 0; i < p_.size(); ++i) {
      if (on_q(p_[i]) && !shared_edge(i)) {
        exit_ = i;
        ++exits;
      }
    }
    if (exits != 1) throw StructureError("the contact of the two relative hulls is not one path");
    const std::size_t n = p_.size(), m = q_.size();
    a_.push_back(p_[exit_]);
    do {
      a_.push_back(p_[wrapped(exit_ + a_.size(), n)]);
    } while (!on_q(a_.back()));
    exit_q_ = position_in_q(a_.front());
    // Along Q from z_b clockwise to z_a.
    const std::size_t entry_q = position_in_q(a_.back());
    std::size_t j = exit_q_;
    b_.push_back(q_[j]);
    do {
      j = wrapped(j + m - 1, m);
      b_.push_back(q_[j]);
    } while (j != entry_q);
  }

  HalfedgeId edge_a(std::size_t k) const { return edges_p_[wrapped(exit_ + k, p_.size())]; }  ///< a_[k] -> a_[k+1]
  HalfedgeId edge_b(std::size_t k) const {                                                    ///< b_[k+1] -> b_[k]
    return edges_q_[wrapped(exit_q_ + q_.size() - 1 - k, q_.size())];
  }

  void merge_contact() {
    for (std::size_t i = 0; i < p_.size(); ++i) {
      if (!shared_edge(i)) continue;
      const std::size_t j = position_in_q(p_[wrapped(i + 1, p_.size())]);
      map_.merge(edges_p_[i], edges_q_[j]);
    }
  }

  /// Looks for the two strands of A touching; links the faces if they do.
  bool pinched() {
    BlockArray<std::uint32_t> seen(place_.size());  ///< by vertex: where it was seen first, or 0
    std::size_t outer_first = npos, outer_second = npos, inner_first = npos, inner_second = npos;
    for (std::size_t k = 1; k + 1 < a_.size(); ++k) {
      std::uint32_t& first = seen.touch(a_[k].value);
      if (first == 0) {
        first = static_cast<std::uint32_t>(k);
        continue;
      }
      if (inner_first == npos || first < inner_first) inner_first = first, inner_second = k;
      if (outer_first == npos || first > outer_first) outer_first = first, outer_second = k;
    }
    if (inner_first == npos) return false;
    if (outer_first - inner_first != inner_second - outer_second) throw StructureError("strands part between touches");
    for (std::size_t k = 0; inner_first + k < outer_first; ++k) {
      const HalfedgeId h = map_.merge(edge_a(inner_first + k), edge_a(inner_second - 1 - k));
      map_.set_pinch(h, true);
    }
    start_cycle(node::infinite_face);
    append_a_backwards(outer_first, outer_second);
    close_cycle();
    start_cycle(node::root);
    append_a_backwards(0, inner_first);
    append_b(0, b_.size() - 1);
    append_a_backwards(inner_second, a_.size() - 1);
    close_cycle();
    return true;
  }

  RootState bridge() {
    const Bridge e = find_bridge(place_, chains_);
    switch (e.end) {
      case BridgeEnd::on_b:
        return close_bridge_b(e.from, e.to);
      case BridgeEnd::at_z_a:
        return close_bridge_end(e.from);
      default:
        return close_mouth(e.from, e.to);
    }
  }

  RootState close_bridge_b(std::size_t i, std::size_t j) {
    const HalfedgeId e = map_.add_edge(a_[i], b_[j]);
    start_cycle(node::infinite_face);
    append(e);
    append_b(j, b_.size() - 1);
    append_a_backwards(i, a_.size() - 1);
    close_cycle();
    start_cycle(node::root);
    append(PlanarMap::twin(e));
    append_a_backwards(0, i);
    append_b(0, j);
    close_cycle();
    return RootState::bridged;
  }
  RootState close_bridge_end(std::size_t i) {
    const HalfedgeId e = map_.add_edge(a_[i], a_.back());
    start_cycle(node::infinite_face);
    append(e);
    append_a_backwards(i, a_.size() - 1);
    close_cycle();
    start_cycle(node::root);
    append(PlanarMap::twin(e));
    append_a_backwards(0, i);
    append_b(0, b_.size() - 1);
    close_cycle();
    return RootState::bridged;
  }
  RootState close_mouth(std::size_t i, std::size_t l) {
    const HalfedgeId e = map_.add_edge(a_[i], a_[l]);
    start_cycle(node::infinite_face);
    append(e);
    append_a_backwards(i, l);
    close_cycle();
    start_cycle(node::root);
    append(PlanarMap::twin(e));
    append_a_backwards(0, i);
    append_b(0, b_.size() - 1);
    append_a_backwards(l, a_.size() - 1);
    close_cycle();
    return RootState::mouth;
  }

  // ----- linking faces -----

  void start_cycle(ChainNode n) {
    label_ = n;
    first_ = last_ = HalfedgeId();
  }
  /// Writes only what is not there yet: most of the infinite face may be that of a body's own map.
  void append(HalfedgeId h) {
    const PlanarMap::Halfedge now = map_.record(h);
    if (now.node != label_) map_.set_node(h, label_);
    if (!last_.valid()) {
      first_ = h;
    } else if (next_of_last_ != h || now.previous != last_) {
      map_.link(last_, h);
    }
    last_ = h;
    next_of_last_ = now.next;
  }
  void close_cycle() {
    if (next_of_last_ != first_ || map_.previous(first_) != last_) map_.link(last_, first_);
  }
  /// Along the outside of a hull, from index `from` clockwise to index `to`; if they are the same, once around or not
  /// at all.
  void append_clockwise(const std::vector<HalfedgeId>& edges, std::size_t from, std::size_t to, bool around = false) {
    const std::size_t n = edges.size();
    if (from == to && !around) return;
    std::size_t k = from;
    do {
      k = wrapped(k + n - 1, n);
      append(PlanarMap::twin(edges[k]));
    } while (k != to);
  }
  /// The same for the infinite face; where the map has it around both bodies already, only its ends are new.
  void append_outside(const std::vector<HalfedgeId>& edges, std::size_t from, std::size_t to, bool around = false) {
    if (!outside_known_) return append_clockwise(edges, from, to, around);
    if (from == to && !around) return;
    append(PlanarMap::twin(edges[(from == 0 ? edges.size() : from) - 1]));
    last_ = PlanarMap::twin(edges[to]);
    next_of_last_ = map_.next(last_);
  }
  /// From a_[to] back to a_[from].
  void append_a_backwards(std::size_t from, std::size_t to) {
    for (std::size_t k = to; k > from; --k) append(PlanarMap::twin(edge_a(k - 1)));
  }
  /// From b_[from] clockwise to b_[to].
  void append_b(std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) append(PlanarMap::twin(edge_b(k)));
  }

  const Placement& place_;
  PlanarMap& map_;
  const std::vector<HalfedgeId>&edges_p_, &edges_q_;
  std::vector<VertexId> p_, q_;           ///< RCH(P), RCH(Q): p_[i] is the origin of edges_p_[i]
  BlockArray<std::uint32_t> place_in_q_;  ///< by vertex: its position in q_ plus 1, or 0
  bool outside_known_ = false;
  std::size_t exit_ = 0, exit_q_ = 0;
  FreeChains chains_;
  std::vector<VertexId>&a_ = chains_.a, &b_ = chains_.b;
  ChainNode label_;
  HalfedgeId first_, last_;
  HalfedgeId next_of_last_;  ///< as the map has it
};

}  // namespace

RootState add_root_faces(const Placement& placement, const std::vector<HalfedgeId>& hull_p,
                         const std::vector<HalfedgeId>& hull_q, PlanarMap& map, bool apart) {
  return RootBuilder(placement, hull_p, hull_q, map).run(apart);
}

StaticTiling build_tiling(const Placement& placement) {
  StaticTiling result;
  FreeTriangulation triangulation;
  const PairGeometry& g = placement.geometry();
  result.overlap = triangulate_free_space(placement, triangulation);
  if (result.overlap) return result;
  result.map.reset(g.size());
  const ChainTree tree_p(g.np, node::p_tree), tree_q(g.nq, node::q_tree);
  add_polygon_edges(tree_p, 0, result.map);
  add_polygon_edges(tree_q, g.np, result.map);
  const auto hull_p = add_geodesic_faces(placement, triangulation, tree_p, 0, result.map);
  const auto hull_q = add_geodesic_faces(placement, triangulation, tree_q, g.np, result.map);
  result.root = add_root_faces(placement, hull_p, hull_q, result.map);
  return result;
}

}  // namespace taut::internal
