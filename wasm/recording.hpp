// A simulation whose events are kept, so that the map at any time is had by replaying them forwards and backwards.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/scene.hpp"
#include "taut/simulation.hpp"

namespace taut::web {

/// Flat arrays, in the layout that web/src/recording.ts reads.
class Recording : private Tracer {
 public:
  static constexpr int halfedge_ints = 3;  ///< origin, next, face (see face_code)
  static constexpr int change_ints = 7;    ///< half-edge, the three before, the three after
  /// first change, one past the last change, repair, flags, the corner's three vertices (body, index), certificates
  static constexpr int event_ints = 11;

  /// Throws InputError or UndecidedError.
  Recording(const Scene& scene, Touch touch);

  /// Processes events up to `until`, for about `milliseconds` at most. True if that time is reached, or nothing is
  /// left to do.
  bool advance(double until, double milliseconds);
  /// From time() on, body `body` moves as in `edited`, whose other parts must be as before.
  void change_plan(const Scene& edited, int body);

  const Scene& scene() const { return scene_; }
  const Simulation& simulation() const { return simulation_; }
  /// As check() would answer, as far as the simulation has come.
  Answer answer() const;
  Touch touch() const { return touch_; }

  const std::vector<std::int32_t>& vertices() const { return vertices_; }  ///< body, index of the input
  const std::vector<std::int32_t>& start() const { return start_; }        ///< the half-edges before all events
  const std::vector<std::int32_t>& changes() const { return changes_; }
  const std::vector<std::int32_t>& events() const { return events_; }
  const std::vector<double>& times() const { return times_; }  ///< lo, hi of each event

 private:
  void on_event(const TraceEvent& event) override;

  Scene scene_;
  Touch touch_;
  Simulation simulation_;
  std::uint64_t initial_ = 0;
  std::vector<TilingHalfedge> map_;
  std::vector<std::int32_t> vertices_, start_, changes_, events_;
  std::vector<double> times_;
};

}  // namespace taut::web
