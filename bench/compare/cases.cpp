#include "compare/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coastline.hpp"
#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "gshhg.hpp"
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

Contest gears_square(int n) { return from("gears, square", n, square_gears(n)); }

Contest combs(int n) {
  gen::CombOptions o;
  o.teeth = n / 4;
  o.swings = 16;
  Scene scene = gen::make_combs(o);
  scene.end = 1;  // before they are pulled out
  return from("combs", n, scene);
}

/// Combs that swing further than the slots allow.
Contest combs_hit(int n) {
  gen::CombOptions o;
  o.teeth = n / 4;
  o.swings = 16;
  o.hit = true;
  Contest contest = from("combs, hit", n, gen::make_combs(o));
  contest.outcome = Outcome::contact;
  return contest;
}

/// One tooth of the second gear is too thick.
Contest gears_hit(int n) {
  gen::GearOptions o;
  o.teeth_1 = n / 8;
  o.teeth_2 = n / 8 + 1;
  o.flank_points = o.teeth_1 < 42 ? 3 : 4;
  o.hit = true;
  Contest contest = from("gears, hit", n, gen::make_gears(o));
  contest.outcome = Outcome::contact;
  return contest;
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

/// From where the continents are today, Africa drifts `share` of the way on which its gulf meets South America, or,
/// `parting`, comes from there. At full resolution, in degrees of longitude and latitude.
Contest africa_drifting(const char* family, double share, bool parting) {
  const Point way{-44, -12}, gulf{9, 4};
  const double turn = -0.7;
  // What follows a polynomial from 0 to `whole` at time 1, or back.
  const auto from_to = [share, parting](double whole) {
    return parting ? Coefficients{whole * share, -whole * share} : Coefficients{0, whole * share};
  };
  MotionPiece drift;
  drift.x = from_to(way.x);
  drift.y = from_to(way.y);
  drift.rotation = AngleRotation{from_to(turn)};
  drift.pivot = gulf;
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"South America", read_gshhg(gshhg_south_america), {}},
                  {"Africa", read_gshhg(gshhg_africa), Motion{{drift}}}};
  return from(family, static_cast<int>(scene.bodies[0].polygon.size()), scene);
}

Contest africa(int) {
  Contest contest = africa_drifting("africa", 1, false);
  contest.outcome = Outcome::contact;  // after 0.958 of the way
  return contest;
}
Contest africa_parting(int) { return africa_drifting("africa, parting", 0.95, true); }

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

/// Upright, as high as 2, with two bulging long sides, and thin.
Polygon blade(int n) {
  const double thickness = 0.004;
  Polygon points;
  for (int k = 0; k < n; ++k) {
    const double y = k < n / 2 ? -1 + 4.0 * k / n : 3 - 4.0 * k / n;
    points.push_back({(k < n / 2 ? 0.5 : -0.5) * thickness * (1 - y * y), y});
  }
  return points;
}

Contest blades(int n) {
  Contest contest = from("blades", n, passing(blade(n), blade(n), 0.3));
  contest.scene.end = 9.9;  // so that no round number of steps has one at the middle of the encounter
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
      {"blades", "two thin blades, one flies through the other", {8, 64, 512}, blades},
      {"gears", "two involute gears, a full turn", {64, 512, 4096, 65536}, gears},
      {"gears, square", "two gears with square teeth, a full turn", {64, 512, 4096, 65536}, gears_square},
      {"gears, hit", "the same gears, one tooth too thick", {64, 512}, gears_hit},
      {"combs", "two combs, 16 slides within the slots", {64, 512, 4096, 65536}, combs},
      {"combs, hit", "the same combs, slides wider than the slots", {64, 512}, combs_hit},
      {"dips", "a disc dips into a cup 8 times, one polynomial of degree 16", {64, 512, 4096, 65536}, dips},
      {"dips_linear", "the same in 16 straight pieces", {64, 512, 4096, 65536}, dips_linear},
      {"far", "two islands, a hit after 500 diameters", {64, 512, 4096, 65536}, far_approach},
      {"plans", "combs, 200 changes of plan within the slots", {64, 512, 4096}, plans},
      {"bay", "a headland moves out of a bay, rough coasts", {64, 512, 4096, 65536}, bay_and_headland},
      {"continents", "Africa drifts towards South America", {0}, continents},
      {"africa", "the same at full resolution", {gshhg_vertices}, africa, gshhg_obstacle},
      {"africa, parting", "Africa drifts away from South America", {gshhg_vertices}, africa_parting, gshhg_obstacle},
      {"spiral", "a spiral screwed out of a spiral groove", {128, 512, 4096}, spiral},
  };
  return all;
}

std::vector<ContestFamily> chosen_families(const std::vector<std::string>& only) {
  std::vector<ContestFamily> out;
  for (const ContestFamily& family : contest_families()) {
    if (!only.empty() && std::find(only.begin(), only.end(), family.name) == only.end()) continue;
    if (const std::string obstacle = family.obstacle ? family.obstacle() : ""; !obstacle.empty()) {
      fmt::print(stderr, "{} is left out: {}\n", family.name, obstacle);
    } else {
      out.push_back(family);
    }
  }
  return out;
}

}  // namespace taut::bench
