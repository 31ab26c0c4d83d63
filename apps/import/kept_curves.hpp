// Curves that stay curves. Lines are joined, nested and told apart as chords; afterwards the chords of each curve are
// found again in the rings, by their inner points, and the curve takes their place.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "import/drawing.hpp"

namespace taut::drawing {

/// Finds curves by their chords.
class CurveFinder {
 public:
  explicit CurveFinder(const std::vector<KeptCurve>& curves);

  /// The ring with its curves. Where ends have been joined, curves end where the ring does.
  Outline outline(const Polygon& ring) const;

 private:
  struct Match {
    const KeptCurve* curve = nullptr;
    bool reversed = false;
  };
  Match match_at(const Polygon& ring, std::size_t first) const;

  std::map<std::pair<double, double>, Match> by_first_;
};

}  // namespace taut::drawing
