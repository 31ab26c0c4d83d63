// The entities of DXF that are lines and curves.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "import/affine.hpp"
#include "import/curves.hpp"
#include "import/dxf_text.hpp"

namespace taut::drawing {

/// How the entity's own coordinates lie in the drawing: it may be seen from below. Nothing if it stands on the plane.
std::optional<Affine> own_plane(const DxfItem& item);

/// Does the entity say something about the drawing, or help to draw it, so that it bounds nothing?
bool is_annotation(const DxfItem& item);

/// Points in whose box the entity lies; empty if its numbers do not say.
std::vector<Point> corners_of(const DxfItem& item, const Affine& where);

/// The least and the greatest z of what lines and curves go through.
struct Heights {
  double lo = INFINITY, hi = -INFINITY;
  void include(const DxfItem& item);
};

/// A vertex of a polyline, and a quarter of the tangent of the arc to the next one.
struct BulgedVertex {
  Point at;
  double bulge = 0;
};

std::vector<BulgedVertex> vertices_of(const DxfItem& lwpolyline);
Chain bulged_chain(const std::vector<BulgedVertex>& vertices, bool closed, const std::string& place,
                   const Affine& where, Flattener& flattener);

/// Has an ARC or ELLIPSE the same angle, or parameter, as start and end? That is a full turn, or nothing: DXF does not
/// say.
bool ends_at_its_start(const DxfItem& item);

/// LINE, LWPOLYLINE, ARC, CIRCLE, ELLIPSE or SPLINE as a chain; nothing for other types. Throws InputError.
std::optional<Chain> chain_of(const DxfItem& item, const Affine& where, Flattener& flattener);

}  // namespace taut::drawing
