// One scene of two bodies with curves for the soak: the answers about them, held against chords that are 4096 times
// nearer to the curves than the polygons of a picture would be.
#pragma once

#include <cstdint>
#include <string>

#include "soak_totals.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

struct CurvedSoakScene {
  Scene scene;
  std::string family;
};

/// Scene `number`; the same everywhere.
CurvedSoakScene curved_soak_scene(std::uint64_t number);

/// What is wrong with the answers about the scene; empty if nothing is. Chords with corners on the curves are computed
/// here, by formulas of SVG in doubles, with nothing of the library's; they are nowhere farther from the curves than a
/// known `away`. So the bodies certainly touch no earlier than chords that come as close as 4 away, and overlap as soon
/// as chords do that were shrunk by as much. The laws:
///   1. the bracket of a contact is not before the one and not behind the other;
///   2. what is free keeps shrunk chords free, what overlaps at the start has chords that are close there;
///   3. a coarser bracket and a finer one have a common instant;
///   4. the clearance is that of chords, give or take 2 away; so is the distance at instants; of every eighth scene;
///   5. of every fourth scene, what examine_curve_proof() says of its proof.
std::string examine_curves(std::uint64_t number, const CurvedSoakScene& made, double max_seconds, Tally& tally);

}  // namespace taut::testing
