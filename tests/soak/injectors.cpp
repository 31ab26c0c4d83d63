#include "injectors.hpp"

#include <algorithm>
#include <cmath>

#include "taut/check.hpp"

namespace taut::testing {
namespace {

double nudged(Rng& rng, double x) { return std::nextafter(x, rng.below(2) ? INFINITY : -INFINITY); }

void nudge(Rng& rng, Scene& scene) {
  for (Body& body : scene.bodies) {
    for (Point& v : body.polygon) {
      if (rng.chance(0.3)) v.x = nudged(rng, v.x);
      if (rng.chance(0.3)) v.y = nudged(rng, v.y);
    }
  }
}

void share(Rng& rng, Scene& scene) {
  std::vector<Point> all;
  for (const Body& body : scene.bodies) all.insert(all.end(), body.polygon.begin(), body.polygon.end());
  for (int k = rng.between(1, 4); k > 0; --k) {
    Polygon& polygon = scene.bodies[static_cast<std::size_t>(rng.below(2))].polygon;
    Point& v = polygon[static_cast<std::size_t>(rng.below(static_cast<int>(polygon.size())))];
    rng.below(2) ? v.x = rng.pick(all).x : v.y = rng.pick(all).y;
  }
}

void put_into_edges(Rng& rng, Scene& scene) {
  for (Body& body : scene.bodies) {
    for (int k = rng.between(1, 4); k > 0; --k) {
      const auto i = static_cast<std::size_t>(rng.below(static_cast<int>(body.polygon.size())));
      const Point a = body.polygon[i], b = body.polygon[(i + 1) % body.polygon.size()];
      const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
      body.polygon.insert(body.polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1, middle);
    }
  }
}

void scale_all(Coefficients& c, double factor) {
  for (double& x : c) x *= factor;
}

void mirror(Rotation& rotation) {
  // In the mirror the angle changes its sign: (x, y) -> (-x, y) maps (cos, sin) frames to (cos, -sin) ones.
  if (auto* r = std::get_if<AngleRotation>(&rotation)) scale_all(r->angle, -1);
  if (auto* r = std::get_if<DirectionRotation>(&rotation)) scale_all(r->b, -1);
  if (auto* r = std::get_if<HalfAngleRotation>(&rotation)) scale_all(r->s, -1);
}

/// The second body: the first one seen in a mirror x = const.
void copy_mirrored(Rng& rng, Scene& scene) {
  const Body& first = scene.bodies[0];
  double right = -INFINITY, left = INFINITY;
  for (const Point& v : first.polygon) {
    right = std::max(right, v.x);
    left = std::min(left, v.x);
  }
  const double gap = (right - left) * std::ldexp(1.0, -rng.between(0, 8)), axis = right + gap / 2;
  Body copy = first;
  copy.name = scene.bodies[1].name;
  for (Point& v : copy.polygon) v.x = -v.x;
  std::reverse(copy.polygon.begin(), copy.polygon.end());
  if (copy.motion.pieces.empty()) copy.motion.pieces.emplace_back();
  for (MotionPiece& piece : copy.motion.pieces) {
    scale_all(piece.x, -1);
    if (piece.x.empty()) piece.x = {0};
    piece.x[0] += 2 * axis;
    mirror(piece.rotation);
  }
  scene.bodies[1] = copy;
}

void multiply(Scene& scene, double factor) {
  for (Body& body : scene.bodies) {
    for (Point& v : body.polygon) {
      v.x *= factor;
      v.y *= factor;
    }
    for (MotionPiece& piece : body.motion.pieces) {
      scale_all(piece.x, factor);
      scale_all(piece.y, factor);
    }
  }
}

void move_away(Rng& rng, Scene& scene) {
  const double far = std::exp(rng.real(std::log(1e6), std::log(1e9)));
  const double dx = rng.sign() * far, dy = rng.sign() * far * rng.unit();
  for (Body& body : scene.bodies) {
    if (body.motion.pieces.empty()) body.motion.pieces.emplace_back();
    for (MotionPiece& piece : body.motion.pieces) {
      piece.x.resize(std::max<std::size_t>(1, piece.x.size()));
      piece.y.resize(std::max<std::size_t>(1, piece.y.size()));
      piece.x[0] += dx;
      piece.y[0] += dy;
    }
  }
}

void start_near_contact(Rng& rng, Scene& scene) {
  const Answer answer = check(scene);
  if (!answer.contact || !(answer.contact->time.lo > scene.start)) return;
  const double t = answer.contact->time.lo, back = (t - scene.start) * std::ldexp(1.0, -rng.between(2, 60));
  const double start = rng.chance(0.2) ? answer.contact->time.hi : t - back;
  if (start >= scene.start && start <= scene.end) scene.start = start;
}

/// If both bodies rest but for one straight way, the mover's path becomes contact + way (t - 1/2)^m.
void touch_tangentially(Rng& rng, Scene& scene) {
  const Answer answer = check(scene);
  if (!answer.contact || !(answer.contact->time.lo > scene.start)) return;
  Body& mover = scene.bodies[scene.bodies[0].motion.pieces.empty() ? 1 : 0];
  const Body& other = scene.bodies[scene.bodies[0].motion.pieces.empty() ? 0 : 1];
  if (!other.motion.pieces.empty() || mover.motion.pieces.size() != 1) return;
  MotionPiece& piece = mover.motion.pieces[0];
  if (!std::holds_alternative<NoRotation>(piece.rotation) || piece.x.size() > 2 || piece.y.size() > 2 ||
      piece.origin != 0)
    return;
  const int degree = rng.between(2, 4);
  const double t = answer.contact->time.lo, middle = 0.5;
  // (t - 1/2)^m, ascending.
  const Coefficients powers[] = {{0.25, -1, 1}, {-0.125, 0.75, -1.5, 1}, {0.0625, -0.5, 1.5, -2, 1}};
  const Coefficients& way = powers[degree - 2];
  for (Coefficients* c : {&piece.x, &piece.y}) {
    c->resize(2);
    const double at_contact = (*c)[0] + (*c)[1] * t, speed = (*c)[1];
    c->assign(way.size(), 0);
    // Before the middle it comes from where it came from.
    const double side = degree % 2 ? 1 : -1;
    for (std::size_t k = 0; k < way.size(); ++k) (*c)[k] = side * speed * way[k];
    (*c)[0] += at_contact;
  }
  scene.start = 0;
  scene.end = 2 * middle;
}

}  // namespace

const char* to_string(Injection injection) {
  static const char* const names[] = {"none",   "nudges", "shared",     "collinear", "symmetric",
                                      "scaled", "offset", "near_start", "tangency"};
  return names[static_cast<std::size_t>(injection)];
}

Scene inject(Rng& rng, Injection injection, Scene scene) {
  switch (injection) {
    case Injection::nudges:
      nudge(rng, scene);
      break;
    case Injection::shared:
      share(rng, scene);
      break;
    case Injection::collinear:
      put_into_edges(rng, scene);
      break;
    case Injection::symmetric:
      copy_mirrored(rng, scene);
      break;
    case Injection::scaled:
      multiply(scene, std::exp(rng.real(std::log(1e-12), std::log(1e12))));
      break;
    case Injection::offset:
      move_away(rng, scene);
      break;
    case Injection::near_start:
      start_near_contact(rng, scene);
      break;
    case Injection::tangency:
      touch_tangentially(rng, scene);
      break;
    default:
      break;
  }
  return scene;
}

}  // namespace taut::testing
