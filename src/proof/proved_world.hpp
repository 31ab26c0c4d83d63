// The pairs of a scene in the terms of a log of separations: their ranges of edges, and how they move.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "pair/placement.hpp"
#include "proof/apart_checker.hpp"
#include "proof/proved_scene.hpp"
#include "proof/stated_box.hpp"

namespace taut::proof {

/// One pair that is asked about.
struct ProvedPair {
  PairPlan plan;
  PairGeometry geometry;
  Legs legs;
  RangedPair ranges;

  ProvedPair(PairPlan pair_plan, PairGeometry displaced, Legs all_legs, const EdgeRanges& p, const EdgeRanges& q)
      : plan(std::move(pair_plan)), geometry(std::move(displaced)), legs(std::move(all_legs)), ranges{geometry, p, q} {}
  ProvedPair(const ProvedPair&) = delete;
  ProvedPair& operator=(const ProvedPair&) = delete;
};

/// A stretch of a leg's parameter.
struct LegStretch {
  std::size_t leg = 0;
  double from = 0, to = 0;
};

/// Bodies displaced one way, prepared when first asked for.
class ProvedWorld {
 public:
  /// The scene must outlive it. The margin is in internal units.
  ProvedWorld(const ProvedScene& scene, bool inwards, double margin = 0)
      : scene_(scene), inwards_(inwards), margin_(margin), ranges_(static_cast<std::size_t>(scene.size())) {}

  const ProvedScene& scene() const { return scene_; }
  bool inwards() const { return inwards_; }
  double margin() const { return margin_; }
  ProvedPair& pair(int a, int b);
  /// Around a box around a body has to be so much room.
  double room() const { return margin_ + box_room; }

 private:
  const EdgeRanges& ranges(const RingSet& body);

  const ProvedScene& scene_;
  bool inwards_;
  double margin_;
  std::vector<std::unique_ptr<EdgeRanges>> ranges_;  ///< by body
  std::map<std::pair<int, int>, std::unique_ptr<ProvedPair>> pairs_;
};

/// What of a pair's legs lies in that time, in order.
std::vector<LegStretch> stretches(const Legs& legs, const WorldTime& time);

/// All of the legs before one.
void add_stretches_before(const Legs& legs, std::size_t leg, std::vector<LegStretch>& all);

/// Do the two bodies overlap at an instant: do their boundaries cross, or does one lie in the other's material?
/// Separations show that no vertex is on an edge; where two edges cross in the shape of a plus none is.
bool overlap_at(const ProvedPair& pair, const Leg& leg, double t);
/// Throws ProofError unless the two edges, by their first vertices, cross.
void require_crossing(const Placement& place, VertexId e, VertexId f);
/// Does the other body's material contain that vertex?
bool inside_the_other(const Placement& place, VertexId vertex);

}  // namespace taut::proof
