// From the lines and shapes of a drawing to pieces of material.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "import/crossing_contours.hpp"
#include "import/drawing.hpp"
#include "import/faces.hpp"
#include "import/gaps.hpp"
#include "import/mending.hpp"
#include "import/open_lines.hpp"

namespace taut::drawing {

/// What became of some chains. Sources are their indices.
struct Outlines {
  std::vector<Region> regions;
  std::vector<std::size_t> sources;  ///< of each region: the chain that its outline is mostly made of
  std::vector<std::map<std::size_t, double>>
      lengths;  ///< of each region: how long each chain's share of its outline is
  std::vector<std::vector<std::size_t>> hole_sources;  ///< of each region: a chain of each of its holes
  std::vector<Gap> gaps;
  std::vector<OpenLine> open;
  std::vector<Closure> suspicious;  ///< rings of open lines that seem meant to be closed
  std::vector<std::pair<std::size_t, Closure>>
      closed;  ///< rings that were closed by straight lines, and a chain of each
  std::vector<Repair> repairs;
  std::vector<std::pair<Point, std::size_t>> crossings;  ///< where a contour meets itself, and a chain of it
  std::vector<ContourCrossing> crossed;                  ///< contours that cross each other
  std::vector<std::size_t> empty;                        ///< chains that are on no ring
  std::vector<std::size_t> idle;  ///< chains that bound nothing: on both of their sides is the same
  std::size_t repeated = 0;       ///< edges that were drawn more than once, counted as often as they were too many
  std::size_t cuts = 0;           ///< edges with a part on either side
  Point first_cut;
  double smallest_cut = 0;  ///< the least area of a part at a cut
};

/// How lines are put together, in units of the scene.
struct OutlineSettings {
  double join = 0;     ///< ends so near to each other, or to a line, meet
  double repair = 0;   ///< loops up to this size are cut off
  bool close = false;  ///< lines that stay open are closed by straight lines
  Crossing crossing = Crossing::error;
  std::size_t most_cuts = 0;
  std::string file;
};

/// Lines: open ones are joined, and divide what others enclose.
Outlines outlines_of_lines(const std::vector<Chain>& chains, const OutlineSettings& settings);

/// Does a chain that is filled by itself enclose anything? A straight line does not, nor one that goes there and back.
bool encloses_area(const Chain& chain, Fill fill, std::size_t most_cuts, const std::string& file);

/// Filled shapes: chains are closed, and what is inside follows from the rule.
Outlines outlines_of_fill(const std::vector<Chain>& chains, Fill fill, const OutlineSettings& settings);

/// Rings that should neither cross themselves nor each other, outlines counterclockwise and holes clockwise: what they
/// go around once, counterclockwise. Faces that this leaves out or adds, against the even-odd rule, are in `repairs` as
/// crossings, and where a ring goes to and fro as spikes, whatever their size.
Outlines outlines_of_repair(const std::vector<Chain>& rings, const OutlineSettings& settings);

/// Ends of lines that meet nothing after joining.
std::vector<Point> loose_ends(const std::vector<Chain>& chains, const OutlineSettings& settings);

}  // namespace taut::drawing
