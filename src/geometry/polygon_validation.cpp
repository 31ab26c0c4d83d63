// validate_polygon: what the engines take for granted about a polygon, checked exactly.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "geometry/boundary_sweep.hpp"
#include "geometry/predicates.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut {
using namespace internal;

namespace {

/// The shortest of the usual decimal forms that reads back the same.
std::string text(double x) {
  char buffer[40];
  for (const int digits : {15, 16, 17}) {
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, x);
    if (!(std::strtod(buffer, nullptr) != x)) break;
  }
  return buffer;
}

std::string text(const Point& p) { return "(" + text(p.x) + ", " + text(p.y) + ")"; }

std::string vertex_text(const Polygon& polygon, int i) {
  return "vertex " + std::to_string(i) + " at " + text(polygon[i]);
}

std::string edge_text(const Polygon& polygon, int j) {
  return std::to_string(j) + "-" + std::to_string((j + 1) % static_cast<int>(polygon.size()));
}

void require_enough_vertices(const Polygon& polygon, const std::string& name) {
  const std::size_t n = polygon.size();
  if (n < 3)
    throw InputError(name, "a polygon needs at least 3 vertices, this one has " + std::to_string(n),
                     "list the corners in order around the boundary, the first one not repeated at the end");
  if (n > (std::size_t{1} << 30))
    throw InputError(name, "a polygon may have at most 2^30 vertices, this one has " + std::to_string(n),
                     "simplify the outline");
}

void require_sound_coordinates(const Polygon& polygon, const std::string& name) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& p = polygon[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y))
      throw InputError(name, "vertex " + std::to_string(i) + " has a coordinate that is not finite: " + text(p),
                       "coordinates must be ordinary numbers", {{{0, static_cast<int>(i)}}, {}});
    if (!in_range(p.x) || !in_range(p.y))
      throw InputError(name,
                       "vertex " + std::to_string(i) + " has a coordinate out of range: " + text(p) +
                           "; a coordinate must be zero or of magnitude between 2^-400 (about 3.9e-121) and 2^400 "
                           "(about 2.6e+120)",
                       "choose other units, or write 0 for a coordinate that is meant to be zero",
                       {{{0, static_cast<int>(i)}}, {}});
  }
}

/// All vertices in lexicographic order, equal ones in order of index.
std::vector<int> sorted_vertices(const Polygon& polygon) {
  struct Item {
    Point p;
    int index;
  };
  std::vector<Item> items(polygon.size());
  for (std::size_t i = 0; i < items.size(); ++i) items[i] = {polygon[i], static_cast<int>(i)};
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    if (a.p != b.p) return lexicographically_less(a.p, b.p);
    return a.index < b.index;
  });
  std::vector<int> order(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].index;
  return order;
}

void require_distinct_vertices(const Polygon& polygon, const std::vector<int>& order, const std::string& name) {
  const int last = static_cast<int>(polygon.size()) - 1;
  int first = -1, second = -1;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (polygon[order[k - 1]] != polygon[order[k]]) continue;
    if (first >= 0 && order[k - 1] > first) continue;  // name the repetition that begins first
    first = order[k - 1];
    second = order[k];
  }
  if (first < 0) return;
  std::string hint = "split the outline where it returns to this point, or move one of the two vertices";
  if (second == first + 1) hint = "remove one of the two";
  if (first == 0 && second == last) hint = "leave out the last vertex: the boundary closes by itself";
  throw InputError(name,
                   "vertices " + std::to_string(first) + " and " + std::to_string(second) + " are the same point " +
                       text(polygon[first]),
                   hint, {{{0, first}, {0, second}}, {}});
}

[[noreturn]] void report(const Polygon& polygon, const SelfMeeting& m, const std::string& name) {
  const std::string both = "edges " + edge_text(polygon, m.first) + " and " + edge_text(polygon, m.second);
  const Culprits edges{{}, {{0, m.first}, {0, m.second}}};
  const Culprits edges_at_vertex{{{0, m.vertex}}, edges.edges};
  const std::string not_simple = "the boundary is not simple: ";
  switch (m.kind) {
    case Meeting::touch:
      throw InputError(name,
                       not_simple + both + " touch: " + vertex_text(polygon, m.vertex) + " lies on the other edge",
                       "move the vertex off the edge, or split the outline there", edges_at_vertex);
    case Meeting::overlap:
      throw InputError(name, not_simple + both + " overlap from " + text(m.from) + " to " + text(m.to),
                       "the two edges must not share a stretch: leave a gap between them, or drop it from the outline",
                       edges);
    case Meeting::fold_back:
      throw InputError(name,
                       not_simple + both + " overlap: the boundary folds back on itself at " +
                           vertex_text(polygon, m.vertex) + ", from there to " + text(m.to),
                       "remove the spike; it encloses no area", edges_at_vertex);
    case Meeting::none:
    case Meeting::crossing:
      break;
  }
  throw InputError(name, not_simple + both + " cross at " + text(m.from),
                   "list the vertices in order around the boundary, which must not meet itself", edges);
}

}  // namespace

void validate_polygon(const Polygon& polygon, const std::string& name) {
  require_enough_vertices(polygon, name);
  require_sound_coordinates(polygon, name);
  const std::vector<int> order = sorted_vertices(polygon);
  require_distinct_vertices(polygon, order, name);
  if (const std::optional<SelfMeeting> meeting = find_self_meeting(polygon, order)) report(polygon, *meeting, name);
}

}  // namespace taut
