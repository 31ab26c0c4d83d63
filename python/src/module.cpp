// What the Python package asks of the library.
//
// Work is done without the interpreter's lock, by the calling thread, which looks for signals at its checkpoints:
// Ctrl-C then ends a check within moments, and other threads of Python go on meanwhile.
#include "bindings.hpp"

PYBIND11_MODULE(_taut2d, module) {
  module.doc() = "The compiled part of taut2d. Use the functions of taut2d instead.";
  taut_python::bind_errors();
  taut_python::bind_questions(module);
  taut_python::bind_shapes(module);
  taut_python::bind_many(module);
  taut_python::bind_maps(module);
  taut_python::bind_simulations(module);
  taut_python::bind_drawings(module);
  taut_python::bind_flatten(module);
  taut_python::bind_pictures(module);
  module.def("version", [] { return TAUT_VERSION; });
}
