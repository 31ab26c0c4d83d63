// Shapes that come again: what depends on one polygon alone, computed once.
#pragma once

#include <memory>
#include <string>

#include "taut/geometry.hpp"
#include "taut/scene.hpp"

namespace taut::internal {
class PreparedShape;
}

namespace taut {

/// A validated polygon with its hull and diameter, its own geodesic triangulation, and its tree of boxes. The latter
/// two are made when first needed, for each role that the shape has played (P or Q, open or closed touching, scale of
/// the pair), and kept. Its answers are those of the bare polygon.
/// Immutable to its users, and safe to share between scenes and threads.

/// Prepares a polygon, O(n log n). Put the result into Body::prepared of any scene, and leave Body::polygon empty:
/// checks and simulations then start without analysing the shapes again, and copy nothing of them.
/// For bodies whose hulls are apart, that takes time for the vertices of the hulls; where they interlock, what lies
/// near the other body is done anew. Throws InputError, as validate_polygon() does; `name` is used in messages.
std::shared_ptr<const internal::PreparedShape> prepare(const Polygon& polygon, const std::string& name = "shape");

/// The polygon of a body, which may be that of its prepared shape alone. The body must outlive the result.
const Polygon& polygon_of(const Body& body);

}  // namespace taut
