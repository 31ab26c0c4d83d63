// How an engine starts: a tiling, built or known, and the certificates of its corners.
#include <algorithm>

#include "kinetic/engine.hpp"
#include "numeric/budget.hpp"
#include "scene/placement.hpp"

namespace taut::internal {

namespace {

/// In units of checkpoint(): the work per vertex of a tiling, and the work of every start.
constexpr std::uint64_t work_of_vertex = 16, work_of_start = 80;

}  // namespace

Engine::Engine(PairGeometry geometry, MotionSegments segments, EngineObserver* observer, const KnownTilings& known)
    : geometry_(std::move(geometry)),
      segments_(std::move(segments)),
      segment_(segments_.hold(0)),
      observer_(observer),
      solver_(geometry_),
      queue_(certificates_, solver_.pool()),
      dormant_(geometry_, certificates_) {
  parameter_ = reached_ = segment().start;
  build(known);
}

namespace {

StaticTiling unmetered_tiling(Placement& placement, const KnownTilings& known) {
  const UnmeteredScope building;
  if (known.p && known.q) {
    if (auto joined = join_tilings(placement, *known.p, *known.q)) return std::move(*joined);
  }
  placement.tabulate();
  return build_tiling(placement);
}

/// The counted work does not depend on what is known: neither does which of two engines is first.
StaticTiling tiling_of(Placement& placement, const KnownTilings& known) {
  const std::uint64_t work = work_of_start + work_of_vertex * placement.size();
  StaticTiling tiling = unmetered_tiling(placement, known);
  count_work(work);
  return tiling;
}

}  // namespace

void Engine::build(const KnownTilings& known) {
  Placement placement(geometry_, segment(), parameter_, Positions::on_demand);
  StaticTiling tiling = tiling_of(placement, known);
  if (tiling.overlap) {
    overlap_ = tiling.overlap;
    state_ = EngineState::overlap;
    return;
  }
  map_ = std::move(tiling.map);
  initial_root_ = tiling.root;
  begin(placement);
}

/// Starts with the certificates of the map at that placement.
void Engine::begin(const Placement& placement) {
  // Edges that the start has removed again may have numbers beyond those that a tiling needs.
  certificate_of_.reset(std::max<std::size_t>(4 * std::size_t{geometry_.size()} + 16, map_.halfedge_count()));
  // An edge between the two bodies is in four corners, most of which have two such edges. A world has thousands of
  // engines, most of which have eight certificates, and there is room for a few more before anything is allocated.
  reserve_certificates(2 * mixed_edges() + 8);
  add_certificates(placement);
  at_start_ = placement.stages();
  queue_.reserve(certificates_.capacity());
  initial_ = max_active_ = active_;
  reserve_for_segments();
  enter_segment();
  solver_.reserve(active_);
}

void Engine::reserve_certificates(std::size_t room) {
  certificates_.reserve(room);
  dormant_.reserve(room);
  free_.reserve(room);
}

std::size_t Engine::mixed_edges() const {
  std::size_t count = 0;
  map_.for_each_changed_edge([&](HalfedgeId, VertexId from, VertexId to) { count += !geometry_.same_body(from, to); });
  return count;
}

/// Adds the certificates of all corners with a PQ edge.
void Engine::add_certificates(const Placement& placement) {
  map_.for_each_changed_edge([&](HalfedgeId edge, VertexId from, VertexId to) {
    if (!geometry_.same_body(from, to)) add_certificates_beside(edge, placement);
  });
}

void Engine::add_certificates_beside(HalfedgeId edge, const Placement& placement) {
  for (const HalfedgeId side : {edge, PlanarMap::twin(edge)}) {
    for (const HalfedgeId h : {map_.previous(side), side}) {
      if (certificate_of_.get(h.value).valid()) continue;
      const Corner at = corner(h);
      if (!is_mixed(at)) continue;
      Certificate& c = certificates_[add_certificate(h, at).value];
      c.sign = static_cast<std::int8_t>(placement.orientation(c.u, c.v, c.w));
    }
  }
}

}  // namespace taut::internal
