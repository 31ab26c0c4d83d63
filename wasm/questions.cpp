#include "questions.hpp"

#include <initializer_list>
#include <limits>
#include <sstream>

#include "base/budget.hpp"
#include "io/answer_json.hpp"
#include "io/json_numbers.hpp"
#include "io/json_object.hpp"
#include "io/json_text.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"
#include "taut/separate.hpp"

namespace taut::web {
using namespace internal;
namespace {

/// What may be asked with a question.
struct AskOptions {
  CheckOptions check;
  double tolerance = 1e-9, from = 0, clearance = 0, travel = std::numeric_limits<double>::infinity();
  int instants = 101;
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
                              {"touch", "engine", "maxSeconds", "maxEvents", "allPairs", "tolerance", "from",
                               "clearance", "instants", "travel"},
                              R"({"touch": "closed", "maxSeconds": 5})");
  AskOptions options;
  read_choice(document, object, "touch", options.check.touch, {Touch::open, Touch::closed});
  read_choice(
      document, object, "engine", options.check.engine,
      {EngineChoice::kinetic, EngineChoice::spacetime, EngineChoice::both, EngineChoice::either, EngineChoice::usual});
  const auto number = [&](const char* key, double otherwise) {
    const auto token = object.find(key);
    return token ? io::read_number(document, *token, key) : otherwise;
  };
  options.check.max_seconds = number("maxSeconds", 1e300);
  const double events = number("maxEvents", 1e300);
  if (events < 1e18) options.check.max_events = events > 0 ? static_cast<std::uint64_t>(events) : 0;
  options.tolerance = number("tolerance", 1e-9);
  options.from = number("from", 0);
  options.clearance = number("clearance", 0);
  options.travel = number("travel", options.travel);
  const double instants = number("instants", 101);
  if (!(instants >= 2 && instants <= 1000000))
    throw InputError("instants", "there are too few or too many", "give 2 to 1000000");
  options.instants = static_cast<int>(instants);
  if (const auto token = object.find("allPairs")) {
    document.require(*token, io::JsonKind::boolean, "allPairs", "true or false");
    options.check.all_pairs = io::value_text(document, *token) == "true";
  }
  return options;
}

std::string proved(const Scene& scene, const CheckOptions& options, std::string& made_log) {
  std::ostringstream log;
  const Answer answer = prove(scene, log, options);
  const bool proof = answer.outcome == Outcome::free || answer.contact || answer.free_until > scene.start;
  made_log = proof ? log.str() : std::string();
  return answer_json(scene, answer, options.touch);
}

std::string verified(const Scene& scene, const std::string& log, const CheckOptions& options) {
  try {
    const Budget scope(nullptr, options.max_seconds);
    std::istringstream stream(log);
    return verified_json(scene, verify(scene, stream));
  } catch (const ProofError& error) {
    return unverified_json(true, error.what());
  } catch (const Interrupted& limit) {
    return unverified_json(false, limit.reason);
  }
}

std::string clearance_of(const Scene& scene, const AskOptions& options) {
  ClearanceOptions how;
  how.relative = options.tolerance;
  how.all_pairs = options.check.all_pairs;
  how.max_seconds = options.check.max_seconds;
  return clearance_json(scene, clearance(scene, how));
}

std::string profile_of(const Scene& scene, const AskOptions& options) {
  ProfileOptions how;
  how.instants = options.instants;
  how.relative = options.tolerance;
  how.all_pairs = options.check.all_pairs;
  how.max_seconds = options.check.max_seconds;
  return profile_json(scene, distance_profile(scene, how));
}

std::string separation_of(const Scene& scene, const AskOptions& options) {
  SeparateOptions how;
  how.travel = options.travel;
  how.max_seconds = options.check.max_seconds;
  return separation_json(scene, separate(scene, how));
}

}  // namespace

std::string answer_to(const Question& question, const Scene& scene, std::string& proof) {
  const AskOptions how = read_options(question.options);
  const CheckOptions& options = how.check;
  const std::string& name = question.name;
  if (name == "check") return answer_json(scene, check(scene, options), options.touch);
  if (name == "prove") return proved(scene, options, proof);
  if (name == "verify") return verified(scene, question.log, options);
  if (name == "intervals") return intervals_json(scene, intervals(scene, options), options.touch);
  if (name == "range") return range_json(scene, how.from, range(scene, how.from, options), options.touch);
  if (name == "check_clearance")
    return margin_json(scene, how.clearance, check_clearance(scene, how.clearance, options), options.touch);
  if (name == "clearance") return clearance_of(scene, how);
  if (name == "distance_profile") return profile_of(scene, how);
  if (name == "separate") return separation_of(scene, how);
  throw InputError("question", "there is no question " + io::string_text(name), "ask check, or another one");
}

}  // namespace taut::web
