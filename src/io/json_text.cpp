#include "io/json_text.hpp"

#include <nlohmann/json.hpp>

namespace taut::io {

std::string string_text(const std::string& s) {
  return nlohmann::json(s).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string array_text(const std::vector<double>& numbers) {
  std::string s = "[";
  for (double x : numbers) {
    if (s.size() > 1) s += ',';
    s += number_text(x);
  }
  return s + "]";
}

std::string point_text(const Point& p) { return "[" + number_text(p.x) + "," + number_text(p.y) + "]"; }

}  // namespace taut::io
