#include "solver/robot_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "spacetime/box_separation.hpp"

namespace taut::internal {

using spacetime::Stretch;
using spacetime::UniformSegment;

namespace {

/// The approximate number of vertices of each outline of a link that are tested for lying in free space.
constexpr std::uint32_t outline_vertices = 8;

/// The link's box over the whole stretch, in the world's frame.
AxisBox box_over(const Stretch& s, const spacetime::Box& box) {
  const spacetime::Path way = s.in_p.place(box.centre, {});
  const double around = (box.radius + s.in_p.error) * (1 + 0x1p-40);
  const double wide = way.x.swing(s.r) * (1 + 0x1p-40) + around, high = way.y.swing(s.r) * (1 + 0x1p-40) + around;
  return {way.x.a - wide, way.y.a - high, way.x.a + wide, way.y.a + high};
}

}  // namespace

RobotSearch::RobotSearch(const MapBodies& bodies, std::vector<Link> links, Offset offset, bool links_meet)
    : bodies_(bodies), cells_(bodies.free_cells->of(bodies.rings)), links_(std::move(links)), offset_(offset) {
  for (const SharedRings& body : bodies.rings) body_trees_.push_back(&tree_of(*body, offset));
  for (const Link& link : links_) {
    LinkState state;
    state.tree = &tree_of(*link.rings, offset);
    state.size = 2 * state.tree->node(0).box.radius;
    state.reach = spacetime::reach_of(*state.tree);
    state.met.resize(bodies.rings.size());
    const DisplacedPolygon& shape = *link.rings->displaced(offset);
    for (const RingSpan& ring : rings_of(shape)) {
      if (ring.hole) continue;
      state.outlines.emplace_back();
      // A few vertices, distributed around it, suffice.
      for (std::uint32_t i = 0; i < ring.count; i += std::max(1u, ring.count / outline_vertices)) {
        const DisplacedPoint& v = shape.points[ring.first + i];
        state.outlines.back().push_back({v.x, v.y});
      }
    }
    state.chain.resize(link.parent < 0 ? 1 : states_[static_cast<std::size_t>(link.parent)].chain.size() + 1);
    states_.push_back(std::move(state));
  }
  const int n = static_cast<int>(links_.size());
  for (int p = 0; links_meet && p < n; ++p) {
    for (int q = p + 1; q < n; ++q) {
      const auto &of_p = links_[static_cast<std::size_t>(p)], &of_q = links_[static_cast<std::size_t>(q)];
      if (of_q.parent == p || !of_p.z.meet(of_q.z)) continue;
      LinkPair pair;
      pair.p = p;
      pair.q = q;
      pair.common = common_parents(p, q);
      pair.geometry = {of_p.rings->displaced(offset), of_q.rings->displaced(offset)};
      pairs_.push_back(std::move(pair));
    }
  }
}

std::size_t RobotSearch::common_parents(int p, int q) const {
  const auto line = [this](int link) {
    std::vector<int> parents;
    for (int k = link; k >= 0; k = links_[static_cast<std::size_t>(k)].parent) parents.insert(parents.begin(), k);
    return parents;
  };
  const std::vector<int> a = line(p), b = line(q);
  const auto [end, other_end] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  return static_cast<std::size_t>(end - a.begin());
}

std::vector<std::array<int, 2>> RobotSearch::meeting() const {
  std::vector<std::array<int, 2>> all;
  for (const LinkPair& pair : pairs_) all.push_back({pair.p, pair.q});
  return all;
}

void RobotSearch::set(std::span<const MotionPiece> own) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    PieceChain& chain = states_[k].chain;
    if (links_[k].parent >= 0) {
      const PieceChain& parent = states_[static_cast<std::size_t>(links_[k].parent)].chain;
      std::copy(parent.begin(), parent.end(), chain.begin());
    }
    chain.back() = own[k];
  }
  const auto rest = [this](int link, std::size_t common, PieceChain& to) {
    const PieceChain& chain = states_[static_cast<std::size_t>(link)].chain;
    to.resize(chain.size() - common);
    std::copy(chain.begin() + static_cast<std::ptrdiff_t>(common), chain.end(), to.begin());
  };
  for (LinkPair& pair : pairs_) {
    rest(pair.p, pair.common, pair.chain_p);
    rest(pair.q, pair.common, pair.chain_q);
  }
}

bool RobotSearch::find_near(std::size_t link, const Stretch& s, const Window* among) {
  const LinkState& state = states_[link];
  box_ = box_over(s, state.tree->node(0).box);
  near_.clear();
  if (among) {
    for (std::size_t i = among->first; i < among->last; ++i) {
      if (bodies_.boxes_of[static_cast<std::size_t>(state.nearby[i])].meets(box_)) near_.push_back(state.nearby[i]);
    }
  } else {
    bodies_.boxes.find(box_, near_);
    if (bodies_.layered)
      std::erase_if(near_, [&](int k) { return !bodies_.z[static_cast<std::size_t>(k)].meet(links_[link].z); });
  }
  list_others(link);
  return !near_.empty();
}

