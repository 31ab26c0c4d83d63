#include "support/large_world.hpp"

#include <algorithm>

namespace taut::testing {
namespace {

/// Few bodies often, many now and then.
int body_count(Rng& rng) { return rng.chance(0.85) ? rng.between(2, 9) : rng.between(10, 60); }

int depth_of(const MadeWorld& world, int body) {
  int depth = 0;
  for (; body >= 0; body = world.bodies[static_cast<std::size_t>(body)].parent) ++depth;
  return depth;
}

void name_bodies(MadeWorld& world) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) world.bodies[i].name = "b" + std::to_string(i);
}

void ignore_some(Rng& rng, MadeWorld& world) {
  const int n = static_cast<int>(world.bodies.size());
  for (int k = rng.chance(0.4) ? rng.between(1, 4) : 0; k > 0; --k)
    world.ignore.push_back({rng.below(n), rng.chance(0.1) ? -1 : rng.below(n)});
}

MadeWorld cells(Rng& rng, int n) {
  MadeWorld world;
  const double moving = rng.real(0.2, 0.9), reach = rng.real(1, 6);
  const int columns = rng.between(2, 8);
  for (int i = 0; i < n; ++i) {
    const Point at{4.0 * (i % columns), 4.0 * (i / columns)};
    MadeBody body;
    body.parts = {star_part(rng, at, rng.real(0.6, 1.9), rng.chance(0.2) ? 0.75 : 0)};
    if (rng.chance(0.2)) body.parts.push_back(star_part(rng, {at.x + rng.real(-1, 1), at.y}, 0.7, 0));
    body.pivot = rng.chance(0.7) ? at : Point{};
    if (rng.chance(moving)) body.keyframes = random_keyframes(rng, world.end, reach, at);
    // Often the one before, so that chains get long.
    if (i > 0 && rng.chance(0.3)) body.parent = rng.chance(0.6) ? i - 1 : rng.below(i);
    if (depth_of(world, body.parent) > 6) body.parent = -1;
    world.bodies.push_back(body);
  }
  return world;
}

