#include "kinetic/session.hpp"

#include <algorithm>
#include <cmath>

#include "motion/motion_plan.hpp"
#include "motion/placement.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut {
namespace {

/// The same bits on every platform, which std::hypot does not promise.
double length(double x, double y) { return std::sqrt(x * x + y * y); }

/// x + i y of a pose's frame applied to a local point.
Point place(const Pose<double>& pose, double x, double y) {
  const double c = pose.xx.v.mid, s = pose.xy.v.mid;
  return {pose.ox.v.mid + (c * x - s * y), pose.oy.v.mid + (s * x + c * y)};
}

/// The pose of P or Q on a leg; on a bridge that after it, which differs by rounding only.
Pose<double> pose_on(const Leg& leg, bool of_p, double parameter) {
  if (leg.bridge) return pose(of_p ? leg.p_next : leg.q_next, Ball<double>::exact(leg.joint));
  return pose(of_p ? leg.p : leg.q, Ball<double>::exact(parameter));
}

}  // namespace

Session::Session(const Scene& scene, Touch touch, Tracer* tracer) : scene_(scene), tracer_(tracer) {
  validate(scene_);
  plan_ = plan_pair(scene_);
  const auto start_engine = [this](bool inwards) {
    engine_ = std::make_unique<Engine>(displaced_pair(plan_, inwards),
                                       make_legs(plan_.pieces[0], plan_.pieces[1], scene_.start, scene_.end),
                                       static_cast<EngineObserver*>(this));
  };
  start_engine(touch == Touch::open);
  if (engine_->state() != EngineState::overlap) return;
  if (engine_->overlap()->one_body) refuse_fine_features(*engine_->overlap());
  if (touch == Touch::closed) {
    // Touching at the start makes the outward shapes overlap; only if the inward ones do as well is it an overlap.
    const Overlap overlap = *engine_->overlap();
    const PairGeometry inner = displaced_pair(plan_, true);
    const Leg& leg = engine_->leg();
    const Placement placement(inner, leg, scene_.start);
    FreeTriangulation triangulation;
    if (!triangulate_free_space(placement, triangulation)) {
      contact_at_start(overlap);
      return;
    }
  }
  overlap_at_start_ = true;
}

void Session::refuse_fine_features(const Overlap& overlap) const {
  const Feature e = edge_feature(overlap.edge_p), f = edge_feature(overlap.edge_q);
  const Body& body = scene_.bodies[static_cast<std::size_t>(e.body)];
  const auto edge = [&body](const Feature& x) {
    return std::to_string(x.index) + "-" +
           std::to_string((static_cast<std::size_t>(x.index) + 1) % body.polygon.size());
  };
  throw InputError(body.name,
                   "edges " + edge(e) + " and " + edge(f) +
                       " come closer than the displacement that taut computes with, 2^-199 of the largest coordinate",
                   "features that small can only be rounding noise: remove them");
}

bool Session::finished() const { return overlap_at_start_ || contact_ || engine_->state() != EngineState::running; }

bool Session::step(double t) {
  if (finished()) return false;
  const bool more = engine_->step(t);
  if (engine_->state() == EngineState::contact) note_contact();
  return more;
}

TraceVertex Session::input_vertex(VertexId v) const {
  const Feature f = vertex_feature(v);
  return {f.body, f.index};
}

Feature Session::vertex_feature(VertexId v) const {
  const PairGeometry& g = engine_->geometry();
  const BodyMap& m = plan_.maps[g.in_p(v) ? 0 : 1];
  return {m.body, m.vertex(g.in_p(v) ? v.value : v.value - g.np)};
}

Feature Session::edge_feature(VertexId v) const {
  const PairGeometry& g = engine_->geometry();
  const BodyMap& m = plan_.maps[g.in_p(v) ? 0 : 1];
  return {m.body, m.edge(g.in_p(v) ? v.value : v.value - g.np)};
}

Point Session::world_at(VertexId v, const Leg& leg, double parameter) const {
  const PairGeometry& g = engine_->geometry();
  const DisplacedPoint& p = g.point(v);
  const Point at = place(pose_on(leg, g.in_p(v), parameter), p.x, p.y);
  return {std::ldexp(at.x, -plan_.exponent), std::ldexp(at.y, -plan_.exponent)};
}

Point Session::world(VertexId v) const { return world_at(v, engine_->leg(), engine_->parameter()); }

