// find_path() as a planner of OMPL: a way that is proved, or the proof that there is none. Needs OMPL (libompl-dev).
//
//   ob::PlannerPtr planner = std::make_shared<taut::for_ompl::Planner>(si, problem);
//   setup.setPlanner(planner);
//
// The space's coordinates, in order, are the problem's joints: real numbers as they are, angles of SO2 in degrees. The
// start and the goal are those of OMPL's problem; what the PathProblem says of them means nothing.
#pragma once

#include <ompl/base/Planner.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/PathGeometric.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "taut/for_ompl/states.hpp"
#include "taut/path.hpp"

namespace taut::for_ompl {

/// Complete up to its tolerance. Where there is no way, solve() returns INFEASIBLE, or ABORT where OMPL does not know
/// that word (before 1.6), and answer() says `none`.
class Planner : public ob::Planner {
 public:
  /// Throws InputError where the space and the problem do not fit: as many coordinates as joints, and each angle a
  /// joint with a period of 360.
  Planner(const ob::SpaceInformationPtr& si, PathProblem problem, PathOptions options = {})
      : ob::Planner(si, "taut"),
        problem_(std::move(problem)),
        options_(options),
        reader_(*si->getStateSpace()),
        space_(si->getStateSpace()) {
    if (reader_.size() != problem_.linkage.joints.size())
      throw InputError("joints",
                       "there are " + std::to_string(problem_.linkage.joints.size()) + ", and the space has " +
                           std::to_string(reader_.size()) + " coordinates",
                       "give the problem a joint for each coordinate, in order");
    for (std::size_t k = 0; k < reader_.size(); ++k) {
      const Joint& joint = problem_.linkage.joints[k];
      if (reader_.wraps(k) != problem_.periodic[k] || (reader_.wraps(k) && joint.hi - joint.lo != 360))
        throw InputError("joints." + joint.name, "an angle of OMPL wraps, and a coordinate of another kind does not",
                         "give angles a period of 360 degrees, and no other joints one");
    }
  }

  /// Asks find_path().
  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& stop) override {
    checkValidity();
    const ob::State* start = pis_.nextStart();
    if (!start) return ob::PlannerStatus::INVALID_START;
    const auto* goal = dynamic_cast<const ob::GoalState*>(pdef_->getGoal().get());
    if (!goal) return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    problem_.start = values_of(start);
    const JointValues end = values_of(goal->getState());
    problem_.goal = {};
    problem_.goal_outside = false;
    for (std::size_t k = 0; k < reader_.size(); ++k) problem_.goal[k] = {end[k], end[k]};
    try {
      answer_ = asked(stop);
    } catch (const InputError&) {
      return ob::PlannerStatus::INVALID_START;
    }
    if (answer_.outcome == PathOutcome::none) return no_way();
    if (answer_.outcome != PathOutcome::path) return ob::PlannerStatus::TIMEOUT;
    pdef_->addSolutionPath(path());
    return ob::PlannerStatus::EXACT_SOLUTION;
  }
  /// As OMPL wants it: the last answer is forgotten.
  void clear() override {
    ob::Planner::clear();
    answer_ = {};
  }

  /// The last answer.
  const PathAnswer& answer() const { return answer_; }
  /// With the start and the goal that were asked about: for path_scene() and prove_path().
  const PathProblem& problem() const { return problem_; }

 private:
  static constexpr double degree = pi / 180;

  /// OMPL's word for what can not be solved, if it has one.
  template <class Status = ob::PlannerStatus>
  static ob::PlannerStatus no_way() {
    if constexpr (requires { Status::INFEASIBLE; }) {
      return Status::INFEASIBLE;
    } else {
      return Status::ABORT;
    }
  }
  /// Within the joints' ranges.
  JointValues values_of(const ob::State* state) const {
    std::vector<double> numbers;
    reader_.read(state, numbers);
    JointValues values{};
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const Joint& joint = problem_.linkage.joints[k];
      values[k] = reader_.wraps(k) ? numbers[k] / degree : numbers[k];
      if (reader_.wraps(k)) values[k] -= 360 * std::floor((values[k] - joint.lo) / 360);
      if (reader_.wraps(k)) values[k] = std::clamp(values[k], joint.lo, joint.hi);
    }
    return values;
  }
  /// The condition is looked at every millisecond.
  PathAnswer asked(const ob::PlannerTerminationCondition& stop) {
    std::atomic<bool> stopped{false}, over{false};
    std::thread watch([&] {
      while (!over && !stop()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      stopped = true;
    });
    struct Joined {
      std::atomic<bool>& over;
      std::thread& watch;
      ~Joined() {
        over = true;
        watch.join();
      }
    } const joined{over, watch};
    PathOptions options = options_;
    options.limits.stop = &stopped;
    return find_path(problem_, options);
  }
  /// OMPL goes the short way round between two states: each turn is cut into ones of less than half a turn.
  ob::PathPtr path() const {
    auto found = std::make_shared<::ompl::geometric::PathGeometric>(si_);
    for (std::size_t i = 0; i < answer_.waypoints.size(); ++i) {
      const JointValues& to = answer_.waypoints[i];
      const JointValues& from = answer_.waypoints[i == 0 ? 0 : i - 1];
      int parts = 1;
      for (std::size_t k = 0; k < reader_.size(); ++k) {
        if (reader_.wraps(k)) parts = std::max(parts, static_cast<int>(std::ceil(std::fabs(to[k] - from[k]) / 90)));
      }
      for (int part = i == 0 ? parts : 1; part <= parts; ++part) {
        JointValues at = to;
        for (std::size_t k = 0; k < reader_.size(); ++k) at[k] = from[k] + (to[k] - from[k]) * part / parts;
        append(*found, part == parts ? to : at);
      }
    }
    return found;
  }
  void append(::ompl::geometric::PathGeometric& path, const JointValues& values) const {
    ob::State* state = si_->allocState();
    std::vector<double> numbers(reader_.size());
    for (std::size_t k = 0; k < numbers.size(); ++k)
      numbers[k] = reader_.wraps(k) ? std::remainder(values[k] * degree, 2 * pi) : values[k];
    space_->copyFromReals(state, numbers);
    path.append(state);
    si_->freeState(state);
  }

  PathProblem problem_;
  PathOptions options_;
  StateReader reader_;
  ob::StateSpacePtr space_;
  PathAnswer answer_;
};

}  // namespace taut::for_ompl
