// Numbers and points from JSON.
#pragma once

#include <string>
#include <vector>

#include "io/json_document.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::io {

double read_number(const JsonDocument& document, std::size_t token, const std::string& path);

/// An array of at most `max_count` numbers.
std::vector<double> read_numbers(const JsonDocument& document, std::size_t token, const std::string& path,
                                 const std::string& shape, std::size_t max_count, const std::string& limit_hint);

/// Throws the InputError of a polygon that has too many vertices.
[[noreturn]] void fail_size(const JsonDocument& document, std::size_t token, const std::string& path,
                            std::size_t max_vertices);

/// An array of [x, y]. Further coordinates ([x, y, z] of GeoJSON) are errors unless `more_coordinates`.
Polygon read_points(const JsonDocument& document, std::size_t token, const std::string& path, std::size_t max_vertices,
                    bool more_coordinates);

}  // namespace taut::internal::io
