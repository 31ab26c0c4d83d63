// The tiling of a simulation, to be drawn.
#include <algorithm>

#include "scene/placement.hpp"
#include "session/simulation_impl.hpp"
#include "tiling/geodesic_faces.hpp"

namespace taut {
using namespace internal;

namespace {

FaceKind face_kind(const PlanarMap& map, HalfedgeId h) {
  if (map.is_interior(h)) return FaceKind::polygon_interior;
  if (map.node(h) == node::root) return FaceKind::root;
  if (map.node(h) == node::infinite_face) return FaceKind::infinite;
  return FaceKind::node;
}

TilingFace copy_face(const Simulation::Impl::OnlyTiling& only, HalfedgeId start, std::vector<bool>& visited) {
  const PlanarMap& map = only.engine.map();
  TilingFace face;
  face.kind = face_kind(map, start);
  const ChainNode n = map.node(start);
  if (face.kind == FaceKind::node || face.kind == FaceKind::polygon_interior) {
    face.body = only.body(n);
    face.depth = node::depth(n);
  }
  if (face.kind == FaceKind::node) {
    const PairGeometry& g = only.engine.geometry();
    const bool p = node::in_p(n);
    const std::uint32_t first = p ? 0 : g.np, size = p ? g.np : g.nq;
    const auto chain = ChainTree(size, p ? node::p_tree : node::q_tree).chain(n);
    face.chain_from = static_cast<int>(first + chain.first);
    face.chain_to = static_cast<int>(first + chain.second % size);
  }
  HalfedgeId h = start;
  do {
    visited[h.value] = true;
    if (face.kind != FaceKind::polygon_interior) face.boundary.push_back(static_cast<int>(map.origin(h).value));
    h = map.next(h);
  } while (h != start);
  return face;
}

}  // namespace

const KineticSolver& Simulation::Impl::only_pair() const {
  expect_decided();
  const KineticSolver* const solver = world->single_pair();
  if (!solver || !solver->bodies().has_single_rings())
    throw InputError("bodies",
                     "only two bodies of one ring each have one tiling; in other scenes, each two rings that are near "
                     "have their own",
                     "simulate two of its bodies, each as one polygon");
  return *solver;
}

Simulation::Impl::OnlyTiling Simulation::Impl::tiling() const {
  const KineticSolver& solver = only_pair();
  if (!solver.engines()) throw InputError("bodies", "the bodies overlap", "there is no free space to tile");
  return {solver, solver.engines()->engine(0)};
}

Tiling Simulation::tiling() const {
  const KineticSolver& solver = usable().only_pair();
  const PairGeometry& g = solver.geometry();
  const Engine* const engine = solver.engines() ? &solver.engines()->engine(0) : nullptr;
  const MotionSegment& segment = engine ? engine->segment() : solver.segments().front();
  const double parameter = engine ? engine->parameter() : segment.start;
  Tiling out;
  out.time = segment.time(parameter);
  for (std::uint32_t i = 0; i < g.size(); ++i) {
    const VertexId v(i);
    out.vertices.push_back({solver.features().vertex(v), solver.features().world(v, segment, parameter)});
  }
  if (!engine) return out;
  const Impl::OnlyTiling only{solver, *engine};
  const PlanarMap& map = engine->map();
  std::vector<bool> visited(map.halfedge_count(), false);
  for (std::uint32_t i = 0; i < map.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!map.alive(h)) continue;
    if ((i & 1u) == 0) {
      const VertexId from = map.origin(h), to = map.target(h);
      out.edges.push_back(
          {static_cast<int>(from.value), static_cast<int>(to.value), map.is_polygon_edge(h), !g.same_body(from, to)});
    }
    if (!visited[i]) out.faces.push_back(copy_face(only, h, visited));
  }
  return out;
}

