// Questions over JSON text: the classes that people see are written in Python.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "scene_text.hpp"
#include "shape.hpp"
#include "taut/ask.hpp"
#include "taut/validate.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

/// The answer as JSON, and of a proof its log and the name of its scene.
py::tuple reply_to(taut::Question question, const std::function<taut::Reply(const taut::Question&)>& ask) {
  const taut::Reply reply = attended<taut::Reply>([&](const std::atomic<bool>& stop) {
    question.stop = &stop;
    return ask(question);
  });
  return py::make_tuple(reply.json, py::bytes(reply.log), reply.scene_sha256);
}

py::tuple ask(const SceneText& text, const std::string& question, const std::string& options, const py::bytes& log) {
  return reply_to({question, options, log}, [&](const taut::Question& asked) {
    return taut::ask_about_text(asked, text.json, text.name, text.folder);
  });
}

/// A scene that is asked about more than once: read, and its shapes prepared, once.
struct ReadScene {
  taut::Scene scene;
};

/// Bodies that have shapes here have placeholders for them in the text.
ReadScene read_scene(const SceneText& text, const std::vector<std::shared_ptr<Shape>>& shapes) {
  return attended<ReadScene>([&](const std::atomic<bool>&) {
    ReadScene read{text.read()};
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (shapes[i]) shapes[i]->put_into(read.scene.bodies.at(i));
    }
    return read;
  });
}

py::tuple ask_again(const ReadScene& read, const std::string& question, const std::string& options,
                    const py::bytes& log) {
  return reply_to({question, options, log}, [&](const taut::Question& asked) { return taut::ask(asked, read.scene); });
}

void validate(const SceneText& text) {
  attended<bool>([&](const std::atomic<bool>&) {
    taut::validate(text.read());
    return true;
  });
}

/// Whether it is a scene by its form; what the shapes and the motions are is looked at later.
void read_form(const SceneText& text) {
  attended<bool>([&](const std::atomic<bool>&) {
    text.read();
    return true;
  });
}

void read_linkage_form(const SceneText& text) {
  attended<bool>([&](const std::atomic<bool>&) {
    text.read_linkage();
    return true;
  });
}

void read_problem_form(const SceneText& text) {
  attended<bool>([&](const std::atomic<bool>&) {
    taut::parse_path_problem(text.json, text.name, text.folder);
    return true;
  });
}

/// The scene in which bodies go along waypoints, as JSON.
std::string path_scene(const SceneText& text, const std::vector<std::vector<double>>& waypoints) {
  return attended<std::string>([&](const std::atomic<bool>&) {
    std::vector<taut::JointValues> way;
    for (const std::vector<double>& values : waypoints) {
      way.emplace_back();
      std::copy_n(values.begin(), std::min(values.size(), way.back().size()), way.back().begin());
    }
    return taut::write_scene(taut::path_scene(taut::parse_path_problem(text.json, text.name, text.folder), way));
  });
}

}  // namespace

void bind_questions(py::module_& module) {
  py::class_<SceneText>(module, "SceneText").def(py::init<std::string, std::string, std::string>());
  py::class_<RunOptions>(module, "RunOptions")
      .def(py::init<std::string, std::string, std::string, std::optional<double>, std::optional<std::uint64_t>>());
  py::class_<ReadScene>(module, "ReadScene").def(py::init(&read_scene));
  module.def("ask", &ask);
  module.def("ask", &ask_again);
  module.def("questions", &taut::question_descriptions);
  module.def("read_linkage", &read_linkage_form);
  module.def("path_scene", &path_scene);
  module.def("read_problem", &read_problem_form);
  module.def("validate", &validate);
  module.def("read", &read_form);
}

}  // namespace taut_python
