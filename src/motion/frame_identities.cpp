#include "motion/frame_identities.hpp"

#include <algorithm>

#include "motion/pieces.hpp"
#include "motion/symbolic.hpp"

namespace taut::internal {
namespace {

using Condition = std::array<Dyadic, 5>;

/// Independent conditions in a row echelon form without divisions: each lacks the leading entries of those before it.
class Echelon {
 public:
  /// Adds the condition. Returns true if it is independent of those before.
  bool add(Condition c) {
    for (const auto& [lead, row] : rows_) {
      if (c[lead].is_zero()) continue;
      const Dyadic factor = c[lead], pivot = row[lead];
      for (std::size_t i = 0; i < c.size(); ++i) c[i] = c[i] * pivot - row[i] * factor;
    }
    for (std::size_t i = 0; i < c.size(); ++i) {
      if (c[i].is_zero()) continue;
      rows_.emplace_back(i, std::move(c));
      return true;
    }
    return false;
  }
  bool full() const { return rows_.size() == 5; }

 private:
  std::vector<std::pair<std::size_t, Condition>> rows_;
};

}  // namespace

FrameIdentities::Side FrameIdentities::conditions_of(const std::array<Symbolic, 5>& functions,
                                                     const SymbolicSegment& segment) {
  Side side;
  side.known = std::all_of(functions.begin(), functions.end(), [](const Symbolic& f) { return f.known(); });
  if (!side.known) return side;
  Symbolic::Exponents denominator{};
  for (const Symbolic& f : functions) {
    for (std::size_t i = 0; i < denominator.size(); ++i) {
      denominator[i] = std::max(denominator[i], f.denominator()[i]);
    }
  }
  struct Terms {
    Symbolic::Key key;
    std::vector<Condition> by_power;
  };
  std::vector<Terms> all;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const Symbolic function = functions[i].over(denominator, segment);
    for (const Symbolic::Term& t : function.terms()) {
      auto found = std::find_if(all.begin(), all.end(), [&](const Terms& x) { return x.key == t.key; });
      if (found == all.end()) found = all.insert(all.end(), {t.key, {}});
      if (found->by_power.size() < t.polynomial.size()) found->by_power.resize(t.polynomial.size());
      for (std::size_t k = 0; k < t.polynomial.size(); ++k) found->by_power[k][i] = t.polynomial[k];
    }
  }
  Echelon echelon;
  for (const Terms& terms : all) {
    for (const Condition& c : terms.by_power) {
      if (!echelon.full() && echelon.add(c)) side.conditions.push_back(c);
    }
  }
  return side;
}

namespace {

/// Symbolic expressions are in powers of the time, or of one joint's value, if nothing else moves.
bool has_symbols(const MotionSegment& segment) {
  int joints = 0, others = 0;
  for (const PieceChain* chain : {&segment.p_chain, &segment.q_chain}) {
    for (const MotionPiece& piece : *chain) {
      if (varies(piece)) ++(followed_joint(piece) ? joints : others);
    }
  }
  return joints == 0 || (joints == 1 && others == 0);
}

}  // namespace

FrameIdentities::FrameIdentities(const MotionSegment& segment) {
  if (!has_symbols(segment)) return;
  SymbolicSegment symbols(segment.start, segment.end);
  const FrameOf<Symbolic> f = symbolic_frame(segment, symbols);
  pp_ = conditions_of(f.for_pp, symbols);
  qq_ = conditions_of(f.for_qq, symbols);
}

bool FrameIdentities::vanishes(bool pp, const std::array<Dyadic, 5>& c) const {
  const Side& side = pp ? pp_ : qq_;
  return side.known && std::all_of(side.conditions.begin(), side.conditions.end(), [&](const Condition& condition) {
           Dyadic sum;
           for (std::size_t i = 0; i < c.size(); ++i) sum = sum + c[i] * condition[i];
           return sum.is_zero();
         });
}

}  // namespace taut::internal
