// Which pairs of bodies an answer is about, and which nobody tested.
#pragma once

#include <cstdint>

namespace taut {

/// Counts of pairs of bodies: `pairs` counts all pairs of the scene and is the sum of the others. Each answer has one.
struct Coverage {
  std::uint64_t pairs = 0;
  std::uint64_t tested = 0;        ///< examined by an engine
  std::uint64_t apart = 0;         ///< kept apart by bounding boxes, as far as the answer goes
  std::uint64_t ignored = 0;       ///< not tested: Scene::ignore excludes them
  std::uint64_t moving_alike = 0;  ///< not tested: both bodies have the same motion, see Scene::at_rest
  std::uint64_t at_rest = 0;       ///< not tested: neither body moves, see Scene::at_rest
  std::uint64_t layers = 0;        ///< not tested: the bodies have no layer in common, see Body::z, and never meet
  std::uint64_t not_reached = 0;   ///< not tested: a limit or an interruption came first

  /// Pairs about which the answer says nothing.
  std::uint64_t untested() const { return ignored + moving_alike + at_rest + layers + not_reached; }
  /// True if the question is about no pair, however long it takes.
  bool is_empty() const { return untested() - not_reached == pairs; }
};

}  // namespace taut
