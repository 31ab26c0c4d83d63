// Whether what a proof log claims is so.
#pragma once

#include <array>
#include <string>

#include "scene/curved_world.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;

/// What is true of a scene, by both engines where it has no curves.
struct Truth {
  std::array<Answer, 2> answers;

  explicit Truth(const Scene& scene) {
    for (const Touch touch : {Touch::open, Touch::closed}) {
      CheckOptions options;
      options.touch = touch;
      if (!has_curves(scene)) options.engine = EngineChoice::both;
      answers[touch == Touch::closed ? 1 : 0] = check(scene, options);
    }
  }
  const Answer& of(Touch touch) const { return answers[touch == Touch::closed ? 1 : 0]; }

  /// Empty if the claim is true.
  std::string refutation(const Verified& v) const {
    const Answer& a = of(v.touch);
    if (a.outcome == Outcome::overlap_at_start) return "the bodies overlap at the start";
    if (a.contact && v.free_until > a.contact->time.hi) return "free beyond the contact";
    if (v.outcome == Outcome::undecided) return {};
    if (v.outcome != a.outcome) return "another outcome";
    if (v.outcome == Outcome::free) return {};
    if (v.contact->time.hi < a.contact->time.lo || a.contact->time.hi < v.contact->time.lo) return "another time";
    // Of curves, which segments they are is not proved.
    if (a.contact->time.lo == a.contact->time.hi || v.kind == ProofKind::curves) return {};
    const bool same = v.contact->vertex == a.contact->vertex && v.contact->edge == a.contact->edge;
    return same ? "" : "other features";
  }
};

}  // namespace taut::testing
