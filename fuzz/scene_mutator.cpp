#include "scene_mutator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/rotation_forms.hpp"
#include "support/random_scenes.hpp"

namespace taut::fuzz {
using namespace internal;
namespace {

using testing::Rng;

std::size_t index_below(Rng& rng, std::size_t n) { return static_cast<std::size_t>(rng.below(static_cast<int>(n))); }

std::vector<Coefficients*> polynomials(MotionPiece& piece) {
  std::vector<Coefficients*> all = {&piece.x, &piece.y};
  for_each_polynomial(piece.rotation, [&](Coefficients& c) { all.push_back(&c); });
  return all;
}

double value(const Coefficients& c, double t) {
  double v = 0;
  for (std::size_t k = c.size(); k-- > 0;) v = v * t + c[k];
  return v;
}

double changed(Rng& rng, double x, double scale) {
  switch (rng.below(5)) {
    case 0:
      return std::nextafter(x, rng.below(2) ? INFINITY : -INFINITY);
    case 1:
      return x + rng.sign() * scale / 4;
    case 2:
      return std::floor(x + 0.5);
    case 3:
      return x + rng.real(-scale, scale);
    default:
      return -x;
  }
}

double extent(const Polygon& polygon) {
  double r = 1e-9;
  for (const Point& v : polygon) r = std::max({r, std::fabs(v.x - polygon[0].x), std::fabs(v.y - polygon[0].y)});
  return r;
}

void change_vertex(Rng& rng, Scene& scene) {
  Polygon& polygon = scene.bodies[index_below(rng, 2)].polygon;
  const Polygon& other = scene.bodies[index_below(rng, 2)].polygon;
  const std::size_t i = index_below(rng, polygon.size());
  Point& v = polygon[i];
  const Point before = polygon[(i + polygon.size() - 1) % polygon.size()], after = polygon[(i + 1) % polygon.size()];
  double& x = rng.below(2) ? v.x : v.y;
  switch (rng.below(6)) {
    case 0:
      v.x = other[index_below(rng, other.size())].x;
      break;
    case 1:
      v.y = other[index_below(rng, other.size())].y;
      break;
    case 2:
      v = {(before.x + after.x) / 2, (before.y + after.y) / 2};
      break;
    default:
      x = changed(rng, x, extent(polygon));
      break;
  }
}

void change_count(Rng& rng, Scene& scene) {
  Polygon& polygon = scene.bodies[index_below(rng, 2)].polygon;
  const std::size_t i = index_below(rng, polygon.size());
  const auto at = polygon.begin() + static_cast<std::ptrdiff_t>(i);
  if (polygon.size() > 3 && rng.below(2)) {
    polygon.erase(at);
    return;
  }
  const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
  const double bulge = rng.below(2) ? 0 : rng.real(-0.25, 0.25);
  polygon.insert(at + 1, {(a.x + b.x) / 2 - bulge * (b.y - a.y), (a.y + b.y) / 2 + bulge * (b.x - a.x)});
}

MotionPiece& some_piece(Rng& rng, Body& body) {
  if (body.motion.pieces.empty()) body.motion.pieces.emplace_back();
  return body.motion.pieces[index_below(rng, body.motion.pieces.size())];
}

void change_coefficient(Rng& rng, Scene& scene) {
  Body& body = scene.bodies[index_below(rng, 2)];
  const std::vector<Coefficients*> all = polynomials(some_piece(rng, body));
  Coefficients& c = *all[index_below(rng, all.size())];
  if (c.empty() || rng.chance(0.2)) c.push_back(0);
  double& x = c[index_below(rng, c.size())];
  x = rng.chance(0.2) ? 0 : changed(rng, x, rng.chance(0.5) ? 1 : extent(body.polygon));
}

void change_rotation(Rng& rng, Scene& scene) {
  MotionPiece& piece = some_piece(rng, scene.bodies[index_below(rng, 2)]);
  const double speed = rng.below(9) / 4.0 - 1;
  const Rotation functions[] = {NoRotation{}, AngleRotation{{0, speed}}, DirectionRotation{{1}, {0, speed}},
                                HalfAngleRotation{{0, speed}}, CosineRotation{{1, -std::fabs(speed) / 2}}};
  piece.rotation = functions[rng.below(5)];
  // Often a corner, of either body: what turns about it stays in touch with it.
  const Polygon& around = scene.bodies[index_below(rng, 2)].polygon;
  if (rng.below(2)) piece.pivot = rng.below(3) ? around[index_below(rng, around.size())] : Point{};
}

/// From some instant on, a body moves otherwise: what a change of plan is.
void add_joint(Rng& rng, Scene& scene) {
  Body& body = scene.bodies[index_below(rng, 2)];
  if (body.motion.pieces.empty()) body.motion.pieces.emplace_back();
  std::vector<MotionPiece>& pieces = body.motion.pieces;
  const Body& other = scene.bodies[index_below(rng, 2)];
  double t = scene.start + (scene.end - scene.start) * rng.below(17) / 16;
  if (!other.motion.pieces.empty() && rng.below(2)) t = other.motion.pieces[0].until;  // both at once
  if (!(t > scene.start && t < scene.end)) return;
  std::size_t k = 0;
  while (k + 1 < pieces.size() && pieces[k].until <= t) ++k;
  MotionPiece after = pieces[k];
  const bool since_joint = rng.below(2);
  const double since = since_joint ? 0 : t - after.origin;
  for (Coefficients* c : polynomials(after)) {
    if (!since_joint && rng.below(2)) continue;
    const double slope = rng.below(2) ? 0 : rng.real(-2, 2) * extent(body.polygon) / (scene.end - scene.start);
    *c = {value(*c, t - after.origin) - slope * since, slope};
  }
  if (since_joint) after.origin = t;
  pieces[k].until = t;
  pieces.insert(pieces.begin() + static_cast<std::ptrdiff_t>(k) + 1, after);
}

void change_time(Rng& rng, Scene& scene) {
  const double length = scene.end - scene.start;
  switch (rng.below(4)) {
    case 0:
      scene.start += length / 4;
      break;
    case 1:
      scene.end -= length / 4;
      break;
    case 2:
      scene.end += length;
      break;
    default:
      scene.end = std::floor(scene.end + 1);
      break;
  }
}

void change_size(Rng& rng, Scene& scene) {
  const double factor = rng.below(2) ? 2 : rng.real(0.5, 2);
  Body& body = scene.bodies[index_below(rng, 2)];
  for (Point& v : body.polygon) v = {v.x * factor, v.y * factor};
}

void shrink_to(Rng& rng, Scene& scene, const SceneSize& size) {
  for (Body& body : scene.bodies) {
    while (body.polygon.size() > size.vertices)
      body.polygon.erase(body.polygon.begin() + static_cast<std::ptrdiff_t>(index_below(rng, body.polygon.size())));
    std::vector<MotionPiece>& pieces = body.motion.pieces;
    if (pieces.size() > size.pieces) {
      pieces.resize(size.pieces);
      scene.end = std::min(scene.end, pieces.back().until);
    }
    for (MotionPiece& piece : pieces) {
      for (Coefficients* c : polynomials(piece)) c->resize(std::min(c->size(), size.degree + 1));
    }
  }
}

}  // namespace

bool fits(const Scene& scene, const SceneSize& size) {
  for (Body body : scene.bodies) {
    if (body.polygon.size() > size.vertices || body.motion.pieces.size() > size.pieces) return false;
    for (MotionPiece& piece : body.motion.pieces) {
      for (const Coefficients* c : polynomials(piece)) {
        if (c->size() > size.degree + 1) return false;
      }
    }
  }
  return true;
}

Scene mutated(Rng& rng, Scene scene, const SceneSize& size) {
  switch (rng.below(12)) {
    case 0:
      change_count(rng, scene);
      break;
    case 1:
    case 2:
      change_coefficient(rng, scene);
      break;
    case 3:
      change_rotation(rng, scene);
      break;
    case 4:
    case 5:
      add_joint(rng, scene);
      break;
    case 6:
      change_time(rng, scene);
      break;
    case 7:
      std::swap(scene.bodies[0].motion, scene.bodies[1].motion);
      break;
    case 8:
      change_size(rng, scene);
      break;
    default:
      change_vertex(rng, scene);
      break;
  }
  shrink_to(rng, scene, size);
  return scene;
}

}  // namespace taut::fuzz
