// Exact logs (docs/exact-logs.md): the scene that they are about, and how edges are separated throughout a window.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vector.hpp"
#include "prove/local_model.hpp"
#include "scene/untested.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// The ends of an edge, in the body's own coordinates.
using ExactEdge = std::array<Point, 2>;
/// Motions of a body and of its parents, the outermost first, without those that rest. The scene owns them.
using ExactChain = std::vector<const Motion*>;

/// Where a body is in a window: its point (u, v) is at (x + u cosine - v sine, y + u sine + v cosine).
struct LocalPlacement {
  LocalModel x, y, cosine, sine;
};

/// A scene that exact logs cover. It must outlive this object. A body with parts on different layers is several ones,
/// its cross-sections: the lowest one has the body's number, the others follow after the last body.
class ExactScene {
 public:
  /// Throws InputError for what they do not cover: curves, mechanisms. The scene must be valid.
  explicit ExactScene(const Scene& scene);

  int size() const { return static_cast<int>(sections_.size()); }
  const std::vector<ExactEdge>& edges(int body) const { return section(body).edges; }
  const std::string& name(int body) const { return section(body).body->name; }
  bool tested(int a, int b) const;
  /// The chains of two bodies as seen from their last common ancestor.
  std::array<ExactChain, 2> relative_chains(int a, int b) const;

 private:
  struct Section {
    const Body* body;
    int in_scene;
    Layers z;
    std::vector<ExactEdge> edges;
  };
  const Section& section(int body) const { return sections_[static_cast<std::size_t>(body)]; }
  const ExactChain& chain(int body) const { return chains_[static_cast<std::size_t>(section(body).in_scene)]; }
  void add_sections(const Scene& scene);

  std::vector<Section> sections_;
  std::vector<ExactChain> chains_;  ///< of the scene's bodies
  IgnoredPairs ignored_;
  bool at_rest_ = false;
};

/// The times between two instants at which motions of the chains pass to another piece, in order.
std::vector<double> joints_between(const std::array<ExactChain, 2>& chains, double start, double end);
/// The placement that a chain gives in the window [from, to], in which no motion passes to another piece; at the end,
/// if it has no length. Nothing where the window is too long for a model.
std::optional<LocalPlacement> placement_in(const ExactChain& chain, double from, double to, const LocalModels& models);

// How the edges of two bodies are separated throughout a window: lines between ranges of edges.

/// A line between two ranges, or that one of them is halved.
struct ExactStep {
  enum class Kind { line, halve_first, halve_second };
  Kind kind = Kind::line;
  Vector normal{};
  double level = 0, slope = 0;  ///< the line is at level + slope * (time since the window's middle)
};

/// Two bodies in a window.
class ExactSeparation {
 public:
  ExactSeparation(const std::vector<ExactEdge>& first, const std::vector<ExactEdge>& second,
                  const LocalPlacement& first_place, const LocalPlacement& second_place, const LocalModels& models);

  /// The steps, in preorder. Nothing if some two edges were not separated: the window is too long, or they meet.
  std::optional<std::vector<ExactStep>> find();

 private:
  struct Side {
    const std::vector<ExactEdge>& edges;
    const LocalPlacement& place;
    std::vector<std::array<Vector, 2>> middle;  ///< the edges' ends in the middle of the window
    double reach = 0;                           ///< the largest magnitude of a coordinate
  };
  struct Range {
    std::size_t from, to;
    std::size_t size() const { return to - from; }
  };

  static Side side(const std::vector<ExactEdge>& edges, const LocalPlacement& place);
  bool separate(const Range& p, const Range& q);
  std::optional<ExactStep> line(const Range& p, const Range& q) const;
  std::optional<Vector> towards(const Range& p, const Range& q) const;
  bool holds(const ExactStep& line, const Range& p, const Range& q) const;
  static Vector farthest(const Side& side, const Range& range, Vector direction);
  static double extent(const Side& side, const Range& range);

  Side first_, second_;
  const LocalModels& models_;
  std::vector<ExactStep> steps_;
};

}  // namespace taut::internal
