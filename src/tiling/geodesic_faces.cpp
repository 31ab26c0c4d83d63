#include "tiling/geodesic_faces.hpp"

#include <algorithm>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// The funnel algorithm (Lee and Preparata, Chazelle) with reusable storage.
class Funnel {
 public:
  /// Room for `room` vertices on each side from the outset.
  Funnel(const Placement& placement, const FreeTriangulation& t, std::size_t room)
      : place_(placement), triangulation_(t) {
    left_.v.reserve(room);
    right_.v.reserve(room);
  }

  /// The shortest path from a to b through the diagonals; `path` gets all its vertices.
  void run(VertexId a, VertexId b, const std::uint32_t* first, const std::uint32_t* last, std::vector<VertexId>& path) {
    path.assign(1, a);
    left_.start(a);
    right_.start(a);
    for (const std::uint32_t* d = first; d != last; ++d) {
      if ((d - first) % 2 == 0) checkpoint();  // half a unit each
      add(left_, right_, triangulation_.origin[*d], 1, path);
      add(right_, left_, triangulation_.target(*d), -1, path);
    }
    add(left_, right_, b, 1, path);
    for (std::size_t i = left_.head + 1; i < left_.v.size(); ++i) path.push_back(left_.v[i]);
  }

 private:
  /// One side of the funnel; v[head] is the apex.
  struct Side {
    std::vector<VertexId> v;
    std::size_t head = 0;
    void start(VertexId a) {
      v.assign(1, a);
      head = 0;
    }
    std::size_t length() const { return v.size() - head; }
  };

  int turn(VertexId a, VertexId b, VertexId c) const {
    if (a == b || b == c || c == a) return 0;
    return place_.orientation(a, b, c);
  }

  void add(Side& side, Side& other, VertexId p, int sign, std::vector<VertexId>& path) {
    if (p == side.v.back()) return;
    while (side.length() > 1 && sign * turn(side.v[side.v.size() - 2], side.v.back(), p) <= 0) side.v.pop_back();
    if (side.length() == 1) {
      while (other.length() > 1 && sign * turn(other.v[other.head], other.v[other.head + 1], p) <= 0) {
        path.push_back(other.v[++other.head]);
        side.v.back() = path.back();
      }
    }
    side.v.push_back(p);
  }

  const Placement& place_;
  const FreeTriangulation& triangulation_;
  Side left_, right_;
};

class Builder {
 public:
  /// Of a whole body.
  Builder(const Placement& placement, const FreeTriangulation& t, const ChainTree& tree, std::uint32_t first,
          PlanarMap& map)
      : triangulation_(t),
        tree_(tree),
        first_(first),
        ring_(tree.leaves()),
        map_(map),
        funnel_(placement, t, std::min(ring_, small)) {
    reserve();
  }
  /// Of the open nodes of an outline.
  Builder(const Placement& placement, const FreeTriangulation& t, const ChainTree& tree, const ShapeOutline& outline,
          const std::vector<VertexId>& vertices, std::uint32_t first, PlanarMap& map)
      : triangulation_(t),
        tree_(tree),
        first_(first),
        ring_(static_cast<std::uint32_t>(outline.edges.size())),
        map_(map),
        funnel_(placement, t, std::min(ring_, small)),
        outline_(&outline),
        vertices_(&vertices) {
    reserve();
  }

  std::vector<HalfedgeId> run() {
    build(tree_.root());
    return std::move(paths_);
  }

  std::vector<HalfedgeId> run(const GeodesicVisitor& visitor) {
    visitor_ = visitor ? &visitor : nullptr;
    return run();
  }

  /// The geodesics of one level, in order.
  std::vector<std::vector<VertexId>> run_to_level(int level) {
    level_ = level;
    build(tree_.root());
    return std::move(geodesics_);
  }

 private:
  /// The buffers of bodies with up to so many vertices do not grow: that would cost them a quarter of their tiling.
  static constexpr std::uint32_t small = 64;

  void reserve() {
    const std::size_t room = std::min(ring_, small);
    paths_.reserve(room);
    sleeves_.reserve(2 * room);
    path_.reserve(room + 1);
    top_.reserve(room);
    kept_.reserve(room);
  }
  VertexId vertex(std::uint32_t i) const { return VertexId(first_ + i % ring_); }
  bool is_leaf(ChainNode n) const { return outline_ ? !outline_->open[tree_.heap(n)] : tree_.is_leaf(n); }

