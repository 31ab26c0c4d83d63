// A spline that a drawing gives by the points that it passes through.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::drawing {

/// What is known of such a spline.
struct FitPoints {
  std::vector<Point> points;
  std::optional<Point> start_tangent, end_tangent;  ///< directions, of any length but 0
  bool closed = false;                              ///< back to the first point, which need not be repeated
};

/// The control points of cubic Bezier curves, one from each point to the next different one: the cubic spline whose
/// second derivative is continuous, with the lengths of the chords as its parameters. Where an end has no tangent, the
/// second derivative is 0 there (a "natural" end); a closed spline is periodic. See de Boor, A Practical Guide to
/// Splines, chapter IV. Empty if fewer than two of the points differ.
std::vector<std::array<Point, 4>> fit_spline(const FitPoints& fit);

}  // namespace taut::drawing
