// A scene that goes on: its near pairs, each with the kinetic engine, event by event.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/instance.hpp"
#include "scene/validate_scene.hpp"
#include "session/due_queue.hpp"
#include "session/near_bodies.hpp"
#include "solver/kinetic_solver.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"

namespace taut::internal {

/// It has a current time up to which no tested pair meets. The pairs that are near have tilings. A queue holds for each
/// a time before which none of its certificates fails, and the pair with the least one is next: it looks further, or
/// processes an event. So a pair costs nothing between its own events. A single pair is always near.
///
/// A contact changes no tiling. Where a body changes its motion, then or between events, the certificates of its pairs,
/// and of the pairs of the bodies that are attached to it, are computed anew; a bridge covers the rounding by which the
/// old and the new pose differ. A tiling that corresponds to a later time, as that of a pair in contact, is built anew
/// right before the present, where all pairs are proved to be apart.
class WorldSimulation {
 public:
  /// The observer of the single pair's events may be null. Throws InputError.
  WorldSimulation(const Scene& scene, Touch touch, std::uint64_t max_events, KineticObserver* observer = nullptr);

  /// Processes all events up to t, or to a contact.
  void advance(double t);
  /// Processes the next event up to t, and those of other pairs that are not later. If there is none, it advances to t.
  /// Returns false then, and after a contact.
  bool step(double t);
  /// An enclosure of the time of the next event of any pair up to t.
  std::optional<TimeInterval> next_event(double t);
  /// Processes events that nearly coincide with the last one, and the rest of a bridge: they belong to the motions that
  /// have held until now.
  void settle();
  /// From the present on; after a contact, too. Throws InputError, and changes nothing.
  void set_motion(BodyId body, const Motion& motion);
  // The next four cost what they are about. They throw InputError, and change nothing, also where bodies would overlap,
  // and return false, and change nothing, where a world must begin anew: at a single pair, and see Instance::can_add().
  // After settle().
  bool add_body(const Body& body);
  /// Bodies that are attached to it must not be there. Under its new name it is ignored by all others.
  bool remove_body(BodyId body, const std::string& name);
  bool ignore(BodyId a, BodyId b);
  /// The body must not jump.
  bool set_parent(BodyId body, std::optional<BodyId> parent, const Motion& motion);
  /// Throws InputError unless the motion is valid from the present on, and has the body where it is.
  void check_motion(BodyId body, const Motion& motion) const;
  /// Goes on after a contact. Pairs whose motions are still the same are in contact again.
  void resume();

  double start() const { return start_; }
  double end() const { return instance_.end(); }
  /// The solver of the single pair; null if there is none.
  KineticSolver* single_pair() const;
  /// The current tilings of two bodies; null if they have none.
  const RingEngines* engines(int a, int b) const;
  /// The time to which the simulation corresponds. All events before it are processed, but for some that nearly
  /// coincide with the last one.
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
  std::uint64_t certificates() const { return certificates_; }
  std::uint64_t certificates_max() const { return certificates_max_; }
  /// For a simulation of the rest of the same scene.
  AtRest at_rest() const { return instance_.at_rest(); }
  const Instance& instance() const { return instance_; }
  /// Of the bodies, in the input's units: jumps are measured by it.
  double extent() const { return extent_; }
  /// It goes on from where that world is, which may stand at a contact.
  void carry_on(const WorldSimulation& before);

 private:
  using Key = std::pair<int, int>;
  struct Near {
    Key key;
    std::unique_ptr<KineticSolver> solver;  ///< null while discs keep the two bodies apart
    double due = 0;                         ///< no certificate fails before, and discs are apart until then
    std::optional<TimeInterval> next;       ///< the next event, if it is known
    std::uint64_t certificates = 0;
    std::uint32_t place = DueQueue<Near>::nowhere;
    bool has_changed = false;  ///< a body moves in another way from now on: the tilings must follow
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const {
      const auto a = static_cast<std::uint64_t>(key.first), b = static_cast<std::uint64_t>(key.second);
      return static_cast<std::size_t>(((a << 32 | b) * 0x9e3779b97f4a7c15u) >> 32);
    }
  };
  /// Never followed in the order of their keys.
  using Pairs = std::unordered_map<Key, Near, KeyHash>;

  static Key key(int a, int b) { return {std::min(a, b), std::max(a, b)}; }
  void add_pair(const Key& key, std::optional<double> from, double jump = 0);
  void begin_tilings(Near& near, std::optional<double> from);
  bool may_meet_soon(const Near& near) const;
  bool leave_to_discs(Near& near, double from, double jump);
  void end_pair(const Key& key);
  void enqueue(Near& near);
  KineticSolver* only_tiling() const;
  void ask_starts_of_groups();
  bool first_is_box() const { return queue_.empty() || near_.until() <= queue_.first_due(); }
  double first_due() const;
  std::optional<double> first_end() const;
  double next_due() const;
  void renew_boxes();
  double process_first(double limit);
  double process_due(double limit);
  static double result_end(const Near& near);
  void look(Near& near, double soon, double limit);
  void take_step(Near& near, double limit);
  void note_time();
  void replan_pair(const Key& key, double jump);
  void follow_change(Near& near);
  double jump_of(BodyId body) const;
  void count_certificates(Near& near);
  bool conclude(double limit);
  void check_body(BodyId body) const;
  double right_before() const { return now_ > start_ ? std::nextafter(now_, start_) : now_; }
  int depth_of(int body) const;
  std::optional<Key> begin_pairs(const std::vector<int>& bodies, const NearBodies::Changes& changes);
  std::optional<Key> attach(int body, int parent, const PieceList& own);
  void forget_last();
  InputError overlap_error(const Key& key, int culprit) const;
  /// In the input's units.
  AxisBox input_bounds(BodyId body) const {
    return instance_.bodies()[static_cast<std::size_t>(body)].rings->input_bounds();
  }
  void note_tested() { has_tested_ = has_tested_ || !coverage().is_empty(); }

  Touch touch_;
  KineticObserver* observer_;
  double start_;
  Instance instance_;
  std::vector<std::string> names_;
  std::optional<BodyNames> numbers_;  ///< known from the first body on that is added
  double extent_ = 0;
  EventBudget budget_;
  NearBodies near_;
  Pairs pairs_;
  DueQueue<Near> queue_;  ///< of all pairs with no result
  std::set<Key> ended_;   ///< pairs with a result: a contact, an overlap, or what was not decided
  double now_;            ///< the present
  double reached_ = 0;    ///< the end of the last event
  double processed_;      ///< all events up to this time are processed
  std::uint64_t certificates_ = 0, certificates_max_ = 0;
  bool has_tested_ = false;
  Answer answer_;
};

}  // namespace taut::internal
