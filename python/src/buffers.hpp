// Arrays of Python's, as the library reads and writes them.
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "answer_row.hpp"
#include "row_scenes.hpp"

namespace taut_python {

/// Buffers that are held while rows point into them. They hold the interpreter's objects: made and let go with its
/// lock.
class Buffers {
 public:
  /// Doubles without gaps, as many as there are said to be; the callers in Python see to that.
  double* doubles(const pybind11::buffer& buffer, std::size_t count, bool writable = false) {
    held_.push_back(buffer.request(writable));
    const pybind11::buffer_info& info = held_.back();
    if (info.format != pybind11::format_descriptor<double>::format() || static_cast<std::size_t>(info.size) != count)
      throw pybind11::value_error("the buffer is not as it must be");
    return static_cast<double*>(info.ptr);
  }
  AnswerRow* answers(const pybind11::buffer& buffer, std::size_t count) {
    held_.push_back(buffer.request(true));
    const pybind11::buffer_info& info = held_.back();
    if (static_cast<std::size_t>(info.itemsize) != sizeof(AnswerRow) || static_cast<std::size_t>(info.size) != count)
      throw pybind11::value_error("the buffer of answers is not as it must be");
    return static_cast<AnswerRow*>(info.ptr);
  }
  PivotColumn pivots(const pybind11::object& given, std::size_t rows) {
    if (given.is_none()) return {};
    const auto buffer = given.cast<pybind11::buffer>();
    const bool one_each = buffer.request().ndim == 2;
    return {doubles(buffer, one_each ? 2 * rows : 2), one_each};
  }

 private:
  std::vector<pybind11::buffer_info> held_;
};

}  // namespace taut_python