Point Session::outward_normal(VertexId edge, const Leg& leg, double parameter) const {
  const PairGeometry& g = engine_->geometry();
  const DisplacedPoint &a = g.point(edge), &b = g.point(g.next(edge));
  const Pose<double> pose = pose_on(leg, g.in_p(edge), parameter);
  // The polygon lies to the left of its edges: outside is to the right.
  double x = b.y - a.y, y = -(b.x - a.x);
  const double c = pose.xx.v.mid, s = pose.xy.v.mid;
  const double size = length(x, y) * length(c, s);
  x /= size;
  y /= size;
  return {c * x - s * y, s * x + c * y};
}

void Session::note_contact() {
  const EngineContact& found = *engine_->contact();
  const Leg& leg = engine_->leg();
  Contact contact;
  contact.time = {leg.time(found.lo), leg.time(found.hi)};
  // The start is exact: a contact found there cannot be earlier.
  contact.time.lo = std::max(contact.time.lo, scene_.start);
  contact.vertex = vertex_feature(found.vertex);
  contact.edge = edge_feature(found.edge);
  const double middle = found.lo + (found.hi - found.lo) / 2;
  contact.point = world_at(found.vertex, leg, middle);
  contact.normal = outward_normal(found.edge, leg, middle);
  contact_ = contact;
}

/// Edges of outward shapes that cross, of shapes that touch: the end of one that is nearest to the other is the vertex.
void Session::contact_at_start(const Overlap& overlap) {
  const PairGeometry& g = engine_->geometry();
  const Leg& leg = engine_->leg();
  const double t = scene_.start;
  const auto distance = [&](VertexId v, VertexId edge) {
    const Point p = world_at(v, leg, t), a = world_at(edge, leg, t), b = world_at(g.next(edge), leg, t);
    const double ex = b.x - a.x, ey = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
    const double share = std::clamp((px * ex + py * ey) / (ex * ex + ey * ey), 0.0, 1.0);
    return length(px - share * ex, py - share * ey);
  };
  const VertexId e = overlap.edge_p, f = overlap.edge_q;
  const std::pair<VertexId, VertexId> candidates[] = {{e, f}, {g.next(e), f}, {f, e}, {g.next(f), e}};
  std::pair<VertexId, VertexId> best = candidates[0];
  for (const auto& c : candidates) {
    if (distance(c.first, c.second) < distance(best.first, best.second)) best = c;
  }
  Contact contact;
  contact.time = {t, t};
  contact.vertex = vertex_feature(best.first);
  contact.edge = edge_feature(best.second);
  contact.point = world_at(best.first, leg, t);
  contact.normal = outward_normal(best.second, leg, t);
  contact_ = contact;
}

void Session::set_motion(int body, const Motion& motion) {
  if (body < 0 || body > 1) throw InputError("", "there is no body " + std::to_string(body), "bodies are 0 and 1");
  const double now = engine_->time();
  const std::size_t side = plan_.maps[0].body == body ? 0 : 1;
  const Body& old = scene_.bodies[static_cast<std::size_t>(body)];
  validate_motion(motion, old.name, old.polygon, now, scene_.end, plan_.extent);
  std::vector<MotionPiece> fresh;
  for (const MotionPiece& piece : pieces_between(motion, now, scene_.end))
    fresh.push_back(scaled(piece, plan_.exponent));
  const MotionPiece before = side == 0 ? engine_->leg().p : engine_->leg().q;
  const double gap = joint_gap(scaled(before, -plan_.exponent), scaled(fresh[0], -plan_.exponent), old.polygon, now);
  if (!(gap <= joint_tolerance * plan_.extent)) {
    throw InputError(old.name,
                     "the new motion jumps by " + std::to_string(gap) + " at the present, t = " + std::to_string(now),
                     "coefficients are in powers of the absolute time t");
  }
  plan_.pieces[side] = fresh;
  std::vector<Leg> legs = make_legs(plan_.pieces[0], plan_.pieces[1], now, scene_.end);
  if (!same_motion(before, fresh[0])) {
    const MotionPiece& p = piece_at(plan_.pieces[0], now);
    const MotionPiece& q = piece_at(plan_.pieces[1], now);
    legs.insert(legs.begin(), Leg::bridging(engine_->leg().p, engine_->leg().q, p, q, now));
  }
  engine_->replan(std::move(legs));
}

void Session::on_event(const EngineEvent& event) {
  if (!tracer_) return;
  TraceEvent out;
  out.number = engine_ ? engine_->events() : 1;
  out.lo = event.leg->time(event.lo);
  out.hi = event.leg->time(event.hi);
  out.bridging = event.leg->bridge;
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

}  // namespace taut
