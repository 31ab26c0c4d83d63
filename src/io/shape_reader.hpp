// Reads what a body of a scene looks like.
#pragma once

#include <string>

#include "io/json_object.hpp"
#include "taut/io.hpp"

namespace taut::internal::io {

/// Where outlines in files of their own are looked for.
struct NamedFiles {
  const std::string& folder;
  const ReadLimits& limits;
};

/// Reads "polygon" or "parts" of a body, the object at that token and path. Throws InputError.
void read_shape(const JsonDocument& document, const JsonObject& object, std::size_t token, const std::string& path,
                const NamedFiles& files, Body& body);

/// Reads [lo, hi], of which null is no end. Throws InputError.
Layers read_layers(const JsonDocument& document, std::size_t token, const std::string& path);

}  // namespace taut::internal::io
