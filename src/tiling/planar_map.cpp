#include "tiling/planar_map.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "scene/placement.hpp"

namespace taut::internal {

PlanarMap PlanarMap::compact(std::vector<HalfedgeId>& handles) const {
  std::vector<HalfedgeId> number(count_);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (alive(HalfedgeId(i))) number[i] = HalfedgeId(count++);
  }
  const auto renumbered = [&number](HalfedgeId h) { return h.valid() ? number[h.value] : h; };
  PlanarMap result;
  result.vertices_ = vertices_;
  result.count_ = count;
  result.reserve(count);
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (!number[i].valid()) continue;
    const Halfedge h = record(HalfedgeId(i));
    result.own(number[i]) = {h.origin, renumbered(h.next), renumbered(h.previous), h.node};
    result.set_pinch(number[i], is_pinch(HalfedgeId(i)));
  }
  for (HalfedgeId& h : handles) h = renumbered(h);
  return result;
}

PlanarMap PlanarMap::joined(const PlanarMap& first, const PlanarMap& second) {
  const Renumbering p = first_in_joined(first, second), q = second_in_joined(first, second);
  PlanarMap result;
  result.vertices_ = first.vertices_ + second.vertices_;
  result.count_ = first.count_ + second.count_;
  result.reserve(4 * static_cast<std::size_t>(result.vertices_) + 16);
  result.parts_ = {{{p.polygon_end, p.polygon_shift, &first, p, 0},
                    {2 * result.vertices_, q.polygon_shift, &second, q, first.vertices_},
                    {first.count_ + p.shift, p.shift, &first, p, 0},
                    {result.count_, q.shift, &second, q, first.vertices_}}};
  return result;
}

/// What the half-edges of a block were in the parts.
void PlanarMap::read_parts(std::uint32_t first, Halfedge* out) const {
  const std::uint32_t end = std::min(first + block, parts_[3].end);
  for (std::uint32_t i = first; i < end;) {
    const Part& part = part_of(i);
    for (const std::uint32_t stop = std::min(end, part.end); i < stop; ++i) out[i - first] = part.record(i);
  }
}

namespace {

std::string name(const PlanarMap& map, HalfedgeId h) {
  return std::to_string(map.origin(h).value) + "->" + std::to_string(map.target(h).value);
}

std::string check_links(const PlanarMap& map, std::uint32_t& alive) {
  alive = 0;
  for (std::uint32_t i = 0; i < map.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!map.alive(h)) continue;
    ++alive;
    if (!map.next(h).valid() || !map.previous(h).valid()) return "half-edge " + name(map, h) + " is not linked";
    if (map.previous(map.next(h)) != h) return "previous of next differs at " + name(map, h);
    if (map.origin(map.next(h)) != map.target(h)) return "next does not continue " + name(map, h);
    if (map.node(h) == node::none) return "no label on " + name(map, h);
  }
  return {};
}

std::string check_face(const PlanarMap& map, const Placement& placement, HalfedgeId start,
                       std::set<std::uint32_t>& seen, std::vector<bool>& visited) {
  const ChainNode label = map.node(start);
  const bool inside = map.is_interior(start);
  int convex = 0;
  HalfedgeId h = start;
  do {
    visited[h.value] = true;
    if (!inside && map.node(h) != label) return "two labels around one face at " + name(map, h);
    const HalfedgeId n = map.next(h);
    const VertexId u = map.origin(h), v = map.target(h), w = map.target(n);
    if (u != w && placement.orientation(u, v, w) > 0) ++convex;
    h = n;
  } while (h != start);
  if (inside) return {};
  if (!seen.insert(label.code).second) return "two faces of node " + std::to_string(label.code);
  const int expected = label == node::infinite_face ? 1 : 3;
  if (convex != expected)
    return "face " + std::to_string(label.code) + " has " + std::to_string(convex) + " convex corners";
  return {};
}

}  // namespace

std::string find_fault(const PlanarMap& map, const Placement& placement) {
  std::uint32_t alive = 0;
  if (std::string fault = check_links(map, alive); !fault.empty()) return fault;
  std::vector<bool> visited(map.halfedge_count(), false);
  std::set<std::uint32_t> seen;
  std::int64_t faces = 0;
  for (std::uint32_t i = 0; i < map.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!map.alive(h) || visited[i]) continue;
    if (std::string fault = check_face(map, placement, h, seen, visited); !fault.empty()) return fault;
    ++faces;
  }
  if (seen.count(node::root.code) == 0 || seen.count(node::infinite_face.code) == 0) return "a root face is missing";
  const std::int64_t v = map.vertices(), e = alive / 2;
  if (v - e + faces != 2) return "Euler's formula fails";
  return {};
}

std::vector<CanonicalHalfedge> canonical(const PlanarMap& map) {
  std::vector<CanonicalHalfedge> out;
  for (std::uint32_t i = 0; i < map.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!map.alive(h)) continue;
    out.push_back({map.origin(h).value, map.target(h).value, map.target(map.next(h)).value, map.node(h).code,
                   map.is_pinch(h) ? 1u : 0u});
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string difference(const PlanarMap& a, const PlanarMap& b) {
  const auto ca = canonical(a), cb = canonical(b);
  const auto describe = [](const CanonicalHalfedge& h) {
    return std::to_string(h.from) + "->" + std::to_string(h.to) + "->" + std::to_string(h.then) + " node " +
           std::to_string(h.node) + (h.pinch ? " pinch" : "");
  };
  std::string text;
  std::size_t i = 0, j = 0;
  for (int shown = 0; shown < 8 && (i < ca.size() || j < cb.size());) {
    if (i < ca.size() && j < cb.size() && ca[i] == cb[j]) {
      ++i, ++j;
    } else if (j == cb.size() || (i < ca.size() && ca[i] < cb[j])) {
      text += "only first: " + describe(ca[i++]) + "\n";
      ++shown;
    } else if (i == ca.size() || cb[j] < ca[i]) {
      text += "only second: " + describe(cb[j++]) + "\n";
      ++shown;
    } else {
      text += "first: " + describe(ca[i++]) + ", second: " + describe(cb[j++]) + "\n";
      ++shown;
    }
  }
  return text;
}

}  // namespace taut::internal
