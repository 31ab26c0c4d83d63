// Which subpath is an outline, and which a hole?
#pragma once

#include <string>
#include <vector>

#include "taut/outline.hpp"

namespace taut::internal::curve {

/// The parts that the rings enclose by the rule; rings with the same on both sides bound nothing and are left out.
/// Throws InputError where rings meet.
std::vector<CurvedPart> nested(const std::vector<Outline>& rings, FillRule rule, const std::string& name);

}  // namespace taut::internal::curve
