// A planetary gear: a world of a ring with inner teeth, a carrier, planets that turn on it, and a sun.
#include <cmath>
#include <string>

#include "generators/generators.hpp"
#include "generators/involute.hpp"
#include "generators/shapes.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"

namespace taut::gen {

namespace {

Body plain(const std::string& name, const Polygon& polygon, const Motion& motion) {
  Body body;
  body.name = name;
  body.polygon = polygon;
  body.motion = motion;
  return body;
}

Polygon circle(double radius, int sides) {
  Polygon polygon;
  for (int k = 0; k < sides; ++k) polygon.push_back(polar(radius, 2 * pi * k / sides));
  return polygon;
}

Polygon moved(Polygon polygon, const Point& by) {
  for (Point& p : polygon) p = {p.x + by.x, p.y + by.y};
  return polygon;
}

/// An arm from the middle to a planet's axle.
Part arm(double angle, double length, double half_width) {
  const Point along = polar(1, angle), u = polar(length, angle);
  const Point side{-along.y * half_width, along.x * half_width};
  return {{{-side.x, -side.y}, {u.x - side.x, u.y - side.y}, {u.x + side.x, u.y + side.y}, side}, {}};
}

void require_planetary(const PlanetaryOptions& o) {
  require_range("--sun", o.sun, 8, 100000);
  require_range("--planet", o.planet, 8, 100000);
  require_range("--planets", o.planets, 1, 1000);
  require_range("--module", o.module, 1e-100, 1e100);
  require_range("--backlash", o.backlash, 0.001, 0.5);
  require_range("--flank-points", o.flank_points, 2, 1000000);
  require_range("--turns", o.turns, 0.001, 1e6);
  const int ring = o.sun + 2 * o.planet;
  if ((o.sun + ring) % o.planets != 0)
    throw InputError("--planets",
                     "the teeth do not fit: twice the sum of the sun's and a planet's is no multiple of it",
                     "for 3 planets, take 18 and 18 teeth");
  // Tips of neighbours must not meet.
  const double apart = (o.sun + o.planet) * std::sin(pi / o.planets);
  if (o.planets > 1 && apart <= o.planet + 2)
    throw InputError("--planets", "so many planets have no room", "take fewer, or smaller ones");
}

}  // namespace

Scene make_planetary(const PlanetaryOptions& o) {
  require_planetary(o);
  const int ring_teeth = o.sun + 2 * o.planet;
  const ToothForm form{o.module, 20, o.backlash, o.flank_points};
  const Gear sun = spur_gear(form, o.sun, o.planet), planet = spur_gear(form, o.planet, o.sun);
  const Gear hole = ring_hole(form, ring_teeth, o.planet);
  const double axle = o.module * (o.sun + o.planet) / 2;
  // The ring stands: the carrier follows the sun more slowly, and the planets roll back on it.
  const double sun_spin = 360, carrier_spin = sun_spin * o.sun / (o.sun + ring_teeth);
  const double planet_spin = -carrier_spin * ring_teeth / o.planet;
  Scene scene;
  scene.end = o.turns;
  Body ring, carrier = plain("carrier", {}, from_velocity({0, 0}, carrier_spin));
  ring.name = "ring";
  // On the far side of the first planet a space of it faces a tooth of the ring, or a tooth a space. The narrow space
  // is one that a planet comes to in the first turn.
  const int narrow =
      o.hit ? std::max(1, static_cast<int>(ring_teeth * carrier_spin / 720 * std::min(o.turns, 1.0))) : -1;
  const double phase_of_ring = o.planet % 2 == 0 ? pi / ring_teeth : 0;
  ring.parts = {{circle(hole.tip + 2 * o.module, 72),
                 {gear_outline(hole, phase_of_ring, narrow, -2 * (o.backlash + 0.05) / ring_teeth)}}};
  scene.bodies = {ring, carrier, plain("sun", gear_outline(sun, 0), from_velocity({0, 0}, sun_spin))};
  for (int k = 0; k < o.planets; ++k) {
    const double angle = 2 * pi * k / o.planets;
    const Point centre = polar(axle, angle);
    scene.bodies[1].parts.push_back(arm(angle, axle, 0.1 * o.planet * o.module));
    // On the way from the sun to the planet a tooth of the sun stands at a turn of so many teeth; a space faces it.
    const double ahead = angle * o.sun / o.planet, phase = angle + pi + pi / o.planet + ahead;
    Body body = plain("planet " + std::to_string(k + 1), moved(gear_outline(planet, phase), centre),
                      from_velocity({0, 0}, planet_spin, centre));
    body.relative_to = "carrier";
    scene.bodies.push_back(body);
  }
  scene.ignore = {{"carrier", "*"}};
  return scene;
}

}  // namespace taut::gen
