// Rings of displaced vertices in exact integers: what the displacement's laws are tested with. Shares no code with it.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "geometry/displacement.hpp"

namespace taut::testing {
using namespace internal;

using Integer = boost::multiprecision::cpp_int;

/// A number as a multiple of 2^-700. It must be one.
Integer exact_integer(double x);

struct ExactPoint {
  Integer x, y;
};

/// Where the vertex is, and where it was.
ExactPoint moved_point(const DisplacedPoint& v);
ExactPoint original_point(const DisplacedPoint& v);

/// Do both edges of the corner u, v, w move by between delta and 2 delta to the left (right, if `offset` is not set)
/// when v moves to where it says?
bool corner_keeps_law(const Point& u, const DisplacedPoint& v, const Point& w, Offset offset, double delta);

/// Do two closed boundaries have a point in common; does one meet itself outside the vertices of neighbouring edges?
/// By all pairs of edges whose rectangles meet.
bool rings_meet(const std::vector<ExactPoint>& a, const std::vector<ExactPoint>& b);
bool ring_meets_itself(const std::vector<ExactPoint>& ring);
/// Twice the area, positive if the ring runs counterclockwise.
Integer twice_area(const std::vector<ExactPoint>& ring);
/// The point must not lie on the ring.
bool ring_contains(const std::vector<ExactPoint>& ring, const ExactPoint& p);

/// What is wrong with a polygon that was displaced without a fault, by displaced_polygon()'s laws; empty if nothing.
const char* broken_law(const std::vector<Point>& polygon, const DisplacedPolygon& displaced, Offset offset);

}  // namespace taut::testing
