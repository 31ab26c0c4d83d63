#include "import/svg_styles.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "import/svg_values.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr std::size_t most_rules = 1000;

const std::set<std::string>& read_properties() {
  static const std::set<std::string> names{"fill", "fill-rule", "stroke", "display", "visibility"};
  return names;
}

/// By these a style would change where a shape is, or what is seen of it.
const std::set<std::string>& moving_properties() {
  static const std::set<std::string> names{"transform", "clip-path", "mask", "d", "x",  "y", "width",
                                           "height",    "cx",        "cy",   "r", "rx", "ry"};
  return names;
}

/// Without comments, and without the marks by which XML and old browsers hide it.
std::string bare_css(const std::string& css) {
  std::string s;
  for (std::size_t i = 0; i < css.size();) {
    bool passed = false;
    for (const char* mark : {"<![CDATA[", "]]>", "<!--", "-->"}) {
      const std::string word = mark;
      if (css.compare(i, word.size(), word) != 0) continue;
      i += word.size();
      passed = true;
    }
    if (passed) continue;
    if (css.compare(i, 2, "/*") == 0) {
      const std::size_t end = css.find("*/", i + 2);
      i = end == std::string::npos ? css.size() : end + 2;
      continue;
    }
    s += css[i++];
  }
  return s;
}

/// The place behind a block that begins at `open`, with the blocks within it.
std::size_t behind_block(const std::string& css, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < css.size(); ++i) {
    if (css[i] == '{') ++depth;
    if (css[i] == '}' && --depth == 0) return i + 1;
  }
  return css.size();
}

template <class Take>
void each_piece(const std::string& text, char mark, const Take& take) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(mark, begin), text.size());
    take(trimmed_text(text.substr(begin, end - begin)));
    begin = end + 1;
  }
}

/// The name and the value of "name: value".
std::pair<std::string, std::string> declaration_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return {};
  std::string name = trimmed_text(text.substr(0, colon));
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return {name, trimmed_text(text.substr(colon + 1))};
}

std::string without_important(const std::string& value, bool& important) {
  const std::size_t mark = value.find('!');
  important = mark != std::string::npos;
  return trimmed_text(value.substr(0, mark));
}

bool has_class(const XmlElement& element, const std::string& wanted) {
  const std::string* classes = element.find("class");
  if (!classes) return false;
  std::size_t at = 0;
  while ((at = classes->find(wanted, at)) != std::string::npos) {
    const std::size_t end = at + wanted.size();
    const auto space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    if ((at == 0 || space((*classes)[at - 1])) && (end == classes->size() || space((*classes)[end]))) return true;
    at = end;
  }
  return false;
}

}  // namespace

bool StyleSheet::Rule::fits(const XmlElement& element) const {
  if (!name.empty() && name != element.name) return false;
  if (!id.empty()) {
    const std::string* found = element.find("id");
    if (!found || *found != id) return false;
  }
  return std::all_of(classes.begin(), classes.end(), [&](const std::string& c) { return has_class(element, c); });
}

/// False for what is more than a name, classes and an id.
bool StyleSheet::read_selector(const std::string& text, Rule& rule) {
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || static_cast<unsigned char>(c) >= 0x80;
  };
  std::size_t i = 0;
  const auto word = [&] {
    const std::size_t begin = i;
    while (i < text.size() && in_word(text[i])) ++i;
    return text.substr(begin, i - begin);
  };
  if (text.empty()) return false;
  if (text[0] == '*') {
    i = 1;
  } else {
    rule.name = word();
  }
  rule.weight = rule.name.empty() ? 0 : 1;
  while (i < text.size()) {
    const char mark = text[i++];
    const std::string found = word();
    if (found.empty() || (mark != '.' && mark != '#') || (mark == '#' && !rule.id.empty())) return false;
    if (mark == '.') rule.classes.push_back(found);
    if (mark == '#') rule.id = found;
    rule.weight += mark == '.' ? 100 : 10000;
  }
  return true;
}

