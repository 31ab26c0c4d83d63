// A world that goes on: its near pairs, each with the kinetic engine, up to the same time.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "search/kinetic_solver.hpp"
#include "search/near_pairs.hpp"
#include "taut/check.hpp"
#include "world/instance.hpp"

namespace taut::internal {

/// Stands at a time up to which no pair that is asked about meets. The pairs that are near in the present window of
/// time have tilings, all followed to that time; no other pair costs anything until the next window. A body that
/// changes its plan takes the tilings of its pairs with it, and those of the bodies that are seen from it: they are
/// built anew, just before the present, so that what the old pose and the new one differ by is bridged. All others
/// stay, and cost nothing then.
class WorldSimulation {
 public:
  /// Throws InputError.
  WorldSimulation(const Scene& scene, Touch touch, std::uint64_t max_events);

  /// All events up to t, or to a contact.
  void advance(double t);
  /// An enclosure of the time of the next event of any pair. Goes on to the end of windows in which there is none.
  std::optional<TimeInterval> next_event();
  /// From the present on. Throws InputError, and changes nothing.
  void set_motion(BodyId body, const Motion& motion);

  double start() const { return start_; }
  double end() const { return instance_.end(); }
  /// Up to where it is proved free.
  double time() const { return now_; }
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
  void open_window();
  void ask_starts();
  void ask_starts_of(const std::vector<int>& changed, const std::vector<int>& groups_before);
  void advance_pairs(double to);
  void conclude();
  void check_motion(BodyId body, const Motion& motion) const;
  void note_tested() { has_tested_ = has_tested_ || !coverage().is_empty(); }

  Touch touch_;
  double start_;
  Instance instance_;
  std::vector<std::string> names_;
  double extent_ = 0;
  NearPairs near_;
  std::map<Key, std::unique_ptr<KineticSolver>> pairs_;
  EventBudget budget_;
  double now_;
  std::uint64_t certificates_max_ = 0;
  bool has_tested_ = false;
  Answer answer_;
};

}  // namespace taut::internal
