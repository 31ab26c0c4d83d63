// Motions in numbers so short that nothing rounds: bodies meet exactly where they are meant to.
#pragma once

#include "support/rng.hpp"
#include "taut/motion.hpp"

namespace taut::testing {

/// factor (t - at)^power, in ascending powers of t.
Coefficients power(double factor, double at, int power);
Coefficients sum(const Coefficients& a, const Coefficients& b);

/// A rotation that begins at t = `at` at that many quarter turns, exactly, and turns by a quarter in a unit of time
/// (AngleRotation: by about that). Of any form that can.
Rotation quarter_turn(Rng& rng, int from, bool clockwise, double at);
/// One that stays at that many quarter turns.
Rotation held(Rng& rng, int quarters);

/// A rotation whose angle is about factor (t - at)^order near t = at: of any form.
Rotation flat_turn(Rng& rng, double factor, double at, int order);

}  // namespace taut::testing
