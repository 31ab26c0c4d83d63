// A pointed pseudo-triangulation of the common exterior of moving bodies, kept up to date event by event.
//
// This is the idea of two papers, in the plainest form that keeps it: Kirkpatrick, Snoeyink and Speckmann, Kinetic
// collision detection for simple polygons (2002), and Agarwal, Basch, Guibas, Hershberger and Zhang, Deformable free
// space tilings for kinetic collision detection (2002). Like the former, it is pointed: there are as few edges as there
// can be, and which ones depends on what happened before, so that nothing bounds the number of events.
#pragma once

#include <cstdint>
#include <queue>
#include <vector>

#include "comparison/failure_time.hpp"
#include "comparison/half_edges.hpp"

namespace taut::paper {

class KineticTiling {
 public:
  /// Builds the tiling at `start`. The bodies must outlive it, be disjoint until `end`, and have no three vertices in
  /// line at the start.
  KineticTiling(const MovingBodies& bodies, double start, double end);

  /// Processes the next event, or a joint of motions. False if there is none before the end. Throws StructureError
  /// where a vertex reaches a side of a body, or the event is none that a pseudo-triangulation can have.
  bool step();
  /// Of the last event.
  double time() const { return time_; }
  /// When there may be an event next; infinite if never.
  double next_time();

  const HalfEdges& map() const { return map_; }
  /// Corners with vertices of bodies that move relative to each other: all others cannot fail.
  std::uint64_t certificates() const { return active_; }
  std::uint64_t certificates_max() const { return active_max_; }
  /// Free edges between bodies that move relative to each other.
  std::uint64_t mixed_edges() const;
  std::uint64_t events() const { return events_; }
  /// Failure times that were computed, and the steps that these took.
  std::uint64_t failure_times() const { return failure_times_; }
  std::uint64_t steps() const { return steps_; }
  /// Certificates that had failed when they were made: by jumps between two pieces of a motion, or by rounding.
  std::uint64_t late() const { return late_; }
  /// The memory that it takes, without the bodies.
  std::size_t bytes() const;
  /// Whether every certificate holds where bodies are at t.
  bool holds(double t) const;

 private:
  struct Entry {
    double time = 0;
    int half_edge = 0;
    std::uint32_t version = 0;
    bool failure = false;  ///< else a joint
    bool operator>(const Entry& other) const {
      return time != other.time ? time > other.time : half_edge > other.half_edge;
    }
  };
  struct Corner {
    std::uint32_t version = 0;
    std::int8_t sign = 0;  ///< 0: not active
  };

  Triple triple(int h) const;
  bool is_mixed(int u, int v, int w) const;
  bool is_active(int h) const;
  /// Derives the certificate of the corner at the origin of h.
  void renew(int h);
  void schedule(int h);
  void repair(int h);
  bool prefers_previous(int h) const;
  int mixed_after(int h, bool previous) const;
  void slide(int h, bool previous);
  void drop_stale();

  const MovingBodies& bodies_;
  double time_ = 0, end_ = 0;
  HalfEdges map_;
  std::vector<Corner> corners_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::uint64_t active_ = 0, active_max_ = 0, events_ = 0, failure_times_ = 0, steps_ = 0, late_ = 0;
};

}  // namespace taut::paper
