#include "tiling/prepared_tiling.hpp"

#include <algorithm>

#include "numeric/budget.hpp"
#include "tiling/geodesic_faces.hpp"

namespace taut::internal {
namespace {

/// Finds which nodes must be done anew, and the outline that remains, with the joined map's numbers.
class OutlineBuilder {
 public:
  OutlineBuilder(const ShapeTiling& shape, const PlanarMap::Renumbering& number, const std::vector<bool>& near)
      : shape_(shape), map_(shape.map), number_(number), near_(near) {
    out_.open.resize(near.size(), false);
  }

  ShapeOutline run() {
    visit(shape_.tree.root());
    return std::move(out_);
  }

 private:
  void visit(ChainNode n) {
    const std::uint32_t k = shape_.tree.heap(n);
    if (!shape_.tree.is_leaf(n) && (near_[k] || !shape_.by_itself[k])) {
      out_.open[k] = true;
      out_.open_nodes.push_back(k);
      visit(node::left(n));
      visit(node::right(n));
    } else {
      add_geodesic(n);
    }
  }

  /// The geodesic has the subtree's faces, or the body's inside, on its left, and on its right something else.
  void add_geodesic(ChainNode n) {
    const auto [begin, end] = shape_.tree.chain(n);
    const VertexId last(end % shape_.tree.leaves());
    const std::size_t before = out_.edges.size();
    HalfedgeId h(2 * begin);
    for (;;) {
      while (node::in_subtree(map_.node(PlanarMap::twin(h)), n)) h = map_.next(PlanarMap::twin(h));
      out_.edges.push_back(number_(h));
      if (map_.target(h) == last) break;
      h = map_.next(h);
    }
    out_.leaf_edges.push_back(static_cast<std::uint32_t>(out_.edges.size() - before));
  }

  const ShapeTiling& shape_;
  const PlanarMap& map_;
  const PlanarMap::Renumbering& number_;
  const std::vector<bool>& near_;
  ShapeOutline out_;
};

/// Makes an outline shorter where nothing happens: runs of edges of the convex hull, with nothing near the cap between
/// them and their chord, are replaced by the chord. All geodesics that get there follow the whole run: below it is the
/// body, and the other body is not near. The chord is an edge of the map for the time being.
class Capper {
 public:
  /// `keep_off`: the other body.
  Capper(const PairGeometry& geometry, const RoundedPose& pose, const NodeBox& keep_off, const RoundedPose& other_pose,
         double margin, PlanarMap& map)
      : geometry_(geometry), pose_(pose), keep_off_(keep_off), other_pose_(other_pose), margin_(margin), map_(map) {}

  void shorten(ShapeOutline& outline) {
    pockets_ = box_of_pockets(outline);
    longest_run_ = outline.edges.size() / 3;  // so that three corners remain
    edges_.clear();
    std::size_t begin = 0;
    for (std::uint32_t& count : outline.leaf_edges) {
      const std::size_t before = edges_.size(), end = begin + count;
      for (std::size_t i = begin; i < end;) {
        std::size_t j = i;
        while (j < end && on_hull(outline.edges[j])) ++j;
        if (j == i) {
          edges_.push_back(outline.edges[i++]);
        } else {
          add_run(outline.edges, i, j);
          i = j;
        }
      }
      count = static_cast<std::uint32_t>(edges_.size() - before);
      begin = end;
    }
    outline.edges = edges_;
  }

  /// A hull in which runs take the place of their chords again, which leave the map.
  std::vector<HalfedgeId> restored(const std::vector<HalfedgeId>& hull) {
    std::vector<HalfedgeId> out;
    for (const HalfedgeId h : hull) {
      const auto chord = std::find_if(chords_.begin(), chords_.end(), [h](const Chord& c) { return c.edge == h; });
      if (chord == chords_.end()) {
        out.push_back(h);
      } else {
        out.insert(out.end(), runs_.begin() + chord->begin, runs_.begin() + chord->end);
      }
    }
    for (const Chord& c : chords_) map_.remove_edge(c.edge);
    return out;
  }

 private:
  struct Chord {
    HalfedgeId edge;
    std::ptrdiff_t begin, end;  ///< its run
  };

  bool on_hull(HalfedgeId h) const { return map_.node(PlanarMap::twin(h)) == node::infinite_face; }
  Point point(VertexId v) const { return {geometry_.point(v).x, geometry_.point(v).y}; }

