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
// What there is, by what it is for:
//
// Questions about a scene
//   taut/check.hpp       when do bodies first collide, if ever?
//   taut/clearance.hpp   how close do they come? do they keep a distance? how far apart are they over time?
//   taut/intervals.hpp   when do they overlap? how far can they go from an instant, both ways?
//   taut/separate.hpp    in which directions do bodies come apart, and in which order?
//   taut/mechanism.hpp   bodies on pins and slides, also in closed loops; taut/mechanism_motion.hpp: how do they move?
//   taut/envelope.hpp    for which combinations of joint values do bodies keep apart?
//   taut/path.hpp        is there any way from a start to a goal?
//   taut/path_proof.hpp  proofs that there is none
//   taut/cells.hpp       which cells of a grid does a moving body touch?
//   taut/swept.hpp       which region does a moving body pass over?
//   taut/follow.hpp      how high does a cam lift its follower?
//   taut/proof.hpp       the answers with a proof, and the check of a proof
//   taut/coverage.hpp    which pairs of bodies an answer is about
//   taut/limits.hpp      when a question gives up
//   taut/ask.hpp         all of this as text: a name, options and an answer in JSON
//
// Objects with memory
//   taut/static_map.hpp  one body among many that rest, asked often
//   taut/map_query.hpp   what a planner asks of such a map: places, straight motions, chains of links
//   taut/simulation.hpp  the motion online: step, advance, change a motion, go on after a contact, get the tiling
//   taut/contact_motions.hpp  what bodies do at a contact: stop, give way
//
// Scenes
//   taut/scene.hpp       bodies, motions, time
//   taut/motions.hpp     motions as people write them: keyframes, velocities, sweeps
//   taut/outline.hpp     outlines with curves, and polygons within and around them
//   taut/shape.hpp       shapes that come again, prepared once
//   taut/grid.hpp        occupancy grids of robots as bodies
//   taut/pose.hpp        where a body is at one instant, for drawing
//   taut/feature.hpp     how bodies, vertices and edges are named
//   taut/validate.hpp    is the input valid?
//   taut/io.hpp          scene files, outlines, pictures of scenes
//   taut/error.hpp       everything that is thrown
//
// From the paper
//   taut/separator.hpp   curves with the fewest edges between the bodies
//   taut/tracer.hpp      the events of a run
#pragma once

#include "taut/ask.hpp"
#include "taut/cells.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/contact_motions.hpp"
#include "taut/coverage.hpp"
#include "taut/envelope.hpp"
#include "taut/error.hpp"
#include "taut/feature.hpp"
#include "taut/follow.hpp"
#include "taut/geometry.hpp"
#include "taut/grid.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/limits.hpp"
#include "taut/map_query.hpp"
#include "taut/mechanism_motion.hpp"
#include "taut/motion.hpp"
#include "taut/motions.hpp"
#include "taut/outline.hpp"
#include "taut/path.hpp"
#include "taut/path_proof.hpp"
#include "taut/pose.hpp"
#include "taut/proof.hpp"
#include "taut/scene.hpp"
#include "taut/separate.hpp"
#include "taut/separator.hpp"
#include "taut/shape.hpp"
#include "taut/simulation.hpp"
#include "taut/static_map.hpp"
#include "taut/swept.hpp"
#include "taut/tracer.hpp"
#include "taut/validate.hpp"
