// Writes logs about paths: the partition of the search, with what shows of each cell that it collides.
#include <algorithm>
#include <climits>
#include <cmath>
#include <ostream>
#include <sstream>
#include <string>

#include "numeric/budget.hpp"
#include "path/goal.hpp"
#include "path/path_search.hpp"
#include "path/slides.hpp"
#include "proof/barrier.hpp"
#include "proof/format.hpp"
#include "proof/mechanism_cells.hpp"
#include "proof/path_checker.hpp"
#include "scene/ring_set.hpp"
#include "taut/path_proof.hpp"

namespace taut {
using namespace internal;
namespace {

/// Cells that the verifier's bounds do not show to collide are halved, so often at the most.
constexpr std::uint32_t most_halvings = 24;

class PathLogWriter {
 public:
  PathLogWriter(const PathProblem& problem, const path::JointSpace& space, path::CellTree& tree, double clearance)
      : problem_(problem), space_(space), tree_(tree), goal_(problem, space), checker_(problem, clearance) {
    // Bounds of the verifier may want cells that are smaller than those of the search.
    tree_.set_tolerance(0);
  }

  /// False if some cell was not shown to collide, or to be without a goal, by bounds as the verifier has them.
  bool write(proof::ByteWriter& out) {
    std::vector<Item> todo = {{tree_.root(), false, 0}};
    while (!todo.empty()) {
      checkpoint();
      const Item item = todo.back();
      todo.pop_back();
      const bool collides = item.collides || tree_[item.id].state == CellState::colliding;
      std::uint32_t halvings = item.halvings;
      if (tree_[item.id].is_leaf()) {
        const std::optional<proof::PathClaim> claim = collides ? proved_claim(item.id) : open_claim(item.id);
        if (claim) {
          proof::write(out, *claim);
          continue;
        }
        const bool divisible = !collides || tree_[item.id].open;
        if (++halvings > most_halvings || !divisible || !tree_.divide(item.id)) return false;
      }
      proof::PathClaim halved;
      halved.kind = proof::PathNode::halved;
      halved.joint = tree_[item.id].axis;
      proof::write(out, halved);
      todo.push_back({tree_[item.id].children + 1, collides, halvings});
      todo.push_back({tree_[item.id].children, collides, halvings});
    }
    return true;
  }

 private:
  struct Item {
    path::CellId id;
    bool collides;           ///< it, or a cell around it, does by the bounds of the search
    std::uint32_t halvings;  ///< for the verifier's sake
  };

  /// Nothing needs to be said of a cell, unless the verifier's bounds do not show what those of the search do: that
  /// there is no goal in it.
  std::optional<proof::PathClaim> open_claim(path::CellId id) const {
    const bool in_doubt = checker_.may_be_goal({tree_[id].lo, tree_[id].side}) && !goal_.may_meet(tree_.box(id));
    return in_doubt ? std::nullopt : std::optional(proof::PathClaim{});
  }
  std::optional<proof::PathClaim> proved_claim(path::CellId id) const {
    if (!tree_[id].open) return std::nullopt;
    const std::optional<path::CellReason> reason = space_.why(tree_.box(id), *tree_[id].open);
    if (!reason) return std::nullopt;
    const proof::PathClaim claim = reason->collision ? claim_of(reason->pair, *reason->collision) : claim_of(*reason);
    if (!checker_.holds(claim, {tree_[id].lo, tree_[id].side})) return std::nullopt;
    return claim;
  }

  const RingSet& rings(std::uint32_t pair, bool of_p) const {
    return *space_.pairs()[pair].search.bodies.rings[of_p ? 0 : 1];
  }
  /// An edge or a vertex, by its number among those of the body.
  template <class Ref>
  proof::PathFeature feature(const Ref& ref) const {
    std::size_t number = 0;
    const std::vector<Part> parts = parts_of(problem_.linkage.scene.bodies[static_cast<std::size_t>(ref.body)]);
    for (std::size_t p = 0; p < parts.size(); ++p) {
      const int ring = static_cast<int>(p) < ref.part ? INT_MAX : static_cast<int>(p) == ref.part ? ref.ring : 0;
      if (ring > 0) number += parts[p].outline.size();
      for (int h = 0; h < std::min(ring - 1, static_cast<int>(parts[p].holes.size())); ++h)
        number += parts[p].holes[static_cast<std::size_t>(h)].size();
    }
    return {static_cast<std::uint32_t>(ref.body),
            static_cast<std::uint32_t>(number + static_cast<std::size_t>(ref.index))};
  }
  proof::PathCrossing crossing(std::uint32_t pair, std::uint32_t p, std::uint32_t q) const {
    return {feature(rings(pair, true).edge(p)), feature(rings(pair, false).edge(q)), 0, 0};
  }
  proof::PathClaim claim_of(std::uint32_t pair, const path::Collision& collision) const {
    using Kind = path::Collision::Kind;
    const RingSet &own = rings(pair, collision.of_p), &other = rings(pair, !collision.of_p);
    proof::PathClaim claim;
    switch (collision.kind) {
      case Kind::crossing:
        claim.kind = proof::PathNode::crossing;
        claim.crossings = {crossing(pair, collision.p, collision.q)};
        break;
      case Kind::inside: {
        claim.kind = proof::PathNode::inside;
        claim.body = static_cast<std::uint32_t>(own.body());
        claim.other = static_cast<std::uint32_t>(other.body());
        const double scale = space_.pairs().scale();
        claim.point = {collision.at.x / scale, collision.at.y / scale};
        break;
      }
      case Kind::near:
        claim.kind = proof::PathNode::near;
        claim.vertex = feature(own.vertex(collision.of_p ? collision.p : collision.q));
        claim.edge = feature(other.edge(collision.of_p ? collision.q : collision.p));
        break;
    }
    return claim;
  }
  /// Conditions of edges that are not of unit length: weights are divided by these.
  proof::PathClaim claim_of(const path::CellReason& reason) const {
    proof::PathClaim claim;
    claim.kind = proof::PathNode::conditions;
    for (std::size_t i = 0; i < reason.weights.size(); ++i) {
      if (reason.weights[i] <= 0) continue;
      const path::Condition& condition = reason.conditions[i];
      proof::PathCrossing c = crossing(condition.pair, condition.p, condition.q);
      const RingSet& own = rings(condition.pair, condition.vertex_of_p);
      const std::uint32_t edge = condition.vertex_of_p ? condition.p : condition.q;
      const proof::PathFeature named = feature(own.edge(edge)), begins = feature(own.vertex(edge));
      // Rings that run the other way begin their edges where the search ends them.
      const bool second = (named.vertex == begins.vertex) == condition.second_vertex;
      c.end = static_cast<std::uint8_t>((condition.vertex_of_p ? 0 : 2) + (second ? 1 : 0));
      const proof::PathFeature line = condition.vertex_of_p ? c.second : c.first;
      c.weight = reason.weights[i] / edge_length(line);
      claim.crossings.push_back(c);
    }
    return claim;
  }
  double edge_length(const proof::PathFeature& line) const {
    std::size_t left = line.vertex;
    for (const Part& part : parts_of(problem_.linkage.scene.bodies[line.body])) {
      for (std::size_t ring = 0; ring <= part.holes.size(); ++ring) {
        const Polygon& points = ring == 0 ? part.outline : part.holes[ring - 1];
        if (left < points.size()) {
          const Point &a = points[left], &b = points[(left + 1) % points.size()];
          return std::hypot(b.x - a.x, b.y - a.y) * space_.pairs().scale();
        }
        left -= points.size();
      }
    }
    return 1;
  }

