// A log about translations: a closed polygon of displacements that no way crosses. docs/path-logs.md describes it in
// full.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "proof/bytes.hpp"
#include "proof/exact_place.hpp"
#include "taut/scene.hpp"

namespace taut::internal::proof {

inline constexpr char of_barriers = '7';

/// An edge of the polygon, from `from` to where the next one begins; and why no way crosses it.
struct BarrierEdge {
  enum class Kind : std::uint8_t {
    collision,  ///< two bodies have a point in common, which moves evenly
    outside,    ///< it is not within the range of a joint
  };
  ExactPlace from;
  Kind kind = Kind::collision;
  std::uint32_t body = 0, other = 0;      ///< collision
  std::array<ExactPlace, 2> common = {};  ///< collision: at the edge's begin and its end, in the body's coordinates
  std::uint8_t side = 0;                  ///< outside: twice the joint among those that move, and 1 if it is above
};

struct Barrier {
  bool touching = false;  ///< ways that touch are not ways
  /// If the goal is "outside": a body that moves and one that does not, whose boxes overlap on all of the inside.
  std::array<std::uint32_t, 2> boxes = {};
  std::vector<BarrierEdge> edges;
};

/// False if a coordinate has too many digits.
bool write(ByteWriter& out, const Barrier& barrier, bool goal_outside);
/// Throws ProofError for what makes no sense.
Barrier read_barrier(ByteReader& in, bool goal_outside);

}  // namespace taut::internal::proof
