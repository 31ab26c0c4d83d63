// How two bodies move at a contact, with bounds.
#include <algorithm>
#include <cmath>

#include "certificate/root.hpp"
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

/// A vertex of one body and an edge of the other one, in the bodies' own coordinates.
struct TouchingFeatures {
  KnownPlace vertex, from, to;
};

ContactMotion motion_at(const TouchingFeatures& features, const BodyInContact& first, const BodyInContact& second,
                        const Point& normal, int exponent) {
  const KnownPlace there = second.seen(first.x(features.vertex), first.y(features.vertex));
  const Known vx = first.speed_x(features.vertex) - second.speed_x(there);
  const Known vy = first.speed_y(features.vertex) - second.speed_y(there);
  const Known ex = features.to.x - features.from.x, ey = features.to.y - features.from.y;
  const Known size = sqrt(ex * ex + ey * ey);
  // The edge turned by -90 degrees, which points outwards along an outline that is counterclockwise.
  Known nx = (second.pose.xx.v * ey + second.pose.xy.v * ex) / size;
  Known ny = (second.pose.xy.v * ey - second.pose.xx.v * ex) / size;
  if (nx.mid * normal.x + ny.mid * normal.y < 0) {
    nx = -nx;
    ny = -ny;
  }
  return {{unscaled(nx, 0), unscaled(ny, 0)},
          {unscaled(vx, -exponent), unscaled(vy, -exponent)},
          unscaled(vx * nx + vy * ny, -exponent)};
}

void include(Enclosure& all, const Enclosure& other) { all = {std::min(all.lo, other.lo), std::max(all.hi, other.hi)}; }

}  // namespace

/// A joint of a motion may come within the time of the contact: then of what holds before it, and of what holds after.
ContactMotion Simulation::relative_velocity(const Contact& contact) const {
  const Impl& impl = usable();
  impl.expect_decided();
  impl.check_body(contact.vertex.body);
  impl.check_body(contact.edge.body);
  const Instance& instance = impl.world->instance();
  const auto ring = [&](const auto& feature) -> const Polygon& {
    return input_ring(impl.scene.bodies[static_cast<std::size_t>(feature.body)], feature.part, feature.ring);
  };
  const Polygon &hitting = ring(contact.vertex), &hit = ring(contact.edge);
  const auto k = static_cast<std::size_t>(contact.edge.index);
  const auto place = [&](const Point& p) { return scaled_place(p, instance.exponent()); };
  const TouchingFeatures features{place(hitting.at(static_cast<std::size_t>(contact.vertex.index))), place(hit.at(k)),
                                  place(hit.at((k + 1) % hit.size()))};
  const Known time = Known::between(contact.time.lo, contact.time.hi);
  const auto at = [&](double t) {
    const auto moving = [&](BodyId body) {
      return BodyInContact(instance.bodies()[static_cast<std::size_t>(body)], time, t);
    };
    return motion_at(features, moving(contact.vertex.body), moving(contact.edge.body), contact.normal,
                     instance.exponent());
  };
  const double now = impl.world->time();
  ContactMotion all = at(now);
  const auto include_those_at = [&](double t) {
    const ContactMotion other = at(t);
    for (std::size_t i = 0; i < 2; ++i) {
      include(all.normal[i], other.normal[i]);
      include(all.velocity[i], other.velocity[i]);
    }
    include(all.along_normal, other.along_normal);
  };
  if (contact.time.hi > now) include_those_at(contact.time.hi);
  // The bodies may have met right at a joint.
  if (!impl.changed_since_contact) include_those_at(std::nextafter(now, -never));
  return all;
}

}  // namespace taut
