// Exact validity for planners of OMPL: states and edges of robots in the plane, without a resolution.
//
//   namespace ob = ompl::base;
//   const auto robot = std::make_shared<taut::for_ompl::Robot>(taut::StaticMap(walls, reach), body);
//   auto si = std::make_shared<ob::SpaceInformation>(space);   // SE2, Dubins, Reeds-Shepp, or SE2 with joints
//   si->setStateValidityChecker(std::make_shared<taut::for_ompl::StateValidityChecker>(si, robot));
//   si->setMotionValidator(std::make_shared<taut::for_ompl::MotionValidator>(si, robot));
//
// for_ompl::path_scene() is a whole path as a scene: for prove(), for `taut prove` and `taut verify`, and for pictures.
//
// Header only, for those who have OMPL (Debian: libompl-dev); nothing else of taut needs it. Tried with OMPL 1.5.2.
//
// What is proved of an edge. In all coordinates straight, x(t) = from + t d for t from 0 to 1, where d is the double
// nearest to the difference of the two (of angles, the short way round), for all t of the reals: the robot of exact
// polygons moves so among those of the map, and meets nothing. Along a car's curve: lines, and turns about the centres
// of its circles, with coefficients that are rounded once or twice from OMPL's; then the straight way from where the
// curve ends to the state that it was to end at. OMPL's interpolate() computes the same places in doubles: for numbers
// of magnitude M it differs by a few units of 2^-53 M. So a robot that must not touch, and lives on interpolated
// states, needs that much room; MapQueryOptions::touch = closed, or a body larger by 1e-12, gives it.
#pragma once

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateValidityChecker.h>

#include <atomic>
#include <cstdint>
#include <memory>

#include "taut/for_ompl/path.hpp"
#include "taut/for_ompl/planner.hpp"
#include "taut/for_ompl/robot.hpp"

namespace taut::for_ompl {

/// Is a state within the space's bounds, and does the robot overlap nothing there? `undecided` is invalid.
class StateValidityChecker : public ob::StateValidityChecker {
 public:
  /// Throws InputError where the space and the robot do not fit.
  StateValidityChecker(const ob::SpaceInformationPtr& si, std::shared_ptr<const Robot> robot)
      : ob::StateValidityChecker(si), robot_(std::move(robot)), steering_(*si->getStateSpace(), *robot_) {}

  /// Within the bounds, and free.
  bool isValid(const ob::State* state) const override {
    if (!si_->satisfiesBounds(state)) return false;
    const Robot::Borrowed asker(*robot_);
    steering_.poses(state, asker->coordinates, asker->from);
    const MapFinding found = asker->query.at(asker->from);
    if (found.outcome == Outcome::undecided) undecided_.fetch_add(1, std::memory_order_relaxed);
    return found.free();
  }
  /// How many states were invalid because nothing was decided.
  std::uint64_t undecided() const { return undecided_; }

 private:
  std::shared_ptr<const Robot> robot_;
  Steering steering_;
  mutable std::atomic<std::uint64_t> undecided_{0};
};

/// Is an edge free, all of it? Its beginning is checked, too. `undecided` is invalid. A curve is also invalid where it
/// leaves the bounds of x and y, by its circles in doubles; straight ways between states within the bounds never do.
class MotionValidator : public ob::MotionValidator {
 public:
  /// Throws InputError where the space and the robot do not fit.
  MotionValidator(const ob::SpaceInformationPtr& si, std::shared_ptr<const Robot> robot)
      : ob::MotionValidator(si), robot_(std::move(robot)), steering_(*si->getStateSpace(), *robot_) {}

  /// Is it free, all the way?
  bool checkMotion(const ob::State* s1, const ob::State* s2) const override {
    const Robot::Borrowed asker(*robot_);
    return counted(asked(s1, s2, *asker, true).free);
  }

  /// `lastValid.second` is the largest time found, up to the lower bound of the first contact, at which the state that
  /// OMPL interpolates is valid: that bound itself, or, where rounding puts the state into the obstacle, a little less.
  bool checkMotion(const ob::State* s1, const ob::State* s2, std::pair<ob::State*, double>& lastValid) const override {
    const Robot::Borrowed asker(*robot_);
    const Verdict verdict = asked(s1, s2, *asker, false);
    if (!verdict.free) set_last_valid(s1, s2, verdict.share, *asker, lastValid);
    return counted(verdict.free);
  }
  /// How many edges were invalid because nothing was decided.
  std::uint64_t undecided() const { return undecided_; }

 private:
  struct Verdict {
    bool free;
    double share;  ///< of the way, which is free
  };

  Verdict asked(const ob::State* s1, const ob::State* s2, Robot::Asker& asker, bool any) const {
    if (steering_.curved()) return asked_along_curve(s1, s2, asker, any);
    steering_.ends(s1, s2, asker);
    const MapFinding found = any ? asker.query.passes(asker.from, asker.to) : asker.query.along(asker.from, asker.to);
    note(found);
    return {found.free(), found.free_until};
  }

  Verdict asked_along_curve(const ob::State* s1, const ob::State* s2, Robot::Asker& asker, bool any) const {
    steering_.ends(s1, s2, asker);
    const Curve curve = steering_.curve(s1, s2);
    WayBox box;
    double end = 0;
    {
      PieceWriter pieces(asker.motions[0]);
      end = write_curve(curve, asker.from[0], asker.to[0], 0, pieces, &box);
    }
    if (!within_bounds(box)) return {false, 0};
    const double until = end + closing_time;
    const MapFinding found =
        any ? asker.query.passes(asker.motions, 0, until) : asker.query.along(asker.motions, 0, until);
    note(found);
    return {found.free(), end > 0 ? std::min(1.0, found.free_until / end) : 0};
  }

  bool within_bounds(const WayBox& box) const {
    const auto* space = si_->getStateSpace()->as<ob::SE2StateSpace>();
    const ob::RealVectorBounds& b = space->getBounds();
    constexpr double room = 1e-9;  // the states at the ends are within the bounds by OMPL's own tolerance
    return box.lo_x > b.low[0] - room && box.hi_x < b.high[0] + room && box.lo_y > b.low[1] - room &&
           box.hi_y < b.high[1] + room;
  }

  void set_last_valid(const ob::State* s1, const ob::State* s2, double share, Robot::Asker& asker,
                      std::pair<ob::State*, double>& lastValid) const {
    const ob::StateSpacePtr& space = si_->getStateSpace();
    ob::State* const at = space->allocState();
    double found = 0;
    for (double less = 0x1p-52, t = share; t > 0 && less < 1; less *= 4, t = share * (1 - less)) {
      space->interpolate(s1, s2, t, at);
      steering_.poses(at, asker.coordinates, asker.from);
      if (!si_->satisfiesBounds(at) || !asker.query.at(asker.from).free()) continue;
      found = t;
      break;
    }
    lastValid.second = found;
    // At 0 it is the first state itself.
    if (lastValid.first) space->copyState(lastValid.first, found > 0 ? at : s1);
    space->freeState(at);
  }

  void note(const MapFinding& found) const {
    if (found.outcome == Outcome::undecided) undecided_.fetch_add(1, std::memory_order_relaxed);
  }
  /// OMPL's own counters are plain numbers, which threads share.
  bool counted(bool free) const {
    std::atomic_ref<unsigned>(free ? valid_ : invalid_).fetch_add(1, std::memory_order_relaxed);
    return free;
  }

  std::shared_ptr<const Robot> robot_;
  Steering steering_;
  mutable std::atomic<std::uint64_t> undecided_{0};
};

}  // namespace taut::for_ompl
