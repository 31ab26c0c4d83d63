// A planner's whole path as a scene.
#pragma once

#include <vector>

#include "taut/for_ompl/robot.hpp"
#include "taut/scene.hpp"

namespace taut::for_ompl {

namespace detail {

/// Adds the straight way between two states, from time t to t + 1.
inline double write_line(const Steering& steering, const ob::State* a, const ob::State* b, double t,
                         Robot::Asker& asker, std::vector<Motion>& motions) {
  steering.ends(a, b, asker);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const PoseSE2 &from = asker.from[k], &to = asker.to[k];
    PieceWriter(motions[k], motions[k].pieces.size())
        .line(from, {to.x - from.x, to.y - from.y, to.angle - from.angle}, t, t + 1);
    motions[k].pieces.back().until = t + 1;
  }
  return t + 1;
}

/// Adds a car's curve between two states; a turning radius takes one unit of time.
inline double write_car(const Steering& steering, const ob::State* a, const ob::State* b, double t, Robot::Asker& asker,
                        Motion& motion) {
  steering.ends(a, b, asker);
  double end = 0;
  {
    PieceWriter pieces(motion, motion.pieces.size());
    end = write_curve(steering.curve(a, b), asker.from[0], asker.to[0], t, pieces) + closing_time;
  }
  motion.pieces.back().until = end;
  return end;
}

}  // namespace detail

/// The map's bodies, and the robot's links on their way through all states, one after the other: an edge straight in
/// all coordinates from one whole number of time to the next, a curve as long as it is in turning radii. It is the
/// motion that MotionValidator asks about, up to the rounding of coefficients for another time; what check() or prove()
/// say of the scene is as certain as ever. Throws InputError if there is no state, or where space and robot do not fit.
inline Scene path_scene(const Robot& robot, const ob::StateSpace& space, const std::vector<ob::State*>& states) {
  const Steering steering(space, robot);
  if (states.empty()) throw InputError("path", "there is no state", "give the states of a path that was found");
  const Robot::Borrowed asker(robot);
  std::vector<Motion> motions(robot.links().size());
  double t = 0;
  for (std::size_t i = 1; i < states.size(); ++i) {
    t = steering.curved() ? detail::write_car(steering, states[i - 1], states[i], t, *asker, motions[0])
                          : detail::write_line(steering, states[i - 1], states[i], t, *asker, motions);
  }
  // A path of one state rests.
  if (states.size() == 1) detail::write_line(steering, states[0], states[0], 0, *asker, motions);
  Scene scene;
  scene.end = t;
  for (std::size_t i = 0; i < robot.map().size(); ++i) scene.bodies.push_back(robot.map().body(static_cast<int>(i)));
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Link& link = robot.links()[k];
    Body body = link.shape;
    body.motion = std::move(motions[k]);
    body.motion.pieces.back().until = std::numeric_limits<double>::infinity();
    if (link.parent >= 0) {
      body.relative_to = robot.links()[static_cast<std::size_t>(link.parent)].shape.name;
      scene.ignore.push_back({body.name, body.relative_to});
    }
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

}  // namespace taut::for_ompl
