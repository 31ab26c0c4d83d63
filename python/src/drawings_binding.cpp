// Drawings as scenes, with a report.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "attended.hpp"
#include "bindings.hpp"
#include "import/import.hpp"
#include "taut/io.hpp"

namespace taut_python {
namespace {

using taut::drawing::Crossing;
using taut::drawing::Grouping;
using taut::drawing::ImportSettings;
using taut::drawing::OpenRings;
/// The scene, which is empty if there are faults, the report as JSON, and the picture.
using ReadDrawing = std::tuple<std::string, std::string, std::string>;

/// taut2d has looked at the words.
Grouping grouping_of(const std::string& word) {
  return word == "layer"     ? Grouping::layer
         : word == "color"   ? Grouping::color
         : word == "group"   ? Grouping::group
         : word == "nesting" ? Grouping::nesting
                             : Grouping::automatic;
}

ReadDrawing read_drawings(const std::vector<std::string>& files, const ImportSettings& settings) {
  return attended<ReadDrawing>([&](const std::atomic<bool>&) {
    const taut::drawing::Import import = taut::drawing::examine_files(files, settings);
    return ReadDrawing{import.faults.empty() ? taut::write_scene(import.scene) : std::string(),
                       taut::drawing::report_json(import, settings), taut::drawing::report_svg(import)};
  });
}

}  // namespace

void bind_drawings(pybind11::module_& module) {
  namespace py = pybind11;
  py::class_<ImportSettings>(module, "ImportSettings")
      .def(py::init<>())
      .def_readwrite("tolerance", &ImportSettings::tolerance)
      .def_readwrite("join", &ImportSettings::join)
      .def_readwrite("repair", &ImportSettings::repair)
      .def_readwrite("scale", &ImportSettings::scale)
      .def_readwrite("unit", &ImportSettings::unit)
      .def_readwrite("curves", &ImportSettings::curves)
      .def_readwrite("split", &ImportSettings::split)
      .def_readwrite("strict", &ImportSettings::strict)
      .def_readwrite("layers", &ImportSettings::layers)
      .def("give_heights",
           [](ImportSettings& s, const std::string& layer, std::optional<double> lo, std::optional<double> hi) {
             taut::Layers z;
             s.heights.push_back({layer, {lo.value_or(z.lo), hi.value_or(z.hi)}});
           })
      .def_readwrite("merged", &ImportSettings::merged)
      .def_readwrite("merge_all", &ImportSettings::merge_all)
      .def_readwrite("drills", &ImportSettings::drills)
      .def_readwrite("unknown_free", &ImportSettings::unknown_free)
      .def("group_by", [](ImportSettings& s, const std::string& word) { s.by = grouping_of(word); })
      .def("leave_open",
           [](ImportSettings& s, const std::string& word) {
             s.open = word == "close" ? OpenRings::close : word == "skip" ? OpenRings::skip : OpenRings::error;
           })
      .def("cross", [](ImportSettings& s, const std::string& word) {
        s.crossing = word == "subtract" ? Crossing::subtract
                     : word == "union"  ? Crossing::unite
                     : word == "parts"  ? Crossing::parts
                                        : Crossing::error;
      });
  module.def("read_drawings", &read_drawings);
}

}  // namespace taut_python
