// Goes through a log about paths. What a valid log proves, and why: docs/path-logs.md.
#include <algorithm>
#include <deque>
#include <vector>

#include "numeric/budget.hpp"
#include "proof/barrier_checker.hpp"
#include "proof/format.hpp"
#include "proof/mechanism_cells.hpp"
#include "proof/path_checker.hpp"
#include "taut/path_proof.hpp"

namespace taut::internal::proof {
namespace {

/// The partition of a log: its leaves that are not shown to collide, and how they hang together.
class Partition {
 public:
  Partition(const PathProblem& problem, const PathChecker& checker, ByteReader& in)
      : problem_(problem), checker_(checker), joints_(problem.linkage.joints.size()) {
    read(in);
  }

  std::uint64_t leaves() const { return leaves_; }
  std::uint64_t colliding() const { return colliding_; }

  /// Goes from the start through leaves that have a face in common. Throws ProofError if that leads to the goal.
  std::uint64_t reach() const {
    std::vector<char> reached(nodes_.size(), 0);
    std::deque<std::uint32_t> todo;
    const auto visit = [&](std::uint32_t leaf) {
      if (reached[leaf]) return;
      if (CellValues(problem_, nodes_[leaf].cell).may_lock(problem_))
        throw ProofError("a cell is reached in which the mechanism may lock, or go on in another way");
      reached[leaf] = 1;
      todo.push_back(leaf);
    };
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].state == State::open && checker_.may_be_start(nodes_[i].cell)) visit(i);
    }
    std::uint64_t count = 0;
    for (; !todo.empty(); ++count) {
      checkpoint();
      const PathCell& cell = nodes_[todo.front()].cell;
      todo.pop_front();
      if (checker_.may_be_goal(cell))
        throw ProofError("cells of which the log does not show that they collide lead from the start to the goal");
      each_neighbour(cell, visit);
    }
    return count;
  }

 private:
  enum class State : std::uint8_t { halved, open, colliding };
  struct Node {
    PathCell cell;
    State state = State::open;
    std::uint8_t joint = 0;
    std::uint32_t upper = 0;  ///< the lower half comes next
  };

  /// In order, each node before its halves; the ones that still wait for their upper half are kept.
  void read(ByteReader& in) {
    PathCell all;
    for (std::size_t k = 0; k < joints_; ++k) all.side[k] = PathCell::whole;
    struct Waiting {
      PathCell cell;
      std::uint32_t parent;
    };
    std::vector<Waiting> todo = {{all, UINT32_MAX}};
    while (!todo.empty()) {
      checkpoint();
      const auto [cell, parent] = todo.back();
      todo.pop_back();
      const auto id = static_cast<std::uint32_t>(nodes_.size());
      if (parent != UINT32_MAX && id != parent + 1) nodes_[parent].upper = id;
      if (id % 64 == 0) report_parts("cells", id);
      const PathClaim claim = read_path_claim(in);
      if (!checker_.holds(claim, cell))
        throw ProofError("cell " + std::to_string(id) + ", before byte " + std::to_string(in.offset()) +
                         ": it is not shown to collide");
      nodes_.push_back({cell, State::open, 0, 0});
      if (claim.kind != PathNode::halved) {
        ++leaves_;
        if (claim.kind == PathNode::open) continue;
        ++colliding_;
        nodes_.back().state = State::colliding;
        continue;
      }
      nodes_.back().state = State::halved;
      nodes_.back().joint = claim.joint;
      if (cell.side[claim.joint] < 2) throw ProofError("a cell is halved too often");
      PathCell lower = cell;
      lower.side[claim.joint] /= 2;
      PathCell upper = lower;
      upper.lo[claim.joint] += lower.side[claim.joint];
      todo.push_back({upper, id});
      todo.push_back({lower, id});
    }
  }

  bool share_face(const PathCell& a, const PathCell& b) const {
    int touching = 0;
    for (std::size_t k = 0; k < joints_; ++k) {
      const std::int64_t lo = std::max(a.lo[k], b.lo[k]), hi = std::min(a.lo[k] + a.side[k], b.lo[k] + b.side[k]);
      if (lo > hi) return false;
      if (lo == hi) ++touching;
    }
    return touching <= 1;
  }
  template <class Visit>
  void each_leaf_at(const PathCell& cell, const Visit& visit) const {
    std::vector<std::uint32_t> todo = {0};
    while (!todo.empty()) {
      const std::uint32_t id = todo.back();
      todo.pop_back();
      const Node& node = nodes_[id];
      if (node.state == State::halved) {
        const std::int64_t cut = nodes_[node.upper].cell.lo[node.joint];
        if (cell.lo[node.joint] <= cut) todo.push_back(id + 1);
        if (cell.lo[node.joint] + cell.side[node.joint] >= cut) todo.push_back(node.upper);
      } else if (node.state == State::open && share_face(cell, node.cell)) {
        visit(id);
      }
    }
  }
  /// Also across the ends of joints with a period.
  template <class Visit>
  void each_neighbour(const PathCell& cell, const Visit& visit) const {
    each_leaf_at(cell, visit);
    for (std::size_t k = 0; k < joints_; ++k) {
      if (!problem_.periodic[k]) continue;
      PathCell seen = cell;
      for (const std::int64_t turn : {PathCell::whole, -PathCell::whole}) {
        seen.lo[k] = cell.lo[k] + turn;
        each_leaf_at(seen, visit);
      }
    }
  }

  const PathProblem& problem_;
  const PathChecker& checker_;
  std::size_t joints_;
  std::vector<Node> nodes_;
  std::uint64_t leaves_ = 0, colliding_ = 0;
};

}  // namespace
}  // namespace taut::internal::proof

namespace taut {
using namespace internal;

bool is_path_log(std::istream& log) {
  const std::istream::pos_type begin = log.tellg();
  char first[8] = {};
  log.read(first, 8);
  log.clear();
  log.seekg(begin);
  return std::equal(proof::magic, proof::magic + 7, first) &&
         (first[7] == proof::of_paths || first[7] == proof::of_barriers);
}

VerifiedPath verify_path(const PathProblem& problem, std::istream& log) {
  validate(problem);
  proof::ByteReader in(log);
  for (const char c : proof::magic) {
    if (in.u8() != static_cast<std::uint8_t>(c)) throw ProofError("this is not a proof log of taut");
  }
  const auto kind = static_cast<char>(in.u8());
  if (kind != proof::of_paths && kind != proof::of_barriers) throw ProofError("the log is not about paths");
  VerifiedPath verified;
  for (std::uint8_t& byte : verified.fingerprint) byte = in.u8();
  if (verified.fingerprint != path_fingerprint(problem)) throw ProofError("the log belongs to another problem");
  if (kind == proof::of_barriers) {
    const proof::Barrier barrier = proof::read_barrier(in, problem.goal_outside);
    in.close();
    proof::BarrierChecker(problem).require(barrier);
    verified.touch = barrier.touching ? Touch::closed : Touch::open;
    verified.barrier = barrier.edges.size();
    return verified;
  }
  verified.clearance = in.f64();
  if (!(verified.clearance >= 0 && verified.clearance < INFINITY)) throw ProofError("the log's header makes no sense");
  const PathProblem stated = proof::with_stated_cells(problem, in);
  const proof::PathChecker checker(stated, verified.clearance);
  const proof::Partition partition(stated, checker, in);
  in.close();
  verified.cells = partition.leaves();
  verified.colliding = partition.colliding();
  verified.reached = partition.reach();
  return verified;
}

}  // namespace taut
