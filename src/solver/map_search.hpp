// The first contact of one moving body with any of many bodies at rest.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "geometry/box_tree.hpp"
#include "motion/far_pieces.hpp"
#include "scene/free_cells.hpp"
#include "solver/pair_solver.hpp"

namespace taut::internal {

/// Bodies at rest in one scale. A body with several cross-sections is one for each of them.
struct MapBodies {
  std::vector<SharedRings> rings;
  std::vector<Layers> z;  ///< of each of them
  bool layered = false;   ///< some are not on all layers
  std::vector<AxisBox> boxes_of;
  BoxTree boxes;  ///< of these
  int exponent = 0;
  double extent = 0;  ///< the largest of a body, in the input's units
  std::shared_ptr<FreeCellsOnce> free_cells = std::make_shared<FreeCellsOnce>();
};

/// Time is halved while the motion of the mover enlarges its box too much. For each window, the tree returns the bodies
/// whose boxes meet that of the mover, and these pairs are decided for the window. Windows come in order of time, and a
/// contact ends the search. The segments of the motion are the same for all bodies of the map, except for the two roles
/// that the mover can have.
class MapSearch {
 public:
  /// The motion is that of the mover, scaled, on [start, end]. `bodies` must outlive the search.
  MapSearch(const MapBodies& bodies, InstanceBody mover, double start, double end, Offset offset);

  /// Determines overlaps, and contacts, at the start. Returns false if nothing is left to search.
  bool start();
  void run() { cover(start_, std::min(end_, repeats_from({}, mover_.motions, start_, end_)), 0); }

  /// The results for the bodies that the mover came near to, in the map's order.
  std::vector<PairResult> results() const { return results_of(pairs_); }
  /// Visits the pairs.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (const auto& [body, pair] : pairs_) visit(*pair);
  }
  /// A point inside the mover and a body of the map that it overlaps at the start.
  std::optional<Point> common_point(int body) const;
  double proved() const { return proved_; }
  /// How many bodies were examined.
  std::uint64_t tested() const;
  StageCounts stages() const { return stages_of(pairs_); }

 private:
  std::vector<int> near(const AxisBox& box) const;
  SpacetimeSolver& pair(int body);
  BodyPair bodies_with(int body) const;
  const SharedSegments& segments(const BodyPair& bodies);
  void cover(double from, double to, int depth);

  const MapBodies& bodies_;
  InstanceBody mover_;
  double start_, end_;
  Offset offset_;
  double size_;  ///< of the mover's box at rest
  double stop_, proved_;
  std::array<SharedSegments, 2> segments_;  ///< with the mover as P, and as Q
  std::map<int, std::unique_ptr<SpacetimeSolver>> pairs_;
};

}  // namespace taut::internal
