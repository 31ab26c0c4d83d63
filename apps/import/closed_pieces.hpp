// What is closed in a drawing of lines, for those that stay open.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/segment_strips.hpp"
#include "import/faces.hpp"
#include "import/line_graph.hpp"

namespace taut::drawing {
using namespace internal;

/// The connected pieces that a graph's edges on cycles make.
class ClosedPieces {
 public:
  /// `closed` are the edges on cycles.
  ClosedPieces(const LineGraph& graph, const std::vector<bool>& closed);

  /// A piece and the convex hull of some points.
  struct Held {
    std::size_t source = 0;
    bool whole = false;  ///< does all of it lie in the hull?
  };
  /// A piece that lies in the convex hull of these points; or else, if `partly`, one that has a part inside of it, and
  /// none of these points; nothing if there is none.
  std::optional<Held> in_hull(const std::vector<Point>& points, bool partly) const;

  /// Does something closed go around the line? It must cross nothing that is closed.
  bool surround(const std::vector<Point>& line);

 private:
  struct Piece {
    std::vector<int> nodes;  ///< two for each edge
    std::size_t source = 0;
  };
  const LineGraph& graph_;
  const std::vector<bool>& closed_;
  std::vector<Piece> pieces_;
  SegmentStrips boxes_, edges_;
  std::optional<FaceMap> faces_;  ///< when they are asked for first, and `edges_`
};

}  // namespace taut::drawing
