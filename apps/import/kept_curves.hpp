// Curves that stay curves. Lines are joined, nested and distinguished as chords; afterwards the chords of each curve
// are found again in the rings, by their inner points, and the curve takes their place.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "import/drawing.hpp"

namespace taut::drawing {

/// A ring with its curves.
struct FoundOutline {
  Outline outline;
  std::vector<const KeptCurve*> curves;  ///< of each segment; null for lines
  std::set<const KeptCurve*> cut;        ///< that have chords in the ring, but not all of them
};

/// Finds curves by their chords.
class CurveFinder {
 public:
  explicit CurveFinder(const std::vector<KeptCurve>& curves);

  /// The ring with its curves, but for those that are to stay chords. Where ends have been joined, curves end where the
  /// ring does.
  FoundOutline outline(const Polygon& ring, const std::set<const KeptCurve*>& chorded) const;

 private:
  struct Match {
    const KeptCurve* curve = nullptr;
    bool reversed = false;
  };
  Match match_at(const Polygon& ring, std::size_t first) const;

  std::map<std::pair<double, double>, Match> by_first_;
  std::map<std::pair<double, double>, const KeptCurve*> by_inner_;
};

}  // namespace taut::drawing
