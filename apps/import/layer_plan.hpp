// Which layers of a drawing are read together.
#pragma once

#include <string>
#include <vector>

#include "import/outlines.hpp"

namespace taut::drawing {

/// The lines of one layer.
struct LineLayer {
  std::size_t layer = 0;  ///< index in the drawing
  std::vector<Chain> chains;
  std::string name = {};   ///< of what they are, within the layer
  std::string place = {};  ///< of the first one
};

/// Two layers whose lines cross, or run along each other, or touch at several points.
struct LayerConflict {
  enum class Kind { cross, along, touch };
  std::size_t first = 0, second = 0;  ///< indices of the sets
  Point at;
  Kind kind = Kind::cross;  ///< the first that holds
};

struct LayerPlan {
  std::vector<std::vector<std::size_t>> sets;  ///< indices of line layers that are read together
  std::vector<LayerConflict> conflicts;        ///< of layers that are therefore read apart
  bool common = false;                         ///< is the first set of layers that have no conflict?
  std::vector<std::size_t> marks;  ///< line layers that had conflicts, enclose nothing, and change no area: read apart
};

/// Layers that have parts of one outline are read together: an end of a line in one of them meets a line of another
/// one. Then all layers are, so that contours of one are holes in what another one encloses. But layers that cross each
/// other, share a part of a line, or touch at several points, each close by themselves: they are different bodies, and
/// read apart. Together, one would divide what the other one encloses. Layers of marks, such as centre lines and
/// bends, take no part in this: they enclose nothing, and without them the areas are the same.
LayerPlan plan_layers(const std::vector<LineLayer>& layers, const std::vector<std::string>& names,
                      const OutlineSettings& settings);

/// Lines of the common set that lie in material of one of the layers read apart are holes in it: they are read with it,
/// as layers of their own at the end of `layers`. Those in material of several stay where they are.
void adopt_holes(std::vector<LineLayer>& layers, LayerPlan& plan, const OutlineSettings& settings);

}  // namespace taut::drawing
