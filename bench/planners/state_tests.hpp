// Collision libraries as planners use them: may the robot be here?
#pragma once

#include <memory>

#include "planners/maps.hpp"

namespace taut::bench {

class StateTest {
 public:
  virtual ~StateTest() = default;
  virtual bool free(const PoseSE2& pose) = 0;
};

/// The map as one closed surface of prisms in a tree of OBBRSS, the robot as another one, twice as high.
std::unique_ptr<StateTest> make_fcl_test(const PlanMap& map);
/// Convex polygons in a dynamic tree, tested by b2Distance as b2TestOverlap does.
std::unique_ptr<StateTest> make_box2d_test(const PlanMap& map);

}  // namespace taut::bench
