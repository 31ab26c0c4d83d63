#include "proof/proof_map.hpp"

#include <algorithm>
#include <string>

#include "numeric/budget.hpp"

namespace taut::internal::proof {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw ProofError(what);
}

std::string at(VertexId v) { return " at vertex " + std::to_string(v.value) + " of the log"; }

}  // namespace

ProofMap::ProofMap(ByteReader& in, const Placement& placement) : vertices_(placement.size()) {
  const PairGeometry& g = placement.geometry();
  halfedges_.resize(2 * static_cast<std::size_t>(vertices_));
  for (std::uint32_t i = 0; i < vertices_; ++i) {
    halfedges_[2 * i].origin = VertexId(i);
    halfedges_[2 * i + 1].origin = g.next(VertexId(i));
  }
  read(in);
  check_links();
  for (std::uint32_t i = 0; i < vertices_; ++i) {
    require(next(HalfedgeId(2 * i)).value == 2 * g.next(VertexId(i)).value, "a body's boundary is missing");
  }
  measure(placement);
  check_faces(placement);
}

void ProofMap::read(ByteReader& in) {
  // A planar map of n vertices has at most 3 n - 6 edges: nothing larger is allocated, whatever the log says.
  const std::uint32_t count = in.u32(), least = 2 * vertices_;
  require(count % 2 == 0 && count >= least && count / 2 <= 3 * static_cast<std::uint64_t>(vertices_) + 16,
          "the number of half-edges is impossible");
  halfedges_.resize(count);
  for (std::uint32_t i = least; i < count; i += 2) {
    const std::uint32_t from = in.u32(), to = in.u32();
    require((from == unused) == (to == unused), "a half-edge without twin");
    if (from == unused) continue;
    require(from < vertices_ && to < vertices_ && from != to, "an edge between vertices that do not exist");
    halfedges_[i].origin = VertexId(from);
    halfedges_[i + 1].origin = VertexId(to);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const HalfedgeId h(i), n(in.u32());
    if (!alive(h)) continue;
    require(alive(n) && !halfedges_[n.value].previous.valid(), "the half-edges do not form cycles");
    link(h, n);
  }
  const std::uint32_t reserve = in.u32();
  require(reserve <= count / 2, "too many unused half-edges");
  std::vector<bool> listed(count, false);
  for (std::uint32_t i = 0; i < reserve; ++i) {
    const HalfedgeId h(in.u32());
    require(h.value < count && h.value % 2 == 0 && !alive(h) && !listed[h.value], "a used half-edge among the unused");
    listed[h.value] = true;
    free_.push_back(h);
  }
}

void ProofMap::check_links() const {
  for (std::uint32_t i = 0; i < size(); ++i) {
    const HalfedgeId h(i);
    if (!alive(h)) continue;
    require(next(h).valid() && previous(h).valid(), "the half-edges do not form cycles");
    require(origin(next(h)) == target(h), "a half-edge does not continue where the one before it ends");
    require(target(next(h)) != origin(h), "a face turns back on an edge");
  }
}

/// The signs of all corners, and the angles around all vertices.
void ProofMap::measure(const Placement& placement) {
  std::vector<HalfedgeId> out(vertices_);
  std::vector<std::uint32_t> degree(vertices_, 0);
  for (std::uint32_t i = 0; i < size(); ++i) {
    const HalfedgeId h(i);
    if (!alive(h)) continue;
    checkpoint();
    halfedges_[i].sign = static_cast<std::int8_t>(placement.orientation(origin(h), target(h), target(next(h))));
    out[origin(h).value] = h;
    ++degree[origin(h).value];
  }
  for (std::uint32_t v = 0; v < vertices_; ++v) {
    checkpoint();
    std::uint32_t met = 0;
    HalfedgeId h = out[v];
    do {
      ++met;
      h = twin(previous(h));
    } while (h != out[v]);
    require(met == degree[v], "the edges at a vertex are not in one order around it");
    check_angles(out[v], placement);
  }
}

/// The corners around a vertex, each between 0 and a full turn, must sum to one full turn. Counterclockwise from `out`,
/// the direction may never come back to that of `out` in between.
void ProofMap::check_angles(HalfedgeId out, const Placement& placement) const {
  const VertexId v = origin(out);
  int side_before = 0;  // of the direction before, as seen along `out`
  for (HalfedgeId h = out;;) {
    const int corner = sign(previous(h));  // from h counterclockwise to the next half-edge
    h = twin(previous(h));
    if (h == out) return;
    require(target(h) != target(out), "two edges between the same vertices");
    const int side = placement.orientation(v, target(out), target(h));
    const bool past_start =
        corner > 0 ? side_before < 0 && side > 0 : side_before != 0 && !(side_before > 0 && side < 0);
    if (past_start) throw ProofError("the angles do not add up" + at(v));
    side_before = side;
  }
}

/// How often the boundary of the face turns around, in half turns: along the direction of the sweep, edges go forwards
/// or backwards, and a corner between the two turns left or right.
int ProofMap::turns(HalfedgeId start, const Placement& placement, std::vector<bool>& seen, int& convex) const {
  int half_turns = 0;
  HalfedgeId h = start;
  do {
    checkpoint();
    seen[h.value] = true;
    const bool forwards = placement.before(origin(h), target(h));
    if (sign(h) > 0) ++convex;
    h = next(h);
    if (forwards != placement.before(origin(h), target(h))) half_turns += sign(previous(h));
  } while (h != start);
  return half_turns;
}

