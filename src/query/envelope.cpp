#include "taut/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "joints/linked_pairs.hpp"
#include "motion/loop_region.hpp"
#include "numeric/budget.hpp"
#include "query/cell_pair.hpp"
#include "scene/untested.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

/// A cell that is still to be evaluated, with what is known of it.
struct OpenCell {
  JointCell box;
  double share = 1;  ///< of all combinations
  std::vector<std::uint32_t> pairs;
  std::vector<std::optional<InnerPoint>> hints;  ///< of each of these
};

class EnvelopeSearch {
 public:
  EnvelopeSearch(const Linkage& linkage, const EnvelopeOptions& options)
      : linkage_(linkage), options_(options), pairs_(linkage) {
    for (const auto& pair : pairs_.pairs()) cells_.emplace_back(pair->search.geometry, pair->search.trees());
    answer_.coverage = pairs_.coverage();
  }

  Envelope run() {
    OpenCell all;
    for (std::size_t k = 0; k < linkage_.joints.size(); ++k) {
      const Joint& joint = linkage_.joints[k];
      all.box.middle[k] = joint.lo + (joint.hi - joint.lo) / 2;
      all.box.half[k] = std::max(joint.hi - all.box.middle[k], all.box.middle[k] - joint.lo);
    }
    for (std::uint32_t i = 0; i < cells_.size(); ++i) all.pairs.push_back(i);
    all.hints.resize(all.pairs.size());
    if (answer_.coverage.is_empty()) return untested();
    // The large ones first. A cell leaves the queue when it is done, so that a limit loses none.
    if (pairs_.overlap()) {
      note(all, CellState::colliding, *pairs_.overlap());
    } else if (cells_.empty()) {
      note(all, CellState::free, {});
    } else {
      queue_.push_back(std::move(all));
    }
    try {
      while (!queue_.empty()) {
        checkpoint();
        report_parts("cells", answer_.cells.size());
        report_share(answer_.free + answer_.colliding + answer_.undecided);
        evaluate(queue_.front());
        queue_.pop_front();
        looked_ = true;
      }
    } catch (const Interrupted& limit) {
      answer_.reason = limit.reason;
      if (!looked_) answer_.coverage = coverage_when_stopped(answer_.coverage, 0);
      for (const OpenCell& cell : queue_) note(cell, CellState::undecided, bodies_of(cell.pairs.front()));
    }
    conclude();
    return std::move(answer_);
  }

 private:
  Envelope untested() {
    answer_.outcome = Outcome::untested;
    answer_.reason = why_untested(answer_.coverage);
    answer_.undecided = 1;
    return std::move(answer_);
  }
  const std::array<BodyId, 2>& bodies_of(std::uint32_t pair) const { return pairs_[pair].bodies; }

  void evaluate(OpenCell& cell) {
    std::array<double, max_joints> effect{};
    if (const MayLock lock = pairs_.may_lock(cell.box); lock.anywhere) {
      for (std::size_t k = 0; k < linkage_.joints.size(); ++k) effect[k] = lock.joints[k] ? side(cell, k) : 0;
      return divide(cell, effect, true);
    }
    OpenCell left{cell.box, cell.share, {}, {}};
    for (std::size_t i = 0; i < cell.pairs.size(); ++i) {
      const LinkedPair& pair = pairs_[cell.pairs[i]];
      const PoseModel seen = pairs_.between(pair, cell.box);
      const CellState state = cells_[cell.pairs[i]].evaluate(seen, cell.hints[i]);
      if (state == CellState::colliding) return note(cell, state, bodies_of(cell.pairs[i]));
      if (state == CellState::free) continue;
      left.pairs.push_back(cell.pairs[i]);
      left.hints.push_back(cell.hints[i]);
      add_effect(pair, seen, effect);
    }
    if (left.pairs.empty()) return note(cell, CellState::free, {});
    divide(left, effect, false);
  }
  /// How far the joints may move a pair's bodies across the cell. To first order that may be 0 at the middle and matter
  /// nevertheless: each joint that the pair follows may be all of what the model leaves out, unless that is rounding.
  void add_effect(const LinkedPair& pair, const PoseModel& seen, std::array<double, max_joints>& effect) const {
    constexpr double more_than_rounding = 0x1p-40;
    const double radius = pair.search.tree_q.node(0).box.radius;
    const JointModel centre = seen.place(pair.search.tree_q.node(0).box.centre);
    const double left_out = centre.error + seen.rotation.error * radius;
    const bool is_rounding = left_out <= more_than_rounding * (centre.reach() + seen.rotation.reach() * radius);
    for (std::size_t k = 0; k < effect.size(); ++k) {
      effect[k] += l1_norm(centre.rate[k]) + l1_norm(seen.rotation.rate[k]) * radius;
      if (!is_rounding && pairs_.follows(pair, k)) effect[k] += left_out;
    }
  }
  double side(const OpenCell& cell, std::size_t k) const {
    const Joint& joint = linkage_.joints[k];
    // What halves overlap by does not make them longer.
    return joint.hi > joint.lo ? 2 * cell.box.half[k] / (joint.hi - joint.lo) * (1 - 0x1p-30) : 0;
  }
  /// Across the joint that moves most, of those whose sides are longer than the tolerance. Halves overlap by what
  /// rounds.
  void divide(const OpenCell& cell, const std::array<double, max_joints>& effect, bool may_lock) {
    std::optional<std::size_t> widest;
    for (std::size_t k = 0; k < linkage_.joints.size(); ++k) {
      const double half = cell.box.half[k] / 2, middle = cell.box.middle[k];
      if (!(side(cell, k) > options_.tolerance) || !(effect[k] > 0) ||
          !(middle - half < middle && middle < middle + half))
        continue;
      if (!widest || effect[k] > effect[*widest]) widest = k;
    }
    if (!widest) {
      note(cell, CellState::undecided, bodies_of(cell.pairs.front()));
      answer_.cells.back().may_lock = may_lock;
      if (may_lock) answer_.may_lock += cell.share;
      return;
    }
    for (const double sign : {-1.0, 1.0}) {
      OpenCell half = cell;
      half.share /= 2;
      double& middle = half.box.middle[*widest];
      middle += sign * half.box.half[*widest] / 2;
      half.box.half[*widest] = half.box.half[*widest] / 2 + 0x1p-51 * std::fabs(middle);
      queue_.push_back(std::move(half));
    }
  }

