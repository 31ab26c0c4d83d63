// Questions about bodies with curves, each asked twice: of polygons around the bodies, and of polygons within them.
// What is true of the bodies lies between. Where the two answers differ by more than is wanted, polygons are refined
// near what made the difference, and the question is asked again.
#pragma once

#include "pair/curved_world.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"
#include "taut/separate.hpp"

namespace taut::internal {

Answer check_curved(const Scene& scene, const CheckOptions& options);

/// A first contact, and the bands between whose walls it was found: pictures show them.
struct CurvedContact {
  Answer answer;
  CurvedWorld world;
};
/// As check_curved(), without `fit` and `all_pairs`.
CurvedContact first_contact_of_curves(const Scene& scene, const CheckOptions& options);

/// Whether bodies keep a clearance, and the bands between whose walls that was found.
struct CurvedMargin {
  MarginAnswer answer;
  CurvedWorld world;
};
/// As check_clearance_of_curves(), without `all_pairs`.
CurvedMargin margin_of_curves(const Scene& scene, double clearance, const CheckOptions& options);

Clearance clearance_of_curves(const Scene& scene, const ClearanceOptions& options);
DistanceProfile distance_profile_of_curves(const Scene& scene, const ProfileOptions& options);
MarginAnswer check_clearance_of_curves(const Scene& scene, double clearance, const CheckOptions& options);
Intervals intervals_of_curves(const Scene& scene, const CheckOptions& options);
/// The outcome of an answer that has its intervals and its undecided pairs.
void conclude(Intervals& answer);
Separation separate_curves(const Scene& scene, const SeparateOptions& options);

/// The curves of distance_profile() with nothing but their instants: polygons only, valid options.
DistanceProfile distances_at_instants(const Scene& scene, const ProfileOptions& options);

/// The largest coordinate of any curve.
double largest_size(const CurvedWorld& world);

/// The scene of two bodies, with all that they are seen from, and with nobody else asked about. `ids` are theirs in the
/// whole scene.
Scene scene_of_pair(const Scene& scene, const std::array<BodyId, 2>& pair, std::vector<BodyId>& ids);

/// How finely cells may be cut before a question is given up: curves that run along each other for a while would never
/// end.
class RefinementLimit {
 public:
  explicit RefinementLimit(const CurvedWorld& world) : most_(4 * world.segments() + 30000) {}
  bool reached(const CurvedWorld& world) const { return world.segments() > most_; }
  std::uint64_t most() const { return most_; }

 private:
  std::uint64_t most_;
};

/// Refines what is marked: a little if that is much, farther if it is little.
bool refine_marked(CurvedWorld& world, CurvedWorld::Halvings marks, std::size_t count);

}  // namespace taut::internal
