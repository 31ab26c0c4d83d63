#include "replies.hpp"

#include <utility>

#include "io/json_writer.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::web {
using namespace internal;
namespace {

std::string error_json(const char* kind, const std::string& place, const std::string& problem,
                       const std::string& hint) {
  return std::string("{\"error\":{\"kind\":\"") + kind + "\",\"place\":" + io::string_text(place) +
         ",\"problem\":" + io::string_text(problem) + ",\"hint\":" + io::string_text(hint) + "}}";
}

}  // namespace

std::string present_error() {
  try {
    throw;
  } catch (const InputError& e) {
    return error_json("input", e.place(), e.problem(), e.hint());
  } catch (const UndecidedError& e) {
    return error_json("undecided", "", e.what(), "");
  } catch (const Interrupted& e) {
    return error_json("undecided", "", e.reason, "");
  } catch (const std::exception& e) {
    return error_json("internal", "", e.what(), "this is a defect of taut: please report it, with the scene");
  }
}

const char* kept(std::string text) {
  static std::string result;
  result = std::move(text);
  return result.c_str();
}

}  // namespace taut::web
