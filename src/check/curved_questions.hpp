// Questions about bodies with curves, each asked twice: of polygons around the bodies, and of polygons within them.
// What is true of the bodies lies between. Where the two answers differ by more than is wanted, polygons are refined
// near what made the difference, and the question is asked again.
#pragma once

#include "pair/curved_world.hpp"
#include "taut/check.hpp"

namespace taut {

Answer check_curved(const Scene& scene, const CheckOptions& options);

/// How finely cells may be cut before a question is given up: curves that run along each other for a while would never
/// end.
class RefinementLimit {
 public:
  explicit RefinementLimit(const CurvedWorld& world) : most_(4 * world.segments() + 30000) {}
  bool reached(const CurvedWorld& world) const { return world.segments() > most_; }

 private:
  std::uint64_t most_;
};

/// Refines what is marked: a little if that is much, farther if it is little.
bool refine_marked(CurvedWorld& world, CurvedWorld::Halvings marks, std::size_t count);

}  // namespace taut
