#include "support/small_world.hpp"

#include <algorithm>

namespace taut::testing {
namespace {

int few_bodies(Rng& rng) { return rng.chance(0.7) ? rng.between(2, 4) : rng.between(5, 8); }

Polygon bar_of_room(double x, double y, double w, double h) { return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}}; }

/// Eight by six, with walls one thick. Pillars stand in its corners and stay clear of its middle.
MadeBody room(Rng& rng) {
  MadeBody body;
  body.parts = {{bar_of_room(0, 0, 8, 6), {bar_of_room(1, 1, 6, 4)}}};
  for (int k = rng.chance(0.6) ? rng.between(1, 3) : 0; k > 0; --k) {
    const Point at{rng.chance(0.5) ? 2.0 : 6.0, rng.chance(0.5) ? 1.75 : 4.25};
    // Some lean on the wall.
    body.parts.push_back(rng.chance(0.5) ? Part{bar_of_room(at.x, at.y < 3 ? 1 : 4, 0.5, 1), {}}
                                         : star_part(rng, at, 0.4, 0));
  }
  body.pivot = rng.chance(0.5) ? Point{4, 3} : Point{};
  return body;
}

/// Whole steps along the axes, so that faces meet faces, or any way at all.
std::vector<Keyframe> way_in_room(Rng& rng, const MadeWorld& world, const Point& at) {
  if (rng.chance(0.5)) return random_keyframes(rng, world.end, 2.5, at);
  std::vector<Keyframe> keyframes{{}};
  const int segments = 1 << rng.below(3);
  for (int i = 1; i <= segments; ++i) {
    Keyframe k = keyframes.back();
    k.t = world.end * i / segments;
    (rng.chance(0.5) ? k.x : k.y) += rng.between(-2, 2) * 0.5;
    if (rng.chance(0.2)) k.angle_deg += 90 * rng.sign();
    keyframes.push_back(k);
  }
  return keyframes;
}

MadeWorld rooms(Rng& rng, int n) {
  MadeWorld world;
  world.bodies.push_back(room(rng));
  if (rng.chance(0.3)) world.bodies[0].keyframes = random_keyframes(rng, world.end, 2, {4, 3});
  for (int i = 1; i < n; ++i) {
    const Point at{2.5 + 1.5 * ((i - 1) % 3), i > 3 ? 3.75 : 2.5};
    MadeBody body;
    body.parts = {rng.chance(0.5) ? Part{bar_of_room(at.x - 0.25, at.y - 0.25, 0.5, 0.5 * rng.between(1, 2)), {}}
                                  : star_part(rng, at, 0.5, rng.chance(0.2) ? 0.6 : 0)};
    body.pivot = rng.chance(0.7) ? at : Point{};
    if (i == 1 || rng.chance(0.6)) body.keyframes = way_in_room(rng, world, at);
    if (rng.chance(0.25)) body.parent = rng.below(i);
    world.bodies.push_back(body);
  }
  return world;
}

/// Two bodies to the right of x = 1 and above y = 1, which often meet.
MadeWorld two_to_be_tied(Rng& rng) {
  if (rng.chance(0.4)) return world_of_family(1, rng, 2).world;
  MadeWorld world;
  for (const Point at : {Point{3, 3}, Point{6.5, 3}}) {
    MadeBody body;
    body.pivot = at;
    body.parts = {star_part(rng, at, 1.5, 0)};
    if (at.x == 3 || rng.chance(0.3)) body.keyframes = random_keyframes(rng, world.end, 4, at);
    // Towards the other one.
    for (Keyframe& k : body.keyframes) k.x += (at.x == 3 ? 0.5 : -0.5) * k.t;
    world.bodies.push_back(body);
  }
  return world;
}

MadeWorld tied(Rng& rng, int n) {
  struct Copy {
    Transform change;
    bool mirrors;
    Point by;
  };
  const Copy copies[] = {{[](const Point& p) {
                            return Point{-p.x, p.y};
                          },
                          true,
                          {-2, 0}},
                         {[](const Point& p) {
                            return Point{p.x, -p.y};
                          },
                          true,
                          {0, -2}},
                         {[](const Point& p) {
                            return Point{-p.y, p.x};
                          },
                          false,
                          {-3, 0}},
                         {[](const Point& p) {
                            return Point{2 * p.x, 2 * p.y};
                          },
                          false,
                          {0, 16}},
                         {[](const Point& p) { return p; }, false, {16, 0}}};
  MadeWorld world = two_to_be_tied(rng);
  for (int k = rng.below(5); static_cast<int>(world.bodies.size()) + 2 <= std::max(n, 4); k = (k + 1) % 5) {
    const int shift = static_cast<int>(world.bodies.size());
    for (int i = 0; i < 2; ++i) {
      const Copy& copy = copies[k];
      MadeBody body = transformed(world.bodies[static_cast<std::size_t>(i)], copy.change, copy.mirrors, copy.by);
      if (body.parent >= 0) body.parent += shift;
      world.bodies.push_back(body);
    }
  }
  return world;
}

}  // namespace

LargeWorld small_world(std::uint64_t number) {
  Rng rng(number * 0x9e3779b97f4a7c15u + 193);
  const int family = rng.below(world_families + 2), n = few_bodies(rng);
  LargeWorld made = family < world_families    ? world_of_family(family, rng, n)
                    : family == world_families ? LargeWorld{rooms(rng, n), "rooms"}
                                               : LargeWorld{tied(rng, n), "tied"};
  finish_world(rng, made.world);
  return made;
}

}  // namespace taut::testing
