// Shapes from what Python has: buffers, which are read without making objects of their numbers, and sequences.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "numeric/budget.hpp"
#include "rings.hpp"
#include "shape.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

taut::Polygon ring_of_buffer(const py::buffer& buffer, const std::string& place) {
  const py::buffer_info info = buffer.request();
  if (info.format != py::format_descriptor<double>::format() || info.ndim != 2 || info.shape[1] != 2)
    throw taut::InputError(place, "this is no array of points", "give doubles in two columns, x and y");
  taut::Polygon ring(static_cast<std::size_t>(info.shape[0]));
  const char* row = static_cast<const char*>(info.ptr);
  for (taut::Point& p : ring) {
    p = {*reinterpret_cast<const double*>(row), *reinterpret_cast<const double*>(row + info.strides[1])};
    row += info.strides[0];
  }
  return ring;
}

taut::Polygon ring_of(const py::handle& value, const std::string& place) {
  if (PyObject_CheckBuffer(value.ptr()) != 0) return ring_of_buffer(py::reinterpret_borrow<py::buffer>(value), place);
  taut::Polygon ring;
  for (const auto& [x, y] : value.cast<std::vector<std::pair<double, double>>>()) ring.push_back({x, y});
  return ring;
}

/// Each part is a pair of its outline and a list of holes.
Shape shape_of(const py::sequence& given, const std::string& name) {
  std::vector<taut::Part> parts;
  for (const py::handle& item : given) {
    const auto part = item.cast<py::sequence>();
    parts.push_back({ring_of(part[0], name), {}});
    for (const py::handle& hole : part[1].cast<py::sequence>()) parts.back().holes.push_back(ring_of(hole, name));
  }
  return attended<Shape>([&](const std::atomic<bool>& stop) {
    const taut::internal::Budget scope(taut::Limits{.stop = &stop});
    return make_shape(parts, name);
  });
}

/// The numbers of a ring, x and y in turn, to be looked at as doubles.
py::bytes bytes_of(const taut::Polygon& ring) {
  static_assert(sizeof(taut::Point) == 2 * sizeof(double));
  return py::bytes(reinterpret_cast<const char*>(ring.data()), ring.size() * sizeof(taut::Point));
}

}  // namespace

py::list rings_of(const std::vector<taut::Part>& parts) {
  py::list found;
  for (const taut::Part& part : parts) {
    py::list rings;
    rings.append(bytes_of(part.outline));
    for (const taut::Polygon& hole : part.holes) rings.append(bytes_of(hole));
    found.append(rings);
  }
  return found;
}

void bind_shapes(py::module_& module) {
  py::class_<Shape, std::shared_ptr<Shape>>(module, "Shape")
      .def(py::init([](const py::sequence& parts, const std::string& name) {
        return std::make_shared<Shape>(shape_of(parts, name));
      }))
      .def("rings", [](const Shape& shape) { return rings_of(shape.parts); });
}

}  // namespace taut_python
