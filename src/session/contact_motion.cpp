// How two bodies move at a contact, with bounds.
#include <cmath>

#include "motion/pose.hpp"
#include "session/simulation_impl.hpp"
#include "taut/shape.hpp"

namespace taut {
using namespace internal;

namespace {

using Known = Ball<double>;

Enclosure unscaled(const Known& x, int exponent) {
  return {std::ldexp(x.lower(), exponent), std::ldexp(x.upper(), exponent)};
}

/// In a body's own coordinates, scaled.
struct KnownPlace {
  Known x, y;
};

/// A body during the contact.
struct BodyInContact {
  Pose<double> pose;

  BodyInContact(const InstanceBody& body, const Known& time, double now)
      : pose(pose_of<Jet<double>>(pieces_at(body.motions, now), time)) {}

  Known x(const KnownPlace& p) const { return pose.ox.v + (pose.xx.v * p.x - pose.xy.v * p.y); }
  Known y(const KnownPlace& p) const { return pose.oy.v + (pose.xy.v * p.x + pose.xx.v * p.y); }
  Known speed_x(const KnownPlace& p) const { return pose.ox.d + (pose.xx.d * p.x - pose.xy.d * p.y); }
  Known speed_y(const KnownPlace& p) const { return pose.oy.d + (pose.xy.d * p.x + pose.xx.d * p.y); }
  /// Where a place of the world is in the body.
  KnownPlace seen(const Known& x, const Known& y) const {
    const Known dx = x - pose.ox.v, dy = y - pose.oy.v;
    return {pose.xx.v * dx + pose.xy.v * dy, pose.xx.v * dy - pose.xy.v * dx};
  }
};

const Polygon& input_ring(const Body& body, int part, int ring) {
  if (body.parts.empty()) return polygon_of(body);
  const Part& own = body.parts.at(static_cast<std::size_t>(part));
  return ring == 0 ? own.outline : own.holes.at(static_cast<std::size_t>(ring) - 1);
}

KnownPlace scaled_place(const Point& p, int exponent) {
  return {Known::exact(std::ldexp(p.x, exponent)), Known::exact(std::ldexp(p.y, exponent))};
}

}  // namespace

ContactMotion Simulation::relative_velocity(const Contact& contact) const {
  const Impl& impl = usable();
  impl.expect_decided();
  impl.check_body(contact.vertex.body);
  impl.check_body(contact.edge.body);
  const Instance& instance = impl.world->instance();
  const int exponent = instance.exponent();
  const auto ring = [&](const auto& feature) -> const Polygon& {
    return input_ring(impl.scene.bodies[static_cast<std::size_t>(feature.body)], feature.part, feature.ring);
  };
  const Polygon &hitting = ring(contact.vertex), &hit = ring(contact.edge);
  const auto k = static_cast<std::size_t>(contact.edge.index);
  const KnownPlace vertex = scaled_place(hitting.at(static_cast<std::size_t>(contact.vertex.index)), exponent);
  const KnownPlace from = scaled_place(hit.at(k), exponent), to = scaled_place(hit.at((k + 1) % hit.size()), exponent);
  const Known time = Known::between(contact.time.lo, contact.time.hi);
  const auto moving = [&](BodyId body) {
    return BodyInContact(instance.bodies()[static_cast<std::size_t>(body)], time, impl.world->time());
  };
  const BodyInContact first = moving(contact.vertex.body), second = moving(contact.edge.body);
  const KnownPlace there = second.seen(first.x(vertex), first.y(vertex));
  const Known vx = first.speed_x(vertex) - second.speed_x(there), vy = first.speed_y(vertex) - second.speed_y(there);
  const Known ex = to.x - from.x, ey = to.y - from.y, size = sqrt(ex * ex + ey * ey);
  // The edge turned by -90 degrees, which points outwards along an outline that is counterclockwise.
  Known nx = (second.pose.xx.v * ey + second.pose.xy.v * ex) / size;
  Known ny = (second.pose.xy.v * ey - second.pose.xx.v * ex) / size;
  if (nx.mid * contact.normal.x + ny.mid * contact.normal.y < 0) {
    nx = -nx;
    ny = -ny;
  }
  return {{unscaled(nx, 0), unscaled(ny, 0)},
          {unscaled(vx, -exponent), unscaled(vy, -exponent)},
          unscaled(vx * nx + vy * ny, -exponent)};
}

}  // namespace taut
