// One question about one scene: validated, scaled, displaced, with an engine, and the way back to the user's terms.
#pragma once

#include <memory>
#include <optional>

#include "kinetic/engine.hpp"
#include "kinetic/near_start.hpp"
#include "sign/feature_map.hpp"
#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// The engine and the translation of its findings.
class Session : private EngineObserver {
 public:
  /// The observer is told of events before the tracer; either may be null. Throws InputError.
  /// `near` has what was kept of the last question, if anything, and takes in this one's start; may be null.
  Session(const Scene& scene, Touch touch, Tracer* tracer, EngineObserver* observer = nullptr,
          NearStart* near = nullptr);

  Engine& engine() { return *engine_; }
  const Engine& engine() const { return *engine_; }
  /// The scene's time.
  double start() const { return start_; }
  double end() const { return end_; }
  const std::optional<Contact>& contact() const { return contact_; }
  /// Of a contact at the start: how the outward shapes overlap.
  const std::optional<StartOverlap>& touching() const { return touching_; }
  bool overlap_at_start() const { return overlap_at_start_; }
  /// Was the tiling made from that of the question before?
  bool began_near() const { return began_near_; }
  /// Inside both bodies, if they overlap at the start and such a point was found.
  const std::optional<Point>& overlap_point() const { return overlap_point_; }
  /// Nothing left to do: contact, overlap, or the end.
  bool finished() const;
  /// As Engine::step, and notes a contact.
  bool step(double t);
  /// Changes a body's plan from the present on. Throws InputError and changes nothing.
  void set_motion(BodyId body, const Motion& motion);
  /// An internal vertex in the user's terms.
  VertexRef input_vertex(VertexId v) const;
  /// World position of a vertex at the engine's present, in the input's units (rounded).
  Point world(VertexId v) const;
  const PairPlan& plan() const { return plan_; }

 private:
  void on_event(const EngineEvent& event) override;
  void build(bool inwards, NearStart* near);
  void resolve_overlap();
  void note_contact();
  FeatureMap witness() const { return {plan_, engine_->geometry(), inwards_}; }

  double start_, end_;
  PairPlan plan_;
  Tracer* tracer_;
  EngineObserver* observer_;
  std::unique_ptr<Engine> engine_;
  std::optional<Contact> contact_;
  std::optional<StartOverlap> touching_;
  bool inwards_ = true;  ///< the displacement
  bool overlap_at_start_ = false, began_near_ = false;
  std::optional<Point> overlap_point_;
};

}  // namespace taut::internal
