#include "support/link_search.hpp"

#include <algorithm>
#include <bitset>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdlib>
#include <optional>

namespace taut::testing {
namespace {

using Rational = boost::multiprecision::cpp_rational;

template <class Number>
struct ExactVec {
  Number x, y;
};

template <class Number>
Number turn(const ExactVec<Number>& a, const ExactVec<Number>& b, const ExactVec<Number>& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

template <class Number>
int sign(const Number& x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

/// +1 inside, 0 on the boundary, -1 outside: by counting crossings of a ray to the right.
template <class Number>
int location(const ExactVec<Number>& p, const std::vector<ExactVec<Number>>& polygon) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactVec<Number>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const int s = sign<Number>(turn(a, b, p));
    if (s == 0 && (a.x - p.x) * (b.x - p.x) <= 0 && (a.y - p.y) * (b.y - p.y) <= 0) return 0;
    if ((a.y <= p.y) != (b.y <= p.y) && (s > 0) == (a.y < b.y)) inside = !inside;
  }
  return inside ? 1 : -1;
}

/// Does the segment meet the inside? It is cut at the lines of all edges; then the middle of each part tells.
bool meets(const ExactVec<Rational>& a, const ExactVec<Rational>& b, const std::vector<ExactVec<Rational>>& polygon) {
  std::vector<Rational> cuts{0, 1};
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &c = polygon[i], &d = polygon[(i + 1) % polygon.size()];
    const Rational at_a = turn(c, d, a), at_b = turn(c, d, b);
    if (sign(at_a) * sign(at_b) < 0) cuts.push_back(at_a / (at_a - at_b));
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Rational t = (cuts[i] + cuts[i + 1]) / 2;
    if (location<Rational>({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}, polygon) > 0) return true;
  }
  return false;
}

/// The middle of a triangle of three neighbours, if it lies inside.
template <class Number>
std::optional<ExactVec<Number>> inner_point(const std::vector<ExactVec<Number>>& polygon, const Number& weight) {
  const std::size_t n = polygon.size();
  for (Number w = weight; w > 0; w = w / 2) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto &u = polygon[i], &v = polygon[(i + 1) % n], &x = polygon[(i + 2) % n];
      const ExactVec<Number> p{(u.x * w + v.x * (12 - 2 * w) + x.x * w) / 12,
                               (u.y * w + v.y * (12 - 2 * w) + x.y * w) / 12};
      if (sign(turn(u, v, x)) > 0 && location(p, polygon) > 0) return p;
    }
  }
  return std::nullopt;
}

/// Does the segment a-b cross the open segment from p to q, which it does not touch at p or q? Points on the line p-q
/// count as being on its right.
template <class Number>
bool crosses_cut(const ExactVec<Number>& a, const ExactVec<Number>& b, const ExactVec<Number>& p,
                 const ExactVec<Number>& q) {
  if ((turn(p, q, a) > 0) == (turn(p, q, b) > 0)) return false;
  return sign<Number>(turn(a, b, p)) * sign<Number>(turn(a, b, q)) < 0;
}

// ----- the lattice -----

using IntVec = ExactVec<std::int64_t>;
constexpr std::size_t most_points = 448;
using Points = std::bitset<2 * most_points>;  ///< a point and a parity

class LatticeSearch {
 public:
  LatticeSearch(const std::vector<IntPoint>& p, const std::vector<IntPoint>& q, int extent) {
    for (const IntPoint& v : p) p_.push_back({12 * v.x, 12 * v.y});
    for (const IntPoint& v : q) q_.push_back({12 * v.x, 12 * v.y});
    in_p_ = *inner_point<std::int64_t>(p_, 4);
    in_q_ = *inner_point<std::int64_t>(q_, 4);
    for (int x = -extent; x <= extent; ++x) {
      for (int y = -extent; y <= extent; ++y) {
        const IntVec v{12 * x, 12 * y};
        if (location(v, p_) <= 0 && location(v, q_) <= 0) points_.push_back(v);
      }
    }
    if (points_.size() > most_points) std::abort();
    far_ = 12 * 40 * extent;
    connect();
  }

  int run() const {
    if (line()) return 1;
    int best = open();
    const int closed = loop(best == 0 ? 99 : best);
    if (closed != 0 && (best == 0 || closed < best)) best = closed;
    return best;
  }

 private:
  static bool enters(const IntVec& before, const IntVec& v, const IntVec& after, const IntVec& w) {
    const bool in = turn(before, v, w) > 0, out = turn(v, after, w) > 0;
    return turn(before, v, after) > 0 ? in && out : in || out;
  }
  static bool meets_inside(const IntVec& a, const IntVec& b, const std::vector<IntVec>& polygon) {
    const std::size_t n = polygon.size();
    bool touched = false;
    for (std::size_t i = 0; i < n; ++i) {
      const IntVec &c = polygon[i], &d = polygon[(i + 1) % n], &before = polygon[(i + n - 1) % n];
      const int ac = sign(turn(a, b, c)), ad = sign(turn(a, b, d)), ca = sign(turn(c, d, a)), cb = sign(turn(c, d, b));
      if (ac * ad < 0 && ca * cb < 0) return true;
      const auto on = [](const IntVec& v, const IntVec& s, const IntVec& e) {
        return std::min(s.x, e.x) <= v.x && v.x <= std::max(s.x, e.x) && std::min(s.y, e.y) <= v.y &&
               v.y <= std::max(s.y, e.y);
      };
      if (ac == 0 && on(c, a, b)) {
        touched = true;
        for (const IntVec& end : {a, b}) {
          if ((end.x != c.x || end.y != c.y) && enters(before, c, d, end)) return true;
        }
      }
      if (ca == 0 && on(a, c, d) && ac != 0 && ad != 0) {
        touched = true;
        if (cb > 0) return true;
      }
      if (cb == 0 && on(b, c, d) && ac != 0 && ad != 0) {
        touched = true;
        if (ca > 0) return true;
      }
    }
    return !touched && location(a, polygon) > 0;
  }
  bool is_free(const IntVec& a, const IntVec& b) const { return !meets_inside(a, b, p_) && !meets_inside(a, b, q_); }

