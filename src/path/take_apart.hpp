// Ways along which bodies leave an assembly one by one, turning if they have to.
#pragma once

#include "geometry/axis_box.hpp"
#include "numeric/budget.hpp"
#include "taut/separate.hpp"

namespace taut::internal::path {

/// The bodies of a scene where they stand at its start, without motions.
struct StandingScene {
  Scene scene;
  double rounded = 0;  ///< boundaries are nowhere farther than this from where they stand
};

/// The scene must be valid, without curves, and no two bodies may overlap at its start. Where some fit exactly and
/// rounding would change that, all are shrunk a little.
StandingScene standing_scene(const Scene& scene);

/// The box of a body that stands.
AxisBox extent_of(const Body& body);
/// The bodies that block a body: all of `among` but itself and those that the scene ignores with it.
std::vector<BodyId> blockers_of(const Scene& scene, BodyId body, const std::vector<BodyId>& among);
/// The smallest box around all of these.
AxisBox extent_of(const Scene& scene, const std::vector<BodyId>& bodies);

/// Sets the answer's ways, and what is left; its outcome too. The budget is the one that holds.
void take_apart(const StandingScene& standing, const SeparateOptions& options, const Budget& budget,
                Separation& answer);

}  // namespace taut::internal::path
