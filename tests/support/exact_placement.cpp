#include "support/exact_placement.hpp"

namespace taut::testing::exact {
namespace {

Rational area(const Polygon& p) {
  Rational sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    sum += Rational(a.x) * Rational(b.y) - Rational(b.x) * Rational(a.y);
  }
  return sum;
}

int orientation(const Point& a, const Point& b, const Point& c) {
  const Rational ax(a.x), ay(a.y);
  return sgn(Rational((Rational(b.x) - ax) * (Rational(c.y) - ay) - (Rational(b.y) - ay) * (Rational(c.x) - ax)));
}

/// A direction along an edge of a body, with it or against it.
struct Direction {
  int edge;
  int side;  // 1 or -1
};

/// The open angle of a body at a point of its boundary, counterclockwise from one direction to the other.
struct Angle {
  int body;
  Direction from, to;
  int second;  // 1: less than pi, 0: pi, -1: more
};

class Placement {
 public:
  Placement(const Shapes& shapes, const Signs& signs) : shapes_(shapes), signs_(signs) {}

  bool intersect() const { return crossing() || angles_meet() || holds(0) || holds(1); }

 private:
  int height(int side, int edge, int vertex) const { return signs_({{side, vertex, edge}, What::height}); }
  int next(int body, int i) const { return i + 1 == shapes_.size(body) ? 0 : i + 1; }
  int previous(int body, int i) const { return i == 0 ? shapes_.size(body) - 1 : i - 1; }

  bool crossing() const {
    for (int e = 0; e < shapes_.size(0); ++e) {
      for (int f = 0; f < shapes_.size(1); ++f) {
        if (height(0, e, f) * height(0, e, next(1, f)) < 0 && height(1, f, e) * height(1, f, next(0, e)) < 0)
          return true;
      }
    }
    return false;
  }

  bool angles_meet() const {
    for (int side = 0; side < 2; ++side) {
      for (int e = 0; e < shapes_.size(side); ++e) {
        for (int v = 0; v < shapes_.size(1 - side); ++v) {
          const VertexEdge pair{side, v, e};
          if (touching(pair, signs_) && intersect(at_vertex(1 - side, v), at_point(pair))) return true;
        }
      }
    }
    return false;
  }

  Angle at_vertex(int body, int v) const {
    const int before = previous(body, v);
    if (shapes_.counterclockwise(body)) return {body, {v, 1}, {before, -1}, shapes_.second(body, v)};
    return {body, {before, -1}, {v, 1}, shapes_.second(body, v)};
  }
  /// Of the edge's body where the vertex is.
  Angle at_point(const VertexEdge& pair) const {
    if (signs_({pair, What::past_a}) == 0) return at_vertex(pair.side, pair.edge);
    if (signs_({pair, What::past_b}) == 0) return at_vertex(pair.side, next(pair.side, pair.edge));
    const int forth = shapes_.counterclockwise(pair.side) ? 1 : -1;
    return {pair.side, {pair.edge, forth}, {pair.edge, -forth}, 0};
  }

  /// Of directions of different bodies: the sign of their cross product, and of their scalar product.
  int turn(int body, const Direction& a, const Direction& b) const {
    return a.side * b.side * signs_({{body, b.edge, a.edge}, What::turn});
  }
  bool same(int body, const Direction& a, const Direction& b) const {
    return turn(body, a, b) == 0 && a.side * b.side * signs_({{body, b.edge, a.edge}, What::along}) > 0;
  }
  bool strictly_within(const Angle& angle, const Direction& ray) const {
    const int first = turn(angle.body, angle.from, ray), last = -turn(angle.body, angle.to, ray);
    if (angle.second == 0) return first > 0;
    if (angle.second > 0) return first > 0 && last > 0;
    return first > 0 || last > 0;
  }
  bool intersect(const Angle& a, const Angle& b) const {
    if (strictly_within(a, b.from) || strictly_within(a, b.to)) return true;
    if (strictly_within(b, a.from) || strictly_within(b, a.to)) return true;
    return same(a.body, a.from, b.from) && same(a.body, a.to, b.to);
  }

  /// Is the first vertex of the other body in this one? It is not on the boundary, or it does not matter.
  bool holds(int side) const {
    for (int e = 0; e < shapes_.size(side); ++e) {
      if (touching({side, 0, e}, signs_)) return false;
    }
    bool inside = false;
    for (int e = 0; e < shapes_.size(side); ++e) {
      const int a = signs_({{side, 0, e}, What::ray}), b = signs_({{side, 0, next(side, e)}, What::ray});
      if (a == 0 || b == 0) throw Beyond{"a vertex on a ray"};
      if (a != b && height(side, e, 0) * a > 0) inside = !inside;
    }
    return inside;
  }

  const Shapes& shapes_;
  const Signs& signs_;
};

}  // namespace

Shapes::Shapes(const Scene& scene) {
  for (std::size_t b = 0; b < 2; ++b) {
    const Polygon& p = scene.bodies[b].polygon;
    const std::size_t n = p.size();
    counterclockwise_[b] = area(p) > 0;
    for (std::size_t i = 0; i < n; ++i) {
      const int second = orientation(p[(i + n - 1) % n], p[i], p[(i + 1) % n]);
      seconds_of_[b].push_back(counterclockwise_[b] ? second : -second);
    }
  }
}

bool touching(const VertexEdge& pair, const Signs& signs) {
  return signs({pair, What::height}) == 0 && signs({pair, What::past_a}) >= 0 && signs({pair, What::past_b}) <= 0;
}

bool interiors_intersect(const Shapes& shapes, const Signs& signs) { return Placement(shapes, signs).intersect(); }

}  // namespace taut::testing::exact
