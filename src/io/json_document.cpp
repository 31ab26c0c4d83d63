#include "io/json_document.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "io/json_writer.hpp"
#include "io/text_file.hpp"

namespace taut::internal::io {

namespace {

/// A scene needs 7 levels, GeoJSON 8.
constexpr std::size_t max_depth = 32;

/// Tells the handler how far the lexer has read.
struct TrackingIterator {
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  const char* position;
  const char** furthest;

  reference operator*() const { return *position; }
  TrackingIterator& operator++() {
    *furthest = ++position;
    return *this;
  }
  TrackingIterator operator++(int) {
    TrackingIterator old = *this;
    ++*this;
    return old;
  }
  friend bool operator==(const TrackingIterator& a, const TrackingIterator& b) { return a.position == b.position; }
  friend bool operator!=(const TrackingIterator& a, const TrackingIterator& b) { return !(a == b); }
};

class TokenWriter : public nlohmann::json_sax<nlohmann::json> {
 public:
  TokenWriter(JsonDocument& document, const char** furthest, Quoting quoting)
      : document_(document), furthest_(furthest), quoting_(quoting) {}

  bool null() override { return add(JsonKind::null); }
  bool boolean(bool value) override { return add_number(JsonKind::boolean, value ? 1 : 0); }
  bool number_integer(number_integer_t value) override {
    return add_number(JsonKind::number, static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add_number(JsonKind::number, static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return add_number(JsonKind::number, value); }
  bool string(string_t& value) override { return add_string(value); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonKind::object); }
  bool key(string_t& value) override { return add_string(value); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(JsonKind::array); }
  bool end_array() override { return close(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception& e) override {
    std::string problem = e.what();
    // "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error ..."
    const std::size_t bracket = problem.find("] ");
    if (bracket != std::string::npos) problem.erase(0, bracket + 2);
    if (problem.rfind("parse error at line", 0) == 0) problem.erase(0, problem.find(": ") + 2);
    const std::size_t read = offset();
    const std::string special = special_number();
    const bool overflow = problem.find("overflow") != std::string::npos;
    const bool whole_token = !special.empty() || overflow;
    const std::size_t at = whole_token ? start_of_token() : read == 0 ? 0 : read - 1;
    const std::string found = hint_at(at), hint = found.empty() ? hint_for(problem) : found;
    if (quoting_ == Quoting::never) drop_quotation(problem);
    throw InputError(place_in_text(document_.text, document_.name, at),
                     special.empty() ? "not valid JSON: " + excerpt(problem, 160) : special,
                     special.empty() ? hint : "write a finite decimal number");
  }

 private:
  std::size_t offset() const { return static_cast<std::size_t>(*furthest_ - document_.text.data()); }

  /// JSON cannot express NaN and infinities; say so rather than "invalid literal". Empty if it is something else.
  std::string special_number() const {
    const std::size_t from = document_.text.find_first_not_of(" \t\r\n,:-+", last_end_);
    for (const char* word : {"NaN", "nan", "Infinity", "inf", "Inf"}) {
      if (from != std::string::npos && document_.text.compare(from, std::string(word).size(), word) == 0) {
        return std::string(word) + " is not a number in JSON";
      }
    }
    return "";
  }

  /// The parser's messages end with what it read, the one about numbers with the number.
  static void drop_quotation(std::string& problem) {
    for (const char* quotation : {"; last read", " parsing '"})
      problem.resize(std::min(problem.find(quotation), problem.size()));
  }

  /// What begins where the parser stopped, and is something that JSON does not have.
  std::string hint_at(std::size_t at) const {
    const std::string& text = document_.text;
    const std::size_t from = text.find_first_not_of(" \t\r\n", std::min(at, text.size()));
    const char c = from == std::string::npos ? '\0' : text[from];
    if (c == '\'') return "JSON has double quotes only: write \"name\"";
    if (c == '#' || (c == '/' && from + 1 < text.size() && (text[from + 1] == '/' || text[from + 1] == '*')))
      return "JSON has no comments: take them out";
    return "";
  }

  static std::string hint_for(const std::string& problem) {
    if (problem.find("overflow") != std::string::npos) {
      return "numbers must fit a 64-bit floating-point number (about 1.8e308 at most)";
    }
    for (const char* cut : {"unexpected end of input", "missing closing quote"}) {
      if (problem.find(cut) != problem.npos) return "the text stops too early: was the file cut off?";
    }
    return "mend the syntax here, or just before";
  }

  /// Where the token that was just read begins: between it and the one before are only separators.
  std::size_t start_of_token() {
    const std::size_t end = offset();
    std::size_t start = document_.text.find_first_not_of(" \t\r\n,:", last_end_);
    if (start == std::string::npos || start > end) start = end;
    last_end_ = end;
    return start;
  }

  bool add_token(JsonToken token, JsonKind kind) {
    token.kind_and_offset = (std::uint64_t{start_of_token()} << 3) | static_cast<std::uint64_t>(kind);
    document_.tokens.push_back(token);
    return true;
  }
  bool add(JsonKind kind) { return add_token({}, kind); }
  bool add_number(JsonKind kind, double value) {
    JsonToken token;
    token.number = value;
    return add_token(token, kind);
  }
  bool add_string(std::string& value) {
    JsonToken token;
    token.link = document_.strings.size();
    document_.strings.push_back(std::move(value));
    return add_token(token, JsonKind::string);
  }
  bool open(JsonKind kind) {
    if (open_.size() == max_depth) {
      throw InputError(place_in_text(document_.text, document_.name, offset() - 1),
                       "arrays or objects are nested more than " + std::to_string(max_depth) + " deep",
                       "see the example in `taut check --help` for the shape of a scene");
    }
    open_.push_back(document_.tokens.size());
    return add(kind);
  }
  bool close() {
    document_.tokens[open_.back()].link = document_.tokens.size();
    open_.pop_back();
    last_end_ = offset();
    return true;
  }

  JsonDocument& document_;
  const char** furthest_;
  Quoting quoting_;
  std::size_t last_end_ = 0;
  std::vector<std::size_t> open_;  ///< tokens of the arrays and objects being read
};

}  // namespace

const char* to_string(JsonKind kind) {
  switch (kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return "true or false";
    case JsonKind::number:
      return "a number";
    case JsonKind::string:
      return "a string";
    case JsonKind::array:
      return "an array";
    case JsonKind::object:
      return "an object";
  }
  return "";
}

InputError JsonDocument::error(std::size_t token, const std::string& path, const std::string& problem,
                               const std::string& hint) const {
  const std::string place = place_in_text(text, name, at(token).offset());
  return InputError(path.empty() ? place : place + ": " + path, problem, hint);
}

void JsonDocument::require(std::size_t token, JsonKind kind, const std::string& path, const std::string& shape) const {
  if (at(token).kind() == kind) return;
  throw error(token, path, std::string("expected ") + to_string(kind) + ", found " + to_string(at(token).kind()),
              "write " + shape);
}

std::string value_text(const JsonDocument& document, std::size_t token) {
  const JsonToken& value = document.at(token);
  const auto until = [&](const char* ends) {
    const std::size_t from = value.offset();
    return document.text.substr(from, document.text.find_first_of(ends, from) - from);
  };
  if (value.kind() == JsonKind::string) return string_text(document.string_at(token));
  if (value.kind() != JsonKind::array && value.kind() != JsonKind::object) return until(" \t\r\n,]}");
  const bool object = value.kind() == JsonKind::object;
  std::string s;
  const std::size_t end = document.after(token);
  for (std::size_t i = token + 1; i < end; i = document.after(i)) {
    if (!s.empty()) s += ',';
    if (object) s += string_text(document.string_at(i++)) + ':';
    s += value_text(document, i);
  }
  return object ? "{" + s + "}" : "[" + s + "]";
}

JsonDocument parse_json(std::string text, const std::string& name, const std::string& example, Quoting quoting) {
  JsonDocument document;
  document.name = name;
  document.text = std::move(text);
  if (document.text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(name, "the file is empty", example);
  }
  if (scan_plain_json(document, max_depth)) return document;
  document.tokens.clear();
  document.strings.clear();
  parse_any_json(document, quoting);
  return document;
}

void parse_any_json(JsonDocument& document, Quoting quoting) {
  const char* begin = document.text.data();
  const char* furthest = begin;
  const char* end = begin + document.text.size();
  TokenWriter writer(document, &furthest, quoting);
  nlohmann::json::sax_parse(TrackingIterator{begin, &furthest}, TrackingIterator{end, &furthest}, &writer);
  // The parser takes a NUL for the end of the text.
  const std::size_t nul = document.text.find('\0');
  if (nul != std::string::npos)
    throw InputError(place_in_text(document.text, document.name, nul),
                     "a NUL character ends the JSON, but not the file", "remove it, and what comes after it");
}

}  // namespace taut::internal::io
