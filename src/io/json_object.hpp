// Reading an object with a fixed set of keys.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/json_document.hpp"

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

/// The word of `known` that `word` is most likely a slip of; empty if none is near.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

}  // namespace taut::internal::io