void ProofMap::check_faces(const Placement& placement) const {
  std::vector<bool> seen(size(), false);
  int infinite = 0;
  std::int64_t faces = 0, edges = 0;
  for (std::uint32_t i = 0; i < size(); ++i) {
    const HalfedgeId h(i);
    if (!alive(h)) continue;
    ++edges;
    if (seen[i]) continue;
    ++faces;
    int convex = 0;
    const int half_turns = turns(h, placement, seen, convex);
    if (is_inside(h)) continue;
    if (half_turns == -2 && convex == 1) {
      ++infinite;
    } else if (half_turns != 2 || convex != 3) {
      throw ProofError("a face is not a pseudo-triangle" + at(origin(h)));
    }
  }
  require(infinite == 1, "there is not one infinite face");
  require(vertices_ - edges / 2 + faces == 2, "Euler's formula fails");
}

HalfedgeId ProofMap::new_edge(VertexId from, VertexId to) {
  HalfedgeId h(halfedges_.size());
  if (!free_.empty()) {
    h = free_.back();
    free_.pop_back();
  } else {
    halfedges_.resize(halfedges_.size() + 2);
  }
  halfedges_[h.value].origin = from;
  halfedges_[h.value ^ 1u].origin = to;
  return h;
}

void ProofMap::drop_edge(HalfedgeId h) {
  halfedges_[h.value] = halfedges_[h.value ^ 1u] = Halfedge{};
  free_.push_back(HalfedgeId(h.value & ~1u));
}

Change ProofMap::ending(HalfedgeId uv, Record kind) const {
  Change c;
  for (const HalfedgeId h : {previous(uv), uv, next(uv)}) c.add(h);
  if (kind == Record::event) return c;
  const HalfedgeId across = twin(kind == Record::event_first ? uv : next(uv));
  c.add(previous(across));
  c.add(across);
  return c;
}

Change ProofMap::apply(HalfedgeId uv, Record kind) {
  const HalfedgeId vw = next(uv);
  switch (kind) {
    case Record::event:
      return open_triangle(uv, vw);
    case Record::event_first:
      return replace_first(uv, vw);
    default:
      return replace_second(uv, vw);
  }
}

/// The corner was reflex: the triangle u, v, w is a new face.
Change ProofMap::open_triangle(HalfedgeId uv, HalfedgeId vw) {
  require(sign(uv) < 0, "an edge must go where a convex corner closes");
  const HalfedgeId p = previous(uv), n = next(vw), uw = new_edge(origin(uv), target(vw)), wu = twin(uw);
  sign_of(uw) = sign_of(vw);
  link(p, uw);
  link(uw, n);
  link(uv, vw);
  link(vw, wu);
  link(wu, uv);
  Change c;
  for (const HalfedgeId h : {uv, vw, wu}) sign_of(h) = 1;
  for (const HalfedgeId h : {p, uw, uv, vw, wu}) c.add(h);
  return c;
}

/// The edge u v goes; v, w and the new edge now bound the face that was across it.
Change ProofMap::replace_first(HalfedgeId uv, HalfedgeId vw) {
  require(!is_body_edge(uv), "an edge of a body would go");
  const HalfedgeId vu = twin(uv), p = previous(uv), n = next(vw), before = previous(vu), after = next(vu);
  const bool reflex = sign(uv) < 0, triangle = next(n) == uv;
  const std::int8_t at_u = sign_of(vu);
  // Closing onto u, a convex corner sees w pass the edge: the face goes on beyond w. Straightening, v leaves a side
  // of the face across, in which it was a convex corner.
  require(reflex ? sign(before) > 0 : triangle || sign(vw) < 0, "the faces around an event are not pseudo-triangles");
  Change c;
  HalfedgeId wu = n;
  if (triangle) {
    drop_edge(uv);
  } else {
    wu = vu;
    halfedges_[vu.value].origin = target(vw);
    sign_of(uv) = reflex ? sign_of(vw) : std::int8_t{1};
    link(uv, n);
    c.add(p);
    c.add(uv);
  }
  link(before, vw);
  link(vw, wu);
  link(wu, after);
  if (reflex) sign_of(before) = -1;
  sign_of(vw) = reflex ? 1 : -1;
  sign_of(wu) = at_u;
  for (const HalfedgeId h : {before, vw, wu}) c.add(h);
  return c;
}

/// The edge v w goes; u, v and the new edge now bound the face that was across it.
Change ProofMap::replace_second(HalfedgeId uv, HalfedgeId vw) {
  require(!is_body_edge(vw), "an edge of a body would go");
  const HalfedgeId wv = twin(vw), p = previous(uv), n = next(vw), before = previous(wv), after = next(wv);
  const bool reflex = sign(uv) < 0, triangle = next(n) == uv;
  const std::int8_t at_v = sign_of(wv), at_w = sign_of(vw);
  require(reflex ? at_v > 0 : triangle || sign(p) < 0, "the faces around an event are not pseudo-triangles");
  Change c;
  HalfedgeId wu = n;
  if (triangle) {
    drop_edge(vw);
  } else {
    const HalfedgeId uw = vw;
    wu = wv;
    halfedges_[uw.value].origin = origin(uv);
    sign_of(uw) = at_w;
    if (!reflex) sign_of(p) = 1;
    link(p, uw);
    link(uw, n);
    c.add(p);
    c.add(uw);
  }
  link(before, wu);
  link(wu, uv);
  link(uv, after);
  sign_of(wu) = reflex ? 1 : -1;
  sign_of(uv) = reflex ? std::int8_t{-1} : at_v;
  for (const HalfedgeId h : {before, wu, uv}) c.add(h);
  return c;
}

}  // namespace taut::internal::proof
