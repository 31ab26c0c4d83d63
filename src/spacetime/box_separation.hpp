// Are two boxes on different bodies disjoint throughout a stretch of time?
#pragma once

#include "spacetime/hierarchy.hpp"
#include "spacetime/stretch.hpp"

namespace taut::internal::spacetime {

/// Two edges that are disjoint in this middle share of a stretch will be disjoint throughout after a few halvings.
constexpr double worth_trying = 0x1p-5;
/// Stretches as short as this share of the segment are not divided any further.
constexpr double shortest_stretch = 0x1p-40;

/// Are the boxes certainly disjoint at all times of the stretch?
bool apart(const Stretch& stretch, const Box& p, const Box& q);

/// Are the boxes certainly farther than `margin` from each other at all times of the stretch? Besides the directions of
/// the boxes' own sides, the direction `towards` is tried. It should be about the direction from P's box to Q's in P's
/// frame, and may have any length.
bool farther(const Stretch& stretch, const Box& p, const Box& q, Vector towards, double margin);

/// Do the boxes appear disjoint within that share of the stretch around its middle? The result is not a proof.
bool apart_around_middle(const Stretch& stretch, double share, const Box& p, const Box& q);

/// The approximate motion of the boxes relative to each other within the stretch, including rotation.
double motion(const Stretch& stretch, const Box& p, const Box& q);

/// Do the boxes appear farther apart than `margin` within that share of the stretch around its middle? The result is
/// not a proof.
bool farther_around_middle(const Stretch& stretch, double share, const Box& p, const Box& q, Vector towards,
                           double margin);

/// Given a vertex and an edge, both as in the input: is one of the following certain throughout the stretch? The
/// displaced vertex does not project onto the displaced edge, or is not on its line and not in front of it within the
/// margin. `relative_pose` is the one into the edge's frame.
bool misses(const Stretch& stretch, const RelativePose& relative_pose, Vector vertex, Vector from, Vector to,
            double margin = 0);
/// Given two vertices, as in the input: is it certain that, displaced, they are farther apart than the margin
/// throughout the stretch?
bool vertices_farther(const Stretch& stretch, Vector of_p, Vector of_q, double margin);

}  // namespace taut::internal::spacetime
