// What the npm package calls: a question about a scene, as JSON text in and out, and proof logs as bytes. No exception
// passes: errors are JSON, too.
#include <emscripten.h>

#include <string>

#include "io/json_text.hpp"
#include "numeric/budget.hpp"
#include "taut/ask.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::web {
using namespace internal;
namespace {

std::string api_result, proof_log;

std::string failure(const char* kind, const std::string& place, const std::string& problem, const std::string& hint) {
  return std::string("{\"error\":{\"kind\":\"") + kind + "\",\"place\":" + io::string_text(place) +
         ",\"problem\":" + io::string_text(problem) + ",\"hint\":" + io::string_text(hint) + "}}";
}

}  // namespace
}  // namespace taut::web

using namespace taut;
using namespace taut::web;

extern "C" {

/// The answer to a question as JSON, valid until the next call.
EMSCRIPTEN_KEEPALIVE const char* taut_ask(const char* question, const char* scene, const char* options, const char* log,
                                          int log_size) {
  proof_log.clear();
  try {
    const Question asked{question, options, std::string(log, static_cast<std::size_t>(log_size))};
    Reply reply = ask_about_text(asked, scene);
    api_result = std::move(reply.json);
    proof_log = std::move(reply.log);
  } catch (const InputError& e) {
    api_result = failure("input", e.place(), e.problem(), e.hint());
  } catch (const UndecidedError& e) {
    api_result = failure("undecided", "", e.what(), "");
  } catch (const Interrupted& e) {
    api_result = failure("undecided", "", e.reason, "");
  } catch (const std::exception& e) {
    api_result = failure("internal", "", e.what(), "this is a defect of taut: please report it, with the scene");
  }
  return api_result.c_str();
}

/// question_descriptions(), valid until the next call: the package's functions and types are made from it.
EMSCRIPTEN_KEEPALIVE const char* taut_questions() {
  api_result = question_descriptions();
  return api_result.c_str();
}

/// The log of the last question, if that writes one.
EMSCRIPTEN_KEEPALIVE const char* taut_log() { return proof_log.data(); }
EMSCRIPTEN_KEEPALIVE int taut_log_size() { return static_cast<int>(proof_log.size()); }

}  // extern "C"
