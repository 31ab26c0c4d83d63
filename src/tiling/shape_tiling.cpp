#include "tiling/prepared_tiling.hpp"

#include "tiling/geodesic_faces.hpp"

namespace taut::internal {
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
