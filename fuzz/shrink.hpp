// A short scene that still fails.
#pragma once

#include <functional>

#include "taut/scene.hpp"

namespace taut::fuzz {

/// Whether a scene still fails in the way that is looked for. Must say no to scenes that fail otherwise.
using StillFails = std::function<bool(const Scene&)>;

/// Tries simplifications, and keeps those with which the scene still fails, until none is left or `max_tries` scenes
/// have been tried: a shorter interval of time, fewer pieces, less motion, lower degrees, fewer vertices, a place near
/// the origin, rounder numbers. `scene` itself must fail.
Scene shrunk(Scene scene, const StillFails& still_fails, int max_tries);

}  // namespace taut::fuzz
