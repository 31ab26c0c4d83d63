// Bodies with parts on different layers, as bodies that each have one interval of layers.
#pragma once

#include <cstddef>
#include <vector>

#include "taut/scene.hpp"

namespace taut::internal {

/// What a body is at all heights of an interval: the union of these parts.
struct CrossSection {
  Layers z;
  std::vector<std::size_t> parts;  ///< in order
};

/// A body from the lowest interval up; intervals without a part are left out, and neighbours differ. One cross-section
/// if all parts have the same layers. Two bodies meet if and only if two of their cross-sections do whose layers
/// meet().
std::vector<CrossSection> cross_sections_of(const Body& body);

/// Calls visit(layers) for each of the body's parts, in order; once for a body that is one polygon.
template <class Visit>
void for_each_layers(const Body& body, const Visit& visit) {
  for (const Part& part : body.parts) visit(part.z.value_or(body.z));
  for (const CurvedPart& part : body.curves) visit(part.z.value_or(body.z));
  if (body.parts.empty() && body.curves.empty()) visit(body.z);
}
/// All of these.
std::vector<Layers> layers_of_parts(const Body& body);

/// Do any two parts have a layer in common?
bool share_layers(const Body& a, const Body& b);

}  // namespace taut::internal
