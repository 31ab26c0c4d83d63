// An oracle by definition: when do the interiors, or the closures, of two moving polygons first intersect?
//
// It sees the polygons as they are, not displaced ones, and shares nothing with the library but the types of a scene.
// Open reading: the infimum of the times at which the interiors intersect. Closed reading: the first time at which the
// closures do. Between two consecutive zeros at which a vertex comes to lie on an edge nothing changes; so these are
// found one after the other, and for the open reading the placement is judged at an instant after each.
//
// Decided exactly if nothing turns, or by half angles or rational directions. Elsewhere a function that cannot be told
// from 0 in 2000 bits is taken to be 0: then `assumed` is set. What vanishes at all times, and at rational instants, is
// recognised exactly with every form.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/exact_interval.hpp"
#include "taut/scene.hpp"

namespace taut::testing::exact {

enum class Verdict : std::uint8_t { free, contact, overlap_at_start, beyond };

const char* to_string(Verdict verdict);

/// A vertex of a body on a closed edge of the other one.
struct Meeting {
  int vertex_body, vertex, edge;
  friend bool operator==(const Meeting&, const Meeting&) = default;
};

struct ExactAnswer {
  Verdict verdict = Verdict::beyond;
  /// Encloses the time of contact, to about 2^-250 of a unit.
  Wide time;
  /// The largest multiplicity of the zeros of functions of vertices and edges that meet then.
  int multiplicity = 0;
  /// By how much the time may change if every vertex is displaced by 2^-190 of the coordinates' scale (times what sharp
  /// corners add): the m-th root of that over the m-th coefficient of the distance.
  double sway = 0;
  /// All that meet at the time of contact, and those that may be the ones to meet when displaced: so close, within that
  /// sway.
  std::vector<Meeting> meetings;
  bool assumed = false;
  std::string why;  ///< beyond: what it is beyond
};

/// The scene must be valid.
ExactAnswer first_contact(const Scene& scene, Touch touch);

}  // namespace taut::testing::exact
