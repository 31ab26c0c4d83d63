// Rectangles around runs of edges, in two binary trees. Intervals of time are halved together with the list of pairs of
// rectangles that are not yet apart in them; so all pairs share what the motion does in an interval: a quadratic about
// its middle, and a bound of what that leaves out.
#include "yardstick.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "geometry/predicates.hpp"

namespace taut::bench {
using namespace internal;
namespace {

/// A complex number. std::complex would look for infinities in each product.
struct Vector {
  double x = 0, y = 0;
};
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
Vector operator*(Vector a, Vector b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
Vector operator*(double k, Vector a) { return {k * a.x, k * a.y}; }
Vector conj(Vector a) { return {a.x, -a.y}; }
Vector turned(Vector a) { return {-a.y, a.x}; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
double norm(Vector a) { return std::sqrt(dot(a, a)); }

/// a + b h + c h^2, where h is the time from an interval's middle.
struct Quadratic {
  double a = 0, b = 0, c = 0;
  double least(double r) const {
    return c > 0 && std::fabs(b) < 2 * c * r ? a - b * b / (4 * c) : a - std::fabs(b) * r + c * r * r;
  }
  double swing(double r) const { return r * (std::fabs(b) + r * std::fabs(c)); }
};
Quadratic operator-(const Quadratic& f) { return {-f.a, -f.b, -f.c}; }
Quadratic operator+(const Quadratic& f, const Quadratic& g) { return {f.a + g.a, f.b + g.b, f.c + g.c}; }
Quadratic operator-(const Quadratic& f, const Quadratic& g) { return {f.a - g.a, f.b - g.b, f.c - g.c}; }
Quadratic operator*(double k, const Quadratic& f) { return {k * f.a, k * f.b, k * f.c}; }
Quadratic operator*(const Quadratic& f, const Quadratic& g) {
  return {f.a * g.a, f.a * g.b + f.b * g.a, f.a * g.c + f.b * g.b + f.c * g.a};
}

/// A moving point or direction, up to `rest`, for |h| <= r.
struct Path {
  Quadratic x, y;
  double rest = 0;
};
Path operator-(const Path& p) { return {-p.x, -p.y, p.rest}; }
Path operator-(const Path& p, const Path& q) { return {p.x - q.x, p.y - q.y, p.rest + q.rest}; }
Path operator*(const Path& p, Vector v) { return {v.x * p.x - v.y * p.y, v.y * p.x + v.x * p.y, 0}; }
Path conj(const Path& p) { return {p.x, -p.y, p.rest}; }
Quadratic along(Vector n, const Path& p) { return n.x * p.x + n.y * p.y; }

Path product(const Path& p, const Path& q, double r) {
  const auto norms = [r](const Path& f) {
    return Quadratic{norm({f.x.a, f.y.a}), r * norm({f.x.b, f.y.b}), r * r * norm({f.x.c, f.y.c})};
  };
  const Quadratic f = norms(p), g = norms(q);
  return {p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x,
          f.b * g.c + f.c * (g.b + g.c) + p.rest * (g.a + g.b + g.c + q.rest) + q.rest * (f.a + f.b + f.c)};
}

/// A polynomial about t: its first three Taylor coefficients, and the sum of the others' magnitudes for |h| <= r.
struct Expansion {
  Quadratic f;
  double rest = 0;
  Expansion(const Coefficients& p, double t, double r) {
    double b[max_degree + 1] = {};
    const int n = static_cast<int>(p.size());
    for (int k = 0; k < n; ++k) b[k] = p[static_cast<std::size_t>(k)];
    for (int k = 0; k < n; ++k) {
      for (int i = n - 2; i >= k; --i) b[i] += t * b[i + 1];
    }
    for (int k = n - 1; k >= 3; --k) rest = r * (rest + std::fabs(b[k]));
    rest *= r * r;
    f = {b[0], b[1], b[2]};
  }
};

/// exp(i angle).
Path rotation(const Rotation& rotation, double t, double r) {
  if (std::holds_alternative<NoRotation>(rotation)) return {{1, 0, 0}, {}, 0};
  const auto* by_angle = std::get_if<AngleRotation>(&rotation);
  if (!by_angle) throw std::invalid_argument("the yardstick turns by angles only");
  const Expansion e(by_angle->angle, t, r);
  const double c = std::cos(e.f.a), s = std::sin(e.f.a), b = e.f.b, half_square = b * b / 2;
  const double first = r * std::fabs(b), second = r * r * std::fabs(e.f.c) + e.rest, all = first + second;
  return {{c, -b * s, -e.f.c * s - half_square * c},
          {s, b * c, e.f.c * c - half_square * s},
          e.rest + first * second + second * second / 2 + all * all * all / 6};
}

Path position(const MotionPiece& piece, double t, double r) {
  const Expansion x(piece.x, t - piece.origin, r), y(piece.y, t - piece.origin, r);
  return {x.f, y.f, x.rest + y.rest};
}

/// How the other body's point v moves in one body's frame: shift + turn v.
struct Side {
  Path shift, turn;
  double swing = 0;  ///< how far `turn` gets from its middle
  /// v as seen from a point of this body.
  Path place(Vector v, Vector from) const {
    const Path p = turn * v;
    return {{shift.x.a + p.x.a - from.x, shift.x.b + p.x.b, shift.x.c + p.x.c},
            {shift.y.a + p.y.a - from.y, shift.y.b + p.y.b, shift.y.c + p.y.c}};
  }
};

/// An interval of time.
struct Interval {
  double middle, r;
  Side side[2];  ///< in P's frame, in Q's frame
  double rest;   ///< in either frame, for any point of the moving polygon

  Interval(const MotionPiece& p, const MotionPiece& q, double start, double end, double size)
      : middle(start + (end - start) / 2), r((end - start) / 2) {
    const Path xp = rotation(p.rotation, middle - p.origin, r), xq = rotation(q.rotation, middle - q.origin, r);
    const Path way = position(q, middle, r) - position(p, middle, r);
    side[0] = {product(conj(xp), way, r), product(conj(xp), xq, r)};
    side[1] = {-product(conj(xq), way, r), conj(side[0].turn)};
    for (Side& s : side) s.swing = s.turn.x.swing(r) + s.turn.y.swing(r) + s.turn.rest;
    rest = std::max(side[0].shift.rest, side[1].shift.rest) + size * side[0].turn.rest;
  }
};

struct Rectangle {
  Vector centre, along;        ///< a unit vector
  double length, width, disc;  ///< half of each; the radius of the disc around
  std::uint32_t first, count;  ///< edges
  std::uint32_t left, right;
};

struct Tree {
  Polygon polygon;  ///< counterclockwise
  std::vector<Rectangle> nodes;
  double size = 0;

  explicit Tree(const Polygon& outline) : polygon(outline) {
    if (polygon_orientation(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
    nodes.reserve(2 * polygon.size());
    build(0, static_cast<std::uint32_t>(polygon.size()));
    for (const Point& v : polygon) size = std::max(size, std::hypot(v.x, v.y));
  }
  Vector vertex(std::uint32_t i) const {
    const Point& v = polygon[i < polygon.size() ? i : i - polygon.size()];
    return {v.x, v.y};
  }
  std::uint32_t build(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(around(first, count));
    if (count > 1) {
      const std::uint32_t left = build(first, count / 2), right = build(first + count / 2, count - count / 2);
      nodes[index].left = left;
      nodes[index].right = right;
    }
    return index;
  }
  Rectangle around(std::uint32_t first, std::uint32_t count) const {
    const Vector chord = vertex(first + count) - vertex(first);
    const Vector u = norm(chord) > 0 ? (1 / norm(chord)) * chord : Vector{1, 0};
    double lo[2] = {INFINITY, INFINITY}, hi[2] = {-INFINITY, -INFINITY};
    for (std::uint32_t k = 0; k <= count; ++k) {
      const Vector at = conj(u) * vertex(first + k);
      lo[0] = std::min(lo[0], at.x), hi[0] = std::max(hi[0], at.x);
      lo[1] = std::min(lo[1], at.y), hi[1] = std::max(hi[1], at.y);
    }
    const Vector half{(hi[0] - lo[0]) / 2, (hi[1] - lo[1]) / 2};
    return {u * Vector{lo[0] + half.x, lo[1] + half.y}, u, half.x, half.y, norm(half), first, count, 0, 0};
  }
};

/// Does a direction of `fixed` separate it from `moving`, throughout?
bool apart(const Interval& in, const Side& side, const Rectangle& fixed, const Rectangle& moving, const Path& centre) {
  const Path e = side.turn * moving.along;
  const auto clear = [&](Vector n, double extent) {
    Quadratic gap = along(n, centre);
    if (gap.a < 0) gap = -gap;
    gap.a -= extent + in.rest;
    if (!(gap.a > 0)) return false;
    // The corner of the moving rectangle that is nearest at the middle is so throughout, unless sides turn past.
    const auto reach = [&](Vector to, double half) {
      const Quadratic f = along(to, e);
      if (std::fabs(f.a) > side.swing) {
        gap = gap - (f.a > 0 ? half : -half) * f;
      } else {
        gap.a -= half * (std::fabs(f.a) + side.swing);
      }
    };
    reach(n, moving.length);
    reach({n.y, -n.x}, moving.width);
    return gap.a > 0 && gap.least(in.r) > 0;
  };
  return clear(turned(fixed.along), fixed.width) || clear(fixed.along, fixed.length);
}

struct Pair {
  std::uint32_t p, q;
};

/// The search on one piece of the motion.
class Search {
 public:
  Search(const Tree& p, const Tree& q, const MotionPiece& mp, const MotionPiece& mq) : p_(p), q_(q), mp_(mp), mq_(mq) {}

  /// The time of the first contact, or infinity.
  double run(double start, double end) {
    shortest_ = 0x1p-40 * (end - start);
    pairs_.assign(1, {0, 0});
    cover(0, start, end);
    return best_;
  }

 private:
  /// All of [start, end], for the pairs from `first` on.
  void cover(std::size_t first, double start, double end) {
    if (start >= best_) return;
    const Interval in(mp_, mq_, start, end, std::max(p_.size, q_.size));
    const std::size_t last = pairs_.size();
    for (std::size_t i = first; i < last; ++i) {
      todo_.assign(1, pairs_[i]);
      while (!todo_.empty()) {
        const Pair pair = todo_.back();
        todo_.pop_back();
        look(in, pair);
      }
    }
    if (pairs_.size() > last) {
      cover(last, start, in.middle);
      cover(last, in.middle, end);
    }
    pairs_.resize(last);
  }
  /// Drops the pair if it is apart throughout, else divides it, or keeps it for the halves of the interval.
  void look(const Interval& in, Pair pair) {
    const Rectangle &p = p_.nodes[pair.p], &q = q_.nodes[pair.q];
    const Path way = in.side[0].place(q.centre, p.centre);
    const double discs = p.disc + q.disc;
    Quadratic gap = along({way.x.a, way.y.a}, way);
    gap.a -= std::sqrt(gap.a) * (discs + in.rest);
    if (gap.a > 0 && gap.least(in.r) > 0) return;
    if (apart(in, in.side[0], p, q, way)) return;
    if (apart(in, in.side[1], q, p, in.side[1].place(p.centre, q.centre))) return;
    const double motion = way.x.swing(in.r) + way.y.swing(in.r) + in.side[0].swing * q.disc + in.rest;
    if (motion > subdivision_threshold * discs && in.r > shortest_) {
      pairs_.push_back(pair);
    } else if (p.count == 1 && q.count == 1) {
      if (!settled(in, p, q)) pairs_.push_back(pair);
    } else if (q.count == 1 || (p.count > 1 && p.disc >= q.disc)) {
      todo_.push_back({p.right, pair.q});
      todo_.push_back({p.left, pair.q});
    } else {
      todo_.push_back({pair.p, q.right});
      todo_.push_back({pair.p, q.left});
    }
  }
  /// The first vertex of each edge and the other edge.
  bool settled(const Interval& in, const Rectangle& p, const Rectangle& q) {
    return meets(in, 0, q_.vertex(q.first), p_.vertex(p.first), p_.vertex(p.first + 1)) &&
           meets(in, 1, p_.vertex(p.first), q_.vertex(q.first), q_.vertex(q.first + 1));
  }
  /// Notes when the vertex passes through the edge from a to b, which is of body `side`. False if the interval is too
  /// long to tell.
  bool meets(const Interval& in, int side, Vector vertex, Vector a, Vector b) {
    const Vector edge = b - a, normal = turned(edge);
    Path way = in.side[side].place(vertex, a);
    const double rest = in.rest * norm(edge);
    const Quadratic line = along(normal, way), ahead = along(edge, way);
    const Quadratic beyond{ahead.a - dot(edge, edge), ahead.b, ahead.c};
    for (const Quadratic& f : {line, -line, -ahead, beyond}) {
      if (f.least(in.r) > rest) return true;
    }
    const double curved = 4 * (std::fabs(line.c) * in.r + rest / in.r);
    if (line.b < -curved) return true;  // it leaves
    if (!(line.b > curved) && in.r > shortest_) return false;
    double t = in.middle;
    for (int step = 0; step < 8; ++step) {
      const Interval at(mp_, mq_, t, t, 0);
      way = at.side[side].place(vertex, a);
      const Quadratic f = along(normal, way);
      t -= f.a / f.b;
    }
    const double share = along(edge, way).a;
    const bool within = std::fabs(t - in.middle) <= in.r * (1 + 0x1p-20);
    if (within && share >= 0 && share <= dot(edge, edge)) best_ = std::min(best_, t);
    return true;
  }

  /// Pairs that move farther than this share of their size wait for a shorter interval.
  static constexpr double subdivision_threshold = 0.75;

  const Tree &p_, &q_;
  const MotionPiece &mp_, &mq_;
  std::vector<Pair> pairs_, todo_;
  double shortest_ = 0, best_ = INFINITY;
};

}  // namespace

YardstickAnswer yardstick(const Scene& scene) {
  const Tree p(scene.bodies[0].polygon), q(scene.bodies[1].polygon);
  const auto pieces = [](const Body& body) {
    return body.motion.pieces.empty() ? std::vector<MotionPiece>(1) : body.motion.pieces;
  };
  const std::vector<MotionPiece> mp = pieces(scene.bodies[0]), mq = pieces(scene.bodies[1]);
  std::size_t i = 0, j = 0;
  for (double t = scene.start; t < scene.end;) {
    while (i + 1 < mp.size() && mp[i].until <= t) ++i;
    while (j + 1 < mq.size() && mq[j].until <= t) ++j;
    const double end =
        std::min({scene.end, i + 1 < mp.size() ? mp[i].until : INFINITY, j + 1 < mq.size() ? mq[j].until : INFINITY});
    const double found = Search(p, q, mp[i], mq[j]).run(t, end);
    if (found < INFINITY) return {true, found};
    t = end;
  }
  return {};
}

}  // namespace taut::bench
