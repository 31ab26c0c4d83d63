#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "certificate/root.hpp"
#include "motion/pose.hpp"
#include "session/simulation_impl.hpp"
#include "taut/contact_motions.hpp"
#include "taut/error.hpp"
#include "taut/pose.hpp"
#include "taut/shape.hpp"

namespace taut {
namespace {

/// So much faster than it is pushed does a body go for a while.
constexpr double faster = 1 + 0x1p-4;

/// The contact of that body at which the simulation stands.
const Contact& contact_of(const Simulation& simulation, BodyId body) {
  const auto is_of = [body](const Contact& c) { return c.vertex.body == body || c.edge.body == body; };
  if (simulation.contact() && is_of(*simulation.contact())) return *simulation.contact();
  for (const PairAnswer& other : simulation.also()) {
    if (is_of(*other.contact)) return *other.contact;
  }
  throw InputError("", fmt::format("the simulation does not stand at a contact of body {}", body),
                   "ask at a contact, before resume()");
}

/// The pose of the frame in which the body's motion is seen.
BodyPose frame_of(const Simulation& simulation, BodyId body) {
  const std::vector<Body>& bodies = simulation.scene().bodies;
  const std::string& parent = bodies[static_cast<std::size_t>(body)].relative_to;
  if (parent.empty()) return {};
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const Body& b) { return b.name == parent; });
  return poses_at(simulation.scene(), simulation.time())[static_cast<std::size_t>(found - bodies.begin())];
}

Point turned_back(const BodyPose& frame, const Point& world) {
  return {frame.axis.x * world.x + frame.axis.y * world.y, frame.axis.x * world.y - frame.axis.y * world.x};
}

/// Where the contact is, and the direction out of the other body, as the body's parent sees them.
struct SeenContact {
  Point point, out;

  SeenContact(const Simulation& simulation, BodyId body, const Contact& contact) {
    const BodyPose frame = frame_of(simulation, body);
    const double sign = contact.vertex.body == body ? 1 : -1;
    out = turned_back(frame, {sign * contact.normal.x, sign * contact.normal.y});
    point = turned_back(frame, {contact.point.x - frame.origin.x, contact.point.y - frame.origin.y});
  }
};

/// Where a body is now, seen from its parent, and how it goes on.
MotionPiece standing(const Simulation& simulation, BodyId body) {
  const double t = simulation.time();
  const BodyPose at = pose_at(simulation.scene().bodies[static_cast<std::size_t>(body)].motion, t);
  MotionPiece piece;
  piece.origin = t;
  piece.x = {at.origin.x};
  piece.y = {at.origin.y};
  if (at.axis.x != 1 || at.axis.y != 0) piece.rotation = AngleRotation{{std::atan2(at.axis.y, at.axis.x)}};
  return piece;
}

/// Moved along the guide, by a way and at a rate: both in radians about a hinge, else in lengths.
MotionPiece guided(MotionPiece piece, const Guide& guide, double way, double rate) {
  if (!guide.hinge) {
    const double size = std::hypot(guide.direction.x, guide.direction.y);
    const Point d{guide.direction.x / size, guide.direction.y / size};
    piece.x = {piece.x[0] + way * d.x, rate * d.x};
    piece.y = {piece.y[0] + way * d.y, rate * d.y};
    return piece;
  }
  const AngleRotation* const turn = std::get_if<AngleRotation>(&piece.rotation);
  const double angle = turn ? turn->angle[0] : 0, c = std::cos(angle), s = std::sin(angle);
  const Point d{guide.hinge->x - piece.x[0], guide.hinge->y - piece.y[0]};
  piece.pivot = {c * d.x + s * d.y, c * d.y - s * d.x};
  piece.x = {guide.hinge->x - piece.pivot.x};
  piece.y = {guide.hinge->y - piece.pivot.y};
  piece.rotation = AngleRotation{{angle + way, rate}};
  return piece;
}

/// How fast the body leaves the contact along the normal if it moves along its guide at rate 1.
double leaving(const Guide& guide, const SeenContact& seen) {
  if (guide.hinge) {
    const Point arm{seen.point.x - guide.hinge->x, seen.point.y - guide.hinge->y};
    return arm.x * seen.out.y - arm.y * seen.out.x;
  }
  const double size = std::hypot(guide.direction.x, guide.direction.y);
  if (!(size > 0)) throw InputError("guide", "it has neither a hinge nor a direction", "give one of them");
  return (guide.direction.x * seen.out.x + guide.direction.y * seen.out.y) / size;
}

}  // namespace

double small_gap(const Simulation& simulation) {
  double largest = 0;
  const auto include = [&largest](const Point& p) { largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)}); };
  for (const BodyPose& pose : poses_at(simulation.scene(), simulation.time())) include(pose.origin);
  for (const Body& body : simulation.scene().bodies) {
    if (body.parts.empty()) std::for_each(polygon_of(body).begin(), polygon_of(body).end(), include);
    for (const Part& part : body.parts) std::for_each(part.outline.begin(), part.outline.end(), include);
  }
  return 0x1p-44 * largest;
}

void stop(Simulation& simulation, BodyId body, double gap) {
  const SeenContact seen(simulation, body, contact_of(simulation, body));
  const double way = gap > 0 ? gap : small_gap(simulation);
  MotionPiece piece = standing(simulation, body);
  piece.x[0] += way * seen.out.x;
  piece.y[0] += way * seen.out.y;
  simulation.set_motion(body, {{piece}});
}

void push(Simulation& simulation, BodyId body, const Guide& guide, double step, double gap) {
  if (!(step > 0)) throw InputError("step", "it is not positive", "give a time");
  const Contact contact = contact_of(simulation, body);
  if (!(simulation.relative_velocity(contact).along_normal.lo < 0)) return;
  const SeenContact seen(simulation, body, contact);
  const double share = leaving(guide, seen);
  if (!(std::fabs(share) > 0x1p-20))
    throw InputError("guide", "along it the body does not leave the contact", "give it another hinge or direction");
  const double way = (gap > 0 ? gap : small_gap(simulation)) / share;
  const MotionPiece here = standing(simulation, body);
  // At rest it shows how fast the other body comes.
  simulation.set_motion(body, {{guided(here, guide, way, 0)}});
  const double speed = std::max(0.0, -simulation.relative_velocity(contact).along_normal.lo);
  const double rate = speed * faster / share;
  MotionPiece moving = guided(here, guide, way, rate);
  moving.until = simulation.time() + step;
  if (moving.until < simulation.scene().end) {
    const double passed = moving.until - moving.origin;
    simulation.set_motion(body, {{moving, guided(here, guide, way + rate * passed, 0)}});
  } else {
    moving.until = std::numeric_limits<double>::infinity();
    simulation.set_motion(body, {{moving}});
  }
}

// How two bodies move at a contact, with bounds.

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
