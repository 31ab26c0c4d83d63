// One question about one scene: validated, scaled, displaced, with an engine, and the way back to the user's terms.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "kinetic/engine.hpp"
#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut {

/// Which body plays P, and how internal vertices are numbered in the input.
struct BodyMap {
  int body = 0;             ///< position in Scene::bodies
  std::uint32_t size = 0;   ///< number of vertices
  std::uint32_t first = 0;  ///< index of the input that became vertex 0
  bool reversed = false;    ///< the input runs clockwise

  int vertex(std::uint32_t k) const {
    return static_cast<int>(reversed ? (first + size - k) % size : (first + k) % size);
  }
  int edge(std::uint32_t k) const {
    return static_cast<int>(reversed ? (first + 2 * size - k - 1) % size : (first + k) % size);
  }
};

/// Everything about a scene that does not depend on the touch mode.
struct PairPlan {
  std::array<BodyMap, 2> maps;                     ///< of P and of Q
  std::array<std::vector<Point>, 2> polygons;      ///< scaled, counterclockwise, first vertex on the hull
  std::array<std::vector<MotionPiece>, 2> pieces;  ///< scaled
  int exponent = 0;                                ///< internal coordinates are the input's times 2^exponent
  double extent = 0;                               ///< of the scene, in the input's units
};

PairPlan plan_pair(const Scene& scene);
PairGeometry displaced_pair(const PairPlan& plan, bool inwards);

/// The engine and the translation of its findings.
class Session : private EngineObserver {
 public:
  /// Throws InputError.
  Session(const Scene& scene, Touch touch, Tracer* tracer);

  Engine& engine() { return *engine_; }
  const Engine& engine() const { return *engine_; }
  const Scene& scene() const { return scene_; }
  const std::optional<Contact>& contact() const { return contact_; }
  bool overlap_at_start() const { return overlap_at_start_; }
  /// Nothing left to do: contact, overlap, or the end.
  bool finished() const;
  /// As Engine::step, and notes a contact.
  bool step(double t);
  /// Changes a body's plan from the present on. Throws InputError and changes nothing.
  void set_motion(int body, const Motion& motion);
  /// An internal vertex in the user's terms.
  TraceVertex input_vertex(VertexId v) const;
  /// World position of a vertex at the engine's present, in the input's units (rounded).
  Point world(VertexId v) const;
  const PairPlan& plan() const { return plan_; }

 private:
  void on_event(const EngineEvent& event) override;
  [[noreturn]] void refuse_fine_features(const Overlap& overlap) const;
  void contact_at_start(const Overlap& overlap);
  void note_contact();
  Feature vertex_feature(VertexId v) const;
  Feature edge_feature(VertexId v) const;
  Point world_at(VertexId v, const Leg& leg, double parameter) const;
  Point outward_normal(VertexId edge, const Leg& leg, double parameter) const;

  Scene scene_;
  PairPlan plan_;
  Tracer* tracer_;
  std::unique_ptr<Engine> engine_;
  std::optional<Contact> contact_;
  bool overlap_at_start_ = false;
};

}  // namespace taut
