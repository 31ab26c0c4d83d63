// Joints, and motions that follow them, from JSON.
#pragma once

#include <optional>

#include "io/json_document.hpp"
#include "taut/envelope.hpp"

namespace taut::internal::io {

/// {"lift": [0, 60], "tilt": [-20, 40]}, in the order in which they stand there.
std::vector<Joint> read_joints(const JsonDocument& document, std::size_t token);

/// {"revolute": {"pivot": [x, y], "by": "lift"}}, {"slide": {"direction": [dx, dy], "by": "x"}}, either with "times"
/// and "plus" if they are not 1 and 0; or null.
std::optional<JointMotion> read_joint_motion(const JsonDocument& document, std::size_t token, const std::string& path,
                                             const std::vector<Joint>& joints);

}  // namespace taut::internal::io
