// taut check over many scenes.
#pragma once

#include <string>
#include <vector>

#include "taut/check.hpp"

namespace taut::cli {

struct CheckBatch {
  std::vector<std::string> paths;
  bool allow_outside = false;  ///< see SceneSource
  bool lines = false;          ///< each file holds a scene on every line
  unsigned threads = 0;        ///< 0: as many as the machine has
  CheckOptions options;
  bool json = false, timing = false;
};

/// Answers all scenes, in order, whatever is wrong with some of them; returns the exit code of the whole.
int check_batch(const CheckBatch& batch);

}  // namespace taut::cli
