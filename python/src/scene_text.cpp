#include "scene_text.hpp"

#include <utility>

#include "io/json_writer.hpp"

namespace taut_python {
namespace {

/// The value that a word stands for, among those given.
template <class Value, std::size_t size>
Value chosen(const char* option, const std::string& word, const std::pair<const char*, Value> (&choices)[size]) {
  std::string all;
  for (const auto& [name, value] : choices) {
    if (word == name) return value;
    all += (all.empty() ? "" : ", ") + taut::internal::io::string_text(name);
  }
  throw taut::InputError(option, "unknown value " + taut::internal::io::string_text(word), "one of " + all);
}

}  // namespace

taut::CheckOptions check_options(const RunOptions& given, const std::atomic<bool>& stop) {
  using taut::EngineChoice;
  taut::CheckOptions options;
  options.touch =
      chosen<taut::Touch>("touch", given.touch, {{"open", taut::Touch::open}, {"closed", taut::Touch::closed}});
  options.engine = chosen<EngineChoice>("engine", given.engine,
                                        {{"kinetic", EngineChoice::kinetic},
                                         {"spacetime", EngineChoice::spacetime},
                                         {"both", EngineChoice::both},
                                         {"either", EngineChoice::either},
                                         {"usual", EngineChoice::usual}});
  options.all_pairs = chosen<bool>("pairs", given.pairs, {{"first", false}, {"all", true}});
  if (given.max_seconds) options.limits.max_seconds = *given.max_seconds;
  if (given.max_events) options.max_events = *given.max_events;
  options.limits.stop = &stop;
  return options;
}

}  // namespace taut_python
