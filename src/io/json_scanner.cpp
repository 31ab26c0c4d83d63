#include "io/json_document.hpp"

#include <cmath>
#include <optional>
#include <string_view>

#include "io/text.hpp"

namespace taut::internal::io {
namespace {

class PlainJson {
 public:
  PlainJson(JsonDocument& document, std::size_t deepest) : document_(document), deepest_(deepest) {}

  bool run() {
    bool valued = false;  // has the array or object at hand a value that a comma or its end must follow?
    for (;;) {
      skip_space();
      if (open_.empty() && valued) return at_ == text_.size();
      if (at_ == text_.size()) return false;
      if (valued && text_[at_] == ',') {
        ++at_;
        skip_space();
        // After a comma there is a value.
        if (!member_or_value(valued)) return false;
      } else if (is_end_of_container()) {
        close();
        valued = true;
      } else if (valued || !member_or_value(valued)) {
        return false;
      }
    }
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\r' || text_[at_] == '\t'))
      ++at_;
  }
  bool in_object() const { return !open_.empty() && kind_of(open_.back()) == JsonKind::object; }
  JsonKind kind_of(std::size_t token) const { return document_.tokens[token].kind(); }
  bool is_end_of_container() const { return !open_.empty() && text_[at_] == (in_object() ? '}' : ']'); }

  /// `valued`: was it a whole value, and not the beginning of an array or object?
  bool member_or_value(bool& valued) {
    if (in_object()) {
      if (peek() != '"' || !string()) return false;
      skip_space();
      if (peek() != ':') return false;
      ++at_;
      skip_space();
    }
    const char c = peek();
    valued = c != '[' && c != '{';
    if (!valued) return open(c == '[' ? JsonKind::array : JsonKind::object);
    if (c == '"') return string();
    if (c == 't') return word("true", JsonKind::boolean, 1);
    if (c == 'f') return word("false", JsonKind::boolean, 0);
    if (c == 'n') return word("null", JsonKind::null, 0);
    return number();
  }

  void add(JsonKind kind, std::size_t start, JsonToken token) {
    token.kind_and_offset = (std::uint64_t{start} << 3) | static_cast<std::uint64_t>(kind);
    document_.tokens.push_back(token);
  }
  bool open(JsonKind kind) {
    if (open_.size() == deepest_) return false;
    open_.push_back(document_.tokens.size());
    add(kind, at_++, {});
    return true;
  }
  void close() {
    document_.tokens[open_.back()].link = document_.tokens.size();
    open_.pop_back();
    ++at_;
  }
  bool word(std::string_view expected, JsonKind kind, double value) {
    if (std::string_view(text_).substr(at_, expected.size()) != expected) return false;
    JsonToken token;
    token.number = value;
    add(kind, at_, token);
    at_ += expected.size();
    return true;
  }
  bool string() {
    const std::size_t start = at_++;
    while (at_ < text_.size() && text_[at_] != '"') {
      const auto c = static_cast<unsigned char>(text_[at_]);
      if (c < 0x20 || c >= 0x7F || c == '\\') return false;
      ++at_;
    }
    if (at_ == text_.size()) return false;
    JsonToken token;
    token.link = document_.strings.size();
    document_.strings.push_back(text_.substr(start + 1, at_ - start - 1));
    add(JsonKind::string, start, token);
    ++at_;
    return true;
  }
  bool digits() {
    const std::size_t from = at_;
    while (peek() >= '0' && peek() <= '9') ++at_;
    return at_ > from;
  }
  bool number() {
    const std::size_t start = at_;
    if (peek() == '-') ++at_;
    const bool zero = peek() == '0';
    const std::size_t first = at_;
    if (!digits() || (zero && at_ > first + 1)) return false;
    bool whole = true;
    if (peek() == '.') {
      ++at_;
      whole = false;
      if (!digits()) return false;
    }
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      whole = false;
      if (peek() == '+' || peek() == '-') ++at_;
      if (!digits()) return false;
    }
    std::size_t end = start;
    const std::optional<double> value = scan_number(text_, &end);
    if (!value || end != at_ || !std::isfinite(*value)) return false;
    JsonToken token;
    // A whole number has no negative zero.
    token.number = whole && *value == 0 ? 0 : *value;
    add(JsonKind::number, start, token);
    return true;
  }

  JsonDocument& document_;
  const std::string& text_ = document_.text;
  std::size_t deepest_, at_ = 0;
  std::vector<std::size_t> open_;  ///< tokens of the arrays and objects being read
};

}  // namespace

bool scan_plain_json(JsonDocument& document, std::size_t deepest) { return PlainJson(document, deepest).run(); }

}  // namespace taut::internal::io
