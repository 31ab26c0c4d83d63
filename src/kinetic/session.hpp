// One query about one scene: validation, scaling, displacement, an engine, and the translation back to the user's
// terms.
#pragma once

#include <memory>
#include <optional>

#include "kinetic/engine.hpp"
#include "sign/feature_map.hpp"
#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// The engine and the translation of its results.
class Session : private EngineObserver {
 public:
  /// The observer is notified of events before the tracer; either may be null. Throws InputError.
  Session(const Scene& scene, Touch touch, Tracer* tracer, EngineObserver* observer = nullptr);

  Engine& engine() { return *engine_; }
  const Engine& engine() const { return *engine_; }
  /// The time interval of the scene.
  double start() const { return start_; }
  double end() const { return end_; }
  const std::optional<Contact>& contact() const { return contact_; }
  /// For a contact at the start: how the outward shapes overlap.
  const std::optional<StartOverlap>& touching() const { return touching_; }
  bool overlap_at_start() const { return overlap_at_start_; }
  /// A point inside both bodies, if they overlap at the start and such a point was found.
  const std::optional<Point>& overlap_point() const { return overlap_point_; }
  /// Is there nothing left to do, because of a contact, an overlap, or the end?
  bool finished() const;
  /// Like Engine::step(), and records a contact.
  bool step(double t);
  /// Changes a body's motion from the current time on. Throws InputError and changes nothing.
  void set_motion(BodyId body, const Motion& motion);
  /// The input vertex of an internal vertex.
  VertexRef input_vertex(VertexId v) const;
  /// World position of a vertex at the engine's current time, in the input's units (rounded).
  Point world(VertexId v) const;
  const BodyPair& bodies() const { return bodies_; }

 private:
  void on_event(const EngineEvent& event) override;
  void build(Offset offset);
  void resolve_overlap();
  void note_contact();
  FeatureMap witness() const { return {bodies_, engine_->geometry(), offset_}; }

  double start_, end_;
  BodyPair bodies_;
  Tracer* tracer_;
  EngineObserver* observer_;
  std::unique_ptr<Engine> engine_;
  std::optional<Contact> contact_;
  std::optional<StartOverlap> touching_;
  Offset offset_ = Offset::inward;  ///< the direction of the displacement
  bool overlap_at_start_ = false;
  std::optional<Point> overlap_point_;
};

}  // namespace taut::internal
