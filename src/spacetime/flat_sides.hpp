// Bodies that slide along each other, told apart by exact signs.
//
// Faces that slide on faces, or so near to them that doubles cannot tell, are apart by less than a box's padding: every
// edge of one body comes before every edge of the other, and each such pair would be settled by an exact line. But on a
// segment on which one body moves straight along v, nothing moves across v: how far two vertices are from each other
// along n, v turned by 90 degrees, stays what it is. So if the highest vertex of one box is below the lowest one of the
// other in that direction, all that is in them is apart throughout the segment. As displaced: the displacement decides,
// as always.
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
  /// Are the contents of the two boxes certainly apart, at all times of the segment? Asked of boxes that other tests
  /// leave.
  bool apart(const BoxNode& p, const BoxNode& q);
  /// Counts where only the displacement told: such bodies touch, or are nearer than it.
  const StageCounts& stages() const { return stages_; }

 private:
  /// The vertices of a box that are lowest and highest along n.
  struct Extremes {
    VertexId low, high;
    bool known = false;
  };
  /// Of one tree's boxes. Few of a large tree are asked for, so they have room in blocks, made when one is.
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
  bool exact_ = true;  ///< has every order of vertices been, so far?
  Vector n_{}, unit_{}, offset_{};
  StageCounts stages_;
  Known of_p_, of_q_;
};

}  // namespace taut::internal::spacetime