  /// Around all edges that are not the hull's.
  std::optional<NodeBox> box_of_pockets(const ShapeOutline& outline) const {
    std::optional<BoxBuilder> box;
    for (const HalfedgeId h : outline.edges) {
      if (on_hull(h)) continue;
      const Point a = point(map_.origin(h)), b = point(map_.target(h));
      if (!box) box.emplace(a, a);
      box->include(a.x, a.y);
      box->include(b.x, b.y);
    }
    return box ? std::optional(box->box()) : std::nullopt;
  }

  void add_run(const std::vector<HalfedgeId>& edges, std::size_t begin, std::size_t end) {
    const std::size_t length = end - begin;
    if (length < shortest_run) {
      edges_.insert(edges_.end(), edges.begin() + static_cast<std::ptrdiff_t>(begin),
                    edges.begin() + static_cast<std::ptrdiff_t>(end));
    } else if (length <= longest_run_ && is_free(edges, begin, end)) {
      const HalfedgeId chord = map_.add_edge(map_.origin(edges[begin]), map_.target(edges[end - 1]));
      const auto first = static_cast<std::ptrdiff_t>(runs_.size());
      runs_.insert(runs_.end(), edges.begin() + static_cast<std::ptrdiff_t>(begin),
                   edges.begin() + static_cast<std::ptrdiff_t>(end));
      chords_.push_back({chord, first, static_cast<std::ptrdiff_t>(runs_.size())});
      edges_.push_back(chord);
    } else {
      const std::size_t middle = begin + length / 2;
      add_run(edges, begin, middle);
      add_run(edges, middle, end);
    }
  }

  bool is_free(const std::vector<HalfedgeId>& edges, std::size_t begin, std::size_t end) const {
    const Point a = point(map_.origin(edges[begin])), b = point(map_.target(edges[end - 1]));
    BoxBuilder builder(a, b);
    for (std::size_t i = begin + 1; i < end; ++i) {
      const Point v = point(map_.origin(edges[i]));
      builder.include(v.x, v.y);
    }
    const NodeBox cap = builder.box();
    return !(pockets_ && near(cap, {}, *pockets_, {}, margin_)) && !near(cap, pose_, keep_off_, other_pose_, margin_);
  }

  static constexpr std::size_t shortest_run = 4;

  const PairGeometry& geometry_;
  RoundedPose pose_;
  const NodeBox& keep_off_;
  RoundedPose other_pose_;
  double margin_;
  PlanarMap& map_;
  std::optional<NodeBox> pockets_;
  std::size_t longest_run_ = 0;
  std::vector<HalfedgeId> edges_, runs_;
  std::vector<Chord> chords_;
};

class Joiner {
 public:
  Joiner(const Placement& placement, const ShapeTiling& p, const ShapeTiling& q)
      : place_(placement), geometry_(placement.geometry()), p_(p), q_(q) {}

