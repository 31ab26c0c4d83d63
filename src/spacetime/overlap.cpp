// Do the bodies overlap in one placement? Boxes first, then exact signs.
#include <utility>
#include <vector>

#include "motion/placement.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/first_contact.hpp"

namespace taut::spacetime {
namespace {

bool edges_cross(const Placement& place, VertexId a, VertexId b) {
  const PairGeometry& g = place.geometry();
  const VertexId a2 = g.next(a), b2 = g.next(b);
  return place.orientation(a, a2, b) != place.orientation(a, a2, b2) &&
         place.orientation(b, b2, a) != place.orientation(b, b2, a2);
}

/// Is a vertex of one body inside the other? A ray along the sweep's "up" crosses its boundary an odd number of times.
bool inside(const Placement& place, VertexId v, std::uint32_t first, std::uint32_t count) {
  const PairGeometry& g = place.geometry();
  bool odd = false;
  for (std::uint32_t k = 0; k < count; ++k) {
    const VertexId a(first + k), b = g.next(a);
    const bool forwards = place.before(a, v);
    if (forwards == place.before(b, v)) continue;
    if (place.orientation(forwards ? a : b, forwards ? b : a, v) < 0) odd = !odd;
  }
  return odd;
}

Stretch at_instant(const Leg& leg, double t) {
  if (leg.translation) return Stretch::of_translation(leg, TranslationPolynomial(leg), t, t);
  FrameWindow window(leg, t, leg.end, leg.end - t);
  return window.smooth() ? Stretch::of_window(leg, window, t, t) : Stretch::of_range(leg, window);
}

}  // namespace

std::optional<StartOverlap> overlapping(const PairGeometry& g, const Leg& leg, double t) {
  const Hierarchy p = hierarchy_of_p(g), q = hierarchy_of_q(g);
  return overlapping(g, {p, q}, leg, t);
}

std::optional<StartOverlap> overlapping(const PairGeometry& g, const TreePair& trees, const Leg& leg, double t) {
  const Placement place(g, leg, t);
  const auto& [p, q] = trees;
  const Stretch instant = at_instant(leg, t);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> stack{{0, 0}};
  while (!stack.empty()) {
    const auto [i, j] = stack.back();
    stack.pop_back();
    const BoxNode &a = p.node(i), &b = q.node(j);
    if (apart(instant, a.box, b.box)) continue;
    if (a.count == 1 && b.count == 1) {
      const VertexId e(a.first), f(g.np + b.first);
      if (edges_cross(place, e, f)) return StartOverlap{true, e, f};
    } else if (b.count == 1 || (a.count > 1 && a.box.radius >= b.box.radius)) {
      stack.insert(stack.end(), {{a.left, j}, {a.right, j}});
    } else {
      stack.insert(stack.end(), {{i, b.left}, {i, b.right}});
    }
  }
  if (inside(place, VertexId(0u), g.np, g.nq) || inside(place, VertexId(g.np), 0, g.np)) return StartOverlap{};
  return std::nullopt;
}

}  // namespace taut::spacetime