TilingHalfedge Simulation::halfedge(int index) const {
  const Impl::OnlyTiling only = usable().tiling();
  const PlanarMap& map = only.engine.map();
  const HalfedgeId h(index);
  TilingHalfedge out;
  if (index < 0 || h.value >= map.halfedge_count() || !map.alive(h)) return out;
  out.origin = static_cast<int>(map.origin(h).value);
  out.next = static_cast<int>(map.next(h).value);
  out.kind = face_kind(map, h);
  if (out.kind == FaceKind::node || out.kind == FaceKind::polygon_interior) {
    const ChainNode n = map.node(h);
    out.body = only.body(n);
    out.depth = node::depth(n);
  }
  return out;
}

std::vector<TilingHalfedge> Simulation::halfedges() const {
  std::vector<TilingHalfedge> out(usable().tiling().engine.map().halfedge_count());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = halfedge(static_cast<int>(i));
  return out;
}

std::vector<int> Simulation::changed_halfedges() const {
  const PlanarMap& map = usable().tiling().engine.map();
  const RepairReport& report = usable().last;
  std::vector<int> out;
  const auto add = [&out](HalfedgeId h) { out.push_back(static_cast<int>(h.value)); };
  for (std::uint32_t i = 0; i < report.corner_count; ++i) {
    add(report.corners[i]);
    add(map.next(report.corners[i]));
  }
  if (report.removed.valid()) {
    add(report.removed);
    add(PlanarMap::twin(report.removed));
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<ActiveCertificate> Simulation::active_set() const {
  const Impl::OnlyTiling only = usable().tiling();
  std::vector<ActiveCertificate> out;
  only.engine.for_each_certificate([&](const Certificate& c) {
    out.push_back({only.input_vertex(c.u), only.input_vertex(c.v), only.input_vertex(c.w), c.sign > 0,
                   only.engine.segment().time(std::min(c.lo, only.engine.segment().end))});
  });
  return out;
}

namespace {

/// 0 if the body plays P, 1 if it plays Q.
std::size_t side_of(const KineticSolver& solver, BodyId body) {
  if (body < 0 || body > 1) throw InputError("", "there is no body " + std::to_string(body), "bodies are 0 and 1");
  return solver.bodies().body(Role::p) == body ? 0 : 1;
}

ChainTree tree_of(const PairGeometry& g, std::size_t side) {
  return side == 0 ? ChainTree(g.np, node::p_tree) : ChainTree(g.nq, node::q_tree);
}

}  // namespace

int Simulation::levels(BodyId body) const {
  const Impl::OnlyTiling only = usable().tiling();
  const ChainTree tree = tree_of(only.engine.geometry(), side_of(only.solver, body));
  return node::depth(tree.leaf(0)) + 1;
}

GeodesicCycle Simulation::geodesic_cycle(BodyId body, int level) const {
  const Impl::OnlyTiling only = usable().tiling();
  const std::size_t side = side_of(only.solver, body);
  const Engine& engine = only.engine;
  const PairGeometry& g = engine.geometry();
  if (engine.segment().bridge)
    throw InputError("", "a jump between two pieces of a motion is being bridged", "advance a little");
  const ChainTree tree = tree_of(g, side);
  const int last = node::depth(tree.leaf(0));
  const auto paths = [&] {
    try {
      const Placement placement(g, engine.segment(), engine.parameter());
      FreeTriangulation triangulation;
      if (triangulate_free_space(placement, triangulation))
        throw InputError("", "the bodies overlap", "there is no free space for geodesics");
      return geodesics_of_level(placement, triangulation, tree, side == 0 ? 0 : g.np, std::clamp(level, 0, last));
    } catch (const Undecidable& limit) {
      throw UndecidedError(not_decided(limit));
    }
  }();
  GeodesicCycle cycle;
  cycle.body = body;
  cycle.level = level;
  for (const auto& path : paths) {
    cycle.pinned.push_back(static_cast<int>(cycle.vertices.size()));
    for (std::size_t i = 0; i + 1 < path.size(); ++i) cycle.vertices.push_back(static_cast<int>(path[i].value));
  }
  return cycle;
}

}  // namespace taut
