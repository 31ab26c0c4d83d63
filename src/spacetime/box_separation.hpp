// Are two boxes on different bodies apart for a stretch of time?
#pragma once

#include "spacetime/hierarchy.hpp"
#include "spacetime/stretch.hpp"

namespace taut::internal::spacetime {

/// Two edges that are apart in this middle share of a stretch will be so throughout in a few halvings.
constexpr double worth_trying = 0x1p-5;
/// Stretches as short as this share of the segment are not divided any more.
constexpr double shortest_stretch = 0x1p-40;

/// Certainly apart at all times of the stretch.
bool apart(const Stretch& stretch, const Box& p, const Box& q);

/// Certainly farther than `margin` from each other at all times of the stretch. Besides the directions of the boxes'
/// own sides, `towards` is tried, about the direction from P's box to Q's in P's frame; it need not be of any length.
bool farther(const Stretch& stretch, const Box& p, const Box& q, Vector towards, double margin);

/// Apart within that share of the stretch around its middle, as far as one can tell. No proof.
bool apart_around_middle(const Stretch& stretch, double share, const Box& p, const Box& q);

/// About how far the boxes move relative to each other within the stretch, turning included.
double motion(const Stretch& stretch, const Box& p, const Box& q);

/// Certainly farther than `margin` within that share of the stretch around its middle, as far as one can tell. No
/// proof.
bool farther_around_middle(const Stretch& stretch, double share, const Box& p, const Box& q, Vector towards,
                           double margin);

/// A vertex and an edge, both as input: is it certain that the displaced vertex is not beside the displaced edge in the
/// stretch, or not on its line, nor in front of it within the margin? `carriage` is the one into the edge's frame.
bool misses(const Stretch& stretch, const RelativePose& relative_pose, Vector vertex, Vector from, Vector to,
            double margin = 0);
/// Two vertices, as input: is it certain that they, displaced, are farther apart than the margin all over the stretch?
bool vertices_farther(const Stretch& stretch, Vector of_p, Vector of_q, double margin);

}  // namespace taut::internal::spacetime
