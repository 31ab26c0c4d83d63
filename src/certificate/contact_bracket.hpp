// The time of a contact, stated so that it holds for the bodies as given.
#pragma once

#include <memory>
#include <optional>

#include "certificate/precise_time.hpp"
#include "geometry/ids.hpp"
#include "scene/body_pair.hpp"
#include "taut/check.hpp"

namespace taut::internal {

// A contact found by an engine, in the engine's own terms.

/// A vertex that is on an edge of the other polygon, and the time. The edge is given by its first vertex,
/// counterclockwise, and the time by an enclosure of the segment's parameter.
struct FoundContact {
  VertexId vertex, edge;
  double lo = 0, hi = 0;
  /// A tighter enclosure of this instant alone, if doubles do not distinguish it from others in [lo, hi].
  std::shared_ptr<const PreciseTime> at = nullptr;
};

/// An enclosure of the segment's parameter, for displaced bodies or for the given ones. Passage: does the vertex come
/// to the edge from outside, or leave it to the outside?
enum class Passage : unsigned char { enters, leaves };

struct ContactBracket {
  double lo = 0, hi = 0;
  bool grazing = false;
};

/// Engines answer for displaced bodies. Where the vertex meets the edge with some speed, the displacement moves the
/// contact by far less than a unit in the last place, and the enclosure found is the bracket. Where it does not (a root
/// of order m moves by about delta^(1/m)), the opposite displacement gives the other end:
///
///   found for bodies displaced inwards: the bracket begins when the vertex was last outside of the edge's line, for
///   bodies displaced outwards, or inside, for those displaced inwards;
///   found for bodies displaced outwards: the bracket ends when the vertex is first inside, for bodies displaced
///   inwards, or outside again, for those displaced outwards.
///
/// Where the vertex leaves, the same holds with time reversed. The given vertex is on its side of the given edge's line
/// between the two, so it reaches the line within the bracket, or stays closer to it than the displacement. The ends
/// are searched for on the segment of the contact alone. `geometry` is displaced as `offset` says.
ContactBracket contact_bracket(const BodyPair& bodies, const PairGeometry& geometry, Offset offset,
                               const MotionSegment& segment, const FoundContact& found,
                               Passage passage = Passage::enters);

/// A bound, in time, of the distance between the contact of the given bodies and the one found. Infinity if the
/// displacement moves it by more than a small part of a unit in the last place.
double displacement_sway(const PairGeometry& geometry, const MotionSegment& segment, const FoundContact& found);

/// The bracket of any event that is outside before and inside after, or the reverse. `here` and `there` return its side
/// (negative outside, 0 if unknown) at any instant of the segment: `here` for bodies displaced like those for which
/// [lo, hi] was found, `there` for the others.
ContactBracket bracket_of_sides(double lo, double hi, Offset offset, const MotionSegment& segment,
                                const std::function<int(double)>& here, const std::function<int(double)>& there,
                                Passage passage = Passage::enters);

}  // namespace taut::internal