/// Of `near_`.
void RobotSearch::list_others(std::size_t link) {
  LinkState& state = states_[link];
  others_.clear();
  for (const int body : near_) {
    const auto at = static_cast<std::size_t>(body);
    std::unique_ptr<PairGeometry>& met = state.met[at];
    if (!met)
      met =
          std::make_unique<PairGeometry>(bodies_.rings[at]->displaced(offset_), links_[link].rings->displaced(offset_));
    others_.push_back({met.get(), body_trees_[at]});
  }
}

RobotFinding RobotSearch::found(Outcome outcome, double lo, double hi, Names names, std::size_t other) const {
  return {outcome,
          lo,
          hi,
          names.link,
          names.other_link < 0 ? bodies_.rings[static_cast<std::size_t>(near_[other])]->body() : -1,
          names.other_link};
}

/// The surroundings of the link, provided that its edges cross none of the map's: covered, if a vertex is certainly
/// inside of a body; free, if each outline has a vertex in free space.
FreeCells::Cell RobotSearch::around(const LinkState& link, const spacetime::QAtPose& pose) const {
  constexpr double decided_by_cells = 0x1p-32;
  if (!(pose.error < decided_by_cells)) return FreeCells::Cell::mixed;
  bool all_free = true;
  for (const std::vector<Vector>& outline : link.outlines) {
    bool one_free = false;
    for (const Vector v : outline) {
      const Vector at = pose.at(v);
      const FreeCells::Cell cell = cells_.at(at.x, at.y);
      // Of which body is not known: it may be on another layer.
      if (cell == FreeCells::Cell::covered) return bodies_.layered ? FreeCells::Cell::mixed : cell;
      one_free = cell == FreeCells::Cell::free;
      if (one_free) break;
    }
    all_free = all_free && one_free;
  }
  return all_free ? FreeCells::Cell::free : FreeCells::Cell::mixed;
}

/// The first of `others_` that the mover overlaps at the instant. It is decided in doubles, by edges that cross and by
/// free cells, and exactly where these do not decide. `with_map` is the link, if it is tested against bodies of the
/// map.
std::optional<std::size_t> RobotSearch::overlapped(const UniformSegment& segment, const Hierarchy& mover,
                                                   const Stretch& instant, const LinkState* with_map) {
  const double t = instant.middle;
  const spacetime::QAtPose pose = spacetime::QAtPose::of(instant);
  const FreeCells::Cell cell = with_map ? around(*with_map, pose) : FreeCells::Cell::mixed;
  // A vertex inside of a body is an overlap, regardless of the edges. The body is known only if there is just one.
  if (cell == FreeCells::Cell::covered && others_.size() == 1) return 0;
  const bool within = cell != FreeCells::Cell::free;
  inside_.clear();
  if (with_map) cells_.outlines_in(box_, inside_);
  for (std::size_t i = 0; i < others_.size(); ++i) {
    const spacetime::Other& other = others_[i];
    const spacetime::EdgesCross cross = posed_.edges_cross(pose, *other.geometry, *other.tree, mover);
    if (cross == spacetime::EdgesCross::yes) return i;
    const bool holds = with_map && std::binary_search(inside_.begin(), inside_.end(), near_[i]);
    if (cross == spacetime::EdgesCross::no && !within && !holds) continue;
    if (spacetime::overlapping(*other.geometry, {*other.tree, mover}, segment.segment(), t,
                               segment.stretch(t, t).everywhere()))
      return i;
  }
  return std::nullopt;
}

RobotFinding RobotSearch::at(double t) {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (roams_free(k, t, t)) continue;
    const LinkState& state = states_[k];
    const UniformSegment segment(world_chain, state.chain, *state.tree, t, t + 1);
    const Stretch instant = segment.instant(t);
    if (!find_near(k, instant)) continue;
    if (const auto other = overlapped(segment, *state.tree, instant, &state))
      return found(Outcome::overlap_at_start, t, t, {static_cast<int>(k), -1}, *other);
  }
  for (const LinkPair& pair : pairs_) {
    const Hierarchy& mover = *states_[static_cast<std::size_t>(pair.q)].tree;
    const UniformSegment segment(pair.chain_p, pair.chain_q, mover, t, t + 1);
    others_.assign(1, {&pair.geometry, states_[static_cast<std::size_t>(pair.p)].tree});
    if (overlapped(segment, mover, segment.instant(t), nullptr))
      return found(Outcome::overlap_at_start, t, t, {pair.p, pair.q}, 0);
  }
  return {};
}

