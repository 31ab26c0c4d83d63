// Queries about bodies with curves: bracket.hpp has the loop that they share.
#pragma once

#include "scene/curved_world.hpp"
#include "scene/pair_margins.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"
#include "taut/separate.hpp"

namespace taut::internal {

Answer check_curved(const Scene& scene, const CheckOptions& options);

/// A first contact, and the bands between whose walls it was found, for use in pictures.
struct CurvedContact {
  Answer answer;
  CurvedWorld world;
};
/// Like check_curved(), without `fit` and `all_pairs`.
CurvedContact first_contact_of_curves(const Scene& scene, const CheckOptions& options);

/// Of an answer about a clearance: are bodies closer, or do they even overlap, already at the start?
inline bool at_start(Outcome outcome) {
  return outcome == Outcome::overlap_at_start || outcome == Outcome::closer_at_start;
}

/// Whether bodies keep a clearance, and the bands between whose walls this was found.
struct CurvedMargin {
  MarginAnswer answer;
  CurvedWorld world;
};
/// Like check_margins_of_curves(), without `all_pairs`.
CurvedMargin margin_of_curves(const Scene& scene, const PairMargins& margins, const CheckOptions& options);

Clearance clearance_of_curves(const Scene& scene, const ClearanceOptions& options);
DistanceProfile distance_profile_of_curves(const Scene& scene, const ProfileOptions& options);
MarginAnswer check_margins_of_curves(const Scene& scene, const PairMargins& margins, const CheckOptions& options);
Intervals intervals_of_curves(const Scene& scene, const CheckOptions& options);
/// `precisely` as overlap_intervals() takes it.
Intervals intervals_of_polygons(const Scene& scene, const CheckOptions& options, bool precisely);
/// Sets the outcome of an answer that has its intervals and its undecided pairs.
void conclude(Intervals& answer);
Separation separate_curves(const Scene& scene, const SeparateOptions& options);

/// The curves of distance_profile() with only their instants. Requires polygons and valid options.
DistanceProfile distances_at_instants(const Scene& scene, const ProfileOptions& options);

/// The largest coordinate of any curve.
double largest_size(const CurvedWorld& world);

/// The scene of two bodies, including all their parents, with all other pairs ignored. `ids` receives the bodies'
/// numbers in the whole scene.
Scene scene_of_pair(const Scene& scene, const std::array<BodyId, 2>& pair, std::vector<BodyId>& ids);

}  // namespace taut::internal
