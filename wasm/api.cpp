// What the npm package calls: a question about a scene, as JSON text in and out, and proof logs as bytes. No exception
// passes: errors are JSON, too.
#include <emscripten.h>

#include <memory>
#include <sstream>
#include <string>

#include "base/interruption.hpp"
#include "io/answer_json.hpp"
#include "io/json_numbers.hpp"
#include "io/json_object.hpp"
#include "io/json_text.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut::web {
namespace {

std::string api_result, proof_log;

/// What may be asked with a question.
struct AskOptions {
  CheckOptions check;
  double tolerance = 1e-9, from = 0;
};

/// The word of an option, one of some.
template <class Choice>
void read_choice(const io::JsonDocument& document, const io::JsonObject& object, const char* key, Choice& choice,
                 std::initializer_list<Choice> all) {
  const auto token = object.find(key);
  if (!token) return;
  std::string words;
  for (const Choice c : all) words += (words.empty() ? "\"" : ", \"") + std::string(to_string(c)) + "\"";
  document.require(*token, io::JsonKind::string, key, "one of " + words);
  for (const Choice c : all) {
    if (document.string_at(*token) != to_string(c)) continue;
    choice = c;
    return;
  }
  throw document.error(*token, key, "an unknown word", "write one of " + words);
}

AskOptions read_options(const std::string& text) {
  const io::JsonDocument document = io::parse_json(text, "options", "{}");
  const io::JsonObject object(document, 0, "",
                              {"touch", "engine", "maxSeconds", "maxEvents", "allPairs", "tolerance", "from"},
                              R"({"touch": "closed", "maxSeconds": 5})");
  AskOptions options;
  read_choice(document, object, "touch", options.check.touch, {Touch::open, Touch::closed});
  read_choice(document, object, "engine", options.check.engine,
              {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::both, EngineChoice::either});
  const auto number = [&](const char* key, double otherwise) {
    const auto token = object.find(key);
    return token ? io::read_number(document, *token, key) : otherwise;
  };
  options.check.max_seconds = number("maxSeconds", 1e300);
  const double events = number("maxEvents", 1e300);
  if (events < 1e18) options.check.max_events = events > 0 ? static_cast<std::uint64_t>(events) : 0;
  options.tolerance = number("tolerance", 1e-9);
  options.from = number("from", 0);
  if (const auto token = object.find("allPairs")) {
    document.require(*token, io::JsonKind::boolean, "allPairs", "true or false");
    options.check.all_pairs = io::value_text(document, *token) == "true";
  }
  return options;
}

std::string proved(const Scene& scene, const CheckOptions& options) {
  std::ostringstream log;
  const Answer answer = prove(scene, log, options);
  const bool proof = answer.outcome == Outcome::free || answer.contact || answer.free_until > scene.start;
  proof_log = proof ? log.str() : std::string();
  return answer_json(scene, answer, options.touch);
}

std::string verified(const Scene& scene, const std::string& log, const CheckOptions& options) {
  try {
    const InterruptionScope scope(nullptr, options.max_seconds);
    std::istringstream stream(log);
    const Verified v = verify(scene, stream);
    std::string s = std::string("{\"valid\":true,\"outcome\":\"") + to_string(v.outcome) +
                    "\",\"free_until\":" + io::number_text(v.free_until);
    if (v.contact) s += io::contact_json(scene, *v.contact);
    return s + ",\"touch\":\"" + to_string(v.touch) + "\",\"scene_sha256\":\"" + to_hex(v.fingerprint) + "\"}";
  } catch (const ProofError& error) {
    return "{\"valid\":false,\"reason\":" + io::string_text(error.what()) + "}";
  } catch (const Interrupted& limit) {
    return "{\"valid\":null,\"reason\":" + io::string_text(limit.reason) + "}";
  }
}

std::string answer_to(const std::string& question, const Scene& scene, const AskOptions& options,
                      const std::string& log) {
  if (question == "check") return answer_json(scene, check(scene, options.check), options.check.touch);
  if (question == "prove") return proved(scene, options.check);
  if (question == "verify") return verified(scene, log, options.check);
  if (question == "intervals") return intervals_json(scene, intervals(scene, options.check), options.check.touch);
  if (question == "range")
    return range_json(scene, options.from, range(scene, options.from, options.check), options.check.touch);
  ClearanceOptions how;
  how.relative = options.tolerance;
  how.all_pairs = options.check.all_pairs;
  how.max_seconds = options.check.max_seconds;
  return clearance_json(scene, clearance(scene, how));
}

std::string failure(const char* kind, const std::string& place, const std::string& problem, const std::string& hint) {
  return std::string("{\"error\":{\"kind\":\"") + kind + "\",\"place\":" + io::string_text(place) +
         ",\"problem\":" + io::string_text(problem) + ",\"hint\":" + io::string_text(hint) + "}}";
}

}  // namespace
}  // namespace taut::web

using namespace taut;
using namespace taut::web;

extern "C" {

/// The answer to "check", "prove", "verify", "clearance", "intervals" or "range" as JSON, valid until the next call.
EMSCRIPTEN_KEEPALIVE const char* taut_ask(const char* question, const char* scene, const char* options, const char* log,
                                          int log_size) {
  proof_log.clear();
  try {
    const AskOptions how = read_options(options);
    api_result = answer_to(question, parse_scene(scene), how, std::string(log, static_cast<std::size_t>(log_size)));
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

/// The log of the last question, if it was "prove".
EMSCRIPTEN_KEEPALIVE const char* taut_log() { return proof_log.data(); }
EMSCRIPTEN_KEEPALIVE int taut_log_size() { return static_cast<int>(proof_log.size()); }

}  // extern "C"
