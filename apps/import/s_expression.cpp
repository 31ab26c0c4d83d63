#include "import/s_expression.hpp"

#include <cctype>
#include <cmath>

#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr std::size_t deepest_list = 100;

class SExpressionReader {
 public:
  SExpressionReader(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  SExpression read() {
    skip_space();
    if (position_ == text_.size() || text_[position_] != '(') fail("expected \"(\"");
    SExpression root = read_list(0);
    skip_space();
    if (position_ != text_.size()) fail("unexpected text after the last bracket");
    return root;
  }

 private:
  SExpression read_list(std::size_t depth) {
    if (depth == deepest_list) fail("brackets are nested more than 100 deep");
    SExpression list;
    list.list = true;
    list.offset = position_++;
    skip_space();
    if (position_ < text_.size() && text_[position_] != '(' && text_[position_] != ')') list.word = read_word();
    for (;;) {
      skip_space();
      if (position_ == text_.size()) fail("a bracket is not closed: the file is cut off");
      if (text_[position_] == ')') {
        ++position_;
        return list;
      }
      if (text_[position_] == '(') {
        list.items.push_back(read_list(depth + 1));
      } else {
        const std::size_t offset = position_;
        list.items.push_back({read_word(), false, {}, offset});
      }
    }
  }

  std::string read_word() {
    std::string word;
    if (text_[position_] == '"') {
      for (++position_; position_ < text_.size() && text_[position_] != '"'; ++position_) {
        if (text_[position_] == '\\' && position_ + 1 < text_.size()) ++position_;
        word += text_[position_];
      }
      if (position_ == text_.size()) fail("a quotation mark without its second one");
      ++position_;
      return word;
    }
    while (position_ < text_.size() && !is_space(text_[position_]) && text_[position_] != '(' &&
           text_[position_] != ')')
      word += text_[position_++];
    return word;
  }

  static bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
  void skip_space() {
    while (position_ < text_.size() && is_space(text_[position_])) ++position_;
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(io::place_in_text(text_, file_, position_), problem, "save the board again with KiCad");
  }

  const std::string& text_;
  const std::string& file_;
  std::size_t position_ = 0;
};

}  // namespace

const SExpression* SExpression::find(const std::string& name) const {
  for (const SExpression& item : items)
    if (item.list && item.word == name) return &item;
  return nullptr;
}

std::optional<double> SExpression::number(std::size_t i) const {
  if (i >= items.size() || items[i].list) return std::nullopt;
  std::size_t position = 0;
  const auto value = io::scan_number(items[i].word, &position);
  if (!value || position != items[i].word.size() || !std::isfinite(*value)) return std::nullopt;
  return value;
}

std::optional<Point> SExpression::point(const std::string& name) const {
  const SExpression* list_of_two = find(name);
  const auto x = list_of_two ? list_of_two->number(0) : std::nullopt;
  const auto y = list_of_two ? list_of_two->number(1) : std::nullopt;
  return x && y ? std::optional(Point{*x, *y}) : std::nullopt;
}

std::string SExpression::text(const std::string& name) const {
  const SExpression* found = find(name);
  return found && !found->items.empty() ? found->items[0].word : "";
}

SExpression parse_s_expression(const std::string& text, const std::string& file) {
  return SExpressionReader(text, file).read();
}

}  // namespace taut::drawing
