// What those who make bodies have in common.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "geometry/predicates.hpp"
#include "geometry/segment_strips.hpp"
#include "import/drawing.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

inline std::string point_text(const Point& p) { return fmt::format("({:.9g}, {:.9g})", p.x + 0.0, p.y + 0.0); }

/// What is computed from here on needs numbers that do not overflow.
inline void require_range(const std::vector<Chain>& chains) {
  for (const Chain& chain : chains) {
    for (const Point& p : chain.points) {
      if (std::fabs(p.x) < max_coordinate && std::fabs(p.y) < max_coordinate) continue;
      throw InputError(chain.place, "a coordinate is beyond 2^400", "choose another unit, or check the drawing");
    }
  }
}

/// A layer in messages, after the word "layer": those of SVG may have no name.
inline std::string layer_title(const std::string& name) { return name.empty() ? "without a name" : io::excerpt(name); }

inline AxisBox box_of(const Polygon& ring) {
  AxisBox box(ring[0], ring[0]);
  for (const Point& p : ring) box.include(AxisBox(p, p));
  return box;
}

}  // namespace taut::drawing
