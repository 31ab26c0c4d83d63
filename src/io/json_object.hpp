// Reading an object with a fixed set of keys, and numbers and points in it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/json_document.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::io {

/// The object at a token, each of whose keys must be one of `known` and appear once. Throws InputError otherwise.
class JsonObject {
 public:
  JsonObject(const JsonDocument& document, std::size_t token, const std::string& path,
             const std::vector<std::string>& known, const std::string& shape);

  /// The token of the value, if the key is there.
  std::optional<std::size_t> find(const std::string& key) const;
  /// The token of the value. Throws InputError if the key is missing.
  std::size_t get(const std::string& key) const;
  /// Path of a member.
  std::string path(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

 private:
  const JsonDocument& document_;
  std::size_t token_;
  std::string path_, shape_;
  std::vector<std::pair<std::string, std::size_t>> members_;
};

/// Does the object at a token have such a member? It may have others.
bool has_member(const JsonDocument& document, std::size_t token, const std::string& key);
/// Has a scene joints, or drives with ranges, instead of a time?
bool has_ranges(const JsonDocument& document);

/// The index after the path: "bodies" and 1 make "bodies[1]".
std::string element_path(const std::string& path, std::size_t index);

/// A hint for a name that is none of `known`: the one that is meant, or all there are.
std::string hint_for_name(const std::string& word, const std::vector<std::string>& known);

// Numbers and points from JSON.

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
