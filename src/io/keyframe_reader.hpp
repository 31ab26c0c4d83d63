// Keyframes, in a scene or in a CSV file of their own.
#pragma once

#include <string>
#include <vector>

#include "io/json_document.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut::internal::io {

/// [{"t":0,"x":1,"y":2,"angle_deg":90},...] with ascending times.
std::vector<Keyframe> read_keyframes(const JsonDocument& document, std::size_t token, const std::string& path,
                                     const ReadLimits& limits);

/// As taut::read_keyframes_csv, but from text; `name` stands for the file in messages.
std::vector<Keyframe> parse_keyframes_csv(const std::string& text, const std::string& name, const ReadLimits& limits);

}  // namespace taut::internal::io
