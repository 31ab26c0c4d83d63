// Shapes that come again: what depends on one polygon alone, computed once.
#pragma once

#include <memory>
#include <string>

#include "taut/geometry.hpp"

namespace taut {

/// A validated polygon with its hull and diameter, its own geodesic triangulation, and its tree of boxes. The latter
/// two are made when first needed, for each role that the shape has played (P or Q, open or closed touching, scale of
/// the pair), and kept. Its answers are those of the bare polygon.
/// Immutable to its users, and safe to share between scenes and threads.
class PreparedShape;

/// Prepares a polygon, O(n log n). Put the result into Body::prepared of any scene with exactly this polygon: checks
/// and simulations then start without looking at what the shapes have in themselves. Bodies whose hulls are apart
/// start in the time that it takes to copy the tiling; where they interlock, only what lies near the other body is done
/// anew. Throws InputError, as validate_polygon() does; `name` is used in messages.
std::shared_ptr<const PreparedShape> prepare(const Polygon& polygon, const std::string& name = "shape");

}  // namespace taut
