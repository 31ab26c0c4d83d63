// taut: exact first contact of moving shapes.
//
//   #include <taut/taut.hpp>
//   #include <iostream>
//
//   int main() {
//     taut::Scene scene;
//     scene.start = 0;
//     scene.end = 10;
//     scene.bodies = {{"anvil", {{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {}},
//                     {"hammer", {{1, 5}, {3, 5}, {2, 6}}, taut::from_velocity({0, -0.5})}};
//     const taut::Answer answer = taut::check(scene);
//     if (answer.outcome == taut::Outcome::contact) {
//       std::cout << "contact at " << answer.contact->time.lo << '\n';  // contact at 8
//     } else {
//       std::cout << to_string(answer.outcome) << '\n';
//     }
//   }
//
// taut/check.hpp       the question and its answer
// taut/proof.hpp       the answer with a proof, and the check of a proof
// taut/static_map.hpp  one body among many that rest, asked often
// taut/map_query.hpp   what a planner asks of it, with memory of its own: places, straight ways, chains of links
// taut/cells.hpp       which cells of a grid a moving body touches
// taut/grid.hpp        occupancy grids of robots as bodies
// taut/simulation.hpp  the same, online: step, advance, look at the tiling, change a motion plan
// taut/warm_check.hpp  one question after another about the same shapes, from places near the last ones
// taut/separate.hpp    in which directions bodies come apart, and in which order
// taut/envelope.hpp    for which combinations of joint values bodies keep apart
// taut/separator.hpp   curves with the fewest edges between the bodies
// taut/outline.hpp     outlines with curves, and polygons within and around them
// taut/scene.hpp       bodies, motions, time
// taut/motions.hpp     motions as people write them: keyframes, velocities, sweeps
// taut/pose.hpp        where a body is at one instant, for drawing
// taut/shape.hpp       shapes that come again, prepared once
// taut/validate.hpp    is the input valid?
// taut/io.hpp          scene files, outlines, pictures
// taut/feature.hpp     how bodies, vertices and edges are named
// taut/error.hpp       everything that is thrown
#pragma once

#include "taut/cells.hpp"
#include "taut/check.hpp"
#include "taut/envelope.hpp"
#include "taut/error.hpp"
#include "taut/feature.hpp"
#include "taut/geometry.hpp"
#include "taut/grid.hpp"
#include "taut/io.hpp"
#include "taut/map_query.hpp"
#include "taut/motion.hpp"
#include "taut/motions.hpp"
#include "taut/outline.hpp"
#include "taut/pose.hpp"
#include "taut/proof.hpp"
#include "taut/scene.hpp"
#include "taut/separate.hpp"
#include "taut/separator.hpp"
#include "taut/shape.hpp"
#include "taut/simulation.hpp"
#include "taut/static_map.hpp"
#include "taut/tracer.hpp"
#include "taut/validate.hpp"
#include "taut/warm_check.hpp"
