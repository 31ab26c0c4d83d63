#include "support/responses.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "taut/pose.hpp"

namespace taut::testing {

Motion going_off(const Simulation& simulation, BodyId body, Point shift, Point velocity, double spin) {
  const double t = simulation.time();
  const BodyPose at = poses_at(simulation.scene(), t)[static_cast<std::size_t>(body)];
  MotionPiece piece;
  piece.origin = t;
  piece.x = {at.origin.x + shift.x, velocity.x};
  piece.y = {at.origin.y + shift.y, velocity.y};
  if (spin != 0 || at.axis.x != 1 || at.axis.y != 0)
    piece.rotation = AngleRotation{{std::atan2(at.axis.y, at.axis.x), spin}};
  return Motion{{piece}};
}

double small_gap(const Simulation& simulation) {
  double largest = 0;
  for (const BodyPose& pose : poses_at(simulation.scene(), simulation.time()))
    largest = std::max({largest, std::fabs(pose.origin.x), std::fabs(pose.origin.y)});
  const auto include = [&](const Polygon& ring) {
    for (const Point& p : ring) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  };
  for (const Body& body : simulation.scene().bodies) {
    include(body.polygon);
    for (const Part& part : body.parts) include(part.outline);
  }
  return 0x1p-44 * largest;
}

namespace {

bool is_attached(const Simulation& simulation, BodyId body) {
  return !simulation.scene().bodies[static_cast<std::size_t>(body)].relative_to.empty();
}
bool carries(const Simulation& simulation, BodyId body) {
  const std::vector<Body>& bodies = simulation.scene().bodies;
  return std::any_of(bodies.begin(), bodies.end(), [&](const Body& other) {
    return other.relative_to == bodies[static_cast<std::size_t>(body)].name;
  });
}

}  // namespace

void part(Simulation& simulation, const Contact& contact, Rng& rng) {
  const BodyId first = contact.vertex.body, second = contact.edge.body;
  const bool fixed = is_attached(simulation, first) || is_attached(simulation, second);
  if (fixed || rng.chance(0.1)) {
    if (!carries(simulation, first) && rng.chance(0.3)) return simulation.remove_body(first);
    return simulation.ignore(first, second);
  }
  const double gap = small_gap(simulation), speed = rng.real(0.1, 2), aside = rng.real(-1, 1);
  const Point n = contact.normal;
  const auto along = [&](double a, double b) { return Point{a * n.x - b * n.y, a * n.y + b * n.x}; };
  const double share = rng.chance(0.5) ? 0 : rng.real(0, 1);
  simulation.set_motion(second, going_off(simulation, second, along(-gap, 0), along(-speed * share, 0), 0));
  simulation.set_motion(first, going_off(simulation, first, along(gap, 0), along(speed, aside), 0));
}

void part_all(Simulation& simulation, Rng& rng) {
  std::vector<Contact> contacts{*simulation.contact()};
  for (const PairAnswer& other : simulation.also()) contacts.push_back(*other.contact);
  // A body that the answer to one contact has taken away has no other ones.
  const auto is_gone = [&](BodyId body) {
    return simulation.scene().bodies[static_cast<std::size_t>(body)].name.find(", removed)") != std::string::npos;
  };
  for (const Contact& contact : contacts) {
    if (!is_gone(contact.vertex.body) && !is_gone(contact.edge.body)) part(simulation, contact, rng);
  }
}

}  // namespace taut::testing
