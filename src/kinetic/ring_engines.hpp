// Two bodies of rings in the kinetic engine: one engine for each two rings that can meet.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "kinetic/engine.hpp"
#include "pair/pair_plan.hpp"
#include "pair/ring_meetings.hpp"
#include "sign/contact_bracket.hpp"

namespace taut::internal {

/// The tiling is between two simple polygons. Which of two parts' rings can meet is settled where they start, and does
/// not change before they do: so the first contact of two bodies is the earliest of those of such pairs of rings, each
/// with an engine of its own. A hole that has the other body's part in it takes part as the container around it.
class RingEngines {
 public:
  /// Segments of the pair in its roles, and with the roles exchanged: a pair of rings has P and Q by what is larger.
  using BothSegments = std::array<MotionSegments, 2>;

  /// Builds the tilings at the start of the segments. The plan and the geometry are those of bodies of rings, and must
  /// outlive this, as must the observer, who may be null. Throws Undecidable.
  RingEngines(const PairPlan& plan, const PairGeometry& geometry, bool inwards, BothSegments segments,
              EngineObserver* observer = nullptr);

  /// Do the bodies overlap at the start of the segments? Then no more can be asked.
  bool overlap() const { return overlap_; }
  /// If they do, and it was seen by a vertex of one in the other, that vertex of the pair's geometry.
  const std::optional<VertexId>& inside() const { return inside_; }

  enum class Arrival : unsigned char { there, contact, on_the_way };
  /// Up to t, or to the contact. After so many events it is left on the way. Throws Undecidable, and what interrupts
  /// it.
  Arrival advance(double t, std::uint64_t events = UINT64_MAX);
  /// Everything up to there is proved.
  double reached() const;
  /// The same at the present, between events: no failure is due before.
  double proved_until() const;
  /// An enclosure of the time of the next event up to t.
  std::optional<std::pair<double, double>> next_event(double t);

  /// In the terms of the pair's geometry and of its segments.
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
  const MotionSegments& segments() const { return segments_[0]; }

  std::size_t size() const { return runs_.size(); }
  Engine& engine(std::size_t k) { return *runs_[k].engine; }
  RingMeeting meeting(std::size_t k) const { return runs_[k].rings; }
  /// The vertex of the pair's geometry that a vertex of that engine's is; nothing for the box and the slit around a
  /// hole.
  std::optional<VertexId> named_vertex(std::size_t k, VertexId v) const { return named(runs_[k], v, false); }
  /// Does a hole take part in it?
  bool is_contained(std::size_t k) const;

 private:
  struct Run {
    RingMeeting rings;
    bool exchanged = false;  ///< P of the pair plays Q
    std::unique_ptr<Engine> engine;

    /// The role in the pair of bodies, of that in the pair of rings.
    Role in_pair(Role role) const { return exchanged ? other(role) : role; }
  };
  template <class Count>
  std::uint64_t sum_of(Count (Engine::*count)() const) const {
    std::uint64_t sum = 0;
    for (const Run& run : runs_) sum += ((*run.engine).*count)();
    return sum;
  }
  const RingSet& set_of(const Run& run, Role role) const { return *plan_.rings[index_of(run.in_pair(role))]; }
  static std::size_t ring_number(const Run& run, Role role) {
    return run.in_pair(role) == Role::p ? run.rings.p : run.rings.q;
  }
  const LoneRing& ring_of(const Run& run, Role role) const;
  /// Of a ring, squared and scaled; found once.
  double diameter_of(Role role, std::size_t ring);
  const ShapeTiling* tiling_of(const Run& run, Role role) const;
  void begin(const RingMeeting& rings, EngineObserver* observer);
  std::optional<VertexId> named(const Run& run, VertexId v, bool edge) const;
  VertexId in_pair(const Run& run, VertexId v, bool edge) const;
  void note_contact(const Run& run);
  bool comes_before(const Found& a, const Found& b) const;

  const PairPlan& plan_;
  const PairGeometry& geometry_;
  bool inwards_;
  bool rings_recur_ = false;  ///< in several pairs each, so that what is known of one alone is worth knowing
  BothSegments segments_;
  std::vector<Run> runs_;
  bool overlap_ = false;
  std::optional<VertexId> inside_;
  StageCounts at_start_;
  std::optional<Found> contact_;
  std::array<std::vector<double>, 2> diameters_;  ///< of the rings of both; negative where not known yet
};

}  // namespace taut::internal
