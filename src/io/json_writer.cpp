#include "io/json_writer.hpp"

#include "io/json_text.hpp"

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

}  // namespace taut::internal::io
