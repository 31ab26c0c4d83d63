// Files that a scene names: outlines and keyframes.
#pragma once

#include <string>

namespace taut::internal::io {

/// The path of a file that a scene names, relative to the scene's folder. Throws InputError if it lies outside of that
/// folder, symbolic links followed, unless that is allowed: who sends a scene does not choose what is read.
std::string named_file(const std::string& folder, const std::string& file, bool allow_outside);

}  // namespace taut::internal::io
