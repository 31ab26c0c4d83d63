#include "support/contact_scene.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "support/contact_motions.hpp"
#include "support/contact_shapes.hpp"

namespace taut::testing {
namespace {

/// Two shapes that fit, or are at least of the same lattice.
struct FittingPair {
  Polygon p, q;
  bool sharp;
};

FittingPair fitting_pair(Rng& rng) {
  FittingPair pair;
  pair.sharp = rng.chance(0.5);
  const ShortMap map = random_map(rng, pair.sharp);
  pair.p = random_shape(rng, map);
  if (rng.chance(0.7)) {
    pair.q = random_shape(rng, map);
    const Point flip{rng.chance(0.5) ? -1.0 : 1.0, 0};
    for (Point& v : pair.q) v = {flip.x * v.x, flip.x * v.y};
  } else {
    pair.q = random_shape(rng, random_map(rng, rng.chance(0.4)));
  }
  return pair;
}

double random_instant(Rng& rng) { return rng.pick(std::vector<double>{0, 0.5, 1, 1, 1.5, 2, 2, 3}); }

Scene scene_of(const FittingPair& pair, double end) {
  Scene scene;
  scene.end = end;
  scene.bodies = {Body{"P", pair.p, {}}, Body{"Q", pair.q, {}}};
  return scene;
}

MotionPiece& piece_of(Body& body) {
  if (body.motion.pieces.empty()) body.motion.pieces.emplace_back();
  return body.motion.pieces[0];
}

void add_way(MotionPiece& piece, const Point& d, const Coefficients& along) {
  Coefficients x = along, y = along;
  for (double& c : x) c *= d.x;
  for (double& c : y) c *= d.y;
  piece.x = sum(piece.x, x);
  piece.y = sum(piece.y, y);
}

/// A place of Q comes to one of P at t = `at`, along a power of t or there and back.
void meet(Rng& rng, Scene& scene, double at) {
  const Polygon &p = scene.bodies[0].polygon, &q = scene.bodies[1].polygon;
  const Point there = random_place(rng, p), own = random_place(rng, q), d = random_way(rng, p, q);
  MotionPiece& piece = piece_of(scene.bodies[1]);
  add_way(piece, {there.x - own.x, there.y - own.y}, {1});
  add_way(piece, d, power(rng.chance(0.5) ? 1 : 2, at, rng.chance(0.6) ? 1 : rng.between(2, 6)));
  if (rng.chance(0.3)) add_way(piece, random_way(rng, p, q), power(rng.sign(), at, rng.between(1, 4)));
}

/// What both do does not change where they meet.
void move_both(Rng& rng, Scene& scene) {
  const Point d{double(rng.between(-3, 3)), double(rng.between(-3, 3))};
  const Coefficients along = power(1, random_instant(rng), rng.between(1, 3));
  for (Body& body : scene.bodies) add_way(piece_of(body), d, along);
}

Scene slide(Rng& rng, bool& sharp) {
  const FittingPair pair = fitting_pair(rng);
  sharp = pair.sharp;
  Scene scene = scene_of(pair, rng.between(2, 4));
  meet(rng, scene, random_instant(rng));
  if (rng.chance(0.3)) move_both(rng, scene);
  return scene;
}

/// One of the bodies or both turn about a vertex, which may be where they meet.
Scene turn_about(Rng& rng) {
  Scene scene = scene_of(fitting_pair(rng), 1);
  if (rng.chance(0.6)) {
    meet(rng, scene, rng.below(2));
  } else {
    const Point d = random_way(rng, scene.bodies[0].polygon, scene.bodies[1].polygon);
    add_way(piece_of(scene.bodies[1]), d, {double(rng.between(1, 3))});
  }
  const Rotation common = quarter_turn(rng, 0, rng.chance(0.3), 0);
  const bool together = rng.chance(0.1);
  for (std::size_t b = rng.chance(0.5) ? 0 : 1; b < 2; ++b) {
    Body& body = scene.bodies[b];
    MotionPiece& piece = piece_of(body);
    piece.rotation = together ? common : quarter_turn(rng, 0, rng.chance(0.3), 0);
    piece.pivot = rng.chance(0.7) ? rng.pick(body.polygon) : random_place(rng, scene.bodies[1 - b].polygon);
    if (rng.chance(0.2)) scene.start = 0.25;
  }
  return scene;
}

/// Slides and quarter turns by turns, on the lattice, one in each unit of time.
Motion stepwise(Rng& rng, const Polygon& own, const Polygon& other, int count) {
  Motion motion;
  const Point pivot = rng.pick(own);
  Point at = random_way(rng, own, other);
  at = {pivot.x + 2 * at.x, pivot.y + 2 * at.y};
  int quarters = rng.below(4);
  for (int k = 0; k < count; ++k) {
    MotionPiece piece;
    piece.pivot = pivot;
    piece.x = {at.x - pivot.x};
    piece.y = {at.y - pivot.y};
    if (rng.chance(0.5)) {
      const Point d = random_way(rng, own, other);
      piece.rotation = held(rng, quarters);
      if (std::holds_alternative<NoRotation>(piece.rotation)) piece.pivot = {};
      add_way(piece, d, power(1, k, 1));
      at = {at.x + d.x, at.y + d.y};
    } else {
      const bool clockwise = rng.chance(0.4);
      piece.rotation = quarter_turn(rng, quarters, clockwise, k);
      // About a quarter is not a quarter.
      if (std::holds_alternative<AngleRotation>(piece.rotation))
        piece.rotation = HalfAngleRotation{power(clockwise ? -1 : 1, k, 1)};
      quarters = (quarters + (clockwise ? 3 : 1)) % 4;
    }
    if (k + 1 < count) piece.until = k + 1;
    motion.pieces.push_back(std::move(piece));
  }
  return motion;
}

Scene joints(Rng& rng) {
  FittingPair pair = fitting_pair(rng);
  const int count = rng.between(2, 4);
  Scene scene = scene_of(pair, count);
  scene.bodies[1].motion = stepwise(rng, pair.q, pair.p, count);
  if (rng.chance(0.4)) scene.bodies[0].motion = stepwise(rng, pair.p, pair.q, count);
  return scene;
}

/// The lowest vertex of a body that rocks comes down to a face, and touches it with a multiplicity of 2 to 6.
Scene graze(Rng& rng) {
  Scene scene;
  const double width = rng.between(1, 4), tip = rng.chance(0.5) ? 1 : std::ldexp(1, -rng.between(4, 20));
  const double reach = rng.between(1, 3), at = rng.pick(std::vector<double>{0, 0.5, 1, 1, 1.5});
  scene.end = 2;
  scene.bodies = {Body{"P", {{-8, -2}, {8, -2}, {8, 0}, {0, 0}, {-8, 0}}, {}},
                  Body{"Q", {{0, -reach}, {tip, 1}, {width + tip, 2}, {-tip, 1}}, {}}};
  if (rng.chance(0.3)) scene.bodies[0].polygon = {{-width, -0.5}, {width, -0.5}, {width, 0}, {-width, 0}};
  MotionPiece& piece = piece_of(scene.bodies[1]);
  piece.rotation = flat_turn(rng, rng.sign() * rng.pick(std::vector<double>{0.25, 0.5, 1}), at, rng.between(1, 3));
  piece.y = {reach};
  if (rng.chance(0.6))
    piece.y = sum(piece.y, power(rng.sign() * rng.pick(std::vector<double>{0.125, 0.5, 1}), at, rng.between(1, 6)));
  if (rng.chance(0.5)) piece.x = power(rng.sign(), at, rng.between(1, 3));
  if (rng.chance(0.3)) {
    // The same seen from a body that rocks as well.
    MotionPiece& wall = piece_of(scene.bodies[0]);
    wall.rotation = flat_turn(rng, rng.sign() * 0.25, at, rng.between(1, 4));
  }
  return scene;
}

/// A cosine that comes close to 1 or -1 on its way, and turns back: as rounded coefficients make of one that reaches
/// it.
CosineRotation near_extreme(Rng& rng) {
  const double missing = std::ldexp(1, -rng.between(8, 50)), second = rng.pick(std::vector<double>{0.5, 1, 2});
  Coefficients a = sum({1 - missing}, power(-second, 0.5, 2));
  if (rng.chance(0.5)) {
    for (double& c : a) c = -c;
  }
  return {a};
}

/// A cosine that is 1 or -1 at an end of the time, or on its way, or nearly.
Scene cosine_ends(Rng& rng) {
  static const Coefficients cosines[] = {{1, -1}, {1, -0.5}, {0, 1},     {-1, 1},    {0, -1},       {1, 0, -1},
                                         {1, -2}, {-1, 2},   {-1, 0, 1}, {1, 0, -2}, {1, 0, 0, -1}, {0, 2, -1}};
  Scene scene = scene_of(fitting_pair(rng), 1);
  meet(rng, scene, rng.below(2));
  for (std::size_t b = rng.chance(0.5) ? 0 : 1; b < 2; ++b) {
    Body& body = scene.bodies[b];
    MotionPiece& piece = piece_of(body);
    piece.rotation =
        rng.chance(0.2) ? near_extreme(rng) : CosineRotation{cosines[rng.below(static_cast<int>(std::size(cosines)))]};
    piece.pivot = rng.chance(0.8) ? rng.pick(body.polygon) : Point{};
    if (b == 0 && rng.chance(0.3)) piece.rotation = quarter_turn(rng, 0, rng.chance(0.3), 0);
  }
  return scene;
}

}  // namespace

ContactScene contact_scene(std::uint64_t number) {
  Rng rng(number * 0x9e3779b97f4a7c15u + 71);
  ContactScene s;
  s.touch = rng.chance(0.5) ? Touch::closed : Touch::open;
  bool sharp = false;
  switch (rng.below(6)) {
    case 0:
    case 1:
      s.scene = slide(rng, sharp);
      s.family = sharp ? "blades" : "slides";
      break;
    case 2:
      s.scene = turn_about(rng);
      s.family = "turns";
      break;
    case 3:
      s.scene = joints(rng);
      s.family = "joints";
      break;
    case 4:
      s.scene = graze(rng);
      s.family = "grazes";
      break;
    default:
      s.scene = cosine_ends(rng);
      s.family = "cosine_ends";
  }
  if (rng.chance(0.2)) std::swap(s.scene.bodies[0], s.scene.bodies[1]);
  return s;
}

}  // namespace taut::testing
