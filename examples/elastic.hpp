// Elastic collisions of rigid polygons, for simulations of taut: what bodies do after a contact is up to the program.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "taut/simulation.hpp"

namespace elastic {

using taut::BodyId;
using taut::Point;

inline double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }

/// A polygon of density 1, moving evenly since `since`. `at` is how far its centre of mass has come from where it is
/// drawn. A body without mass does not move.
struct RigidBody {
  double mass = 0, inertia = 0;
  Point centre{}, at{}, velocity{};
  double angle = 0, spin = 0, since = 0;

  double energy() const {
    return (mass * (velocity.x * velocity.x + velocity.y * velocity.y) + inertia * spin * spin) / 2;
  }
};

/// Area, centre and moment of inertia about it, by Green's theorem, relative to a vertex.
inline RigidBody rigid_body(const taut::Polygon& ring) {
  double area = 0, x = 0, y = 0, second = 0;
  const Point o = ring[0];
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a{ring[k].x - o.x, ring[k].y - o.y};
    const Point next = ring[(k + 1) % ring.size()], b{next.x - o.x, next.y - o.y};
    const double w = cross(a, b);
    area += w / 2;
    x += w * (a.x + b.x) / 6;
    y += w * (a.y + b.y) / 6;
    second += w * (a.x * a.x + a.x * b.x + b.x * b.x + a.y * a.y + a.y * b.y + b.y * b.y) / 12;
  }
  RigidBody body;
  body.mass = std::fabs(area);
  body.centre = {o.x + x / area, o.y + y / area};
  body.inertia = std::fabs(second) - body.mass * ((x / area) * (x / area) + (y / area) * (y / area));
  return body;
}

/// The motion of a body, and its scene's other bodies, from contact to contact.
class Collisions {
 public:
  /// The bodies are those of the scene, in its order; their motions are theirs from then on. `gap`: how far two bodies
  /// are moved apart at a contact, so that the rounding of their new motions does not make them overlap.
  Collisions(std::vector<RigidBody> bodies, double gap) : bodies_(std::move(bodies)), gap_(gap) {}

  const std::vector<RigidBody>& bodies() const { return bodies_; }
  double energy() const {
    double sum = 0;
    for (const RigidBody& body : bodies_) sum += body.energy();
    return sum;
  }
  /// Of all bodies, and what those without a mass were given.
  Point momentum() const {
    Point sum = given_away_;
    for (const RigidBody& body : bodies_)
      sum = {sum.x + body.mass * body.velocity.x, sum.y + body.mass * body.velocity.y};
    return sum;
  }
  taut::Motion motion(BodyId k) const {
    const RigidBody& body = bodies_[static_cast<std::size_t>(k)];
    taut::MotionPiece piece;
    if (body.mass == 0) return {};
    // Motions that count time from the same origin are quicker together than others, and nearby, nothing is lost.
    constexpr double stretch = 64;
    piece.origin = stretch * std::floor(body.since / stretch);
    const double passed = body.since - piece.origin;
    piece.x = {body.at.x - body.velocity.x * passed, body.velocity.x};
    piece.y = {body.at.y - body.velocity.y * passed, body.velocity.y};
    piece.rotation = taut::AngleRotation{{body.angle - body.spin * passed, body.spin}};
    piece.pivot = body.centre;
    return {{piece}};
  }
  /// Answers all contacts at which the simulation stands, and goes on.
  void respond(taut::Simulation& simulation) {
    std::vector<BodyId> changed;
    const auto answer = [&](const taut::Contact& contact) {
      collide(contact, simulation.time());
      changed.insert(changed.end(), {contact.vertex.body, contact.edge.body});
    };
    answer(*simulation.contact());
    for (const taut::PairAnswer& other : simulation.also()) answer(*other.contact);
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const BodyId k : changed) {
      if (bodies_[static_cast<std::size_t>(k)].mass > 0) simulation.set_motion(k, motion(k));
    }
    simulation.resume();
  }

 private:
  void stand_at(RigidBody& body, double t) const {
    const double passed = t - body.since;
    if (body.mass == 0) return;
    body.at = {body.at.x + body.velocity.x * passed, body.at.y + body.velocity.y * passed};
    body.angle = std::remainder(body.angle + body.spin * passed, 2 * std::acos(-1.0));
    body.since = t;
  }

  /// The impulse along the normal that reverses the velocity with which the two approach there.
  void collide(const taut::Contact& contact, double t) {
    RigidBody &a = bodies_[static_cast<std::size_t>(contact.vertex.body)],
              &b = bodies_[static_cast<std::size_t>(contact.edge.body)];
    stand_at(a, t);
    stand_at(b, t);
    const Point n = contact.normal;
    const auto arm = [&](const RigidBody& body) {
      return Point{contact.point.x - body.centre.x - body.at.x, contact.point.y - body.centre.y - body.at.y};
    };
    const double turn_a = cross(arm(a), n), turn_b = cross(arm(b), n);
    const double approach =
        (a.velocity.x - b.velocity.x) * n.x + (a.velocity.y - b.velocity.y) * n.y + a.spin * turn_a - b.spin * turn_b;
    const auto yields = [](const RigidBody& body, double turn) {
      return body.mass > 0 ? 1 / body.mass + turn * turn / body.inertia : 0;
    };
    const double impulse = approach < 0 ? -2 * approach / (yields(a, turn_a) + yields(b, turn_b)) : 0;
    push(a, n, turn_a, impulse, gap_);
    push(b, n, turn_b, -impulse, -gap_);
    for (const auto& [body, sign] : {std::pair(&a, 1.0), std::pair(&b, -1.0)}) {
      if (body->mass > 0) continue;
      given_away_ = {given_away_.x + sign * impulse * n.x, given_away_.y + sign * impulse * n.y};
    }
  }

  static void push(RigidBody& body, const Point& n, double turn, double impulse, double way) {
    if (body.mass == 0) return;
    body.velocity = {body.velocity.x + impulse / body.mass * n.x, body.velocity.y + impulse / body.mass * n.y};
    body.spin += impulse * turn / body.inertia;
    body.at = {body.at.x + way * n.x, body.at.y + way * n.y};
  }

  std::vector<RigidBody> bodies_;
  double gap_;
  Point given_away_{};
};

}  // namespace elastic
