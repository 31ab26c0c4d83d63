// A scene whose bodies have been shrunk a little, so that what overlaps by rounding does not.
#pragma once

#include "taut/scene.hpp"

namespace taut {

/// The same scene with all rings moved towards the material by between `fit` and twice as much along every edge: the
/// displacement that puts scenes in general position, only larger, and rounded to doubles. Vertices keep their numbers.
/// The scene must be valid. Throws InputError where a body has features that are finer than that, with the place, or
/// where `fit` is below what doubles tell.
Scene fitted(const Scene& scene, double fit);

}  // namespace taut
