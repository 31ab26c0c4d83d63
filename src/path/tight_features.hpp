// Which vertices and edges leave no room at a tight place?
#pragma once

#include <vector>

#include "path/joint_space.hpp"

namespace taut::internal::path {

/// Of what is open in a cell around these values: the vertex and the edge that are nearest to each other there, and of
/// those that push the bodies the other way, the nearest ones. Distances are in the scene's units.
std::vector<TightFeatures> tight_features(const JointSpace& space, const JointValues& values, const OpenPairs& open);

}  // namespace taut::internal::path
