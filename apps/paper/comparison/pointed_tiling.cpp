#include "comparison/pointed_tiling.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>

#include "comparison/edge_grid.hpp"
#include "comparison/half_edges.hpp"
#include "geometry/predicates.hpp"
#include "taut/error.hpp"

namespace taut::paper {
namespace {

struct Candidate {
  double length = 0;
  int from = 0, to = 0;
};

class Builder {
 public:
  Builder(const MovingBodies& bodies, const std::vector<Point>& positions)
      : bodies_(bodies), positions_(positions), grid_(positions), around_(positions.size()) {
    missing_ = 3 * bodies.bodies() - 3;
    for (int v = 0; v < bodies.vertices(); ++v) {
      around_[index(v)] = {bodies.previous(v), bodies.next(v)};
      grid_.add(v, bodies.next(v));
      missing_ += is_reflex(v);
    }
  }

  std::vector<std::vector<int>> run() {
    add_hull();
    add_within_bodies();
    add_between_bodies();
    if (missing_ != 0) throw StructureError("a pointed pseudo-triangulation misses edges");
    return std::move(around_);
  }

 private:
  static std::size_t index(int v) { return static_cast<std::size_t>(v); }
  const Point& at(int v) const { return positions_[index(v)]; }
  int side(int u, int v, int w) const { return internal::orientation(at(u), at(v), at(w)); }
  bool is_reflex(int v) const { return side(bodies_.previous(v), v, bodies_.next(v)) < 0; }
  double distance(int v, int w) const { return std::hypot(at(v).x - at(w).x, at(v).y - at(w).y); }

  /// Where w goes among the edges of v, if it is on the free side and leaves an angle of more than 180 degrees.
  std::optional<std::size_t> place(int v, int w) const {
    const std::vector<int>& ends = around_[index(v)];
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const int a = ends[k], b = ends[k + 1];
      if (a == w || b == w) return {};
      const bool narrow = side(v, a, b) > 0;
      const bool left = side(v, a, w) > 0, right = side(v, w, b) > 0;
      if (narrow ? !(left && right) : !(left || right)) continue;
      // A wide gap must leave a wide one.
      return narrow || !(left && right) ? std::optional(k + 1) : std::nullopt;
    }
    return {};
  }

  bool add(int v, int w) {
    const auto here = place(v, w), there = place(w, v);
    if (!here || !there || grid_.is_crossed(v, w)) return false;
    const auto insert = [this](int at, std::size_t k, int end) {
      around_[index(at)].insert(around_[index(at)].begin() + static_cast<std::ptrdiff_t>(k), end);
    };
    insert(v, *here, w);
    insert(w, *there, v);
    grid_.add(v, w);
    --missing_;
    return true;
  }

  void add_hull() {
    std::vector<int> order(positions_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [this](int a, int b) { return internal::lexicographically_less(at(a), at(b)); });
    for (int pass = 0; pass < 2; ++pass) {
      std::vector<int> chain;
      for (const int v : order) {
        while (chain.size() > 1 && side(chain[chain.size() - 2], chain.back(), v) < 0) chain.pop_back();
        chain.push_back(v);
      }
      for (std::size_t k = 0; k + 1 < chain.size(); ++k) {
        if (bodies_.next(chain[k]) != chain[k + 1] && bodies_.previous(chain[k]) != chain[k + 1])
          add(chain[k], chain[k + 1]);
      }
      std::reverse(order.begin(), order.end());
    }
  }

