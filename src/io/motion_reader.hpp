// The "motion" of a body, and keyframes in a scene or in a CSV file of their own.
#pragma once

#include <string>
#include <vector>

#include "io/json_document.hpp"
#include "taut/io.hpp"
#include "taut/motion.hpp"
#include "taut/motions.hpp"

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

// Keyframes, in a scene or in a CSV file of their own.

/// [{"t":0,"x":1,"y":2,"angle_deg":90},...] with ascending times.
std::vector<Keyframe> read_keyframes(const JsonDocument& document, std::size_t token, const std::string& path,
                                     const ReadLimits& limits);

/// As taut::read_keyframes_csv, but from text; `name` stands for the file in messages.
std::vector<Keyframe> parse_keyframes_csv(const std::string& text, const std::string& name, const ReadLimits& limits);

}  // namespace taut::internal::io
