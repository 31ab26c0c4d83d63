// What the lock of a mechanism makes of an answer.
#pragma once

#include <string>

#include "taut/check.hpp"

namespace taut::internal {

/// Does the scene end at a lock, before the end that it was given?
bool ends_at_lock(const Scene& scene);

/// The end of the scene's time as it was given, whether a mechanism locks before or not.
double given_end(const Scene& scene);

/// Of an answer about all of the scene's time: `free` becomes `locked` where that ends at a lock, and `undecided`, with
/// the reason, where it is not known how the mechanism goes on.
void note_lock(const Scene& scene, Outcome& outcome, std::string& reason);

/// Of an answer about values or intervals in the time until a lock: only what is not decided changes it.
void note_undecided_lock(const Scene& scene, Outcome& outcome, std::string& reason);

}  // namespace taut::internal
