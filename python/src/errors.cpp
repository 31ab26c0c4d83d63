#include <pybind11/pybind11.h>

#include <exception>
#include <string>
#include <utility>

#include "bindings.hpp"
#include "taut/error.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

/// Text that names files may be no UTF-8; Python then has it as os.fsdecode() gives it.
py::object text_of(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape"));
}

/// Sets an exception of the package, looked up when it is needed.
template <class... Arguments>
void raise(const char* name, Arguments&&... arguments) {
  const py::object type = py::module_::import("taut2d.errors").attr(name);
  const py::object error = type(std::forward<Arguments>(arguments)...);
  PyErr_SetObject(type.ptr(), error.ptr());
}

void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const taut::InputError& error) {
    raise("InputError", text_of(error.place()), text_of(error.problem()), text_of(error.hint()));
  } catch (const taut::InternalError& error) {
    raise("InternalError", text_of(error.what()));
  } catch (const taut::UndecidedError& error) {
    raise("UndecidedError", text_of(error.what()));
  } catch (const taut::Error& error) {
    raise("TautError", text_of(error.what()));
  }
}

}  // namespace

void bind_errors() { py::register_exception_translator(translate); }

}  // namespace taut_python