Polygon box_ring(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

/// A bar, two bars on each other, an angle, a channel, or a frame: all corners at whole numbers.
std::vector<Part> grid_parts(Rng& rng, double x, double y) {
  const int w = rng.between(2, 3), h = rng.between(2, 3);
  const double r = x + w, t = y + h;
  switch (rng.below(5)) {
    case 0:
      return {{box_ring(x, y, w, h), {}}};
    case 1:
      return {{box_ring(x, y, w, 1), {}}, {box_ring(x, y + 1, 1, h), {}}};
    case 2:
      return {{{{x, y}, {r, y}, {r, y + 1}, {x + 1, y + 1}, {x + 1, t}, {x, t}}, {}}};
    case 3:
      return {{{{x, y}, {x + 3, y}, {x + 3, t}, {x + 2, t}, {x + 2, y + 1}, {x + 1, y + 1}, {x + 1, t}, {x, t}}, {}}};
    default:
      return {{box_ring(x, y, 3, 3), {box_ring(x + 1, y + 1, 1, 1)}}};
  }
}

/// Straight ways from one grid point to the next, now and then with a quarter turn on the way.
std::vector<Keyframe> grid_keyframes(Rng& rng, double end) {
  std::vector<Keyframe> keyframes{{}};
  const bool turns = rng.chance(0.2);
  const int segments = 1 << rng.below(3);
  for (int i = 1; i <= segments; ++i) {
    Keyframe k = keyframes.back();
    k.t = end * i / segments;
    (rng.chance(0.5) ? k.x : k.y) += rng.between(-4, 4);
    if (rng.chance(0.3)) k.y += rng.between(-2, 2);
    if (turns && rng.chance(0.5)) k.angle_deg += 90 * rng.sign();
    keyframes.push_back(k);
  }
  return keyframes;
}

MadeWorld grid(Rng& rng, int n) {
  MadeWorld world;
  const int columns = rng.between(2, 8), pitch = rng.between(4, 6);
  const double moving = rng.real(0.2, 0.9);
  for (int i = 0; i < n; ++i) {
    const double x = pitch * (i % columns), y = pitch * (i / columns);
    MadeBody body;
    body.parts = grid_parts(rng, x, y);
    body.pivot = {x, y};
    if (rng.chance(moving)) body.keyframes = grid_keyframes(rng, world.end);
    if (i > 0 && rng.chance(0.2)) body.parent = rng.below(i);
    if (depth_of(world, body.parent) > 6) body.parent = -1;
    world.bodies.push_back(body);
  }
  return world;
}

MadeBody mirrored_body(const MadeBody& of, int shift) {
  const auto mirror = [](const Point& p) { return Point{-p.x, p.y}; };
  MadeBody body = transformed(of, mirror, true);
  if (body.parent >= 0) body.parent += shift;
  return body;
}

MadeWorld mirrored(Rng& rng, int n) {
  MadeWorld world = cells(rng, (n + 1) / 2);
  const int half = static_cast<int>(world.bodies.size());
  // On the right of the mirror, x = 0; bodies of cells start at most 2.7 to the left of their first column.
  for (MadeBody& body : world.bodies) {
    const auto shift = [](Point& p) { p.x += 3; };
    if (!(body.pivot == Point{})) shift(body.pivot);
    for (Part& part : body.parts) {
      std::for_each(part.outline.begin(), part.outline.end(), shift);
      for (Polygon& hole : part.holes) std::for_each(hole.begin(), hole.end(), shift);
    }
    for (Keyframe& k : body.keyframes) shift(k.centre);
  }
  for (int i = 0; i < half; ++i) world.bodies.push_back(mirrored_body(world.bodies[static_cast<std::size_t>(i)], half));
  return world;
}

/// Rings of one centre, each with room for the next one; what is inside stays with its ring or moves a little.
MadeWorld nested(Rng& rng, int n) {
  MadeWorld world;
  for (int cell = 0; static_cast<int>(world.bodies.size()) < n; ++cell) {
    const Point at{9.0 * (cell % 4), 9.0 * (cell / 4)};
    double radius = 4;
    const int deep = rng.between(2, 4);
    for (int i = 0; i < deep && static_cast<int>(world.bodies.size()) < n; ++i) {
      MadeBody body;
      body.pivot = at;
      body.parts = {star_part(rng, at, radius, i + 1 < deep ? 0.8 : 0)};
      if (rng.chance(0.5)) body.keyframes = random_keyframes(rng, world.end, i == 0 ? 3 : 0.4 * radius, at);
      if (i > 0 && rng.chance(0.6)) body.parent = static_cast<int>(world.bodies.size()) - 1;
      if (depth_of(world, body.parent) > 6) body.parent = -1;
      world.bodies.push_back(body);
      // Corners of the hole at 0.85 * 0.8 of the radius, its edges nearer to the centre.
      radius *= 0.45;
    }
  }
  return world;
}

void add_arm(Rng& rng, MadeWorld& world, const Point& base, int links) {
  double x = base.x;
  for (int i = 0; i < links; ++i) {
    const double length = sixteenths(rng, 1, 2.5);
    MadeBody link;
    link.pivot = {x, base.y};
    link.parts = {{box_ring(x - 0.125, base.y - 0.125, length + 0.25, 0.25), {}}};
    if (i + 1 == links) link.parts.push_back(star_part(rng, {x + length, base.y}, 0.4, 0));
    const int index = static_cast<int>(world.bodies.size());
    if (i > 0) {
      link.parent = index - 1;
      world.ignore.push_back({index - 1, index});
    }
    Keyframe k;
    link.keyframes = {k};
    for (int segment = 1; segment <= 2; ++segment) {
      k.t = world.end * segment / 2;
      k.angle_deg += rng.between(-100, 100);
      link.keyframes.push_back(k);
    }
    world.bodies.push_back(link);
    x += length;
  }
}

MadeWorld arms(Rng& rng, int n) {
  MadeWorld world;
  for (int k = 0; static_cast<int>(world.bodies.size()) < n; ++k) {
    const Point at{7.0 * (k % 5), 7.0 * (k / 5)};
    const int room = n - static_cast<int>(world.bodies.size());
    if (k == 0 || rng.chance(0.3)) {
      add_arm(rng, world, at, std::min(room, rng.between(1, 7)));
    } else {
      MadeBody obstacle;
      obstacle.parts = {star_part(rng, {at.x, at.y + 2}, rng.real(0.4, 1.5), rng.chance(0.2) ? 0.6 : 0)};
      obstacle.pivot = {at.x, at.y + 2};
      world.bodies.push_back(obstacle);
    }
  }
  return world;
}

}  // namespace

LargeWorld world_of_family(int family, Rng& rng, int bodies) {
  struct Maker {
    const char* family;
    MadeWorld (*make)(Rng&, int);
  };
  const Maker makers[] = {{"cells", cells}, {"grid", grid}, {"mirrored", mirrored}, {"nested", nested}, {"arms", arms}};
  const Maker& maker = makers[family];
  return {maker.make(rng, bodies), maker.family};
}

void finish_world(Rng& rng, MadeWorld& world) {
  name_bodies(world);
  ignore_some(rng, world);
}

LargeWorld large_world(std::uint64_t number) {
  Rng rng(number * 0x9e3779b97f4a7c15u + 71);
  const int family = rng.below(world_families);
  LargeWorld made = world_of_family(family, rng, body_count(rng));
  finish_world(rng, made.world);
  return made;
}

MadeWorld with_one_mover(MadeWorld world, int mover) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    world.bodies[i].parent = -1;
    if (static_cast<int>(i) != mover) world.bodies[i].keyframes.clear();
  }
  world.ignore.clear();
  return world;
}

}  // namespace taut::testing
