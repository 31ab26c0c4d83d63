// taut check over many scenes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene_source.hpp"
#include "taut/check.hpp"

namespace taut::cli {

/// Of every `count` scenes the one at `index`, from 0: the scenes of several runs are then all of them, each once.
struct Shard {
  std::uint64_t index = 0, count = 1;
};

/// From "I/N", I from 1 to N. Throws InputError.
Shard shard_of(const std::string& text);

struct CheckBatch {
  std::vector<std::string> paths;
  bool allow_outside = false;          ///< see SceneSource
  std::optional<AtRest> at_rest = {};  ///< the same
  bool allow_untested = false;
  bool lines = false;    ///< each file holds a scene on every line
  unsigned threads = 0;  ///< 0: as many as the machine has
  Shard shard;
  std::string resume;    ///< a file that answers are appended to, and are taken up from; empty: standard output
  std::string junit;     ///< a file for a JUnit report; empty: none
  double clearance = 0;  ///< the distance that is asked about; 0: none
  CheckOptions options;
  bool json = false, timing = false;
  bool time_tolerance = false;  ///< was it given?

  SceneSource source_of(const std::string& path) const { return {path, allow_outside, at_rest}; }
};

/// Answers all scenes, in order, whatever is wrong with some of them; returns the exit code of the whole.
int check_batch(const CheckBatch& batch);

}  // namespace taut::cli
