// Scenes and motions later or earlier in time, and small scenes for them.
#pragma once

#include <vector>

#include "taut/scene.hpp"

namespace taut::testing {

/// The polynomial of t - shift; exact as long as coefficients and shift have few bits.
Coefficients moved_in_time(Coefficients c, double shift);

/// The piece of t - shift, in powers of the time since its origin as before; exact under the same condition.
MotionPiece moved_in_time(MotionPiece piece, double shift);

/// The same motion in powers of the time since an origin; exact under the same condition.
MotionPiece about_origin(MotionPiece piece, double origin);

Scene moved_in_time(Scene scene, double shift);

/// The scene that is later by `shift`, whose pieces take their origins along; exact if the sums of times are.
Scene later(Scene scene, double shift);

/// Nine scenes with coefficients of few bits over [0, 4]: free, in contact, and in touch, with several forms of motion.
std::vector<Scene> small_scenes();

}  // namespace taut::testing
