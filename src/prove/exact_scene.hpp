// A scene as exact logs are about it (docs/exact-logs.md): edges as they are written, chains of motions, tested pairs.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "prove/local_model.hpp"
#include "scene/ignored_pairs.hpp"
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

}  // namespace taut::internal
