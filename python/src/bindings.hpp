// The parts of the module, each of which adds its classes and functions.
#pragma once

#include <pybind11/pybind11.h>

namespace taut_python {

void bind_questions(pybind11::module_& module);
void bind_shapes(pybind11::module_& module);
void bind_many(pybind11::module_& module);
void bind_maps(pybind11::module_& module);
void bind_simulations(pybind11::module_& module);
void bind_drawings(pybind11::module_& module);
void bind_flatten(pybind11::module_& module);
void bind_pictures(pybind11::module_& module);
/// taut's exceptions as those of taut2d.errors.
void bind_errors();

}  // namespace taut_python