  std::optional<StaticTiling> run(bool in_any_case) {
    const double margin = 4 * place_.position_error();
    const BoxedTree tree_p{p_.tree, p_.boxes, place_.pose_p()}, tree_q{q_.tree, q_.boxes, place_.pose_q()};
    const std::size_t most_p = in_any_case ? geometry_.np : worthwhile(geometry_.np);
    const std::size_t most_q = in_any_case ? geometry_.nq : worthwhile(geometry_.nq);
    const bool boxes_apart = !near(p_.boxes[1], tree_p.pose, q_.boxes[1], tree_q.pose, margin);
    NodeSet near_p;
    if (!boxes_apart) near_p = near_nodes(tree_p, tree_q, margin, most_p);
    // Hulls that meet, though no part of one body is within the other's, would cut one of them in two.
    const bool apart =
        boxes_apart || (near_p.size == 0 ? near_nodes(tree_q, tree_p, margin, 0).size == 0 : rest_apart(near_p.size));
    NodeSet near_q;
    if (!apart) {
      if (near_p.size > most_p) return std::nullopt;
      near_q = near_nodes(tree_q, tree_p, margin, most_q);
      if (near_q.size > most_q) return std::nullopt;
    }
    map_ = PlanarMap::joined(p_.map, q_.map);
    const auto number_p = PlanarMap::first_in_joined(p_.map, q_.map);
    const auto number_q = PlanarMap::second_in_joined(p_.map, q_.map);
    std::vector<HalfedgeId> hull_p, hull_q;
    if (apart) {
      hull_p.reserve(p_.hull.size());
      hull_q.reserve(q_.hull.size());
      for (const HalfedgeId h : p_.hull) hull_p.push_back(number_p(h));
      for (const HalfedgeId h : q_.hull) hull_q.push_back(number_q(h));
    } else {
      ShapeOutline outline_p = OutlineBuilder(p_, number_p, near_p.has).run();
      ShapeOutline outline_q = OutlineBuilder(q_, number_q, near_q.has).run();
      remove_faces(p_, outline_p, number_p);
      remove_faces(q_, outline_q, number_q);
      Capper capper_p(geometry_, place_.pose_p(), q_.boxes[1], place_.pose_q(), margin, map_);
      Capper capper_q(geometry_, place_.pose_q(), p_.boxes[1], place_.pose_p(), margin, map_);
      capper_p.shorten(outline_p);
      capper_q.shorten(outline_q);
      if (!add_faces(outline_p, outline_q, hull_p, hull_q)) return std::nullopt;
      hull_p = capper_p.restored(hull_p);
      hull_q = capper_q.restored(hull_q);
    }
    StaticTiling result;
    result.root = add_root_faces(place_, hull_p, hull_q, map_, apart);
    result.map = std::move(map_);
    return result;
  }

 private:
  /// If more than a quarter of the nodes are near, an outline and its triangulation cost as much as those of the whole.
  static std::size_t worthwhile(std::size_t vertices) { return vertices / 4 + 8; }

  /// Where so many nodes of P are near Q that it is worth the way around both hulls.
  bool rest_apart(std::size_t near) const {
    if (32 * near < p_.hull.size() + q_.hull.size()) return false;
    const auto corners = [](const ShapeTiling& shape, std::uint32_t first) {
      std::vector<VertexId> vertices;
      vertices.reserve(shape.hull.size());
      for (const HalfedgeId h : shape.hull) vertices.emplace_back(first + shape.map.origin(h).value);
      return vertices;
    };
    return hulls_apart(place_, corners(p_, 0), corners(q_, geometry_.np));
  }

  /// The edges that only open nodes' geodesics run along.
  void remove_faces(const ShapeTiling& shape, const ShapeOutline& outline, const PlanarMap::Renumbering& number) {
    doomed_.clear();
    const PlanarMap& map = shape.map;
    const auto is_open = [&](ChainNode node) {
      return node == node::infinite_face || outline.open[shape.tree.heap(node)];
    };
    for (const std::uint32_t k : outline.open_nodes) {
      if (!shape.face[k].valid()) continue;
      HalfedgeId h = shape.face[k];
      do {
        if (!map.is_polygon_edge(h) && is_open(map.node(PlanarMap::twin(h)))) doomed_.push_back(number(h));
        h = map.next(h);
      } while (h != shape.face[k]);
    }
    for (const HalfedgeId h : doomed_) {
      if (map_.alive(h)) map_.remove_edge(h);
    }
  }

  /// Returns false if the outlines are not disjoint.
  bool add_faces(const ShapeOutline& outline_p, const ShapeOutline& outline_q, std::vector<HalfedgeId>& hull_p,
                 std::vector<HalfedgeId>& hull_q) {
    std::vector<VertexId> vertices;
    vertices.reserve(outline_p.edges.size() + outline_q.edges.size());
    const auto corners = [&](const ShapeOutline& outline) {
      std::vector<DisplacedPoint> points;
      points.reserve(outline.edges.size());
      for (const HalfedgeId h : outline.edges) {
        vertices.push_back(map_.origin(h));
        points.push_back(geometry_.point(vertices.back()));
      }
      return points;
    };
    std::vector<DisplacedPoint> points_p = corners(outline_p), points_q = corners(outline_q);
    const PairGeometry outlines(std::move(points_p), std::move(points_q));
    const Placement outside = place_.with_geometry(outlines);
    FreeTriangulation triangulation;
    if (triangulate_free_space(outside, triangulation)) return false;
    hull_p = add_open_faces(outside, triangulation, p_.tree, outline_p, vertices, 0, map_);
    hull_q = add_open_faces(outside, triangulation, q_.tree, outline_q, vertices, outlines.np, map_);
    return true;
  }

