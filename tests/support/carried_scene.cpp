#include "support/carried_scene.hpp"

#include <utility>

namespace taut::testing {
namespace {

/// By -90 degrees.
Point turned_back(const Point& p) { return {p.y, -p.x}; }
Coefficients negated(Coefficients c) {
  for (double& x : c) x = -x;
  return c;
}

/// The terms of odd degree, or the others.
Coefficients terms(const Coefficients& c, bool odd) {
  Coefficients some = c;
  for (std::size_t k = 0; k < c.size(); ++k) {
    if ((k % 2 == 1) != odd) some[k] = 0;
  }
  return some;
}

}  // namespace

Scene carried(const Scene& scene, bool turned) {
  Scene chain = scene;
  Body &body = chain.bodies[1], carrier = chain.bodies[0];
  carrier.name = "carrier";
  carrier.motion = {};
  for (MotionPiece& piece : body.motion.pieces) {
    MotionPiece way;
    way.until = piece.until;
    way.x = terms(piece.x, true);
    way.y = terms(piece.y, true);
    piece.x = terms(piece.x, false);
    piece.y = terms(piece.y, false);
    if (turned) {
      way.rotation = DirectionRotation{{0}, {1}};
      std::swap(piece.x, piece.y);
      piece.y = negated(piece.y);
      piece.pivot = turned_back(piece.pivot);
    }
    carrier.motion.pieces.push_back(way);
  }
  if (turned) {
    for (Point& p : body.polygon) p = turned_back(p);
  }
  body.relative_to = carrier.name;
  chain.bodies.push_back(carrier);
  chain.ignore = {{"*", carrier.name}};
  return chain;
}

}  // namespace taut::testing
