#include "motion/across_joint.hpp"

#include <utility>

#include "motion/joint_functions.hpp"
#include "motion/pieces.hpp"

namespace taut::internal {
namespace {

/// The link of a mechanism that a body is, or is carried by.
struct LinkInChain {
  const PieceList* motion = nullptr;  ///< nothing: the ground
  std::size_t after = 0;              ///< motions after these are the body's own
  JointFollower follower;
  int number() const { return motion ? follower.joint : -1; }
};

LinkInChain link_of(const MotionChain& chain) {
  for (std::size_t k = chain.size(); k-- > 0;) {
    if (chain[k].follows_joint()) return {&chain[k], k + 1, std::get<JointFollower>(chain[k][0].rotation)};
  }
  return {};
}

MotionChain part_of(const MotionChain& chain, std::size_t from, std::size_t to) {
  return {chain.begin() + static_cast<std::ptrdiff_t>(from), chain.begin() + static_cast<std::ptrdiff_t>(to)};
}

}  // namespace

std::optional<MotionsFrom> across_joint(const MotionChain& p, const MotionChain& q) {
  const LinkInChain a = link_of(p), b = link_of(q);
  const LinkInChain& known = a.motion ? a : b;
  if (!known.motion || (a.motion && b.motion && a.follower.functions != b.follower.functions)) return std::nullopt;
  const LoopEquations& equations = known.follower.functions->equations();
  const auto carries = [&](int link, int other) {
    return other >= 0 && equations.joints[static_cast<std::size_t>(other)].parent == link;
  };
  if (carries(a.number(), b.number()) || carries(b.number(), a.number())) return std::nullopt;
  std::size_t joint = equations.joints.size();
  const std::size_t end = joint + equations.closures.size() + equations.implied.size();
  const auto joins = [&](const LoopEquations::Closure& closure) {
    return (closure.first == a.number() && closure.second == b.number()) ||
           (closure.first == b.number() && closure.second == a.number());
  };
  while (joint < end && !joins(equations.closure(joint))) ++joint;
  if (joint == end) return std::nullopt;
  const LoopEquations::Closure& closure = equations.closure(joint);
  std::vector<MotionPiece> pieces;
  for (std::size_t k = 0; k < known.motion->size(); ++k) {
    JointFollower follower = std::get<JointFollower>((*known.motion)[k].rotation);
    follower.joint = static_cast<int>(joint);
    follower.slides = closure.slide;
    follower.direction = closure.direction;
    follower.sign = closure.first == a.number() ? 1 : -1;
    const int exponent = std::exchange(follower.exponent, 0);
    MotionPiece piece;
    piece.until = known.motion->until(k);
    if (!follower.slides) piece.pivot = closure.pivot;
    piece.rotation = std::move(follower);
    pieces.push_back(scaled(std::move(piece), exponent));
  }
  MotionsFrom out{part_of(p, 0, a.after), part_of(p, a.after, p.size()), {PieceList(pieces)}};
  const MotionChain rest = part_of(q, b.after, q.size());
  out.q.insert(out.q.end(), rest.begin(), rest.end());
  return out;
}

}  // namespace taut::internal
