// The gases of taut_dynamics, as Box2D steps them: contacts, depth of overlap, drift of energy, and time.
//
//   taut_dynamics_box2d [--bodies N] [--vertices V] [--fraction F] [--until T] [--rates HZ...]
#include <box2d/box2d.h>
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "dynamics/gas.hpp"
#include "stopwatch.hpp"
#include "taut/simulation.hpp"

namespace taut::bench {
namespace {

/// Counts pairs of bodies that begin to touch. A star is made of triangles around its middle, which do not count alone.
class Contacts final : public b2ContactListener {
 public:
  std::uint64_t begun = 0;
  void BeginContact(b2Contact* contact) override { begun += ++touching_[pair(contact)] == 1; }
  void EndContact(b2Contact* contact) override { --touching_[pair(contact)]; }

 private:
  static std::pair<b2Body*, b2Body*> pair(b2Contact* contact) {
    return std::minmax(contact->GetFixtureA()->GetBody(), contact->GetFixtureB()->GetBody());
  }
  std::map<std::pair<b2Body*, b2Body*>, int> touching_;
};

void add_fixture(b2Body& body, const std::vector<b2Vec2>& points) {
  b2PolygonShape shape;
  shape.Set(points.data(), static_cast<int>(points.size()));
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 1;
  fixture.friction = 0;
  fixture.restitution = 1;
  fixture.restitutionThreshold = 0;
  body.CreateFixture(&fixture);
}

b2Body* add_body(b2World& world, const Polygon& ring, const elastic::RigidBody& rigid) {
  const auto vector = [](const Point& p) { return b2Vec2(static_cast<float>(p.x), static_cast<float>(p.y)); };
  b2BodyDef definition;
  definition.type = rigid.mass > 0 ? b2_dynamicBody : b2_staticBody;
  definition.position = vector(rigid.at);
  definition.linearVelocity = vector(rigid.velocity);
  definition.angularVelocity = static_cast<float>(rigid.spin);
  definition.bullet = true;
  definition.allowSleep = false;
  b2Body* const body = world.CreateBody(&definition);
  std::vector<b2Vec2> points;
  for (const Point& p : ring) points.push_back(vector(p));
  if (points.size() <= 6) {
    add_fixture(*body, points);
    return body;
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    add_fixture(*body, {b2Vec2(0, 0), points[k], points[(k + 1) % points.size()]});
  return body;
}

double energy_of(const std::vector<b2Body*>& bodies) {
  double sum = 0;
  for (const b2Body* body : bodies) {
    if (body->GetType() != b2_dynamicBody) continue;
    const b2Vec2 v = body->GetLinearVelocity();
    const double spin = body->GetAngularVelocity();
    const double inertia = body->GetInertia() - body->GetMass() * body->GetLocalCenter().LengthSquared();
    sum += (body->GetMass() * static_cast<double>(v.LengthSquared()) + inertia * spin * spin) / 2;
  }
  return sum;
}

/// The deepest overlap of two fixtures now, as Box2D's own manifolds say.
double deepest(const b2World& world) {
  double depth = 0;
  for (const b2Contact* c = world.GetContactList(); c; c = c->GetNext()) {
    if (!c->IsTouching()) continue;
    b2WorldManifold manifold;
    c->GetWorldManifold(&manifold);
    for (int k = 0; k < c->GetManifold()->pointCount; ++k)
      depth = std::max(depth, -static_cast<double>(manifold.separations[k]));
  }
  return depth;
}

void step(const Gas& gas, double until, double rate) {
  b2World world(b2Vec2(0, 0));
  Contacts contacts;
  world.SetContactListener(&contacts);
  std::vector<b2Body*> bodies;
  for (std::size_t k = 0; k < gas.bodies.size(); ++k)
    bodies.push_back(add_body(world, gas.scene.bodies[k].polygon, gas.bodies[k]));
  const double before = energy_of(bodies);
  double depth = 0;
  const Stopwatch watch;
  const auto steps = static_cast<std::uint64_t>(std::llround(until * rate));
  for (std::uint64_t k = 0; k < steps; ++k) {
    world.Step(static_cast<float>(1 / rate), 8, 3);
    depth = std::max(depth, deepest(world));
  }
  fmt::print("Box2D {:>5.0f} Hz {:>9} {:>10.3f} {:>10.1e} {:>10.1e}\n", rate, contacts.begun, watch.seconds(), depth,
             energy_of(bodies) / before - 1);
}

void simulate(const Gas& gas, double until) {
  elastic::Collisions collisions(gas.bodies, 0x1p-44 * gas.side);
  const double before = collisions.energy();
  const Stopwatch watch;
  Simulation simulation(gas.scene);
  while (simulation.advance_to(until) == SimulationState::contact) collisions.respond(simulation);
  fmt::print("taut           {:>9} {:>10.3f} {:>10} {:>10.1e}\n", simulation.contacts(), watch.seconds(), "none",
             collisions.energy() / before - 1);
}

}  // namespace
}  // namespace taut::bench

int main(int argc, char** argv) {
  CLI::App app("dynamics of polygons beside Box2D");
  int bodies = 1000, vertices = 6;
  double fraction = 0.5, until = 10;
  std::vector<double> rates{60, 600, 6000};
  app.add_option("--bodies", bodies, "how many bodies");
  app.add_option("--vertices", vertices, "of each body: 6 is a hexagon, more an even number for a star");
  app.add_option("--fraction", fraction, "of the box that bodies fill");
  app.add_option("--until", until, "time to simulate");
  app.add_option("--rates", rates, "steps a second of Box2D");
  CLI11_PARSE(app, argc, argv);
  const taut::bench::Gas gas = taut::bench::gas(bodies, vertices, fraction);
  fmt::print("{:<14} {:>9} {:>10} {:>10} {:>10}\n", "", "contacts", "seconds", "overlap", "energy");
  taut::bench::simulate(gas, until);
  for (const double rate : rates) taut::bench::step(gas, until, rate);
}
