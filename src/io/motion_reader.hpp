// The "motion" of a body.
#pragma once

#include <string>

#include "io/json_document.hpp"
#include "taut/io.hpp"
#include "taut/motion.hpp"

namespace taut::internal::io {

/// What a motion is read in.
struct MotionContext {
  double start = 0, end = 0;  ///< the scene's time
  std::string folder;         ///< where files are looked up
  ReadLimits limits;
};

/// Of a polynomial, in ascending powers. `remedy` says what to do about a degree that is too high.
Coefficients read_coefficients(const JsonDocument& document, std::size_t token, const std::string& path,
                               const std::string& remedy);
/// null, a piece, an array of pieces with ascending "until", or one of the forms of taut/motions.hpp.
Motion read_motion(const JsonDocument& document, std::size_t token, const std::string& path,
                   const MotionContext& context);

}  // namespace taut::internal::io
