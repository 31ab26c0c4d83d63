// Maps, robots and states for the tests of taut/ompl.hpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/made_world.hpp"
#include "taut/ompl.hpp"

namespace taut::testing {

namespace ob = ::ompl::base;

/// Stars in a grid of blocks 4 apart, a third of them left out.
inline std::vector<Body> star_obstacles(Rng& rng, int side) {
  std::vector<Body> all;
  for (int i = 0; i < side * side; ++i) {
    if (rng.chance(0.3) && i > 0) continue;
    Body block;
    block.name = "block" + std::to_string(i);
    block.parts = {star_part(rng, {4.0 * (i % side), 4.0 * (i / side)}, 1.5, 0)};
    all.push_back(block);
  }
  return all;
}

inline Body star_body(Rng& rng, const std::string& name, double size) {
  Body body;
  body.name = name;
  body.parts = {star_part(rng, {0, 0}, size, 0)};
  return body;
}

/// From -3 to 4 side in both directions.
template <class Space>
void set_bounds(Space& space, int side) {
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-3);
  bounds.setHigh(4.0 * side);
  space.setBounds(bounds);
}

/// A space with the two classes in question.
struct Planning {
  ob::StateSpacePtr space;
  std::shared_ptr<for_ompl::Robot> robot;
  ob::SpaceInformationPtr si;
  std::shared_ptr<for_ompl::StateValidityChecker> states;
  std::shared_ptr<for_ompl::MotionValidator> motions;

  Planning(ob::StateSpacePtr of, std::shared_ptr<for_ompl::Robot> who)
      : space(std::move(of)), robot(std::move(who)), si(std::make_shared<ob::SpaceInformation>(space)) {
    states = std::make_shared<for_ompl::StateValidityChecker>(si, robot);
    motions = std::make_shared<for_ompl::MotionValidator>(si, robot);
    si->setStateValidityChecker(states);
    si->setMotionValidator(motions);
    si->setup();
  }
  /// With numbers of taut's own generator.
  ob::State* random_state(Rng& rng, double lo, double hi) const {
    std::vector<double> values;
    for (unsigned i = 0; i < space->getDimension(); ++i)
      values.push_back(i < 2 && space->getDimension() > 2 ? rng.real(lo, hi) : rng.real(-3.1, 3.1));
    ob::State* state = si->allocState();
    space->copyFromReals(state, values);
    return state;
  }
};

}  // namespace taut::testing
