// Rings as bytes, which Python looks at as doubles.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "taut/geometry.hpp"

namespace taut_python {

/// For each part a list of its rings, the outline first; each has x and y in turn.
pybind11::list rings_of(const std::vector<taut::Part>& parts);

}  // namespace taut_python