/// The other bodies are in `others_`. The result counts if it is earlier than the known one.
void RobotSearch::search(const UniformSegment& segment, const Hierarchy& mover, Names names, double from, double to,
                         RobotFinding& best) {
  try {
    if (best.outcome == Outcome::contact) to = std::max(std::nextafter(from, to), std::min(to, best.hi));
    const auto contact = uniform_pairs_.run(segment, others_, mover, from, to, any_);
    if (contact && (best.outcome == Outcome::free || contact->lo < best.lo))
      best = found(Outcome::contact, contact->lo, contact->hi, names, contact->other);
  } catch (const Undecidable&) {
    // The earliest undecided contact: nothing is claimed beyond it.
    if (best.outcome != Outcome::free && best.lo <= uniform_pairs_.proved()) return;
    best = {Outcome::undecided, uniform_pairs_.proved(), uniform_pairs_.proved(), names.link, -1, names.other_link};
  }
}

RobotFinding RobotSearch::along(double from, double to, bool any) {
  any_ = any;
  RobotFinding best;
  best.lo = best.hi = to;
  for (LinkState& state : states_) state.nearby.clear();
  if (any) {
    search_any(from, to, best);
    if (best.outcome != Outcome::free) return best;
  } else {
    for (std::size_t k = 0; k < links_.size(); ++k) {
      if (!roams_free(k, from, to)) cover(k, from, to, best);
    }
  }
  for (const LinkPair& pair : pairs_) {
    if (any && best.outcome != Outcome::free) break;
    const Hierarchy& mover = *states_[static_cast<std::size_t>(pair.q)].tree;
    const UniformSegment segment(pair.chain_p, pair.chain_q, mover, from, to);
    others_.assign(1, {&pair.geometry, states_[static_cast<std::size_t>(pair.p)].tree});
    search(segment, mover, {pair.p, pair.q}, from, to, best);
  }
  return best;
}

/// Searches the bridge, against all of `others_`.
void RobotSearch::cross(MotionSegment bridge, const Hierarchy& mover, Names names, RobotFinding& best) {
  const double t = bridge.joint;
  const MotionSegments segments(std::move(bridge));
  for (std::size_t i = 0; i < others_.size() && best.outcome == Outcome::free; ++i) {
    const spacetime::SpacetimeResult r =
        spacetime::first_contact(*others_[i].geometry, {*others_[i].tree, mover}, segments);
    if (r.outcome == spacetime::SpacetimeResult::free) continue;
    const bool contact = r.outcome == spacetime::SpacetimeResult::contact;
    best = found(contact ? Outcome::contact : Outcome::undecided, t, t, names, i);
  }
}

/// Keeps those of `others_` that the link may meet between its previous and its current pose. These differ by rounding,
/// by which the stretch is widened.
void RobotSearch::find_crossed(std::size_t link, double t) {
  const Hierarchy& mover = *states_[link].tree;
  const UniformSegment before(world_chain, states_[link].before, mover, t, t + 1);
  const UniformSegment after(world_chain, states_[link].chain, mover, t, t + 1);
  Stretch s = before.stretch(t, t).everywhere();
  const Stretch to = after.stretch(t, t).everywhere();
  const auto gap = [](const spacetime::Path& a, const spacetime::Path& b) {
    return std::fabs(a.x.a - b.x.a) + std::fabs(a.y.a - b.y.a);
  };
  s.in_p.error += to.in_p.error + gap(s.in_p.shift, to.in_p.shift) + 5 * gap(s.in_p.rotation, to.in_p.rotation);
  // Between the two poses the link is not quite rigid: nothing is claimed in its own frame.
  s.in_q.error = INFINITY;
  find_near(link, s);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < others_.size(); ++i) {
    if (spacetime::apart(s, *others_[i].tree, mover)) continue;
    others_[kept] = others_[i];
    near_[kept++] = near_[i];
  }
  others_.resize(kept);
  near_.resize(kept);
}

RobotFinding RobotSearch::join(std::span<const MotionPiece> next, double t) {
  for (LinkState& state : states_) state.before = state.chain;
  for (LinkPair& pair : pairs_) {
    pair.before_p = pair.chain_p;
    pair.before_q = pair.chain_q;
  }
  set(next);
  RobotFinding best;
  best.lo = best.hi = t;
  for (std::size_t k = 0; k < links_.size(); ++k) {
    find_crossed(k, t);
    if (others_.empty()) continue;
    const PieceChain rests{MotionPiece{}};
    cross(MotionSegment::bridging_chains(rests, states_[k].before, rests, states_[k].chain, t), *states_[k].tree,
          {static_cast<int>(k), -1}, best);
  }
  for (const LinkPair& pair : pairs_) {
    others_.assign(1, {&pair.geometry, states_[static_cast<std::size_t>(pair.p)].tree});
    cross(MotionSegment::bridging_chains(pair.before_p, pair.before_q, pair.chain_p, pair.chain_q, t),
          *states_[static_cast<std::size_t>(pair.q)].tree, {pair.p, pair.q}, best);
  }
  return best;
}

}  // namespace taut::internal
