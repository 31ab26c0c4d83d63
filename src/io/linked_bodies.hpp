// Bodies that follow joints, for pages that draw them at any values of these.
#pragma once

#include <string>

#include "taut/envelope.hpp"

namespace taut::internal::io {

/// An array, an object for each body: its "name"; "parts", of each its outline and holes; the place of its "parent"
/// among the bodies; "motion", the outermost first: by "times" degrees for each unit of the "joint" of that number, and
/// "plus" degrees, about the "pivot"; or so far along the "direction". Of links of a mechanism there are "values"
/// instead of "times" and "plus", evenly over the joint's range, for pictures. Parents and motions are left out where
/// there are none.
std::string linked_bodies_json(const Linkage& linkage);

}  // namespace taut::internal::io
