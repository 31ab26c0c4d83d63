#include "support/triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace taut::testing {

namespace {

/// Positive if d is inside the circle through a, b, c by more than rounding.
double in_circle(const IntPoint& a, const IntPoint& b, const IntPoint& c, const IntPoint& d) {
  const auto row = [&](const IntPoint& p) {
    const double x = static_cast<double>(p.x - d.x), y = static_cast<double>(p.y - d.y);
    return std::array<double, 3>{x, y, x * x + y * y};
  };
  const auto u = row(a), v = row(b), w = row(c);
  const double terms[3] = {u[2] * (v[0] * w[1] - v[1] * w[0]), v[2] * (w[0] * u[1] - w[1] * u[0]),
                           w[2] * (u[0] * v[1] - u[1] * v[0])};
  const double size = std::fabs(terms[0]) + std::fabs(terms[1]) + std::fabs(terms[2]);
  return terms[0] + terms[1] + terms[2] - 1e-9 * size;
}

}  // namespace

Triangulation::Triangulation(std::vector<IntPoint> points) : points_(std::move(points)) {
  std::sort(points_.begin(), points_.end());
  const int n = static_cast<int>(points_.size());
  int k = 2;  // the first point off the line of the first two
  while (k < n && cross(points_[0], points_[1], points_[k]) == 0) ++k;
  if (k >= n) return;

  std::vector<int> hull;  // counterclockwise; it may hold collinear points
  const bool left = cross(points_[0], points_[1], points_[k]) > 0;
  for (int i = 0; i + 1 < k; ++i) left ? add(i, i + 1, k) : add(i + 1, i, k);
  for (int i = 0; i < k; ++i) hull.push_back(left ? i : k - 1 - i);
  hull.push_back(k);
  for (int p = k + 1; p < n; ++p) {
    // p is lexicographically largest: it sees one contiguous run of hull edges.
    const int m = static_cast<int>(hull.size());
    const auto sees = [&](int i) { return cross(points_[hull[i % m]], points_[hull[(i + 1) % m]], points_[p]) < 0; };
    int start = 0;
    while (!(sees(start) && !sees(start + m - 1))) ++start;
    int end = start;
    for (; sees(end); ++end) add(hull[(end + 1) % m], hull[end % m], p);
    std::vector<int> next{hull[start % m], p};
    for (int i = end; i < start + m; ++i) next.push_back(hull[i % m]);
    hull.swap(next);
  }
}

void Triangulation::add(int a, int b, int c) {
  const int t = static_cast<int>(triangles_.size());
  triangles_.push_back({a, b, c});
  left_[{a, b}] = left_[{b, c}] = left_[{c, a}] = t;
}

int Triangulation::apex(int a, int b) const {
  const auto it = left_.find({a, b});
  if (it == left_.end()) return -1;
  const Triangle& t = triangles_[it->second];
  return t[0] + t[1] + t[2] - a - b;
}

bool Triangulation::flip(int a, int b) {
  const int c = apex(a, b), d = apex(b, a);
  if (c < 0 || d < 0) return false;
  const auto turn = [&](int p, int q, int r) { return cross(points_[p], points_[q], points_[r]); };
  if (turn(d, b, c) <= 0 || turn(c, a, d) <= 0) return false;
  const int s = left_[{a, b}], t = left_[{b, a}];
  left_.erase({a, b});
  left_.erase({b, a});
  triangles_[s] = {d, b, c};
  triangles_[t] = {c, a, d};
  left_[{d, b}] = left_[{b, c}] = left_[{c, d}] = s;
  left_[{c, a}] = left_[{a, d}] = left_[{d, c}] = t;
  return true;
}

bool Triangulation::wants_flip(int a, int b) const {
  const int c = apex(a, b), d = apex(b, a);
  return c >= 0 && d >= 0 && in_circle(points_[a], points_[b], points_[c], points_[d]) > 0;
}

void Triangulation::make_delaunay() {
  std::vector<std::pair<int, int>> stack;
  for (const auto& entry : left_) stack.push_back(entry.first);
  while (!stack.empty()) {
    const auto [a, b] = stack.back();
    stack.pop_back();
    if (!wants_flip(a, b)) continue;
    const int c = apex(a, b), d = apex(b, a);
    if (!flip(a, b)) continue;
    for (const auto& edge : {std::pair(d, b), std::pair(b, c), std::pair(c, a), std::pair(a, d)}) stack.push_back(edge);
  }
}

void Triangulation::flip_randomly(Rng& rng, int count) {
  for (; count > 0 && !triangles_.empty(); --count) {
    const Triangle t = rng.pick(triangles_);
    const int k = rng.below(3);
    flip(t[k], t[(k + 1) % 3]);
  }
}

}  // namespace taut::testing
