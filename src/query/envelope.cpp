#include "taut/envelope.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>

#include "numeric/budget.hpp"
#include "numeric/progress.hpp"
#include "query/cell_pair.hpp"
#include "scene/ignored_pairs.hpp"
#include "scene/untested.hpp"
#include "spacetime/first_contact.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

/// How each body hangs on others: itself, its parent, and so on.
using Chain = std::vector<int>;

void drop_common(Chain& a, Chain& b) {
  while (!a.empty() && !b.empty() && a.back() == b.back()) {
    a.pop_back();
    b.pop_back();
  }
}

/// One pair that is asked about: the bodies in their roles, and the chains from them up to what they have in common.
struct LinkedPair {
  PairInstance search;
  Chain of_p, of_q;  ///< the innermost first, without common parents
  CellPair cells;
  std::array<BodyId, 2> bodies;

  LinkedPair(const Instance& world, int a, int b, const std::vector<Chain>& chains)
      : search(world, a, b, Offset::outward), cells(search.geometry, search.trees()), bodies(world.scene_pair(a, b)) {
    of_p = chains[static_cast<std::size_t>(search.bodies.rings[0]->body())];
    of_q = chains[static_cast<std::size_t>(search.bodies.rings[1]->body())];
    drop_common(of_p, of_q);
  }
};

/// The cross-sections of two bodies that have a layer in common.
std::vector<std::array<int, 2>> sections_of_pair(const Instance& world, const std::array<BodyId, 2>& bodies) {
  std::vector<std::array<int, 2>> pairs;
  for (const int a : world.sections(bodies[0])) {
    for (const int b : world.sections(bodies[1])) {
      if (!world.excluded(a, b)) pairs.push_back({a, b});
    }
  }
  return pairs;
}