  void note(const OpenCell& cell, CellState state, const std::array<BodyId, 2>& pair) {
    EnvelopeCell done;
    done.state = state;
    done.pair = pair;
    for (std::size_t k = 0; k < linkage_.joints.size(); ++k) {
      const Joint& joint = linkage_.joints[k];
      done.lo[k] = std::max(joint.lo, cell.box.middle[k] - cell.box.half[k]);
      done.hi[k] = std::min(joint.hi, cell.box.middle[k] + cell.box.half[k]);
    }
    (state == CellState::free        ? answer_.free
     : state == CellState::colliding ? answer_.colliding
                                     : answer_.undecided) += cell.share;
    if (state == CellState::colliding && !answer_.witness) answer_.witness = {cell.box.middle, done.pair};
    answer_.cells.push_back(done);
  }

  void conclude() {
    if (!answer_.witness) look_at_middles();
    answer_.other_poses = std::any_of(linkage_.loops.begin(), linkage_.loops.end(), [](const DrivenLoops& loops) {
      return loops.region && !loops.region->has_one_pose();
    });
    answer_.outcome = answer_.witness ? Outcome::contact : answer_.undecided > 0 ? Outcome::undecided : Outcome::free;
  }
  /// What collides may be thinner than the tolerance: single combinations decide.
  void look_at_middles() {
    constexpr int most_middles = 10000;
    int tried = 0;
    for (const EnvelopeCell& cell : answer_.cells) {
      if (cell.state != CellState::undecided || ++tried > most_middles) continue;
      JointCell point;
      for (std::size_t k = 0; k < linkage_.joints.size(); ++k)
        point.middle[k] = cell.lo[k] + (cell.hi[k] - cell.lo[k]) / 2;
      for (std::size_t i = 0; i < cells_.size() && !pairs_.may_lock(point).anywhere; ++i) {
        std::optional<InnerPoint> hint;
        if (cells_[i].evaluate(pairs_.between(pairs_[i], point), hint) != CellState::colliding) continue;
        answer_.witness = {point.middle, pairs_[i].bodies};
        return;
      }
    }
  }

  const Linkage& linkage_;
  const EnvelopeOptions& options_;
  LinkedPairs pairs_;
  std::vector<CellPair> cells_;  ///< of each of these
  std::deque<OpenCell> queue_;
  bool looked_ = false;  ///< at a cell, and so at all pairs
  Envelope answer_;
};

}  // namespace

Envelope envelope(const Linkage& linkage, const EnvelopeOptions& options) {
  if (!(options.tolerance >= 1e-6 && options.tolerance <= 1))
    throw InputError("tolerance", "it is not between 1e-6 and 1", "it is a share of each joint's range");
  const Budget scope(options.limits);
  Envelope answer;
  try {
    scope.check();
    validate(linkage);
    return EnvelopeSearch(linkage, options).run();
  } catch (const Interrupted& limit) {
    answer.reason = limit.reason;
  }
  answer.coverage = coverage_before_search(linkage.scene);
  answer.undecided = 1;
  return answer;
}

}  // namespace taut
