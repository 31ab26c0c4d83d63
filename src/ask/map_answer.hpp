// Answers about a map, in the words of the scene that they are about.
#pragma once

#include <string>

#include "taut/static_map.hpp"

namespace taut::internal {

/// The JSON of an answer about the scene of the map's bodies and the mover, cut where its scope names all bodies: what
/// is before the names, and after them. Only the bodies that the answer speaks of are looked at.
struct MapAnswerText {
  std::string before, after;
};

/// `mover` has the motion that was asked about.
MapAnswerText map_answer_text(const StaticMap& map, const Body& mover, double start, double end, Answer answer,
                              Touch touch);

}  // namespace taut::internal