/// Two bodies that no joint moves against each other overlap.
bool overlap_at_rest(const Instance& world, const std::array<BodyId, 2>& bodies) {
  const std::vector<std::array<int, 2>> sections = sections_of_pair(world, bodies);
  return std::any_of(sections.begin(), sections.end(), [&](const std::array<int, 2>& s) {
    const PairInstance pair(world, s[0], s[1], Offset::inward);
    return spacetime::overlapping(pair.geometry, pair.trees(), pair.segments()[0], world.start()).has_value();
  });
}

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
      : linkage_(linkage), options_(options), rests_(resting(linkage)), world_(rests_) {
    scale_ = std::ldexp(1.0, world_.exponent());
    link();
  }

  Envelope run() {
    OpenCell all;
    for (std::size_t k = 0; k < linkage_.joints.size(); ++k) {
      const Joint& joint = linkage_.joints[k];
      all.box.middle[k] = joint.lo + (joint.hi - joint.lo) / 2;
      all.box.half[k] = std::max(joint.hi - all.box.middle[k], all.box.middle[k] - joint.lo);
    }
    for (std::uint32_t i = 0; i < pairs_.size(); ++i) all.pairs.push_back(i);
    all.hints.resize(all.pairs.size());
    if (answer_.coverage.is_empty()) return untested();
    // The large ones first. A cell leaves the queue when it is done, so that a limit loses none.
    if (overlap_) {
      note(all, CellState::colliding, *overlap_);
    } else if (pairs_.empty()) {
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
  static Scene resting(const Linkage& linkage) { return posed(Linkage{linkage.joints, linkage.scene, {}}, {}); }

  void link() {
    const std::map<std::string, int> by_name = bodies_by_name(rests_);
    std::vector<Chain> chains(rests_.bodies.size());
    for (std::size_t i = 0; i < chains.size(); ++i) {
      for (int body = static_cast<int>(i);;) {
        chains[i].push_back(body);
        const std::string& parent = rests_.bodies[static_cast<std::size_t>(body)].relative_to;
        if (parent.empty()) break;
        body = by_name.at(parent);
      }
    }
    choose_pairs(chains);
  }
  /// Bodies that no joint moves against each other are tested once, as the scene says, and where there are no others.
  void choose_pairs(const std::vector<Chain>& chains) {
    const IgnoredPairs ignored(rests_);
    const int n = static_cast<int>(chains.size());
    std::vector<std::array<BodyId, 2>> fixed;
    bool any_moves = false;
    Coverage& coverage = answer_.coverage;
    for (int a = 0; a < n; ++a) {
      for (int b = a + 1; b < n; ++b) {
        checkpoint();
        ++coverage.pairs;
        const bool apart = move_apart(chains[static_cast<std::size_t>(a)], chains[static_cast<std::size_t>(b)]);
        any_moves = any_moves || apart;
        if (ignored.has(a, b)) {
          ++coverage.ignored;
        } else if (!apart) {
          fixed.push_back({a, b});
        } else {
          const std::vector<std::array<int, 2>> sections = sections_of_pair(world_, {a, b});
          ++(sections.empty() ? coverage.layers : coverage.tested);
          for (const auto& [of_a, of_b] : sections)
            pairs_.push_back(std::make_unique<LinkedPair>(world_, of_a, of_b, chains));
        }
      }
    }
    const bool tests_fixed = !any_moves || rests_.at_rest == AtRest::test;
    coverage.at_rest = tests_fixed ? 0 : fixed.size();
    if (!tests_fixed) return;
    for (const auto& pair : fixed) ++(sections_of_pair(world_, pair).empty() ? coverage.layers : coverage.tested);
    const auto found =
        std::find_if(fixed.begin(), fixed.end(), [&](const auto& pair) { return overlap_at_rest(world_, pair); });
    if (found != fixed.end()) overlap_ = *found;
  }
  Envelope untested() {
    answer_.outcome = Outcome::untested;
    answer_.reason = why_untested(answer_.coverage);
    answer_.undecided = 1;
    return std::move(answer_);
  }
  const std::array<BodyId, 2>& bodies_of(std::uint32_t pair) const { return pairs_[pair]->bodies; }
  const JointMotion* motion_of(int body) const {
    const auto i = static_cast<std::size_t>(body);
    return i < linkage_.motions.size() && linkage_.motions[i] ? &*linkage_.motions[i] : nullptr;
  }
  /// Is there a joint below what two chains have in common?
  bool move_apart(Chain a, Chain b) const {
    drop_common(a, b);
    return moves(a) || moves(b);
  }
  bool moves(const Chain& chain) const {
    return std::any_of(chain.begin(), chain.end(), [this](int body) { return motion_of(body) != nullptr; });
  }
  PoseModel pose(const Chain& chain, const JointCell& box) const {
    PoseModel whole;
    for (const int body : chain) {
      if (const JointMotion* motion = motion_of(body)) whole = pose_of(*motion, box, scale_).of(whole);
    }
    return whole;
  }
  PoseModel between(const LinkedPair& pair, const JointCell& box) const {
    const PoseModel q = pose(pair.of_q, box);
    return moves(pair.of_p) ? pose(pair.of_p, box).inverse().of(q) : q;
  }

  void evaluate(OpenCell& cell) {
    std::array<double, max_joints> effect{};
    OpenCell left{cell.box, cell.share, {}, {}};
    for (std::size_t i = 0; i < cell.pairs.size(); ++i) {
      const LinkedPair& pair = *pairs_[cell.pairs[i]];
      const PoseModel seen = between(pair, cell.box);
      const CellState state = pair.cells.evaluate(seen, cell.hints[i]);
      if (state == CellState::colliding) return note(cell, state, bodies_of(cell.pairs[i]));
      if (state == CellState::free) continue;
      left.pairs.push_back(cell.pairs[i]);
      left.hints.push_back(cell.hints[i]);
      add_effect(pair, seen, effect);
    }
    if (left.pairs.empty()) return note(cell, CellState::free, {});
    divide(left, effect);
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
      if (!is_rounding && (follows(pair.of_p, k) || follows(pair.of_q, k))) effect[k] += left_out;
    }
  }
  bool follows(const Chain& chain, std::size_t joint) const {
    return std::any_of(chain.begin(), chain.end(), [&](int body) {
      const JointMotion* motion = motion_of(body);
      return motion && static_cast<std::size_t>(motion->joint) == joint;
    });
  }
  double side(const OpenCell& cell, std::size_t k) const {
    const Joint& joint = linkage_.joints[k];
    // What halves overlap by does not make them longer.
    return joint.hi > joint.lo ? 2 * cell.box.half[k] / (joint.hi - joint.lo) * (1 - 0x1p-30) : 0;
  }
  /// Across the joint that moves most, of those whose sides are longer than the tolerance. Halves overlap by what
  /// rounds.
  void divide(const OpenCell& cell, const std::array<double, max_joints>& effect) {
    std::optional<std::size_t> widest;
    for (std::size_t k = 0; k < linkage_.joints.size(); ++k) {
      const double half = cell.box.half[k] / 2, middle = cell.box.middle[k];
      if (!(side(cell, k) > options_.tolerance) || !(effect[k] > 0) ||
          !(middle - half < middle && middle < middle + half))
        continue;
      if (!widest || effect[k] > effect[*widest]) widest = k;
    }
    if (!widest) return note(cell, CellState::undecided, bodies_of(cell.pairs.front()));
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
      for (const auto& pair : pairs_) {
        std::optional<InnerPoint> hint;
        if (pair->cells.evaluate(between(*pair, point), hint) != CellState::colliding) continue;
        answer_.witness = {point.middle, pair->bodies};
        return;
      }
    }
  }

  const Linkage& linkage_;
  const EnvelopeOptions& options_;
  Scene rests_;
  Instance world_;
  double scale_ = 1;
  std::vector<std::unique_ptr<LinkedPair>> pairs_;  ///< that joints move against each other
  std::optional<std::array<BodyId, 2>> overlap_;    ///< of bodies that are fixed to each other, if they are tested
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