  /// Leaves the node's geodesic on top of paths_ and its diagonals on top of sleeves_.
  /// The depth of the recursion is that of the tree, at most 32.
  void build(ChainNode n) {
    if (is_leaf(n)) {
      if (node::depth(n) <= level_) geodesics_.push_back({vertex(next_edge_), vertex(next_edge_ + 1)});
      add_leaf();
      return;
    }
    const std::size_t path_begin = paths_.size(), sleeve_begin = sleeves_.size();
    const std::uint32_t chain_begin = next_edge_;
    build(node::left(n));
    const std::size_t path_middle = paths_.size();
    add_fan(vertex(next_edge_), sleeve_begin);
    const std::size_t junction = sleeves_.size();
    build(node::right(n));
    cancel(sleeve_begin, junction);
    const VertexId a = vertex(chain_begin), b = vertex(next_edge_);
    find_path(a, b, sleeve_begin);
    if (node::depth(n) == level_) geodesics_.push_back(path_);
    if (visitor_) (*visitor_)(n, path_);
    make_face(n, path_begin, path_middle);
  }

  /// An edge of the body; of an outline, the edges of a geodesic that is there already.
  void add_leaf() {
    if (!outline_) {
      paths_.push_back(HalfedgeId(2 * (first_ + next_edge_++)));
      return;
    }
    const std::size_t sleeve_begin = sleeves_.size();
    const std::uint32_t end = next_edge_ + outline_->leaf_edges[next_leaf_++];
    paths_.push_back(outline_->edges[next_edge_++]);
    while (next_edge_ < end) {
      add_fan(vertex(next_edge_), sleeve_begin);
      paths_.push_back(outline_->edges[next_edge_++]);
    }
  }

  /// The diagonals around u from its previous polygon edge to its next one, through free space.
  void add_fan(VertexId u, std::size_t sleeve_begin) {
    const VertexId before = vertex(u.value - first_ + ring_ - 1);
    std::uint32_t h = triangulation_.boundary[before.value];
    for (;;) {
      h = triangulation_.twin[FreeTriangulation::previous(h)];
      if (h == FreeTriangulation::none) return;
      if (sleeves_.size() > sleeve_begin && sleeves_.back() == triangulation_.twin[h]) {
        sleeves_.pop_back();
      } else {
        sleeves_.push_back(h);
      }
    }
  }

  void cancel(std::size_t begin, std::size_t junction) {
    std::size_t k = 0;
    while (junction - begin > k && junction + k < sleeves_.size() &&
           sleeves_[junction - 1 - k] == triangulation_.twin[sleeves_[junction + k]])
      ++k;
    if (k > 0) {
      sleeves_.erase(sleeves_.begin() + static_cast<std::ptrdiff_t>(junction - k),
                     sleeves_.begin() + static_cast<std::ptrdiff_t>(junction + k));
    }
  }

  bool touches(std::uint32_t diagonal, VertexId v) const {
    return triangulation_.origin[diagonal] == v || triangulation_.target(diagonal) == v;
  }

  void find_path(VertexId a, VertexId b, std::size_t sleeve_begin) {
    std::size_t lo = sleeve_begin, hi = sleeves_.size();
    while (lo < hi && touches(sleeves_[lo], a)) ++lo;
    while (hi > lo && touches(sleeves_[hi - 1], b)) --hi;
    funnel_.run(a, b, sleeves_.data() + lo, sleeves_.data() + hi, path_);
    if (vertices_) {
      for (VertexId& v : path_) v = (*vertices_)[v.value];
    }
  }

