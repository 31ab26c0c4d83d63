// A scene in the terms of a log of separations: its pairs, their ranges of edges, and how they move.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "pair/placement.hpp"
#include "proof/apart_checker.hpp"
#include "world/swept_box.hpp"
#include "world/world_plan.hpp"

namespace taut::proof {

/// One pair that is asked about.
struct ProvedPair {
  PairPlan plan;
  PairGeometry geometry;
  std::vector<Leg> legs;
  RangedPair ranges;

  ProvedPair(PairPlan pair_plan, PairGeometry displaced, std::vector<Leg> all_legs, const EdgeRanges& p,
             const EdgeRanges& q)
      : plan(std::move(pair_plan)), geometry(std::move(displaced)), legs(std::move(all_legs)), ranges{geometry, p, q} {}
  ProvedPair(const ProvedPair&) = delete;
  ProvedPair& operator=(const ProvedPair&) = delete;
};

/// A stretch of the world's time, without its beginning unless it begins with the scene: stretches that follow each
/// other have each joint once.
struct WorldTime {
  double from = 0, to = 0;
  bool first = true;

  double middle() const { return from + (to - from) / 2; }
  bool divisible() const { return from < middle() && middle() < to; }
};

/// A stretch of a leg's parameter.
struct LegStretch {
  std::size_t leg = 0;
  double from = 0, to = 0;
};

/// Bodies displaced one way, prepared when first asked for.
class ProvedWorld {
 public:
  /// The plan must outlive it. With a margin, in internal units, boxes meet that come as close as that.
  ProvedWorld(const WorldPlan& plan, bool inwards, double margin = 0)
      : plan_(plan), inwards_(inwards), margin_(margin), ranges_(plan.bodies().size()) {}

  const WorldPlan& plan() const { return plan_; }
  bool inwards() const { return inwards_; }
  double margin() const { return margin_; }
  ProvedPair& pair(int a, int b);
  /// All pairs that are asked about and whose boxes over that time meet, in order.
  std::vector<std::pair<int, int>> meeting(const WorldTime& time) const;

 private:
  const EdgeRanges& ranges(const RingSet& body);

  const WorldPlan& plan_;
  bool inwards_;
  double margin_;
  std::vector<std::unique_ptr<EdgeRanges>> ranges_;  ///< by body
  std::map<std::pair<int, int>, std::unique_ptr<ProvedPair>> pairs_;
};

/// What of a pair's legs lies in that time, in order.
std::vector<LegStretch> stretches(const std::vector<Leg>& legs, const WorldTime& time);

/// Do the two bodies overlap at an instant: do their boundaries cross, or does one lie in the other's material?
/// Separations show that no vertex is on an edge; where two edges cross in the shape of a plus none is.
bool overlap_at(const ProvedPair& pair, const Leg& leg, double t);
/// Does the other body's material contain that vertex?
bool inside_the_other(const Placement& place, VertexId vertex);

/// The boxes of bodies over a stretch of time, each made once.
class BoxesOver {
 public:
  BoxesOver(const WorldPlan& plan, const WorldTime& time, double margin = 0)
      : plan_(plan), time_(time), margin_(margin), boxes_(plan.bodies().size()) {}
  const SweptBox& of(int body) {
    std::optional<SweptBox>& box = boxes_[static_cast<std::size_t>(body)];
    if (!box) box = swept_box(plan_.bodies()[static_cast<std::size_t>(body)], time_.from, time_.to);
    return *box;
  }
  bool meet(const std::pair<int, int>& pair) { return of(pair.first).grown(margin_).meets(of(pair.second)); }

 private:
  const WorldPlan& plan_;
  WorldTime time_;
  double margin_;
  std::vector<std::optional<SweptBox>> boxes_;
};

}  // namespace taut::proof
