#include "compare/cases.hpp"

#include <cmath>

#include "coastline.hpp"
#include "gen/generators.hpp"
#include "gen/shapes.hpp"
#include "taut/io.hpp"

namespace taut::bench {
namespace {

Contest from(const char* family, int n, const Scene& scene) { return {family, n, scene, Outcome::free, {}, {}}; }

const Family& family_named(const std::string& name) {
  for (const Family& family : families()) {
    if (family.name == name) return family;
  }
  throw std::logic_error("no family " + name);
}

Contest of_family(const char* name, int n) {
  const Case c = family_named(name).make(n);
  Contest contest{name, n, c.scene, c.outcome, {}, {}};
  if (c.outcome == Outcome::contact) contest.contact_time = c.contact_time;
  return contest;
}

Contest gears(int n) { return of_family("gears", n); }
Contest dips(int n) { return of_family("dips", n); }
Contest dips_linear(int n) { return of_family("dips_linear", n); }
Contest far_approach(int n) { return of_family("far", n); }

/// A wheel with square teeth, narrower than the gaps.
Polygon square_gear(int teeth, double radius, double depth, double share, double phase) {
  Polygon wheel;
  for (int k = 0; k < teeth; ++k) {
    const double pitch = 2 * gen::pi / teeth, from = pitch * (k + phase), to = from + share * pitch;
    for (const auto& [r, angle] : {std::pair{radius, from}, std::pair{radius + depth, from},
                                   std::pair{radius + depth, to}, std::pair{radius, to}})
      wheel.push_back(gen::polar(r, angle));
  }
  return wheel;
}

/// Two equal wheels, the teeth of one in the middle of the other's gaps, one turn in opposite directions.
Contest square_gears(int n) {
  const int teeth = n / 4;
  const double radius = teeth / (2 * gen::pi), depth = 0.3, share = 0.25;
  Scene scene;
  scene.end = 1;
  const double distance = 2 * radius + depth + 0.1;
  scene.bodies = {
      {"left", square_gear(teeth, radius, depth, share, -share / 2), {}},
      {"right", square_gear(teeth, radius, depth, share, 0.5 - share / 2 + (teeth % 2 == 0 ? 0 : 0.5)), {}}};
  MotionPiece turn;
  turn.rotation = AngleRotation{{0, 2 * gen::pi}};
  scene.bodies[0].motion.pieces = {turn};
  turn.x = {distance};
  turn.rotation = AngleRotation{{0, -2 * gen::pi}};
  scene.bodies[1].motion.pieces = {turn};
  return from("gears, square", n, scene);
}

Contest combs(int n) {
  gen::CombOptions o;
  o.teeth = n / 4;
  o.swings = 16;
  Scene scene = gen::make_combs(o);
  scene.end = 1;  // before they are pulled out
  return from("combs", n, scene);
}

Contest plans(int n) {
  constexpr int changes = 200;
  Contest contest = from("plans", n, resting_combs(n, changes));
  gen::Random random(5);
  Point at{0, 0};
  for (int k = 0; k < changes; ++k) {
    const Point to{random.uniform(-0.08, 0.08), random.uniform(-0.3, 0.3)}, speed{to.x - at.x, to.y - at.y};
    contest.plans.push_back(Motion{{gen::translation({at.x - speed.x * k, speed.x}, {at.y - speed.y * k, speed.y})}});
    at = to;
  }
  contest.scene.bodies[1].motion = contest.plans.front();
  return contest;
}

Contest bay_and_headland(int n) { return from("bay", n, bay(static_cast<std::size_t>(n))); }

/// Natural Earth's outlines on the way to each other.
Contest continents(int) {
  const Scene scene = read_scene("examples/continents/continents.json");
  const auto vertices = static_cast<int>(scene.bodies[1].polygon.size());
  Contest contest = from("continents", vertices, scene);
  contest.outcome = Outcome::contact;
  return contest;
}

Contest spiral(int n) {
  gen::SpiralOptions o;
  o.side_points = n / 2;
  return from("spiral", n, gen::make_spiral(o));
}

Polygon star(int n, double phase) {
  Polygon points;
  for (int k = 0; k < n; ++k) points.push_back(gen::polar(k % 2 == 0 ? 1 : 0.5, phase + 2 * gen::pi * k / n));
  return points;
}

Scene passing(const Polygon& a, const Polygon& b, double aside) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"first", a, {}}, {"second", b, Motion{{gen::translation({5, -1}, {aside})}}}};
  return scene;
}

Contest octagons(int) {
  Polygon octagon, turned;
  for (int k = 0; k < 8; ++k) {
    octagon.push_back(gen::polar(1, 0.1 + gen::pi / 4 * k));
    turned.push_back(gen::polar(1, 0.3 + gen::pi / 4 * k));
  }
  Contest contest = from("octagons", 8, passing(octagon, turned, 0.3));
  contest.outcome = Outcome::contact;
  return contest;
}

Contest stars(int n) {
  Contest contest = from("stars", n, passing(star(n, 0.1), star(n, 0.37), 0.3));
  contest.outcome = Outcome::contact;
  return contest;
}

}  // namespace

const std::vector<ContestFamily>& contest_families() {
  static const std::vector<ContestFamily> all{
      {"octagons", "two octagons, one straight way to a hit", {8}, octagons},
      {"stars", "two stars, one straight way to a hit", {8, 64, 512, 4096, 65536}, stars},
      {"gears", "two involute gears, a full turn", {64, 512, 4096, 65536}, gears},
      {"gears, square", "two gears with square teeth, a full turn", {64, 512, 4096, 65536}, square_gears},
      {"combs", "two combs, 16 slides within the slots", {64, 512, 4096, 65536}, combs},
      {"dips", "a disc dips into a cup 8 times, one polynomial of degree 16", {64, 512, 4096, 65536}, dips},
      {"dips_linear", "the same in 16 straight pieces", {64, 512, 4096, 65536}, dips_linear},
      {"far", "two islands, a hit after 500 diameters", {64, 512, 4096, 65536}, far_approach},
      {"plans", "combs, 200 changes of plan within the slots", {64, 512, 4096}, plans},
      {"bay", "a headland moves out of a bay, rough coasts", {64, 512, 4096, 65536}, bay_and_headland},
      {"continents", "Africa drifts towards South America", {0}, continents},
      {"spiral", "a spiral screwed out of a spiral groove", {128, 512, 4096}, spiral},
  };
  return all;
}

}  // namespace taut::bench
