#include "peers/convex_pieces.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "geometry/predicates.hpp"

namespace taut::bench {
using namespace internal;
namespace {

double squared_distance(const Point& a, const Point& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

bool counterclockwise(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  std::size_t least = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (std::pair(polygon[i].x, polygon[i].y) < std::pair(polygon[least].x, polygon[least].y)) least = i;
  }
  // The neighbours of the smallest vertex may be in line with it; their own neighbours do not matter then.
  for (std::size_t k = 1; k < n; ++k) {
    const int turn = orientation(polygon[(least + n - 1) % n], polygon[least], polygon[(least + k) % n]);
    if (turn != 0) return turn > 0;
  }
  throw std::invalid_argument("a polygon whose vertices are all in one line");
}

/// What is left of a polygon while its ears are cut off: a ring of vertices.
class Ring {
 public:
  explicit Ring(const Polygon& polygon) : points_(polygon) {
    const int n = static_cast<int>(polygon.size());
    next_.resize(polygon.size());
    prev_.resize(polygon.size());
    stamp_.assign(polygon.size(), 0);
    const bool ccw = counterclockwise(polygon);
    for (int i = 0; i < n; ++i) (ccw ? next_ : prev_)[i] = (i + 1) % n;
    for (int i = 0; i < n; ++i) (ccw ? prev_ : next_)[i] = (i + n - 1) % n;
    left_ = n;
    for (int i = 0; i < n; ++i) {
      if (turn(i) <= 0) reflex_.push_back(i);
      queue(i);
    }
  }

  std::vector<Triangle> cut() {
    std::vector<Triangle> triangles;
    while (left_ > 2) {
      if (ears_.empty()) throw std::invalid_argument("a polygon without an ear: it is not simple");
      const Candidate best = ears_.top();
      ears_.pop();
      if (best.stamp != stamp_[best.vertex]) continue;
      const int v = best.vertex, sign = turn(v);
      if (sign < 0) continue;
      if (sign > 0) {
        // Then it stays so until a neighbour of v goes: of the vertices in the triangle the one nearest to v, measured
        // across the diagonal, is reflex, and is so as long as it is the nearest one.
        if (blocked(v)) continue;
        triangles.push_back({prev_[v], v, next_[v]});
      }
      remove(v);
    }
    return triangles;
  }

 private:
  struct Candidate {
    double length;
    int vertex;
    int stamp;
    bool operator<(const Candidate& other) const { return length > other.length; }
  };

  int turn(int v) const { return orientation(points_[prev_[v]], points_[v], points_[next_[v]]); }

  void queue(int v) { ears_.push({squared_distance(points_[prev_[v]], points_[next_[v]]), v, ++stamp_[v]}); }

  /// Does another vertex lie in the closed triangle at v? Then a reflex one does.
  bool blocked(int v) const {
    const Point &a = points_[prev_[v]], &b = points_[v], &c = points_[next_[v]];
    const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
    const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
    for (const int r : reflex_) {
      const Point& p = points_[r];
      if (p.x < x0 || p.x > x1 || p.y < y0 || p.y > y1) continue;
      if (stamp_[r] < 0 || r == v || r == prev_[v] || r == next_[v]) continue;
      if (orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0) return true;
    }
    return false;
  }

  void remove(int v) {
    const int before = prev_[v], after = next_[v];
    next_[before] = after;
    prev_[after] = before;
    stamp_[v] = -1;
    --left_;
    queue(before);
    queue(after);
  }

  const Polygon& points_;
  std::vector<int> next_, prev_;
  std::vector<int> stamp_;   ///< of the vertex's newest candidate; -1: no longer in the ring
  std::vector<int> reflex_;  ///< a superset: what is convex once stays so
  std::priority_queue<Candidate> ears_;
  int left_ = 0;
};

/// Pieces that grow by joining neighbours.
class Pieces {
 public:
  Pieces(const Polygon& polygon, std::size_t most) : points_(polygon), most_(most) {
    for (const Triangle& t : triangulate(polygon)) {
      const int piece = static_cast<int>(loops_.size());
      loops_.emplace_back(t.begin(), t.end());
      for (int k = 0; k < 3; ++k) owner_.emplace(key(t[k], t[(k + 1) % 3]), piece);
    }
    joined_.resize(loops_.size());
    std::iota(joined_.begin(), joined_.end(), 0);
  }

  void join() {
    std::vector<std::pair<int, int>> diagonals;
    for (const std::vector<int>& loop : loops_) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const int u = loop[k], v = loop[(k + 1) % loop.size()];
        if (u < v && owner_.count(key(v, u)) > 0) diagonals.emplace_back(u, v);
      }
    }
    const auto length = [this](const auto& d) { return squared_distance(points_[d.first], points_[d.second]); };
    std::sort(diagonals.begin(), diagonals.end(),
              [&length](const auto& a, const auto& b) { return std::pair(-length(a), a) < std::pair(-length(b), b); });
    for (const auto& [u, v] : diagonals) join_across(u, v);
  }

  std::vector<Polygon> take() const {
    std::vector<Polygon> out;
    for (const std::vector<int>& loop : loops_) {
      if (loop.empty()) continue;
      Polygon& piece = out.emplace_back();
      for (const int v : loop) piece.push_back(points_[v]);
    }
    return out;
  }

 private:
  static std::uint64_t key(int u, int v) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(u)) << 32 | static_cast<std::uint32_t>(v);
  }
  int piece_at(int u, int v) const {
    int piece = owner_.at(key(u, v));
    while (joined_[piece] != piece) piece = joined_[piece];
    return piece;
  }
  /// The loop without its edge from u to v, as a chain from v to u.
  static std::vector<int> chain(std::vector<int> loop, int v) {
    std::rotate(loop.begin(), std::find(loop.begin(), loop.end(), v), loop.end());
    return loop;
  }

  void join_across(int u, int v) {
    const int left = piece_at(u, v), right = piece_at(v, u);
    if (loops_[left].size() + loops_[right].size() - 2 > most_) return;
    const std::vector<int> a = chain(loops_[left], v), b = chain(loops_[right], u);
    const auto convex = [this](int p, int q, int r) { return orientation(points_[p], points_[q], points_[r]) > 0; };
    if (!convex(a[a.size() - 2], u, b[1]) || !convex(b[b.size() - 2], v, a[1])) return;
    loops_[left] = a;
    loops_[left].insert(loops_[left].end(), b.begin() + 1, b.end() - 1);
    loops_[right].clear();
    joined_[right] = left;
  }

  const Polygon& points_;
  std::size_t most_;
  std::vector<std::vector<int>> loops_;
  std::vector<int> joined_;                       ///< the piece that a piece has become part of
  std::unordered_map<std::uint64_t, int> owner_;  ///< the triangle to the left of a directed edge
};

}  // namespace

std::vector<Triangle> triangulate(const Polygon& polygon) { return Ring(polygon).cut(); }

std::vector<Polygon> convex_pieces(const Polygon& polygon, std::size_t most) {
  Pieces pieces(polygon, most);
  pieces.join();
  return pieces.take();
}

}  // namespace taut::bench
