#include "kinetic/session.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/budget.hpp"
#include "base/errors.hpp"
#include "motion/pieces.hpp"
#include "pair/overlap_witness.hpp"
#include "pair/placement.hpp"
#include "pair/validate_scene.hpp"
#include "relative/make_segments.hpp"
#include "relative/motion_segment.hpp"
#include "sign/contact_at_start.hpp"
#include "taut/error.hpp"

namespace taut::internal {

namespace {

const ShapeTiling* known_tiling(const BodyPair& bodies, Role role, Offset offset) {
  const RingSet& rings = *bodies.rings[index_of(role)];
  if (!rings.is_prepared()) return nullptr;
  const SharedPolygon& polygon = rings.displaced(offset);
  return rings.kept_of<ShapeTiling>(0, offset, role,
                                    [&] { return tile_shape(polygon, role == Role::p ? node::p_tree : node::q_tree); });
}

KnownTilings known_tilings(const BodyPair& bodies, Offset offset) {
  return {known_tiling(bodies, Role::p, offset), known_tiling(bodies, Role::q, offset)};
}

}  // namespace

Session::Session(const Scene& scene, Touch touch, Tracer* tracer, EngineObserver* observer)
    : start_(scene.start), end_(scene.end), tracer_(tracer), observer_(observer) {
  validate_polygons(scene);
  require_ring_pair(scene, "a simulation of a tiling");
  bodies_ = pair_of(scene);
  build(offset_for(touch));
  if (engine_->state() == EngineState::overlap) resolve_overlap();
}

void Session::resolve_overlap() {
  const MotionSegment& segment = engine_->segment();
  const auto how = [&] { return overlap_of_outlines(engine_->geometry(), segment, start_); };
  const auto overlap_of = [&](const PairGeometry& shapes) {
    FreeTriangulation triangulation;
    return triangulate_free_space(Placement(shapes, segment, start_), triangulation).has_value();
  };
  if (const auto touching = contact_at_start(witness(), segment, start_, how, overlap_of)) {
    touching_ = touching->how;
    contact_ = touching->contact;
    return;
  }
  overlap_at_start_ = true;
  overlap_point_ = common_point(bodies_, start_);
}

void Session::build(Offset offset) {
  offset_ = offset;
  engine_ = std::make_unique<Engine>(displaced_pair(bodies_, offset), segments_of(bodies_, start_, end_),
                                     static_cast<EngineObserver*>(this), known_tilings(bodies_, offset));
}

bool Session::finished() const { return overlap_at_start_ || contact_ || engine_->state() != EngineState::running; }

bool Session::step(double t) {
  if (finished()) return false;
  const bool more = engine_->step(t);
  if (engine_->state() == EngineState::contact) note_contact();
  return more;
}

VertexRef Session::input_vertex(VertexId v) const { return witness().vertex(v); }

Point Session::world(VertexId v) const { return witness().world(v, engine_->segment(), engine_->parameter()); }

void Session::note_contact() {
  contact_ = witness().contact(*engine_->contact(), engine_->segment());
  // The start is exact: a contact found there cannot be earlier.
  contact_->time.lo = std::max(contact_->time.lo, start_);
}

void Session::set_motion(BodyId body, const Motion& motion) {
  if (body < 0 || body > 1) throw InputError("", "there is no body " + std::to_string(body), "bodies are 0 and 1");
  // Events that nearly coincide with the last one, and the rest of a bridge, belong to the old motion.
  while (step(engine_->time())) {
  }
  if (contact_) return;
  const double now = engine_->time();
  const Role role = bodies_.body(Role::p) == body ? Role::p : Role::q;
  const std::size_t k = index_of(role);
  const std::string& name = bodies_.rings[k]->name();
  const Bounds bounds = bodies_.rings[k]->input_bounds();
  const double extent =
      std::max(diagonal(bodies_.rings[0]->input_bounds()), diagonal(bodies_.rings[1]->input_bounds()));
  validate_motion(motion, name, bounds, now, end_, extent);
  const PieceList fresh = PieceList::between(motion, now, end_, bodies_.exponent);
  const MotionPiece before = role == Role::p ? engine_->segment().p : engine_->segment().q;
  const MotionPiece from = scaled(before, -bodies_.exponent), to = scaled(fresh[0], -bodies_.exponent);
  const double gap = joint_gap(from, to, bounds, now);
  if (!(gap <= joint_room(from, to, bounds, now, extent))) {
    throw InputError(name, fmt::format("the new motion jumps by {:.6g} at the present, t = {}", gap, now),
                     "coefficients are in powers of t, or of t - origin where the piece has an origin");
  }
  bodies_.motions[k] = {fresh};
  MotionSegments segments = segments_of(bodies_, now, end_);
  if (!same_motion(before, fresh[0])) {
    const MotionPiece p = bodies_.motions[0][0].at(now), q = bodies_.motions[1][0].at(now);
    segments.put_first(
        MotionSegment::bridging(engine_->segment().p, engine_->segment().q, p, q, now, engine_->segment().far()));
  }
  engine_->replan(std::move(segments));
}

void Session::on_event(const EngineEvent& event) {
  if (observer_) observer_->on_event(event);
  if (!tracer_) return;
  TraceEvent out;
  out.number = engine_ ? engine_->events() : 1;
  out.lo = event.segment->time(event.lo);
  out.hi = event.segment->time(event.hi);
  out.bridging = event.segment->bridge;
  out.repair = event.report.repair;
  out.u = input_vertex(event.u);
  out.v = input_vertex(event.v);
  out.w = input_vertex(event.w);
  out.pinch_rule = event.report.pinch_rule;
  out.three_corners = event.three_corners;
  out.corners_touched = static_cast<int>(event.report.corner_count);
  out.certificates = engine_->active_certificates();
  tracer_->on_event(out);
}

}  // namespace taut::internal
