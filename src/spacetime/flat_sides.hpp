// Bodies that slide along each other, separated by exact signs.
//
// Faces that slide on faces, or so near to them that doubles cannot distinguish this, are separated by less than the
// padding of a box. Every edge of one body comes before every edge of the other, and an exact line would have to decide
// each such pair. But on a segment on which one body moves straight along v, nothing moves across v. Let n be v rotated
// by 90 degrees: the distance of two vertices along n stays constant. So if the highest vertex of one box is below the
// lowest one of the other in that direction, all their contents are disjoint throughout the segment. This holds for the
// displaced vertices: as always, the displacement decides.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "spacetime/walk.hpp"

namespace taut::internal::spacetime {

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
