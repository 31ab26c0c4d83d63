// Two bodies of rings in the kinetic engine: one engine for each pair of rings that can meet.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "certificate/contact_bracket.hpp"
#include "kinetic/engine.hpp"
#include "scene/body_pair.hpp"
#include "scene/ring_set.hpp"

namespace taut::internal {

/// The tiling is between two simple polygons. The start decides which rings of two parts can meet, and this does not
/// change before they do. So the first contact of two bodies is the earliest contact of these pairs of rings, each with
/// its own engine. A hole that contains a part of the other body takes part as the container around it.
class RingEngines {
 public:
  /// Builds the tilings at the start of the segments, which are those of the motion. The motion, the geometry and the
  /// observer, which may be null, must outlive this object. Throws Undecidable.
  RingEngines(const BodyPair& bodies, const PairGeometry& geometry, Offset offset, MotionSegments segments,
              EngineObserver* observer = nullptr);

  /// Do the bodies overlap at the start of the segments? If so, no other query is allowed.
  bool overlap() const { return overlap_; }
  /// If they overlap and a vertex of one inside the other showed it, that vertex of the pair's geometry.
  const std::optional<VertexId>& inside() const { return inside_; }

  enum class Arrival : unsigned char { there, contact, on_the_way };
  /// Advances to t, or to the contact. Stops on the way after the given number of events. Throws Undecidable, and any
  /// interruption.
  Arrival advance(double t, std::uint64_t events = UINT64_MAX);
  /// The time to which the tilings correspond; the earliest one, between events.
  double time() const;
  /// Everything up to this time is proved.
  double reached() const;
  /// The corresponding time at present, between events: no failure is due before it.
  double proved_until() const;
  /// An enclosure of the time of the next event up to t.
  std::optional<std::pair<double, double>> next_event(double t);

  /// See Engine::can_replan_at().
  bool can_replan_at(double t) const;
  /// Replaces all segments from the time on at which the first new one starts.
  void replan(MotionSegments segments);

  /// See Engine::put_aside().
  void put_aside() {
    for (Run& run : runs_) run.engine->put_aside();
    segments_.give_back();
  }

  /// A contact in terms of the pair's geometry and segments.
  struct Found {
    FoundContact contact;
    std::size_t segment = 0;
  };
  const std::optional<Found>& contact() const { return contact_; }

  std::uint64_t events() const { return sum_of(&Engine::events); }
  std::uint64_t certificates() const { return sum_of(&Engine::active_certificates); }
  std::uint64_t initial_certificates() const { return sum_of(&Engine::initial_certificates); }
  std::uint64_t max_certificates() const { return sum_of(&Engine::max_certificates); }
  StageCounts stages() const;
  const MotionSegments& segments() const { return segments_; }

  std::size_t size() const { return runs_.size(); }
  Engine& engine(std::size_t k) { return *runs_[k].engine; }
  const Engine& engine(std::size_t k) const { return *runs_[k].engine; }
  RingMeeting meeting(std::size_t k) const { return runs_[k].rings; }
  /// The vertex of the pair's geometry that corresponds to a vertex of that engine; none for the box and the slit
  /// around a hole.
  std::optional<VertexId> named_vertex(std::size_t k, VertexId v) const { return named(runs_[k], v, false); }
  /// Does a hole take part in this engine?
  bool is_contained(std::size_t k) const;

 private:
  struct Run {
    RingMeeting rings;
    bool exchanged = false;  ///< P of the pair plays Q
    std::unique_ptr<Engine> engine;

    /// Maps a role in the pair of rings to the role in the pair of bodies.
    Role in_pair(Role role) const { return exchanged ? other(role) : role; }
  };
  template <class Count>
  std::uint64_t sum_of(Count (Engine::*count)() const) const {
    std::uint64_t sum = 0;
    for (const Run& run : runs_) sum += ((*run.engine).*count)();
    return sum;
  }
  const RingSet& set_of(const Run& run, Role role) const { return *bodies_.rings[index_of(run.in_pair(role))]; }
  static std::size_t ring_number(const Run& run, Role role) {
    return run.in_pair(role) == Role::p ? run.rings.p : run.rings.q;
  }
  const SingleRing& ring_of(const Run& run, Role role) const;
  /// The squared, scaled diameter of a ring; computed once.
  double diameter_of(Role role, std::size_t ring);
  const ShapeTiling* tiling_of(const Run& run, Role role) const;
  void begin(const RingMeeting& rings, EngineObserver* observer);
  std::optional<VertexId> named(const Run& run, VertexId v, bool edge) const;
  VertexId in_pair(const Run& run, VertexId v, bool edge) const;
  void note_contact(const Run& run);
  bool comes_before(const Found& a, const Found& b) const;

  const BodyPair& bodies_;
  const PairGeometry& geometry_;
  Offset offset_;
  bool keeps_tilings_ = false;  ///< of each ring alone, since there are several queries about it
  const MotionSegments& segments_in_roles(bool exchanged);
  RingMeetings meetings_at_start();

  MotionSegments segments_;
  /// With the roles exchanged: in a pair of rings, the size determines P and Q. Made when first needed.
  std::optional<MotionSegments> exchanged_segments_;
  std::vector<Run> runs_;
  bool overlap_ = false;
  std::optional<VertexId> inside_;
  StageCounts at_start_;
  std::optional<Found> contact_;
  std::array<std::vector<double>, 2> diameters_;  ///< of the rings of both bodies; negative if not known yet
};

}  // namespace taut::internal
