// check_many: arrays of Python's in, rows of answers into an array of Python's.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "buffers.hpp"
#include "check_rows.hpp"
#include "numeric/budget.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

/// A template and its columns, for Python to fill in.
class Template {
 public:
  Template(const SceneText& text, std::size_t rows) : rows_(rows) {
    taut::Scene scene = attended<taut::Scene>([&](const std::atomic<bool>& stop) {
      const taut::internal::Budget scope(taut::Limits{.stop = &stop});
      taut::Scene read = text.read();
      prepare_bodies(read);
      return read;
    });
    table_ = std::make_unique<TemplateRows>(std::move(scene), rows);
  }
  void keyframes(std::size_t body, const py::buffer& values, std::size_t count, std::size_t columns,
                 const py::object& pivots) {
    const double* found = buffers_.doubles(values, rows_ * count * columns);
    table_->motions.emplace_back(KeyframeColumn{body, found, count, columns, buffers_.pivots(pivots, rows_)});
  }
  void velocities(std::size_t body, const py::buffer& values, const py::object& pivots) {
    const double* found = buffers_.doubles(values, rows_ * 3);
    table_->motions.emplace_back(VelocityColumn{body, found, buffers_.pivots(pivots, rows_)});
  }
  void shapes(std::size_t body, const std::vector<std::shared_ptr<Shape>>& shapes) {
    table_->shapes.push_back({body, {shapes.begin(), shapes.end()}});
  }
  void times(const py::buffer& values) { table_->times = buffers_.doubles(values, rows_ * 2); }
  const RowScenes& rows() const { return *table_; }

 private:
  std::size_t rows_;
  Buffers buffers_;
  std::unique_ptr<TemplateRows> table_;
};

void check_all(const RowScenes& rows, const RunOptions& options, std::size_t threads, const py::buffer& into) {
  Buffers buffers;
  AnswerRow* answers = buffers.answers(into, rows.size());
  attended<bool>([&](const std::atomic<bool>& stop) {
    check_rows(rows, check_options(options, stop), threads, answers);
    return true;
  });
}

}  // namespace

void bind_many(py::module_& module) {
  py::class_<Template>(module, "Template")
      .def(py::init<const SceneText&, std::size_t>())
      .def("keyframes", &Template::keyframes)
      .def("velocities", &Template::velocities)
      .def("shapes", &Template::shapes)
      .def("times", &Template::times);
  module.def("check_rows", [](const Template& rows, const RunOptions& options, std::size_t threads,
                              const py::buffer& into) { check_all(rows.rows(), options, threads, into); });
  module.def("check_texts", [](const std::vector<SceneText>& texts, const RunOptions& options, std::size_t threads,
                               const py::buffer& into) { check_all(TextRows(texts), options, threads, into); });
}

}  // namespace taut_python
