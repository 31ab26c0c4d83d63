// Questions over JSON text: the classes that people see are written in Python.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>

#include "attended.hpp"
#include "base/budget.hpp"
#include "bindings.hpp"
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "scene_text.hpp"
#include "taut/taut.hpp"

namespace py = pybind11;

namespace taut_python {
namespace {

std::string check(const SceneText& text, const RunOptions& options) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions how = check_options(options, stop);
    const taut::Scene scene = text.read();
    return taut::answer_json(scene, taut::check(scene, how), how.touch);
  });
}

/// The answer, the log, and the name of what was proved.
struct Proved {
  std::string json, log, scene_sha256;
};

py::tuple prove(const SceneText& text, const RunOptions& options) {
  const Proved proved = attended<Proved>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions how = check_options(options, stop);
    const taut::Scene scene = text.read();
    std::ostringstream log;
    const taut::Answer answer = taut::prove(scene, log, how);
    // There is nothing to prove about bodies that overlap from the start, or where nothing was decided.
    const bool proof = answer.outcome == taut::Outcome::free || answer.contact || answer.free_until > scene.start;
    return Proved{taut::answer_json(scene, answer, how.touch), proof ? log.str() : std::string(),
                  taut::to_hex(taut::scene_fingerprint(scene, how.touch))};
  });
  return py::make_tuple(proved.json, py::bytes(proved.log), proved.scene_sha256);
}

py::tuple prove_clearance(const SceneText& text, double clearance, const RunOptions& options) {
  const Proved proved = attended<Proved>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions how = check_options(options, stop);
    const taut::Scene scene = text.read();
    std::ostringstream log;
    const taut::MarginAnswer answer = taut::prove_clearance(scene, clearance, log, how);
    return Proved{taut::margin_json(scene, clearance, answer, how.touch), log.str(),
                  taut::to_hex(taut::scene_fingerprint(scene, how.touch))};
  });
  return py::make_tuple(proved.json, py::bytes(proved.log), proved.scene_sha256);
}

std::string verify(const SceneText& text, const std::string& log, std::optional<double> max_seconds) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::Scene scene = text.read();
    try {
      const taut::internal::Budget scope(&stop, max_seconds ? *max_seconds : 1e300);
      std::istringstream stream(log);
      return taut::verified_json(scene, taut::verify(scene, stream));
    } catch (const taut::ProofError& error) {
      return taut::unverified_json(true, error.what());
    } catch (const taut::internal::Interrupted& limit) {
      return taut::unverified_json(false, limit.reason);
    }
  });
}

std::string intervals(const SceneText& text, const RunOptions& options) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions how = check_options(options, stop);
    const taut::Scene scene = text.read();
    return taut::intervals_json(scene, taut::intervals(scene, how), how.touch);
  });
}

std::string free_range(const SceneText& text, double from, const RunOptions& options) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions how = check_options(options, stop);
    const taut::Scene scene = text.read();
    return taut::range_json(scene, from, taut::range(scene, from, how), how.touch);
  });
}

std::string clearance(const SceneText& text, double tolerance, const RunOptions& options) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions given = check_options(options, stop);
    taut::ClearanceOptions how;
    how.relative = tolerance;
    how.all_pairs = given.all_pairs;
    how.max_seconds = given.max_seconds;
    how.stop = &stop;
    const taut::Scene scene = text.read();
    return taut::clearance_json(scene, taut::clearance(scene, how));
  });
}

std::string distance_profile(const SceneText& text, int instants, double tolerance, const RunOptions& options) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions given = check_options(options, stop);
    taut::ProfileOptions how;
    how.instants = instants;
    how.relative = tolerance;
    how.all_pairs = given.all_pairs;
    how.max_seconds = given.max_seconds;
    how.stop = &stop;
    const taut::Scene scene = text.read();
    return taut::profile_json(scene, taut::distance_profile(scene, how));
  });
}

std::string check_clearance(const SceneText& text, double clearance, const RunOptions& options) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::CheckOptions how = check_options(options, stop);
    const taut::Scene scene = text.read();
    return taut::margin_json(scene, clearance, taut::check_clearance(scene, clearance, how), how.touch);
  });
}

std::string separate(const SceneText& text, std::optional<double> travel, const RunOptions& options) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    taut::SeparateOptions how;
    how.travel = travel.value_or(how.travel);
    how.max_seconds = check_options(options, stop).max_seconds;
    how.stop = &stop;
    const taut::Scene scene = text.read();
    return taut::separation_json(scene, taut::separate(scene, how));
  });
}

std::string envelope(const SceneText& text, double tolerance, bool cells, const RunOptions& options) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    taut::EnvelopeOptions how;
    how.tolerance = tolerance;
    how.max_seconds = check_options(options, stop).max_seconds;
    how.stop = &stop;
    const taut::Linkage linkage = text.read_linkage();
    return taut::envelope_json(linkage, taut::envelope(linkage, how), tolerance, cells);
  });
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

}  // namespace

void bind_questions(py::module_& module) {
  py::class_<SceneText>(module, "SceneText").def(py::init<std::string, std::string, std::string>());
  py::class_<RunOptions>(module, "RunOptions")
      .def(py::init<std::string, std::string, std::string, std::optional<double>, std::optional<std::uint64_t>, double,
                    double>());
  module.def("check", &check);
  module.def("intervals", &intervals);
  module.def("range", &free_range);
  module.def("clearance", &clearance);
  module.def("check_clearance", &check_clearance);
  module.def("separate", &separate);
  module.def("envelope", &envelope);
  module.def("read_linkage", &read_linkage_form);
  module.def("distance_profile", &distance_profile);
  module.def("prove", &prove);
  module.def("prove_clearance", &prove_clearance);
  module.def("verify", [](const SceneText& text, const py::bytes& log, std::optional<double> max_seconds) {
    return verify(text, log, max_seconds);
  });
  module.def("validate", &validate);
  module.def("read", &read_form);
}

}  // namespace taut_python