  /// Replaces the children's geodesics on the stack by the node's, and links the face between them.
  void make_face(ChainNode n, std::size_t begin, std::size_t middle) {
    const std::size_t end = paths_.size(), left = middle - begin, right = end - middle, own = path_.size() - 1;
    std::size_t prefix = 0, suffix = 0, tail = 0;
    while (prefix < own && prefix < left && path_[prefix + 1] == map_.target(paths_[begin + prefix])) ++prefix;
    while (suffix < own - prefix && suffix < right && path_[own - 1 - suffix] == map_.origin(paths_[end - 1 - suffix]))
      ++suffix;
    while (tail < left && tail < right && map_.origin(paths_[middle - 1 - tail]) == map_.target(paths_[middle + tail]))
      ++tail;
    top_.clear();
    for (std::size_t i = prefix; i < own - suffix; ++i) {
      const HalfedgeId h = map_.add_edge(path_[i], path_[i + 1]);
      map_.set_node(h, n);
      top_.push_back(h);
    }
    for (std::size_t k = 0; k < tail; ++k) map_.merge(paths_[middle - 1 - k], paths_[middle + k]);
    link_cycle(n, begin + prefix, middle - tail, middle + tail, end - suffix);
    // The stack now gets prefix, top, suffix.
    kept_.assign(paths_.end() - static_cast<std::ptrdiff_t>(suffix), paths_.end());
    paths_.resize(begin + prefix);
    paths_.insert(paths_.end(), top_.begin(), top_.end());
    paths_.insert(paths_.end(), kept_.begin(), kept_.end());
  }

  /// The face: the new top forwards, then the right child's part and the left child's part, both backwards.
  void link_cycle(ChainNode n, std::size_t left_begin, std::size_t left_end, std::size_t right_begin,
                  std::size_t right_end) {
    HalfedgeId first, last;
    const auto append = [&](HalfedgeId h) {
      map_.set_node(h, n);
      if (last.valid()) {
        map_.link(last, h);
      } else {
        first = h;
      }
      last = h;
    };
    for (const HalfedgeId h : top_) append(h);
    for (std::size_t i = right_end; i > right_begin; --i) append(PlanarMap::twin(paths_[i - 1]));
    for (std::size_t i = left_end; i > left_begin; --i) append(PlanarMap::twin(paths_[i - 1]));
    if (last.valid()) map_.link(last, first);
  }

  const FreeTriangulation& triangulation_;
  const ChainTree& tree_;
  std::uint32_t first_, ring_;  ///< the vertices of the ring in the triangulation: the first one, and how many
  PlanarMap& map_;
  Funnel funnel_;
  const ShapeOutline* outline_ = nullptr;
  const std::vector<VertexId>* vertices_ = nullptr;  ///< the map's, if they are not the triangulation's
  const GeodesicVisitor* visitor_ = nullptr;
  std::uint32_t next_edge_ = 0, next_leaf_ = 0;
  std::vector<HalfedgeId> paths_;       ///< a stack of geodesics
  std::vector<std::uint32_t> sleeves_;  ///< a stack of sequences of diagonals, the chain on the left
  std::vector<VertexId> path_;
  std::vector<HalfedgeId> top_, kept_;
  int level_ = -1;  ///< whose geodesics are kept
  std::vector<std::vector<VertexId>> geodesics_;
};

}  // namespace

void add_polygon_edges(const ChainTree& tree, std::uint32_t first, PlanarMap& map) {
  const std::uint32_t n = tree.leaves();
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    const HalfedgeId inside(2 * (first + i));
    map.set_origin(inside, VertexId(first + i));
    map.set_origin(PlanarMap::twin(inside), VertexId(first + j));
    map.link(inside, HalfedgeId(2 * (first + j)));
    map.set_node(inside, tree.leaf(i));
  }
}

std::vector<HalfedgeId> add_geodesic_faces(const Placement& placement, const FreeTriangulation& triangulation,
                                           const ChainTree& tree, std::uint32_t first_vertex, PlanarMap& map,
                                           const GeodesicVisitor& visitor) {
  return Builder(placement, triangulation, tree, first_vertex, map).run(visitor);
}

std::vector<HalfedgeId> add_open_faces(const Placement& outside, const FreeTriangulation& triangulation,
                                       const ChainTree& tree, const ShapeOutline& outline,
                                       const std::vector<VertexId>& vertices, std::uint32_t first, PlanarMap& map) {
  return Builder(outside, triangulation, tree, outline, vertices, first, map).run();
}

std::vector<std::vector<VertexId>> geodesics_of_level(const Placement& placement,
                                                      const FreeTriangulation& triangulation, const ChainTree& tree,
                                                      std::uint32_t first_vertex, int level) {
  PlanarMap scratch;
  scratch.reset(placement.size());
  add_polygon_edges(tree, first_vertex, scratch);
  return Builder(placement, triangulation, tree, first_vertex, scratch).run_to_level(level);
}

}  // namespace taut::internal