  const Placement& place_;
  const PairGeometry& geometry_;
  const ShapeTiling &p_, &q_;
  PlanarMap map_;
  std::vector<HalfedgeId> doomed_;
};

}  // namespace

std::optional<StaticTiling> join_tilings(const Placement& placement, const ShapeTiling& p, const ShapeTiling& q,
                                         bool in_any_case) {
  return Joiner(placement, p, q).run(in_any_case);
}

namespace {

class ShapeTiler {
 public:
  ShapeTiler(const SharedPolygon& polygon, ShapeTiling& out)
      : out_(out), geometry_(polygon, std::make_shared<const DisplacedPolygon>(std::vector<DisplacedPoint>())) {}

  bool run() {
    const MotionSegment rest = MotionSegment::motion({}, {}, 0, 0);
    const Placement placement(geometry_, rest, 0);
    FreeTriangulation triangulation;
    if (triangulate_free_space(placement, triangulation, true)) return false;
    const std::uint32_t n = geometry_.np;
    out_.boxes.resize(2 * static_cast<std::size_t>(n));
    out_.by_itself.resize(2 * static_cast<std::size_t>(n), true);
    for (std::uint32_t i = 0; i < n; ++i) add_leaf_box(i);
    PlanarMap map;
    map.reset(n);
    add_polygon_edges(out_.tree, 0, map);
    const auto visit = [this](ChainNode node, std::span<const VertexId> geodesic) { look_at(node, geodesic); };
    out_.hull = add_geodesic_faces(placement, triangulation, out_.tree, 0, map, visit);
    add_infinite_face(map);
    out_.map = map.compact(out_.hull);
    find_faces();
    return true;
  }

 private:
  Point point(std::uint32_t i) const {
    const DisplacedPoint& p = geometry_.point(VertexId(i % geometry_.np));
    return {p.x, p.y};
  }
  void add_leaf_box(std::uint32_t edge) {
    out_.boxes[out_.tree.heap(out_.tree.leaf(edge))] = BoxBuilder(point(edge), point(edge + 1)).box();
  }

  void look_at(ChainNode node, std::span<const VertexId> geodesic) {
    const auto [begin, end] = out_.tree.chain(node);
    BoxBuilder box(point(begin), point(end));
    for (std::uint32_t i = begin + 1; i < end; ++i) box.include(point(i).x, point(i).y);
    // Within its chain, a geodesic runs from the first vertex to the last, in order or not at all.
    bool by_itself = true;
    std::uint32_t last = begin;
    for (std::size_t i = 1; i < geodesic.size(); ++i) {
      const VertexId v = geodesic[i];
      box.include(point(v.value).x, point(v.value).y);
      const bool closes = i + 1 == geodesic.size();
      by_itself = by_itself && (closes || (v.value > last && v.value < end));
      last = v.value;
    }
    const std::uint32_t k = out_.tree.heap(node);
    out_.boxes[k] = box.box();
    out_.by_itself[k] = by_itself;
  }

  void add_infinite_face(PlanarMap& map) const {
    HalfedgeId after = out_.hull.back();
    for (const HalfedgeId h : out_.hull) {
      map.set_node(PlanarMap::twin(h), node::infinite_face);
      map.link(PlanarMap::twin(h), PlanarMap::twin(after));
      after = h;
    }
  }

  void find_faces() {
    out_.face.resize(out_.boxes.size());
    for (std::uint32_t i = 0; i < out_.map.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      const ChainNode n = out_.map.node(h);
      if (n != node::infinite_face && !out_.map.is_interior(h)) out_.face[out_.tree.heap(n)] = h;
    }
  }

  ShapeTiling& out_;
  PairGeometry geometry_;
};

}  // namespace

std::unique_ptr<const ShapeTiling> tile_shape(const SharedPolygon& polygon, ChainNode root) {
  const ChainTree tree(static_cast<std::uint32_t>(polygon->points.size()), root);
  auto tiling = std::make_unique<ShapeTiling>(ShapeTiling{tree, {}, {}, {}, {}, {}});
  if (!ShapeTiler(polygon, *tiling).run()) return nullptr;
  return tiling;
}

}  // namespace taut::internal
