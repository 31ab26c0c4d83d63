#include "comparison/moving_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "generators/shapes.hpp"
#include "taut/error.hpp"

namespace taut::paper {
namespace {

double area_of(const Polygon& ring) {
  double twice = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
    twice += (a.x - ring[0].x) * (b.y - ring[0].y) - (a.y - ring[0].y) * (b.x - ring[0].x);
  }
  return twice / 2;
}

/// The polynomial's value and slope.
struct ValueAndSlope {
  double value = 0, slope = 0;
};
ValueAndSlope evaluate(const Coefficients& c, double t) {
  ValueAndSlope out;
  for (std::size_t k = c.size(); k-- > 0;) {
    out.slope = out.slope * t + out.value;
    out.value = out.value * t + c[k];
  }
  return out;
}

/// Bounds on the first and the second derivative over [t, t + h], from the expansion at t.
struct Derivatives {
  double first = 0, second = 0;
};
Derivatives derivatives(const Coefficients& c, double t, double h) {
  if (c.size() < 2) return {};
  if (c.size() == 2) return {std::fabs(c[1]), 0};
  double shifted[max_degree + 1];
  std::copy(c.begin(), c.end(), shifted);
  for (std::size_t k = 0; k + 1 < c.size(); ++k)
    for (std::size_t j = c.size() - 1; j-- > k;) shifted[j] += t * shifted[j + 1];
  Derivatives out;
  for (std::size_t k = c.size() - 1; k >= 1; --k) {
    const auto degree = static_cast<double>(k);
    out.first = out.first * h + degree * std::fabs(shifted[k]);
    if (k >= 2) out.second = out.second * h + degree * (degree - 1) * std::fabs(shifted[k]);
  }
  return out;
}

}  // namespace

MovingBodies::MovingBodies(const Scene& scene) {
  first_.push_back(0);
  for (const Body& body : scene.bodies) {
    if (body.polygon.size() < 3 || !body.relative_to.empty())
      throw InputError(body.name, "the comparison takes bodies of one polygon, in the world's frame");
    Polygon ring = body.polygon;
    if (area_of(ring) < 0) std::reverse(ring.begin(), ring.end());
    drawn_.insert(drawn_.end(), ring.begin(), ring.end());
    body_.insert(body_.end(), ring.size(), static_cast<int>(first_.size()) - 1);
    first_.push_back(static_cast<int>(drawn_.size()));
    std::vector<Piece> pieces;
    for (const MotionPiece& given : body.motion.pieces) {
      const auto* angle = std::get_if<AngleRotation>(&given.rotation);
      if (!given.orbit.angle.empty() || (!angle && !std::holds_alternative<NoRotation>(given.rotation)))
        throw InputError(body.name, "the comparison takes polynomials and angles only");
      pieces.push_back(
          {given.until, given.origin, given.x, given.y, angle ? angle->angle : Coefficients{}, given.pivot});
    }
    pieces_.push_back(std::move(pieces));
  }
}

int MovingBodies::next(int vertex) const {
  const int body = body_of(vertex);
  return vertex + 1 == first(body + 1) ? first(body) : vertex + 1;
}

int MovingBodies::previous(int vertex) const {
  const int body = body_of(vertex);
  return vertex == first(body) ? first(body + 1) - 1 : vertex - 1;
}

bool MovingBodies::rigid(int body, int other) const {
  return body == other ||
         (pieces_[static_cast<std::size_t>(body)].empty() && pieces_[static_cast<std::size_t>(other)].empty());
}

const MovingBodies::Piece& MovingBodies::piece(int body, double t) const {
  const std::vector<Piece>& all = pieces_[static_cast<std::size_t>(body)];
  const auto found = std::upper_bound(all.begin(), all.end() - 1, t,
                                      [](double instant, const Piece& one) { return instant < one.until; });
  return *found;
}

Moving MovingBodies::at(int vertex, double t) const {
  const Point& u = drawn_[static_cast<std::size_t>(vertex)];
  const int body = body_of(vertex);
  if (pieces_[static_cast<std::size_t>(body)].empty()) return {u, {}};
  const Piece& p = piece(body, t);
  const double passed = t - p.origin;
  const ValueAndSlope x = evaluate(p.x, passed), y = evaluate(p.y, passed);
  if (p.angle.empty()) return {{x.value + u.x, y.value + u.y}, {x.slope, y.slope}};
  const ValueAndSlope angle = evaluate(p.angle, passed);
  const double c = std::cos(angle.value), s = std::sin(angle.value), a = u.x - p.pivot.x, b = u.y - p.pivot.y;
  const double rx = c * a - s * b, ry = s * a + c * b;
  return {{x.value + p.pivot.x + rx, y.value + p.pivot.y + ry},
          {x.slope - angle.slope * ry, y.slope + angle.slope * rx}};
}

std::vector<Point> MovingBodies::positions(double t) const {
  std::vector<Point> out(static_cast<std::size_t>(vertices()));
  for (int v = 0; v < vertices(); ++v) out[static_cast<std::size_t>(v)] = at(v, t).position;
  return out;
}

MotionBounds MovingBodies::bounds(int body, double t, double h) const {
  if (pieces_[static_cast<std::size_t>(body)].empty()) return {};
  const Piece& p = piece(body, t);
  const double passed = t - p.origin;
  const Derivatives x = derivatives(p.x, passed, h), y = derivatives(p.y, passed, h),
                    angle = derivatives(p.angle, passed, h);
  return {std::hypot(x.first, y.first), std::hypot(x.second, y.second), angle.first, angle.second};
}

double MovingBodies::arm(int vertex, double t) const {
  const int body = body_of(vertex);
  if (pieces_[static_cast<std::size_t>(body)].empty()) return 0;
  const Point &u = drawn_[static_cast<std::size_t>(vertex)], &c = piece(body, t).pivot;
  return std::hypot(u.x - c.x, u.y - c.y);
}

double MovingBodies::piece_end(int body, double t) const {
  const std::vector<Piece>& all = pieces_[static_cast<std::size_t>(body)];
  if (all.empty()) return std::numeric_limits<double>::infinity();
  const Piece& p = piece(body, t);
  return &p == &all.back() ? std::numeric_limits<double>::infinity() : p.until;
}

Scene jittered(Scene scene, double size, std::uint64_t seed) {
  gen::Random random(seed);
  for (Body& body : scene.bodies) {
    for (Point& p : body.polygon) {
      p.x += random.uniform(-size, size) / 2;
      p.y += random.uniform(-size, size) / 2;
    }
  }
  return scene;
}

Scene shrunk(Scene scene, double share, std::uint64_t seed) {
  gen::Random random(seed);
  for (Body& body : scene.bodies) {
    Point centre;
    const auto count = static_cast<double>(body.polygon.size());
    for (const Point& p : body.polygon) centre = {centre.x + p.x / count, centre.y + p.y / count};
    for (Point& p : body.polygon) {
      const double by = share * random.uniform(1, 2);
      p = {p.x + by * (centre.x - p.x), p.y + by * (centre.y - p.y)};
    }
  }
  return scene;
}

}  // namespace taut::paper
