// A scene and options as Python hands them over.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>

#include "taut/taut.hpp"

namespace taut_python {

/// A scene as JSON text.
struct SceneText {
  std::string json;
  /// Stands for the text in messages.
  std::string name;
  /// Where files that it names are looked up.
  std::string folder;

  taut::Scene read() const { return taut::parse_scene(json, name, folder); }
  taut::Linkage read_linkage() const { return taut::parse_linkage(json, name, folder); }
};

/// Words that are not looked at before check_options().
struct RunOptions {
  std::string touch, engine, pairs;
  std::optional<double> max_seconds;
  std::optional<std::uint64_t> max_events;
};

/// Throws InputError for a word that has no meaning. `stop` must outlive the result.
taut::CheckOptions check_options(const RunOptions& given, const std::atomic<bool>& stop);

}  // namespace taut_python
