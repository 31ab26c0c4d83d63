// A scene that goes on: its near pairs, each with the kinetic engine, up to the same time.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/instance.hpp"
#include "solver/kinetic_solver.hpp"
#include "solver/near_pairs.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// It has a current time up to which no tested pair meets. The pairs that are near in the current window of time have
/// tilings, all followed to that time; no other pair costs anything until the next window. A single pair is always
/// near. If a body changes its motion, the certificates of its pairs, and of the pairs of the bodies that are attached
/// to it, are computed anew; a bridge covers the rounding by which the old and the new pose differ. The tilings stay.
class WorldSimulation {
 public:
  /// The observer of the single pair's events may be null. Throws InputError.
  WorldSimulation(const Scene& scene, Touch touch, std::uint64_t max_events, KineticObserver* observer = nullptr);

  /// Processes all events up to t, or to a contact.
  void advance(double t);
  /// Processes the next event up to t, and those of other pairs that are not later. If there is none, it advances to t.
  /// Returns false then, and after a contact.
  bool step(double t);
  /// An enclosure of the time of the next event of any pair up to t. Proceeds to the end of windows that have none.
  std::optional<TimeInterval> next_event(double t);
  /// From the present on. Throws InputError, and changes nothing.
  void set_motion(BodyId body, const Motion& motion);

  double start() const { return start_; }
  double end() const { return instance_.end(); }
  /// The solver of the single pair; null if there is none.
  KineticSolver* single_pair() const;
  /// The current tilings of two bodies; null if they have none.
  const RingEngines* engines(int a, int b) const;
  /// The time to which the tilings correspond. All events before it are processed, but for some that nearly coincide
  /// with the last one.
  double time() const { return now_; }
  bool finished() const { return processed_ >= end(); }
  /// Something has happened: a contact, an overlap, or what was not decided. Then that is the answer.
  bool over() const { return answer_.outcome != Outcome::free; }
  const Answer& answer() const { return answer_; }
  /// At present.
  Coverage coverage() const;
  /// Was there a pair to test at any time?
  bool has_tested() const { return has_tested_; }
  std::uint64_t events() const { return budget_.most - budget_.left; }
  /// Of the pairs that are near.
  std::uint64_t certificates() const;
  std::uint64_t certificates_max() const { return certificates_max_; }

 private:
  using Key = std::pair<int, int>;
  static Key key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }
  KineticSolver& pair(const Key& key);
  KineticSolver* only_tiling() const;
  bool first_to_fail(double t);
  void forget_distant_pairs();
  bool may_meet_at_start(int a, int b) const;
  void ask_starts();
  void ask_starts_of(const std::vector<int>& changed, const std::vector<int>& groups_before);
  void advance_in_window(double t);
  void advance_pairs(double to);
  void replan_pairs_of(int body);
  void note_time();
  void conclude();
  void check_body(BodyId body) const;
  void check_motion(BodyId body, const Motion& motion) const;
  void note_tested() { has_tested_ = has_tested_ || !coverage().is_empty(); }

  Touch touch_;
  KineticObserver* observer_;
  double start_;
  Instance instance_;
  std::vector<std::string> names_;
  double extent_ = 0;
  NearPairs near_;
  std::map<Key, std::unique_ptr<KineticSolver>> pairs_;
  EventBudget budget_;
  double now_;        ///< the time to which the tilings correspond
  double processed_;  ///< all events before this time are processed
  TimeInterval next_{};
  std::uint64_t certificates_max_ = 0;
  bool has_tested_ = false;
  Answer answer_;
};

}  // namespace taut::internal
