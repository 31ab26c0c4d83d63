// Bodies that follow joints, for pages that draw them at any values of these.
#pragma once

#include <string>

#include "taut/envelope.hpp"

namespace taut::internal::io {

/// An array, an object for each body: its "name"; "parts", of each its outline and holes; the place of its "parent"
/// among the bodies; "motion", the outermost first: by "times" degrees for each unit of the "joint" of that number, and
/// "plus" degrees, about the "pivot"; or so far along the "direction". The last two are left out where there is none.
std::string linked_bodies_json(const Linkage& linkage);

}  // namespace taut::internal::io
