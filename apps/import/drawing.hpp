// What a drawing comes to before it is bodies: chains of straight lines, in layers.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "taut/geometry.hpp"
#include "taut/outline.hpp"

namespace taut::drawing {

/// How the user wants drawings read.
struct ImportSettings {
  double tolerance = 0.01;     ///< the most that a chord may be away from its curve, in units of the scene
  std::optional<double> join;  ///< ends at most so far apart are one point; a hundredth of the tolerance if not given
  double scale = 1;            ///< all lengths are multiplied by this
  bool curves = false;  ///< curves stay curves where scenes have such: chords stand for them while lines are joined
  bool split = false;   ///< a body for each part
  bool unknown_free = false;          ///< of a robot's map: cells that are neither free nor occupied are no obstacles
  std::size_t max_points = 20000000;  ///< of a whole file: a hostile one must not fill the memory
  double join_distance() const { return join.value_or(tolerance / 100); }
};

/// What is inside, where rings lie in each other.
enum class Fill { even_odd, nonzero };

/// Points joined by straight lines.
struct Chain {
  std::vector<Point> points;
  bool closed = false;  ///< the last point is joined to the first, which is not repeated
  std::string place;    ///< file and line
};

/// Chains that are filled together.
struct Sheet {
  std::string name;  ///< of the element, if it has one
  Fill fill = Fill::even_odd;
  std::vector<Chain> chains;
  bool lines = false;            ///< not filled: chains are joined where their ends meet
  std::vector<Part> parts = {};  ///< where the file says itself what is a hole
};

/// What becomes a body.
struct Layer {
  std::string name;
  std::vector<Sheet> sheets;
};

/// What did not become part of a body, and why; the first one of its kind.
struct Skipped {
  std::string place, what, reason;
  int times = 1;
};

/// A curve that a scene can have, and the points that stand for it between its ends; at least one.
struct KeptCurve {
  std::vector<Point> inner;
  CurveSegment segment;
};

/// Curves that became chords.
struct CurveCounts {
  std::size_t segments = 0, chords = 0;
  double deviation = 0;  ///< of any curve from its chords, at most
};

/// Curves that scenes do not have, and which are chords though curves were to be kept; the first one of its kind and
/// layer.
struct Chorded {
  std::string place, what, layer;
  std::size_t entities = 0;
  CurveCounts counts = {};
};

struct Drawing {
  std::string file, format, units;
  std::vector<Layer> layers;
  std::vector<Skipped> skipped;
  CurveCounts curves;
  std::vector<KeptCurve> kept = {};
  std::vector<Chorded> chorded = {};

  /// The layer of this name, which is made if there is none.
  Layer& layer(const std::string& name);
  void skip(const std::string& place, const std::string& what, const std::string& reason);
  void count_chorded(const Chorded& more);
};

}  // namespace taut::drawing