std::map<std::string, StyleSheet::Value> StyleSheet::read_declarations(const std::string& text, const XmlElement& style,
                                                                       Drawing& drawing) const {
  std::map<std::string, Value> values;
  each_piece(text, ';', [&](const std::string& piece) {
    const auto [name, given] = declaration_of(piece);
    if (moving_properties().count(name))
      drawing.skip(lost(style.place, "\"" + name + "\" in a style sheet", "is not read: use the attribute"));
    if (!read_properties().count(name)) return;
    Value value;
    value.text = without_important(given, value.important);
    const auto there = values.find(name);
    if (there == values.end() || !there->second.important || value.important) values[name] = value;
  });
  return values;
}

void StyleSheet::add(const std::string& selectors, const std::map<std::string, Value>& values, const XmlElement& style,
                     Drawing& drawing) {
  if (values.empty()) return;
  each_piece(selectors, ',', [&](const std::string& selector) {
    Rule rule;
    rule.values = values;
    if (!read_selector(selector, rule))
      return drawing.skip(style.place, "the rule \"" + io::excerpt(selector, 30) + "\"",
                          "is not read: only names, classes and ids are");
    if (rules_.size() == most_rules)
      throw InputError(style.place, "style sheets have more than 1000 rules about what is seen",
                       "save the drawing as plain SVG, without style sheets");
    rules_.push_back(std::move(rule));
  });
}

void StyleSheet::read(const std::string& text, const XmlElement& style, Drawing& drawing) {
  const std::string css = bare_css(text);
  for (std::size_t i = 0; i < css.size();) {
    const std::size_t open = css.find('{', i), stop = css.find(';', i);
    const std::string head = trimmed_text(css.substr(i, std::min(open, stop) - i));
    if (head.empty() && open == std::string::npos) break;
    const bool at_rule = !head.empty() && head[0] == '@';
    if (at_rule && stop < open) {
      i = stop + 1;
    } else if (open == std::string::npos) {
      break;
    } else {
      const std::size_t end = behind_block(css, open);
      if (!at_rule)
        add(trimmed_text(css.substr(i, open - i)),
            read_declarations(css.substr(open + 1, end - open - 2), style, drawing), style, drawing);
      i = end;
    }
    // Fonts and character sets change nothing.
    const std::string word = head.substr(0, head.find_first_of(" \t\r\n(\""));
    if (at_rule && word != "@font-face" && word != "@charset" && word != "@namespace")
      drawing.skip(style.place, io::excerpt(word, 30), "in a style sheet is not read");
  }
}

StyleSheet::Found StyleSheet::find(const XmlElement& element, const std::string& name) const {
  Found best;
  for (const Rule& rule : rules_) {
    const auto value = rule.values.find(name);
    if (value == rule.values.end() || !rule.fits(element)) continue;
    const int weight = rule.weight + (value->second.important ? 100000000 : 0);
    if (weight >= best.weight) best = {&value->second, weight};
  }
  return best;
}

std::string StyleSheet::property(const XmlElement& element, const std::string& name) const {
  const Found rule = find(element, name);
  std::string value;
  bool given = false, important = false;
  if (const std::string* style = element.find("style")) {
    each_piece(*style, ';', [&](const std::string& piece) {
      const auto [found, text] = declaration_of(piece);
      if (found != name) return;
      bool strong = false;
      const std::string bare = without_important(text, strong);
      if (given && important && !strong) return;
      value = bare;
      given = true;
      important = strong;
    });
  }
  if (rule.value && (!given || (rule.value->important && !important))) return rule.value->text;
  if (given) return value;
  const std::string* attribute = element.find(name);
  return attribute ? trimmed_text(*attribute) : "";
}

std::string unread_in_style(const XmlElement& element) {
  std::string unread;
  if (const std::string* style = element.find("style")) {
    each_piece(*style, ';', [&](const std::string& piece) {
      const std::string name = declaration_of(piece).first;
      if (moving_properties().count(name)) unread = name;
    });
  }
  return unread;
}

}  // namespace taut::drawing