  void add_in_order(std::vector<Candidate>& candidates) {
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
      return std::tie(a.length, a.from, a.to) < std::tie(b.length, b.from, b.to);
    });
    for (const Candidate& c : candidates) {
      if (missing_ == 0) return;
      add(c.from, c.to);
    }
  }

  void add_within_bodies() {
    std::vector<Candidate> candidates;
    for (int body = 0; body < bodies_.bodies(); ++body) {
      const int first = bodies_.first(body), last = bodies_.first(body + 1);
      for (int v = first; v < last; ++v)
        for (int w = v + 1; w < last; ++w)
          if (place(v, w) && place(w, v)) candidates.push_back({distance(v, w), v, w});
    }
    add_in_order(candidates);
  }

  /// All pairs whose distance is within a band, band after band; and once all bodies are joined and few faces are open,
  /// all pairs of each of these, which is the same and takes less time.
  void add_between_bodies() {
    const double far = farthest();
    double from = 0, to = far / std::sqrt(static_cast<double>(positions_.size()));
    for (; missing_ > 0 && from <= far && !add_within_faces(); from = to, to *= 1.5) {
      std::map<std::pair<int, int>, std::vector<int>> cells;
      const auto cell = [&](double x) { return static_cast<int>(std::floor(x / to)); };
      for (int v = 0; v < bodies_.vertices(); ++v) cells[{cell(at(v).x), cell(at(v).y)}].push_back(v);
      std::vector<Candidate> candidates;
      for (int v = 0; v < bodies_.vertices(); ++v) {
        for (int i = cell(at(v).x) - 1; i <= cell(at(v).x) + 1; ++i) {
          for (int j = cell(at(v).y) - 1; j <= cell(at(v).y) + 1; ++j) {
            const auto found = cells.find({i, j});
            if (found != cells.end()) gather(v, found->second, from, to, candidates);
          }
        }
      }
      add_in_order(candidates);
    }
  }
  void gather(int v, const std::vector<int>& others, double from, double to, std::vector<Candidate>& out) const {
    for (const int w : others) {
      if (w <= v || bodies_.body_of(v) == bodies_.body_of(w)) continue;
      const double d = distance(v, w);
      if (d > from && d <= to && place(v, w) && place(w, v)) out.push_back({d, v, w});
    }
  }
  /// Adds edges to the faces that are no pseudo-triangles yet. False if there is too much of them.
  bool add_within_faces() {
    if (!all_joined()) return false;
    std::vector<Candidate> candidates;
    for (std::vector<int>& face : open_faces()) {
      if (candidates.size() + face.size() * face.size() > 4'000'000) return false;
      // A vertex comes twice where the face is on both sides of it.
      std::sort(face.begin(), face.end());
      face.erase(std::unique(face.begin(), face.end()), face.end());
      for (const int v : face) gather(v, face, 0, INFINITY, candidates);
    }
    add_in_order(candidates);
    return true;
  }
  bool all_joined() const {
    std::vector<bool> reached(index(bodies_.bodies()));
    std::vector<int> left{0};
    int count = 0;
    while (!left.empty()) {
      const int body = left.back();
      left.pop_back();
      if (reached[index(body)]) continue;
      reached[index(body)] = true;
      ++count;
      for (int v = bodies_.first(body); v < bodies_.first(body + 1); ++v)
        for (const int w : around_[index(v)]) left.push_back(bodies_.body_of(w));
    }
    return count == bodies_.bodies();
  }
  /// The vertices of each face with more than three convex corners, once all bodies are joined.
  std::vector<std::vector<int>> open_faces() const {
    const HalfEdges map(bodies_, around_);
    std::vector<bool> seen(index(map.size()));
    std::vector<std::vector<int>> out;
    for (int start = 0; start < map.size(); ++start) {
      std::vector<int> face;
      int convex = 0;
      for (int h = start; !seen[index(h)]; h = map.next(h)) {
        seen[index(h)] = true;
        face.push_back(map.origin(h));
        convex += side(map.origin(map.previous(h)), map.origin(h), map.target(h)) > 0;
      }
      if (convex > 3 && !map.is_inside(start)) out.push_back(std::move(face));
    }
    return out;
  }
  double farthest() const {
    double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
    for (const Point& p : positions_) {
      x0 = std::min(x0, p.x), x1 = std::max(x1, p.x);
      y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
    }
    return std::hypot(x1 - x0, y1 - y0);
  }

  const MovingBodies& bodies_;
  const std::vector<Point>& positions_;
  EdgeGrid grid_;
  std::vector<std::vector<int>> around_;
  int missing_ = 0;
};

}  // namespace

std::vector<std::vector<int>> pointed_tiling(const MovingBodies& bodies, const std::vector<Point>& positions) {
  return Builder(bodies, positions).run();
}

}  // namespace taut::paper