  void connect() {
    const std::size_t n = points_.size();
    next_.assign(2 * n, {});
    const auto join = [&](std::size_t i, std::size_t j, bool odd) {
      next_[i].set(odd ? most_points + j : j);
      next_[n + i].set(odd ? j : most_points + j);
    };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!is_free(points_[i], points_[j])) continue;
        const bool odd = crosses_cut(points_[i], points_[j], in_p_, in_q_);
        join(i, j, odd);
        join(j, i, odd);
      }
      for (int dx = -4; dx <= 4; ++dx) {
        for (int dy = -4; dy <= 4; ++dy) {
          if (dx == 0 && dy == 0) continue;
          const IntVec end{points_[i].x + far_ * dx, points_[i].y + far_ * dy};
          if (!is_free(points_[i], end)) continue;
          rays_.set(crosses_cut(points_[i], end, in_p_, in_q_) ? most_points + i : i);
        }
      }
    }
  }
  Points step(const Points& from) const {
    Points to;
    for (std::size_t k = from._Find_first(); k < from.size(); k = from._Find_next(k))
      to |= next_[k < most_points ? k : points_.size() + (k - most_points)];
    return to;
  }

  /// A line through two vertices, all of P on the one side and all of Q on the other?
  bool line() const {
    std::vector<IntVec> all = p_;
    all.insert(all.end(), q_.begin(), q_.end());
    for (const IntVec& a : all) {
      for (const IntVec& b : all) {
        if (a.x == b.x && a.y == b.y) continue;
        const bool p_left = std::all_of(p_.begin(), p_.end(), [&](const IntVec& v) { return turn(a, b, v) >= 0; });
        const bool q_right = std::all_of(q_.begin(), q_.end(), [&](const IntVec& v) { return turn(a, b, v) <= 0; });
        if (p_left && q_right) return true;
      }
    }
    return false;
  }
  /// From infinity to infinity, crossing the cut an odd number of times.
  int open() const {
    Points odd_end;  // where a ray completes an odd curve
    for (std::size_t i = 0; i < most_points; ++i) {
      odd_end[i] = rays_[most_points + i];
      odd_end[most_points + i] = rays_[i];
    }
    Points seen = rays_, front = rays_;
    for (int edges = 2; front.any(); ++edges) {
      if ((front & odd_end).any()) return edges;
      front = step(front) & ~seen;
      seen |= front;
    }
    return 0;
  }
  int loop(int below) const {
    int best = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      Points seen, front;
      front.set(i);
      for (int edges = 1; front.any() && edges < below; ++edges) {
        front = step(front) & ~seen;
        seen |= front;
        if (seen[most_points + i]) {
          best = below = edges;
          break;
        }
      }
    }
    return best;
  }

  std::vector<IntVec> p_, q_, points_;
  IntVec in_p_{}, in_q_{};
  std::int64_t far_ = 0;
  std::vector<Points> next_;  ///< by parity and point
  Points rays_;               ///< points from which a ray is free, by its parity
};

}  // namespace

int fewest_lattice_links(const std::vector<IntPoint>& p, const std::vector<IntPoint>& q, int extent) {
  return LatticeSearch(p, q, extent).run();
}

bool is_separator(const std::vector<Point>& curve, bool closed, const Polygon& p, const Polygon& q) {
  const auto exact = [](const std::vector<Point>& points) {
    std::vector<ExactVec<Rational>> out;
    for (const Point& v : points) out.push_back({Rational(v.x), Rational(v.y)});
    return out;
  };
  std::vector<ExactVec<Rational>> line = exact(curve);
  auto exact_p = exact(p), exact_q = exact(q);
  for (auto* polygon : {&exact_p, &exact_q}) {
    Rational area = 0;
    for (std::size_t i = 0; i < polygon->size(); ++i)
      area += turn<Rational>({0, 0}, (*polygon)[i], (*polygon)[(i + 1) % polygon->size()]);
    if (area < 0) std::reverse(polygon->begin(), polygon->end());
  }
  if (closed) {
    line.push_back(line.front());
  } else {
    // Rays: so long that they end far away from everything.
    const auto lengthen = [](const ExactVec<Rational>& from, ExactVec<Rational>& end) {
      end = {from.x + 4096 * (end.x - from.x), from.y + 4096 * (end.y - from.y)};
    };
    const ExactVec<Rational> first = line[0];
    lengthen(line[1], line[0]);
    lengthen(line.size() == 2 ? first : line[line.size() - 2], line.back());
  }
  const auto in_p = inner_point<Rational>(exact_p, Rational(4)), in_q = inner_point<Rational>(exact_q, Rational(4));
  bool odd = false;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if (meets(line[i], line[i + 1], exact_p) || meets(line[i], line[i + 1], exact_q)) return false;
    if (crosses_cut(line[i], line[i + 1], *in_p, *in_q)) odd = !odd;
  }
  return odd;
}

}  // namespace taut::testing
