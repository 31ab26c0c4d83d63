// Questions about worlds, timed: the same program for this machine and for WebAssembly in Node.js, which compare.py
// runs in turn.
//
// usage: taut_platform_worlds : of each question a line with its name, the milliseconds of one asking, and a number
// made of all that was answered, which is the same everywhere.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/motions.hpp"
#include "taut/simulation.hpp"
#include "taut/static_map.hpp"

namespace taut::bench {
namespace {

/// The same everywhere, which the distributions of the library are not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double within(double lo, double hi) { return lo + (hi - lo) * static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

/// Numbers of which each bit counts.
class Digest {
 public:
  void add(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    value_ = (value_ ^ bits) * 0x100000001b3u;
  }
  void add(const Answer& answer) {
    add(static_cast<double>(answer.outcome));
    add(answer.free_until);
    if (!answer.contact) return;
    add(answer.contact->time.lo);
    add(answer.contact->time.hi);
    add(answer.contact->vertex.index + 65536 * answer.contact->edge.index);
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// Sines are a library's own: nearby, but not the same. So corners are rounded to what all of them agree on.
double rounded(double x) { return std::round(x * 65536) / 65536; }

Polygon star(Dice& dice, int vertices, double x = 0, double y = 0) {
  Polygon polygon;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::numbers::pi * k / vertices,
                 radius = k % 2 ? dice.within(0.85, 1) : dice.within(0.4, 0.8);
    polygon.push_back({x + rounded(radius * std::cos(angle)), y + rounded(radius * std::sin(angle))});
  }
  return polygon;
}

Body body_of(const std::string& name, Polygon polygon) {
  Body body;
  body.name = name;
  body.polygon = std::move(polygon);
  return body;
}

/// On a grid with room between them.
std::vector<Body> stars(int side, int vertices) {
  Dice dice(7);
  std::vector<Body> all;
  for (int i = 0; i < side * side; ++i)
    all.push_back(body_of("star " + std::to_string(i), star(dice, vertices, 4 * (i % side), 4 * (i / side))));
  return all;
}

/// Between 2,500 obstacles of 12 vertices a cart goes 200 ways, which turn.
void ask_map(Digest& digest) {
  static const StaticMap map(stars(50, 12));
  static const StaticMap::Mover cart =
      map.prepare(body_of("cart", {{-0.5, -0.1}, {0.5, -0.1}, {0.5, 0.1}, {-0.5, 0.1}}));
  Dice dice(3);
  for (int k = 0; k < 200; ++k) {
    const double x = dice.within(0, 196), y = dice.within(0, 196);
    const Keyframe from{0, rounded(x), rounded(y), 0};
    const Keyframe to{1, rounded(x + dice.within(-20, 20)), rounded(y + dice.within(-20, 20)),
                      rounded(dice.within(-180, 180))};
    digest.add(map.check(cart, from_keyframes({from, to}), 0, 1));
  }
}

Scene drifting(int side, int vertices) {
  Dice dice(11);
  Scene scene;
  scene.end = 2;
  scene.bodies = stars(side, vertices);
  for (Body& body : scene.bodies) {
    const double vx = rounded(dice.within(-1, 1)), vy = rounded(dice.within(-1, 1)), spin = rounded(dice.within(-1, 1));
    // About its own middle.
    double x = 0, y = 0;
    for (const Point& p : body.polygon) x += p.x, y += p.y;
    x = std::round(x / static_cast<double>(body.polygon.size()));
    y = std::round(y / static_cast<double>(body.polygon.size()));
    for (Point& p : body.polygon) p = {p.x - x, p.y - y};
    body.motion.pieces = {{{x, vx}, {y, vy}, AngleRotation{{0, spin}}}};
  }
  return scene;
}

/// 400 stars of 64 vertices drift and spin until two of them meet.
void ask_stars(Digest& digest) {
  static const Scene scene = drifting(20, 64);
  digest.add(check(scene));
}

/// An arm of four links reaches into 64 posts, each link seen from the one before.
Scene arm() {
  Scene scene;
  scene.end = 4;
  scene.bodies = stars(8, 16);
  for (int k = 0; k < 4; ++k) {
    Body link = body_of("link " + std::to_string(k), {{-0.1, -0.1}, {3, -0.05}, {3.1, 0}, {3, 0.05}, {-0.1, 0.1}});
    MotionPiece way{{k == 0 ? -2.0 : 3.0}, {k == 0 ? 14.0 : 0.0}, AngleRotation{{0, k % 2 ? -0.25 : 0.125}}};
    link.motion.pieces = {way};
    if (k > 0) {
      link.relative_to = scene.bodies.back().name;
      scene.ignore.push_back({link.name, link.relative_to});
    }
    scene.bodies.push_back(link);
  }
  return scene;
}

void ask_arm(Digest& digest) {
  static const Scene scene = arm();
  digest.add(check(scene));
}

void ask_arm_clearance(Digest& digest) {
  static const Scene scene = [] {
    Scene all = arm();
    all.end = 0.25;
    return all;
  }();
  const Clearance found = clearance(scene);
  if (!found.nearest) return;
  digest.add(found.nearest->lo);
  digest.add(found.nearest->hi);
}

/// One of 400 drifting stars changes its plan 100 times.
void simulate(Digest& digest) {
  static const Scene scene = [] {
    Scene all = drifting(20, 12);
    all.end = 100;
    return all;
  }();
  Simulation simulation(scene);
  const MotionPiece& way = scene.bodies[210].motion.pieces[0];
  double x = way.x[0], speed = way.x[1];
  for (int k = 1; k <= 100; ++k) {
    const double now = k / 256.0;
    if (simulation.advance_to(now) != SimulationState::running) break;
    x += speed / 256;
    speed = (k % 7 - 3) / 8.0;
    MotionPiece next = way;
    next.x = {x - speed * now, speed};
    simulation.set_motion(210, Motion{{next}});
  }
  digest.add(simulation.time());
  digest.add(static_cast<double>(simulation.events()));
}

/// The best of some runs, for half a second or three times.
void time_of(const char* name, const std::function<void(Digest&)>& ask) {
  using Clock = std::chrono::steady_clock;
  Digest digest;
  ask(digest);
  double best = INFINITY, spent = 0;
  for (int run = 0; run < 3 || spent < 0.5; ++run) {
    Digest again;
    const Clock::time_point start = Clock::now();
    ask(again);
    const double lap = std::chrono::duration<double>(Clock::now() - start).count();
    best = std::min(best, lap);
    spent += lap;
    if (again.value() != digest.value()) std::printf("%s: not twice the same\n", name);
  }
  std::printf("%s\t%.6f\t%016llx\n", name, 1e3 * best, static_cast<unsigned long long>(digest.value()));
  std::fflush(stdout);
}

}  // namespace
}  // namespace taut::bench

int main() {
  using namespace taut::bench;
  time_of("200 ways through a map of 2,500 obstacles", ask_map);
  time_of("400 stars that drift and spin, to the first contact", ask_stars);
  time_of("an arm of four links among posts, to the first contact", ask_arm);
  time_of("its clearance for a quarter of a second", ask_arm_clearance);
  time_of("a simulation of 400 stars, one of which changes its plan 100 times", simulate);
  return 0;
}
