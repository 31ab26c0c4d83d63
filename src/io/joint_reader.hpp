// Joints, and motions that follow them, from JSON.
#pragma once

#include <optional>
#include <string>

#include "io/json_document.hpp"
#include "taut/envelope.hpp"
#include "taut/path.hpp"

namespace taut::internal::io {

/// {"lift": [0, 60], "tilt": [-20, 40]}, in the order in which they stand there.
std::vector<Joint> read_joints(const JsonDocument& document, std::size_t token);

/// {"revolute": {"pivot": [x, y], "by": "lift"}}, {"slide": {"direction": [dx, dy], "by": "x"}}, either with "times"
/// and "plus" if they are not 1 and 0; {"free": {"x": "x", "y": "y", "deg": "turn", "pivot": [x, y]}}; or null.
std::optional<JointMotion> read_joint_motion(const JsonDocument& document, std::size_t token, const std::string& path,
                                             const std::vector<Joint>& joints);

/// What a question about paths has besides: "periodic", "start" and "goal", of joints that are known.
void read_periodic(const JsonDocument& document, std::size_t token, PathProblem& problem);
void read_start(const JsonDocument& document, std::size_t token, PathProblem& problem);
void read_goal(const JsonDocument& document, std::size_t token, PathProblem& problem);

// Bodies that follow joints, for pages that draw them at any values of these.

/// An array, an object for each body: its "name"; "parts", of each its outline and holes; the place of its "parent"
/// among the bodies; "motion", the outermost first: by "times" degrees for each unit of the "joint" of that number, and
/// "plus" degrees, about the "pivot"; or so far along the "direction". Of links of a mechanism there are "values"
/// instead of "times" and "plus", evenly over the joint's range, for pictures. Parents and motions are left out where
/// there are none.
std::string linked_bodies_json(const Linkage& linkage);

}  // namespace taut::internal::io
