// Are two boxes on different bodies disjoint throughout a stretch of time?
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

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

// Bodies that slide along each other, separated by exact signs.
//
// Faces that slide on faces, or so near to them that doubles cannot distinguish this, are separated by less than the
// padding of a box. Every edge of one body comes before every edge of the other, and an exact line would have to decide
// each such pair. But on a segment on which one body moves straight along v, nothing moves across v. Let n be v rotated
// by 90 degrees: the distance of two vertices along n stays constant. So if the highest vertex of one box is below the
// lowest one of the other in that direction, all their contents are disjoint throughout the segment. This holds for the
// displaced vertices: as always, the displacement decides.

class FlatSides {
 public:
  FlatSides(const PairGeometry& geometry, const TreePair& trees, const MotionSegment& segment);
  /// Are the contents of the two boxes certainly disjoint at all times of the segment? Called for boxes that other
  /// tests do not separate.
  bool apart(const BoxNode& p, const BoxNode& q);
  /// Counts the cases that only the displacement decided: such bodies touch, or are nearer than the displacement.
  const StageCounts& stages() const { return stages_; }

 private:
  /// The vertices of a box that are lowest and highest along n.
  struct Extremes {
    VertexId low, high;
    bool known = false;
  };
  /// The extremes of one tree's boxes. Few of a large tree are needed, so they are stored in blocks that are allocated
  /// on demand.
  struct Known {
    static constexpr std::uint32_t size = 256;
    std::vector<std::unique_ptr<std::array<Extremes, size>>> blocks;
    Extremes& of(std::uint32_t node, std::size_t all);
  };
  Extremes extremes(bool of_p, std::uint32_t node);
  bool above(VertexId a, VertexId b);
  bool clear(VertexId low, VertexId high);

  const PairGeometry& geometry_;
  TreePair trees_;
  const MotionSegment& segment_;
  bool usable_ = false;
  bool exact_ = true;  ///< whether every order of vertices has been exact so far
  Vector n_{}, unit_{}, offset_{};
  StageCounts stages_;
  Known of_p_, of_q_;
};

}  // namespace taut::internal::spacetime
