// Reads what a body of a scene looks like.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/json_object.hpp"
#include "taut/io.hpp"
#include "taut/outline.hpp"

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

// The data of an SVG path.

/// At least one segment; closed by Z, or open.
struct Subpath {
  Outline outline;
  bool closed = false;
};

/// Throws InputError, which names `place`, where the data cannot be read: browsers draw what comes before, which is
/// half of a part.
std::vector<Subpath> read_path_data(std::string_view data, const std::string& place);

}  // namespace taut::internal::io
