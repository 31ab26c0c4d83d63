// What the Python package asks of the library, over JSON text: the classes that people see are written in Python.
//
// Work is done on a thread of its own, without the interpreter's lock, while the calling thread looks for signals:
// Ctrl-C then ends a check within moments, and other threads of Python go on meanwhile.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>

#include "base/interruption.hpp"
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "taut/taut.hpp"

namespace py = pybind11;

namespace {

/// How often the calling thread looks for signals while work is done.
constexpr std::chrono::milliseconds signal_period{20};

/// A scene as Python hands it over.
struct SceneText {
  std::string json;
  /// Stands for the text in messages.
  std::string name;
  /// Where files that it names are looked up.
  std::string folder;

  taut::Scene read() const { return taut::parse_scene(json, name, folder); }
};

struct RunOptions {
  std::string touch, engine, pairs;
  std::optional<double> max_seconds;
  std::optional<std::uint64_t> max_events;
};

/// The value that a word stands for, among those given.
template <class Value, std::size_t size>
Value chosen(const char* option, const std::string& word, const std::pair<const char*, Value> (&choices)[size]) {
  std::string all;
  for (const auto& [name, value] : choices) {
    if (word == name) return value;
    all += (all.empty() ? "" : ", ") + taut::io::string_text(name);
  }
  throw taut::InputError(option, "unknown value " + taut::io::string_text(word), "one of " + all);
}

taut::CheckOptions check_options(const RunOptions& given, const std::atomic<bool>& stop) {
  using taut::EngineChoice;
  taut::CheckOptions options;
  options.touch =
      chosen<taut::Touch>("touch", given.touch, {{"open", taut::Touch::open}, {"closed", taut::Touch::closed}});
  options.engine = chosen<EngineChoice>("engine", given.engine,
                                        {{"kinetic", EngineChoice::kinetic},
                                         {"spacetime", EngineChoice::spacetime},
                                         {"both", EngineChoice::both},
                                         {"either", EngineChoice::either}});
  options.all_pairs = chosen<bool>("pairs", given.pairs, {{"first", false}, {"all", true}});
  if (given.max_seconds) options.max_seconds = *given.max_seconds;
  if (given.max_events) options.max_events = *given.max_events;
  options.stop = &stop;
  return options;
}

/// Runs `work` on a thread of its own, and hands over what it returns or throws. Called with the interpreter's lock,
/// which is free meanwhile. Where a handler of signals raises an exception, the work is told to stop, and the exception
/// goes on as soon as it has.
template <class Result>
Result attended(const std::function<Result(const std::atomic<bool>&)>& work) {
  std::atomic<bool> stop{false};
  std::mutex mutex;
  std::condition_variable finished;
  bool done = false;
  std::optional<Result> result;
  std::exception_ptr error;
  std::thread worker([&] {
    try {
      result.emplace(work(stop));
    } catch (...) {
      error = std::current_exception();
    }
    // Told under the lock: once it is free, the calling thread may be gone from here, and what is told with it.
    const std::lock_guard lock(mutex);
    done = true;
    finished.notify_one();
  });
  bool raised = false;
  {
    py::gil_scoped_release released;
    std::unique_lock lock(mutex);
    while (!finished.wait_for(lock, signal_period, [&] { return done; })) {
      lock.unlock();
      {
        py::gil_scoped_acquire acquired;
        raised = PyErr_CheckSignals() != 0;
      }
      lock.lock();
      if (raised) break;
    }
    lock.unlock();
    if (raised) stop = true;
    worker.join();
  }
  if (raised) throw py::error_already_set();
  if (error) std::rethrow_exception(error);
  return std::move(*result);
}

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

const char* name_of(taut::ContactAt at) {
  return at == taut::ContactAt::start ? "start" : at == taut::ContactAt::joint ? "joint" : "motion";
}

std::string verified_json(const taut::Scene& scene, const taut::Verified& v) {
  std::string s = std::string("{\"valid\":true,\"outcome\":\"") + to_string(v.outcome) +
                  "\",\"free_until\":" + taut::io::number_text(v.free_until);
  if (v.contact) s += taut::io::contact_json(scene, *v.contact) + ",\"contact_at\":\"" + name_of(v.contact_at) + "\"";
  return s + ",\"touch\":\"" + to_string(v.touch) + "\",\"events\":" + std::to_string(v.events) +
         ",\"scene_sha256\":\"" + taut::to_hex(v.fingerprint) + "\"}";
}

std::string verify(const SceneText& text, const std::string& log, std::optional<double> max_seconds) {
  return attended<std::string>([&](const std::atomic<bool>& stop) {
    const taut::Scene scene = text.read();
    try {
      const taut::InterruptionScope scope(&stop, max_seconds ? *max_seconds : 1e300);
      std::istringstream stream(log);
      return verified_json(scene, taut::verify(scene, stream));
    } catch (const taut::ProofError& error) {
      return "{\"valid\":false,\"reason\":" + taut::io::string_text(error.what()) + "}";
    } catch (const taut::Interrupted& limit) {
      return "{\"valid\":null,\"reason\":" + taut::io::string_text(limit.reason) + "}";
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
  } catch (const taut::Error& error) {
    raise("TautError", text_of(error.what()));
  }
}

}  // namespace

PYBIND11_MODULE(_taut2d, module) {
  module.doc() = "The compiled part of taut2d. Use the functions of taut2d instead.";
  py::register_exception_translator(translate);
  py::class_<SceneText>(module, "SceneText").def(py::init<std::string, std::string, std::string>());
  py::class_<RunOptions>(module, "RunOptions")
      .def(py::init<std::string, std::string, std::string, std::optional<double>, std::optional<std::uint64_t>>());
  module.def("check", &check);
  module.def("intervals", &intervals);
  module.def("range", &free_range);
  module.def("clearance", &clearance);
  module.def("prove", &prove);
  module.def("verify", [](const SceneText& text, const py::bytes& log, std::optional<double> max_seconds) {
    return verify(text, log, max_seconds);
  });
  module.def("validate", &validate);
  module.def("read", &read_form);
  module.def("version", [] { return TAUT_VERSION; });
}
