#include "io/json_text.hpp"

#include <nlohmann/json.hpp>

#include "io/terminal_text.hpp"

namespace taut::internal::io {

std::string string_text(const std::string& s) {
  const std::string plain = nlohmann::json(s).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string out;
  out.reserve(plain.size());
  for (std::size_t at = 0; at < plain.size();) {
    const std::size_t begin = at;
    const auto character = next_character(plain, at);
    if (character && is_hidden(*character)) {
      out += line_for_terminal(plain.substr(begin, at - begin));
    } else {
      out.append(plain, begin, at - begin);
    }
  }
  return out;
}

std::string array_text(const std::vector<double>& numbers) {
  std::string s = "[";
  for (double x : numbers) {
    if (s.size() > 1) s += ',';
    s += number_text(x);
  }
  return s + "]";
}

std::string clearances_text(const std::vector<PairClearance>& clearances) {
  std::string s = "[";
  for (const PairClearance& entry : clearances) {
    const auto& [coefficients, origin] = entry.margin;
    s +=
        (s.size() > 1 ? ",{\"pair\":[" : "{\"pair\":[") + string_text(entry.pair[0]) + "," + string_text(entry.pair[1]);
    s += "],\"margin\":" + (coefficients.size() == 1 ? number_text(coefficients[0]) : array_text(coefficients));
    s += origin != 0 ? ",\"origin\":" + number_text(origin) + "}" : "}";
  }
  return s + "]";
}

std::string point_text(const Point& p) { return "[" + number_text(p.x) + "," + number_text(p.y) + "]"; }

}  // namespace taut::internal::io
