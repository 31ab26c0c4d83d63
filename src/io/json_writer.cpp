#include "io/json_writer.hpp"

#include <nlohmann/json.hpp>

#include "io/text.hpp"

namespace taut::internal::io {

void JsonWriter::separate() {
  if (!first_) text_ += ',';
  first_ = false;
}

JsonWriter& JsonWriter::key(std::string_view name) {
  separate();
  text_ += '"';
  text_ += name;
  text_ += "\":";
  first_ = true;
  return *this;
}

JsonWriter& JsonWriter::user_key(const std::string& name) {
  separate();
  text_ += string_text(name) + ":";
  first_ = true;
  return *this;
}

void JsonWriter::raw(std::string_view json) {
  separate();
  text_ += json;
}

void JsonWriter::string(std::string_view text) { raw(string_text(std::string(text))); }
void JsonWriter::number(double value) { raw(number_text(value)); }
void JsonWriter::count(std::uint64_t value) { raw(std::to_string(value)); }
void JsonWriter::integer(std::int64_t value) { raw(std::to_string(value)); }
void JsonWriter::boolean(bool value) { raw(value ? "true" : "false"); }
void JsonWriter::null() { raw("null"); }

void JsonWriter::numbers(std::initializer_list<double> values) {
  array(values, [this](double value) { number(value); });
}

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
