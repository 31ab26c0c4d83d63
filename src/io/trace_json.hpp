// Events as `taut trace` prints them.
#pragma once

#include <string>
#include <vector>

#include "taut/scene.hpp"
#include "taut/tracer.hpp"

namespace taut::internal::io {

/// Writes events of one scene as JSON objects, each on one line, without a line break.
class TraceWriter {
 public:
  explicit TraceWriter(const Scene& scene);

  std::string line(const TraceEvent& event) const;

 private:
  std::vector<std::string> names_;  ///< of the bodies, quoted
};

}  // namespace taut::internal::io
