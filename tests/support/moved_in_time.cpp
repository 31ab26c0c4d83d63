#include "support/moved_in_time.hpp"

#include "motion/rotation_forms.hpp"

namespace taut::testing {
using namespace internal;

/// The polynomial of t - shift; exact as long as coefficients and shift have few bits.
Coefficients moved_in_time(Coefficients c, double shift) {
  for (std::size_t k = 0; k + 1 < c.size(); ++k) {
    for (std::size_t i = c.size() - 1; i-- > k;) c[i] -= c[i + 1] * shift;
  }
  return c;
}

MotionPiece moved_in_time(MotionPiece piece, double shift) {
  piece.x = moved_in_time(piece.x, shift);
  piece.y = moved_in_time(piece.y, shift);
  piece.orbit.angle = moved_in_time(piece.orbit.angle, shift);
  for_each_polynomial(piece.rotation, [shift](Coefficients& c) { c = moved_in_time(c, shift); });
  piece.until += shift;
  return piece;
}

MotionPiece about_origin(MotionPiece piece, double origin) {
  const double until = piece.until;
  piece = moved_in_time(std::move(piece), piece.origin - origin);
  piece.origin = origin;
  piece.until = until;
  return piece;
}

Scene moved_in_time(Scene scene, double shift) {
  scene.start += shift;
  scene.end += shift;
  for (Body& body : scene.bodies) {
    for (MotionPiece& piece : body.motion.pieces) piece = moved_in_time(piece, shift);
  }
  return scene;
}

Scene later(Scene scene, double shift) {
  scene.start += shift;
  scene.end += shift;
  for (Body& body : scene.bodies) {
    for (MotionPiece& piece : body.motion.pieces) {
      piece.until += shift;
      piece.origin += shift;
    }
  }
  return scene;
}

namespace {

/// Two bodies, Q of which comes down, turns or slides.
Scene descending_scene(const MotionPiece& motion, double end) {
  Scene scene;
  scene.start = 0;
  scene.end = end;
  scene.bodies = {{"P", {{-5, -1}, {5, -1}, {5, 0}, {1, 0.5}, {-5, 0}}, {}},
                  {"Q", {{-1, 0}, {1, 0}, {2, 1}, {0, 0.25}, {-2, 1}}, {{motion}}}};
  return scene;
}

}  // namespace

std::vector<Scene> small_scenes() {
  std::vector<Scene> scenes;
  const auto add = [&scenes](Coefficients x, Coefficients y, const Rotation& rotation, Point pivot = {}) {
    MotionPiece piece;
    piece.x = std::move(x);
    piece.y = std::move(y);
    piece.rotation = rotation;
    piece.pivot = pivot;
    scenes.push_back(descending_scene(piece, 4));
  };
  add({}, {5, -1, 0.25}, AngleRotation{{0, 0.75}});           // free
  add({}, {5, -3, 0.25}, AngleRotation{{0, 0.75}});           // contact
  add({0, 0.5}, {3, -1}, NoRotation{});                       // contact on a line
  add({0.25, 0.5, 0.125}, {3, -2, 0.125}, NoRotation{});      // contact on a curve
  add({-3, 0.25}, {0.5, 0.03125}, NoRotation{});              // along a face
  add({0.125, -1}, {0.5}, NoRotation{});                      // slides in touch, from above the tip
  add({-0.5}, {2.5}, AngleRotation{{0.125, 1.5}}, {0.5, 1});  // about a pivot
  add({0, 0.125}, {2, -0.5}, HalfAngleRotation{{0.25, 0.5}});
  add({0, 0.125}, {2, -0.5}, DirectionRotation{{1, 0.25}, {0, 0.5}});
  return scenes;
}

}  // namespace taut::testing
