#include "geometry/subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "geometry/predicates.hpp"
#include "geometry/segment_strips.hpp"

namespace taut::internal {

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
bool is_left_of(const Point& low_a, const Point& high_a, const Point& low_b, const Point& high_b) {
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

/// Of each connected component the half-edge of the walk around it, seen from outside, that leaves its least node:
/// nothing lies to the left of that node, so it is the last of those that point right, counterclockwise. From left to
/// right.
std::vector<int> Subdivision::outer_walks() const {
  Components components(nodes_.size());
  for (const SubdivisionEdge& e : edges_) components.join(e.from, e.to);
  std::vector<int> least(nodes_.size(), -1), walks;
  for (int h = 0; h < half_edges(); ++h) {
    int& best = least[static_cast<std::size_t>(components.of(origin(h)))];
    if (best < 0 || lexicographically_less(point(origin(h)), point(origin(best)))) best = h;
    if (origin(h) == origin(best) && orientation(point(origin(h)), point(target(best)), point(target(h))) > 0) best = h;
  }
  std::copy_if(least.begin(), least.end(), std::back_inserter(walks), [](int h) { return h >= 0; });
  std::sort(walks.begin(), walks.end(),
            [this](int g, int h) { return lexicographically_less(point(origin(g)), point(origin(h))); });
  return walks;
}

/// The half-edge right to the left of a component's least node, with the node on its left; -1 if there is none.
int Subdivision::left_of_component(const Point& p, const SegmentStrips& strips) const {
  int nearest = -1;  // it runs down
  strips.each_to_the_left(p, [&](std::size_t e) {
    int h = static_cast<int>(2 * e);
    if (point(origin(h)).y < point(target(h)).y) h ^= 1;
    const Point &high = point(origin(h)), &low = point(target(h));
    // As a ray a little above p would meet it.
    if (low.y <= p.y && p.y < high.y && orientation(high, low, p) > 0 &&
        (nearest < 0 || is_left_of(point(target(nearest)), point(origin(nearest)), low, high)))
      nearest = h;
    return nearest < 0 ? -INFINITY : std::min(point(origin(nearest)).x, point(target(nearest)).x);
  });
  return nearest;
}

void Subdivision::find_faces() {
  const std::vector<int> outer = outer_walks();
  std::vector<bool> outside(next_.size(), false);
  for (const int start : outer) {
    for (int h = start; !outside[static_cast<std::size_t>(h)]; h = next(h)) outside[static_cast<std::size_t>(h)] = true;
  }
  faces_.assign(next_.size(), -1);
  const auto mark = [this](int start, int face) {
    for (int h = start; faces_[static_cast<std::size_t>(h)] < 0; h = next(h))
      faces_[static_cast<std::size_t>(h)] = face;
  };
  for (int h = 0; h < half_edges(); ++h)
    if (!outside[static_cast<std::size_t>(h)] && faces_[static_cast<std::size_t>(h)] < 0) mark(h, face_count_++);
  if (outer.size() == 1) return mark(outer[0], 0);
  std::vector<AxisBox> boxes;
  for (const SubdivisionEdge& e : edges_) boxes.emplace_back(point(e.from), point(e.to));
  const SegmentStrips strips(std::move(boxes));
  // What is left of a component's least node belongs to one that begins farther left, and has its face by then.
  for (const int start : outer) {
    const int h = left_of_component(point(origin(start)), strips);
    mark(start, h < 0 ? 0 : face(h));
  }
}

}  // namespace taut::internal