  const PathProblem& problem_;
  const path::JointSpace& space_;
  path::CellTree& tree_;
  path::Goal goal_;
  proof::PathChecker checker_;
};

void write_path_header(proof::ByteWriter& out, const PathProblem& problem, char kind) {
  for (const char c : proof::magic) out.u8(static_cast<std::uint8_t>(c));
  out.u8(static_cast<std::uint8_t>(kind));
  for (const std::uint8_t byte : path_fingerprint(problem)) out.u8(byte);
}

/// A barrier as a log has it, or nothing if a corner is no exact number.
std::optional<proof::Barrier> barrier_of_log(const path::JointSpace& space, const path::Barrier& barrier,
                                             bool touching) {
  const Dyadic one(1, 0);
  const auto is_exact = [&](const path::ExactPoint& p) { return p.w == one; };
  const auto place = [](const path::ExactPoint& p) { return proof::ExactPlace{p.x, p.y}; };
  proof::Barrier log;
  log.touching = touching;
  for (std::size_t i = 0; i < 2; ++i) log.boxes[i] = static_cast<std::uint32_t>(barrier.boxes[i]);
  for (const path::BarrierEdge& edge : barrier.edges) {
    if (!is_exact(edge.from)) return std::nullopt;
    proof::BarrierEdge written;
    written.from = place(edge.from);
    written.side = static_cast<std::uint8_t>(edge.side);
    if (!edge.bodies) {
      written.kind = proof::BarrierEdge::Kind::outside;
    } else {
      if (!is_exact(edge.common[0]) || !is_exact(edge.common[1])) return std::nullopt;
      const path::ExactVector offset = path::slides_of(space.linkage(), (*edge.bodies)[0])->offset;
      written.body = static_cast<std::uint32_t>((*edge.bodies)[0]);
      written.other = static_cast<std::uint32_t>((*edge.bodies)[1]);
      for (std::size_t i = 0; i < 2; ++i)
        written.common[i] = place(edge.common[i]) - proof::ExactPlace{offset.x, offset.y};
    }
    log.edges.push_back(std::move(written));
  }
  return log;
}

}  // namespace

PathAnswer prove_path(const PathProblem& problem, std::ostream& log, const PathOptions& options) {
  std::string text;
  // What is handed out was read and found right: the log may have been written by bounds other than the verifier's.
  const auto take = [&](const std::ostringstream& written) {
    std::istringstream read(written.str());
    try {
      verify_path(problem, read);
    } catch (const ProofError&) {
      return false;
    }
    text = written.str();
    return true;
  };
  path::OnNone on_none;
  on_none.barrier = [&](const path::JointSpace& space, const path::Barrier& found) {
    const auto barrier = barrier_of_log(space, found, options.touch == Touch::closed);
    if (!barrier) return false;
    std::ostringstream written;
    proof::ByteWriter out(written);
    write_path_header(out, problem, proof::of_barriers);
    if (!write(out, *barrier, problem.goal_outside)) return false;
    out.close();
    return take(written);
  };
  on_none.cells = [&](const path::JointSpace& space, path::CellTree& tree) {
    std::ostringstream written;
    proof::ByteWriter out(written);
    write_path_header(out, problem, proof::of_paths);
    out.f64(options.clearance);
    write_cells(out, problem);
    if (!PathLogWriter(problem, space, tree, options.clearance).write(out)) return;
    out.close();
    take(written);
  };
  PathAnswer answer = path::find_path(problem, options, on_none);
  if (answer.outcome != PathOutcome::none) return answer;
  if (text.empty()) {
    answer.outcome = PathOutcome::undecided;
    answer.reason = "cells show that there is no way, but no proof was found that the verifier accepts";
    return answer;
  }
  log << text;
  return answer;
}

}  // namespace taut
