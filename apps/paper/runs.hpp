// Scenes in motion that the study counts events of, and how it runs them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::paper {

/// Fig. 16 with a path of degree k (even): k/2 dips. Beyond degree 16 in pieces of degree 8, four dips each.
Scene fig16(int k, int n);
/// Fig. 17: about n vertices each, one turn.
Scene fig17(int n);
/// Combs with teeth of random lengths, n vertices in all, pulled apart on a random path of degree 4.
Scene combs_leaving(int n, std::uint64_t seed);
/// Two random convex polygons, n vertices in all; one passes the other to and fro on a random path of degree 4.
Scene convex_passing(int n, std::uint64_t seed);
/// The same, both turning about once as well.
Scene convex_turning(int n, std::uint64_t seed);
/// Two meshing gears, about n vertices in all, for one turn of the smaller one.
Scene gears(int n);

/// Both bodies at rest, from time 0 to 1, where they are at t.
Scene at_rest(Scene scene, double t);

struct Run {
  std::size_t vertices = 0;
  std::uint64_t events = 0, certificates_max = 0;
  double seconds = 0;       ///< in the loop of events
  int corners_touched = 0;  ///< by one repair, the most
  int edges_changed = 0;    ///< by one repair, the most: gone and new
};

/// Runs to the end; throws if the motion is not free. The time is the least of `repeats` runs.
Run run_free(const Scene& scene, int repeats = 1);

}  // namespace taut::paper
