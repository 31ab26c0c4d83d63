#include "geometry/subdivision.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/predicates.hpp"
#include "geometry/segment_strips.hpp"

namespace taut {

namespace {

/// Does a to b point into [-90, 90) degrees, or rather (-90, 90]: to the right, or straight up?
bool points_right(const Point& a, const Point& b) { return lexicographically_less(a, b); }

/// Connected components, by union-find.
class Components {
 public:
  explicit Components(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i) {
      int& up = parent_[static_cast<std::size_t>(i)];
      up = parent_[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  }
  void join(int a, int b) { parent_[static_cast<std::size_t>(of(a))] = of(b); }

 private:
  std::vector<int> parent_;
};

/// Of two edges that do not cross and both span the height y, with lower < y <= upper or the like: is the first one to
/// the left of the second?
bool left_of(const Point& low_a, const Point& high_a, const Point& low_b, const Point& high_b) {
  // The end that lies between the heights of the other edge decides; on a common end, the other one does.
  if (low_a.y >= low_b.y) {
    const int side = orientation(low_b, high_b, low_a);
    if (side != 0) return side > 0;
  } else {
    const int side = orientation(low_a, high_a, low_b);
    if (side != 0) return side < 0;
  }
  if (high_a.y <= high_b.y) return orientation(low_b, high_b, high_a) > 0;
  return orientation(low_a, high_a, high_b) < 0;
}

}  // namespace

Subdivision::Subdivision(std::vector<Point> nodes, std::vector<SubdivisionEdge> edges)
    : nodes_(std::move(nodes)), edges_(std::move(edges)) {
  next_.resize(2 * edges_.size());
  link_around_nodes();
  find_faces();
}

void Subdivision::link_around_nodes() {
  std::vector<int> out(next_.size());
  std::iota(out.begin(), out.end(), 0);
  // By node, then counterclockwise, beginning after the direction straight down.
  std::sort(out.begin(), out.end(), [this](int g, int h) {
    if (origin(g) != origin(h)) return origin(g) < origin(h);
    if (g == h) return false;
    const Point &o = point(origin(g)), &a = point(target(g)), &b = point(target(h));
    if (points_right(o, a) != points_right(o, b)) return points_right(o, a);
    return orientation(o, a, b) > 0;
  });
  for (std::size_t i = 0; i < out.size();) {
    std::size_t end = i;
    while (end < out.size() && origin(out[end]) == origin(out[i])) ++end;
    // Whoever arrives here by the twin of out[k] leaves by the one clockwise of it.
    for (std::size_t k = i; k < end; ++k) next_[static_cast<std::size_t>(out[k] ^ 1)] = out[k == i ? end - 1 : k - 1];
    i = end;
  }
}

void Subdivision::find_faces() {
  Components components(nodes_.size());
  for (const SubdivisionEdge& e : edges_) components.join(e.from, e.to);
  // The walk around a component from outside passes its least node, where nothing lies to the left: it arrives by the
  // twin of the last half-edge that points right, and leaves by the first one.
  std::vector<int> least(nodes_.size(), -1);
  for (int h = 0; h < half_edges(); ++h) {
    int& best = least[static_cast<std::size_t>(components.of(origin(h)))];
    if (best < 0 || lexicographically_less(point(origin(h)), point(origin(best)))) best = h;
    if (origin(h) == origin(best) && orientation(point(origin(h)), point(target(best)), point(target(h))) > 0) best = h;
  }
  faces_.assign(next_.size(), -1);
  const auto mark = [this](int start, int face) {
    for (int h = start; faces_[static_cast<std::size_t>(h)] < 0; h = next(h))
      faces_[static_cast<std::size_t>(h)] = face;
  };
  // For now, the outer walks have faces of their own below -1.
  std::vector<int> outer;
  for (const int h : least)
    if (h >= 0) outer.push_back(h);
  std::vector<bool> outside(next_.size(), false);
  for (const int h : outer) {
    int g = h;
    do {
      outside[static_cast<std::size_t>(g)] = true;
      g = next(g);
    } while (g != h);
  }
  for (int h = 0; h < half_edges(); ++h)
    if (!outside[static_cast<std::size_t>(h)] && faces_[static_cast<std::size_t>(h)] < 0) mark(h, face_count_++);
  // Components from left to right: what is left of one's least node has its face by then.
  std::sort(outer.begin(), outer.end(),
            [this](int g, int h) { return lexicographically_less(point(origin(g)), point(origin(h))); });
  if (outer.size() == 1) return mark(outer[0], 0);
  std::vector<SegmentBox> boxes;
  for (const SubdivisionEdge& e : edges_) boxes.emplace_back(point(e.from), point(e.to));
  const SegmentStrips strips(std::move(boxes));
  for (const int start : outer) {
    const Point& p = point(origin(start));
    int nearest = -1;  // the half-edge that runs down, with p on its left
    SegmentBox ray(p, p);
    ray.lo_x = -max_coordinate;
    strips.each_near(ray, [&](std::size_t e) {
      int h = static_cast<int>(2 * e);
      if (point(origin(h)).y < point(target(h)).y) h ^= 1;
      const Point &high = point(origin(h)), &low = point(target(h));
      // As a ray a little above p would meet it.
      if (!(low.y <= p.y && p.y < high.y) || orientation(high, low, p) <= 0) return;
      if (nearest < 0 || left_of(point(target(nearest)), point(origin(nearest)), low, high)) nearest = h;
    });
    mark(start, nearest < 0 ? 0 : face(nearest));
  }
}

}  // namespace taut
