#include "spacetime/nested_discs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace taut::internal::spacetime {
namespace {

/// The search for the least disc ends after so many points, each farther out than the last disc reaches.
constexpr int most_steps = 32;

double distance(Vector a, Vector b) {
  const Vector d = a - b;
  return std::sqrt(dot(d, d));
}

/// Of two points, and of three; rounded. Nothing if they are in line.
Disc disc_of(Vector a, Vector b) { return {{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2}, distance(a, b) / 2}; }
std::optional<Disc> disc_of(Vector a, Vector b, Vector c) {
  const Vector u = b - a, v = c - a;
  const double twice = 2 * dot(turned(u), v), uu = dot(u, u), vv = dot(v, v);
  const Vector to{(v.y * uu - u.y * vv) / twice, (u.x * vv - v.x * uu) / twice};
  if (!(std::fabs(to.x) < INFINITY && std::fabs(to.y) < INFINITY)) return std::nullopt;
  return Disc{a + to, std::sqrt(dot(to, to))};
}

/// The points that the least disc so far is determined by: at most three of them.
class Support {
 public:
  explicit Support(Vector first) : points_{first}, size_(1), disc_{first, 0} {}

  const Disc& disc() const { return disc_; }
  /// The least disc of these points and one more. Returns false if rounding leaves none that is larger.
  bool add(Vector more) {
    const double before = disc_.radius;
    std::array<Vector, 4> all = points_;
    all[size_] = more;
    const std::size_t n = size_ + 1;
    disc_.radius = INFINITY;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = i + 1; k < n; ++k) {
        attempt(all, n, disc_of(all[i], all[k]), {all[i], all[k]}, 2);
        for (std::size_t l = k + 1; l < n; ++l) {
          if (const auto disc = disc_of(all[i], all[k], all[l])) attempt(all, n, *disc, {all[i], all[k], all[l]}, 3);
        }
      }
    }
    return disc_.radius < INFINITY && disc_.radius > before;
  }

 private:
  void attempt(const std::array<Vector, 4>& all, std::size_t n, const Disc& disc, const std::array<Vector, 4>& points,
               std::size_t size) {
    if (!(disc.radius < disc_.radius)) return;
    for (std::size_t i = 0; i < n; ++i) {
      if (distance(all[i], disc.centre) > disc.radius * (1 + 0x1p-45)) return;
    }
    disc_ = disc;
    points_ = points;
    size_ = size;
  }

  std::array<Vector, 4> points_;
  std::size_t size_;
  Disc disc_;
};

Vector undisplaced(const DisplacedPoint& p) { return {p.x, p.y}; }

Vector middle_of(std::span<const DisplacedPoint> points) {
  Support support(undisplaced(points[0]));
  Vector middle = support.disc().centre;
  for (int step = 0; step < most_steps; ++step) {
    Vector farthest = middle;
    double most = 0;
    for (const DisplacedPoint& p : points) {
      const Vector d = undisplaced(p) - middle;
      if (!(dot(d, d) > most)) continue;
      most = dot(d, d);
      farthest = undisplaced(p);
    }
    if (std::sqrt(most) <= support.disc().radius || !support.add(farthest)) break;
    middle = support.disc().centre;
  }
  return middle;
}

/// Covers the rounding of a distance between points whose coordinates are no larger, and their displacement.
double room_for(double largest) { return 0x1p-45 * largest + displacement_room; }

}  // namespace

Disc disc_around(std::span<const DisplacedPoint> points) {
  Disc disc;
  if (points.empty()) return disc;
  disc.centre = middle_of(points);
  double largest = l1_norm(disc.centre);
  for (const DisplacedPoint& p : points) {
    disc.radius = std::max(disc.radius, distance(undisplaced(p), disc.centre));
    largest = std::max(largest, l1_norm(undisplaced(p)));
  }
  disc.radius += room_for(largest);
  return disc;
}

Disc disc_within(std::span<const DisplacedPoint> ring) {
  Disc disc{middle_of(ring), INFINITY};
  double largest = l1_norm(disc.centre);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector a = undisplaced(ring[i]), edge = undisplaced(ring[(i + 1) % ring.size()]) - a;
    const double share = std::clamp(dot(disc.centre - a, edge) / dot(edge, edge), 0.0, 1.0);
    disc.radius = std::min(disc.radius, distance(disc.centre, {a.x + share * edge.x, a.y + share * edge.y}));
    largest = std::max(largest, l1_norm(a));
  }
  disc.radius = std::max(0.0, disc.radius - room_for(largest));
  return disc;
}

}  // namespace taut::internal::spacetime
