#include "import/css_selectors.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "import/svg_values.hpp"
#include "import/text_encoding.hpp"

namespace taut::drawing {

namespace {

bool is_css_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

bool in_css_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || static_cast<unsigned char>(c) >= 0x80;
}

std::string in_small_letters(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

/// What a picture that nobody points at, or types in, never is.
bool is_never(const std::string& pseudo_class) {
  static const std::set<std::string> states{"hover",   "active",        "focus",        "focus-within", "focus-visible",
                                            "visited", "target",        "checked",      "disabled",     "invalid",
                                            "before",  "after",         "first-letter", "first-line",   "selection",
                                            "marker",  "target-within", "fullscreen"};
  return states.count(pseudo_class) != 0;
}

class SelectorParser {
 public:
  explicit SelectorParser(const std::string& text) : text_(text) {}

  /// Nothing if the text is no list of selectors.
  std::optional<std::vector<Selector>> list() {
    std::vector<Selector> all;
    do {
      Selector selector;
      if (!complex(selector)) return std::nullopt;
      all.push_back(std::move(selector));
    } while (take(','));
    if (at_ != text_.size()) return std::nullopt;
    return all;
  }

 private:
  bool more() const { return at_ < text_.size(); }
  void skip_space() {
    while (more() && is_css_space(text_[at_])) ++at_;
  }
  bool take(char c) {
    if (!more() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  bool complex(Selector& selector) {
    skip_space();
    for (char combinator = 0;;) {
      Selector::Step step{{}, combinator};
      if (!compound(step.compound, selector)) return false;
      selector.steps.push_back(std::move(step));
      const std::size_t end = at_;
      skip_space();
      if (!more() || text_[at_] == ',') return true;
      const char c = text_[at_];
      if (c == '>' || c == '+' || c == '~') {
        combinator = c;
        ++at_;
        skip_space();
      } else if (at_ > end) {
        combinator = ' ';
      } else {
        return false;
      }
    }
  }

  bool compound(CompoundSelector& c, Selector& selector) {
    const std::size_t start = at_;
    if (!take('*')) {
      c.name = word();
      if (!c.name.empty()) ++selector.specificity[2];
    }
    for (; more();) {
      const char mark = text_[at_];
      if (mark != '.' && mark != '#' && mark != '[' && mark != ':') break;
      ++at_;
      if (mark == '[' ? !attribute(c) : mark == ':' ? !pseudo(c, selector) : !name_after(mark, c)) return false;
      if (mark != ':') ++selector.specificity[mark == '#' ? 0 : 1];
    }
    return at_ > start;
  }

  bool name_after(char mark, CompoundSelector& c) {
    std::string name = word();
    if (name.empty()) return false;
    (mark == '#' ? c.ids : c.classes).push_back(std::move(name));
    return true;
  }

  bool attribute(CompoundSelector& c) {
    AttributeTest test;
    skip_space();
    test.name = word();
    // A prefix of a namespace: "xlink|href", or "*|href".
    if (test.name.empty() && !take('*')) return false;
    if (more() && text_[at_] == '|' && text_.compare(at_, 2, "|=") != 0) {
      ++at_;
      test.name = (test.name.empty() ? "" : test.name + ":") + word();
    }
    skip_space();
    if (!take(']')) {
      const char mark = more() ? text_[at_++] : 0;
      if (mark != '=' && (std::string("~|^$*").find(mark) == std::string::npos || !take('='))) return false;
      test.mark = mark;
      skip_space();
      if (!value(test.value)) return false;
      skip_space();
      const std::string flag = in_small_letters(word());
      if (!flag.empty() && flag != "i" && flag != "s") return false;
      test.any_case = flag == "i";
      skip_space();
      if (!take(']')) return false;
    }
    c.attributes.push_back(std::move(test));
    return true;
  }

  bool value(std::string& text) {
    if (!more()) return false;
    const char quote = text_[at_];
    if (quote != '"' && quote != '\'') {
      text = word();
      return !text.empty();
    }
    for (++at_; more() && text_[at_] != quote;) text += character();
    return take(quote);
  }

  bool pseudo(CompoundSelector& c, Selector& selector) {
    const std::size_t start = at_ - 1;
    const bool element = take(':');
    const std::string name = in_small_letters(word());
    if (name.empty()) return false;
    const bool function = take('(');
    if (function && name == "not" && negation(c, selector)) return true;
    if (function && !pass_brackets()) return false;
    if (!element && !function) ++selector.specificity[1];
    if (element || is_never(name))
      c.never = true;
    else if (name == "root" && !function)
      c.root = true;
    else if (name == "first-child")
      c.first = true;
    else if (name == "last-child")
      c.last = true;
    else
      selector.unread = text_.substr(start, at_ - start);
    return true;
  }

  /// The arguments of :not, if they are compounds; what they say counts as much as the one that says most.
  bool negation(CompoundSelector& c, Selector& selector) {
    const std::size_t start = at_;
    Specificity most{};
    std::vector<CompoundSelector> arguments;
    do {
      skip_space();
      Selector argument;
      CompoundSelector inner;
      if (!compound(inner, argument) || !argument.unread.empty()) break;
      skip_space();
      arguments.push_back(std::move(inner));
      most = std::max(most, argument.specificity);
    } while (take(','));
    if (!take(')')) {
      at_ = start;
      return false;
    }
    for (std::size_t k = 0; k < most.size(); ++k) selector.specificity[k] += most[k];
    std::move(arguments.begin(), arguments.end(), std::back_inserter(c.none_of));
    return true;
  }

  bool pass_brackets() {
    for (int depth = 1; more();) {
      const char c = text_[at_++];
      if (c == '(') ++depth;
      if (c == ')' && --depth == 0) return true;
    }
    return false;
  }

  std::string word() {
    std::string name;
    while (more() && (in_css_name(text_[at_]) || text_[at_] == '\\')) name += character();
    return name;
  }

  /// The next one; "\31 " and "\." are escapes.
  std::string character() {
    if (!take('\\') || !more()) return std::string(1, text_[at_++]);
    std::string digits;
    while (more() && digits.size() < 6 && std::isxdigit(static_cast<unsigned char>(text_[at_]))) digits += text_[at_++];
    if (digits.empty()) return std::string(1, text_[at_++]);
    if (more() && is_css_space(text_[at_])) ++at_;
    const unsigned long code = std::strtoul(digits.c_str(), nullptr, 16);
    return utf8_of(code == 0 || code >= 0x110000 || (code >= 0xD800 && code < 0xE000) ? 0xFFFD : code);
  }

  const std::string& text_;
  std::size_t at_ = 0;
};

/// Is the word one of those in the text, which spaces separate?
bool has_word(const std::string& text, const std::string& wanted) {
  for (std::size_t at = 0; at < text.size();) {
    while (at < text.size() && is_css_space(text[at])) ++at;
    std::size_t end = at;
    while (end < text.size() && !is_css_space(text[end])) ++end;
    if (end > at && text.compare(at, end - at, wanted) == 0) return true;
    at = end;
  }
  return false;
}

bool passes(const AttributeTest& test, const XmlElement& element) {
  const std::string* found = element.find(test.name);
  if (!found) return false;
  const std::string text = test.any_case ? in_small_letters(*found) : *found;
  const std::string value = test.any_case ? in_small_letters(test.value) : test.value;
  switch (test.mark) {
    case 0:
      return true;
    case '=':
      return text == value;
    case '~':
      return has_word(text, value);
    case '|':
      return text == value || text.starts_with(value + "-");
    case '^':
      return !value.empty() && text.starts_with(value);
    case '$':
      return !value.empty() && text.ends_with(value);
    default:
      return !value.empty() && text.find(value) != std::string::npos;
  }
}

bool fits(const CompoundSelector& c, const XmlTree& xml, std::size_t node) {
  const XmlElement& element = xml.element(node);
  if (c.never || (!c.name.empty() && c.name != element.name)) return false;
  const std::string *id = element.find("id"), *classes = element.find("class");
  const auto parent = xml.parent(node);
  if (c.root && parent) return false;
  if (c.first && xml.previous(node)) return false;
  if (c.last && parent && xml.end(node) != xml.end(*parent)) return false;
  return std::all_of(c.ids.begin(), c.ids.end(), [&](const std::string& wanted) { return id && *id == wanted; }) &&
         std::all_of(c.classes.begin(), c.classes.end(),
                     [&](const std::string& wanted) { return classes && has_word(*classes, wanted); }) &&
         std::all_of(c.attributes.begin(), c.attributes.end(),
                     [&](const AttributeTest& test) { return passes(test, element); }) &&
         std::none_of(c.none_of.begin(), c.none_of.end(),
                      [&](const CompoundSelector& inner) { return fits(inner, xml, node); });
}

/// Remembers what did not match: without that, "a a a" in deep groups would try each way to choose three of them.
class Matcher {
 public:
  Matcher(const Selector& selector, const XmlTree& xml) : selector_(selector), xml_(xml) {}

  /// Does the element fit step k, and others those before?
  bool matches(std::size_t k, std::size_t node) {
    if (!fits(selector_.steps[k].compound, xml_, node)) return false;
    if (k == 0) return true;
    if (!tried_.insert({k, node}).second) return false;
    const char combinator = selector_.steps[k].combinator;
    const bool outwards = combinator == ' ' || combinator == '>', once = combinator == '>' || combinator == '+';
    auto other = outwards ? xml_.parent(node) : xml_.previous(node);
    for (; other; other = outwards ? xml_.parent(*other) : xml_.previous(*other)) {
      if (matches(k - 1, *other)) return true;
      if (once) return false;
    }
    return false;
  }

 private:
  const Selector& selector_;
  const XmlTree& xml_;
  std::set<std::pair<std::size_t, std::size_t>> tried_;
};

}  // namespace

std::vector<Selector> parse_selectors(const std::string& text) {
  const std::string bare = trimmed_text(text);
  auto list = SelectorParser(bare).list();
  if (list) return std::move(*list);
  Selector everything;
  everything.steps.emplace_back();
  everything.unread = bare;
  return {everything};
}

bool matches(const Selector& selector, const XmlTree& xml, std::size_t node) {
  return Matcher(selector, xml).matches(selector.steps.size() - 1, node);
}

}  // namespace taut::drawing
