#include "import/svg_styles.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "import/svg_values.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr std::size_t most_rules = 1000;

const std::set<std::string>& read_properties() {
  static const std::set<std::string> names{
      "fill",          "fill-rule",  "fill-opacity", "stroke",       "stroke-width", "stroke-opacity",   "opacity",
      "display",       "visibility", "overflow",     "clip-path",    "mask",         "transform-origin", "transform",
      "transform-box", "filter",     "marker",       "marker-start", "marker-mid",   "marker-end"};
  return names;
}

/// These are read in styles only: attributes of these names mean something else.
const std::set<std::string>& placing_properties() {
  static const std::set<std::string> names{"translate", "rotate", "scale"};
  return names;
}

/// By these a style would change where a shape is, or what is seen of it. They are not read.
const std::set<std::string>& moving_properties() {
  static const std::set<std::string> names{"zoom",         "offset-path",        "offset",           "mask-image",
                                           "-webkit-mask", "-webkit-mask-image", "-webkit-clip-path"};
  return names;
}

/// The sizes of shapes: a style may have them in place of the attributes. They are not read, either.
const std::set<std::string>& size_properties() {
  static const std::set<std::string> names{"d", "x", "y", "width", "height", "cx", "cy", "r", "rx", "ry"};
  return names;
}

bool matters(const std::string& property) {
  if (property.starts_with("--")) return true;
  return read_properties().count(property) || placing_properties().count(property) ||
         moving_properties().count(property) || size_properties().count(property);
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
  // Capitals count in names of custom properties.
  for (char& c : name)
    if (!name.starts_with("--")) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return {name, trimmed_text(text.substr(colon + 1))};
}

std::string without_important(const std::string& value, bool& important) {
  const std::size_t mark = value.find('!');
  important = mark != std::string::npos;
  return trimmed_text(value.substr(0, mark));
}

std::string in_lower_case(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

/// Is the block of a @media rule for a picture on a screen? Unknown where more is asked for than the kind of medium.
enum class Medium { screen, other, unknown };
Medium medium_of(const std::string& query) {
  bool unknown = false, screen = false;
  each_piece(query, ',', [&](const std::string& piece) {
    std::string word = in_lower_case(piece);
    if (word.starts_with("only ")) word = trimmed_text(word.substr(5));
    std::erase_if(word, [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; });
    // Pages are light where nothing else is said.
    if (word == "screen" || word == "all" || word == "(prefers-color-scheme:light)")
      screen = true;
    else if (word != "print" && word != "speech" && word != "(prefers-color-scheme:dark)")
      unknown = true;
  });
  if (trimmed_text(query).empty() || screen) return Medium::screen;
  return unknown ? Medium::unknown : Medium::other;
}

}  // namespace

std::string ElementStyle::text(const std::string& name) const {
  const auto value = values_.find(name);
  return value == values_.end() ? "" : value->second;
}

std::string ElementStyle::word(const std::string& name) const {
  const std::string word = in_lower_case(text(name));
  return word == "inherit" || word == "unset" ? "" : word;
}

bool ElementStyle::is_zero(const std::string& name) const {
  const auto length = parse_length(text(name));
  return length && length->value == 0;
}

namespace {

constexpr int deepest_variable = 8;

/// The text with what custom properties say in place of each var(--name, otherwise); nothing where one says nothing.
/// Where they refer to each other too deeply, or in a ring, some are left, which is an error.
std::optional<std::string> with_variables(const std::string& text, const Variables& variables, int depth = 0) {
  const std::size_t at = in_lower_case(text).find("var(");
  if (at == std::string::npos || depth == deepest_variable) return text;
  std::size_t end = at + 4, comma = std::string::npos;
  for (int open = 1; end < text.size() && open > 0; ++end) {
    if (text[end] == '(') ++open;
    if (text[end] == ')') --open;
    if (text[end] == ',' && open == 1 && comma == std::string::npos) comma = end;
  }
  if (text[end - 1] != ')') return std::nullopt;
  const std::string name = trimmed_text(text.substr(at + 4, std::min(comma, end - 1) - at - 4));
  const auto known = variables.find(name);
  std::optional<std::string> value;
  if (known != variables.end()) value = with_variables(known->second, variables, depth + 1);
  if (!value && comma != std::string::npos)
    value = with_variables(trimmed_text(text.substr(comma + 1, end - comma - 2)), variables, depth + 1);
  if (!value) return std::nullopt;
  return with_variables(text.substr(0, at) + *value + text.substr(end), variables, depth + 1);
}

}  // namespace

void ElementStyle::take_variables(std::shared_ptr<const Variables>& around) {
  Variables own;
  for (const auto& [name, text] : values_)
    if (name.starts_with("--")) own[name] = text;
  if (!own.empty()) {
    if (around) own.insert(around->begin(), around->end());
    around = std::make_shared<const Variables>(std::move(own));
  }
  static const Variables none;
  for (auto value = values_.begin(); value != values_.end();) {
    // What is not known is as if nothing were said.
    const auto text = with_variables(value->second, around ? *around : none);
    if (text) value->second = *text;
    value = text ? std::next(value) : values_.erase(value);
  }
}

StyleSheet::Values StyleSheet::read_declarations(const std::string& text) {
  Values values;
  each_piece(text, ';', [&](const std::string& piece) {
    const auto [name, given] = declaration_of(piece);
    if (!matters(name)) return;
    Value value;
    value.text = without_important(given, value.important);
    const auto there = values.find(name);
    if (there == values.end() || !there->second.important || value.important) values[name] = value;
  });
  return values;
}

void StyleSheet::add(const std::string& selectors, const Values& values, const XmlElement& style, Drawing& drawing) {
  if (values.empty()) return;
  for (Selector& selector : parse_selectors(selectors)) {
    if (!selector.unread.empty()) {
      // Which elements it is about is not known.
      if (may_change_shapes(selector))
        drawing.skip(lost_style(style.place, "the rule \"" + io::excerpt(trimmed_text(selectors), 40) + "\"",
                                "has \"" + io::excerpt(selector.unread, 30) + "\", which is not read",
                                "style the elements by their classes or ids"));
      continue;
    }
    if (rules_.size() == most_rules)
      throw InputError(style.place, "style sheets have more than 1000 rules about what is seen",
                       "save the drawing as plain SVG, without style sheets");
    rules_.push_back({std::move(selector), values});
  }
}

/// Does the selector match a shape, or what shapes may be in?
bool StyleSheet::may_change_shapes(const Selector& selector) const {
  static const std::set<std::string> around{"g", "a", "svg", "use", "symbol", "switch", "defs"};
  for (std::size_t node = 0; node < xml_.size(); ++node) {
    const std::string& name = xml_.element(node).name;
    if ((is_svg_shape(name) || around.count(name)) && matches(selector, xml_, node)) return true;
  }
  return false;
}

void StyleSheet::read(const std::string& text, const XmlElement& style, Drawing& drawing) {
  const auto media = style.find("media");
  if (media)
    read_at_rule("@media " + *media, bare_css(text), style, drawing);
  else
    read_rules(bare_css(text), style, drawing);
}

void StyleSheet::read_rules(const std::string& css, const XmlElement& style, Drawing& drawing) {
  for (std::size_t i = 0; i < css.size();) {
    const std::size_t open = css.find('{', i), stop = css.find(';', i);
    const std::string head = trimmed_text(css.substr(i, std::min(open, stop) - i));
    if (head.empty() && open == std::string::npos) break;
    const bool at_rule = !head.empty() && head[0] == '@';
    if (at_rule && stop < open) {
      i = stop + 1;
      read_at_rule(head, "", style, drawing);
      continue;
    }
    if (open == std::string::npos) break;
    const std::size_t end = behind_block(css, open);
    const std::string block = css.substr(open + 1, std::max(end, open + 2) - open - 2);
    if (at_rule)
      read_at_rule(head, block, style, drawing);
    else if (block.find('{') != std::string::npos)
      drawing.skip(lost_style(style.place, "the rule \"" + io::excerpt(head, 40) + "\"",
                              "has rules within it, which are not read", "write them one after the other"));
    else
      add(css.substr(i, open - i), read_declarations(block), style, drawing);
    i = end;
  }
}

void StyleSheet::read_at_rule(const std::string& head, const std::string& block, const XmlElement& style,
                              Drawing& drawing) {
  const std::string word = in_lower_case(head.substr(0, head.find_first_of(" \t\r\n(\"")));
  const Medium medium = word == "@media" ? medium_of(head.substr(6)) : Medium::unknown;
  // Fonts and character sets change nothing, and what moves is drawn as it is before it moves.
  static const std::set<std::string> idle{"@font-face", "@charset", "@namespace", "@page", "@keyframes"};
  if (idle.count(word) || medium == Medium::other) return;
  if (medium == Medium::screen) return read_rules(block, style, drawing);
  if (word == "@import")
    return drawing.skip(lost_style(style.place, "the rule \"" + io::excerpt(head, 40) + "\"",
                                   "takes styles from another file, which is not read",
                                   "put the styles into the drawing"));
  Drawing unused;
  StyleSheet within(xml_);
  within.read_rules(block, style, unused);
  const std::string rule = "the rule \"" + io::excerpt(head, 40) + "\"", reason = "in a style sheet is not read";
  if (within.rules_.empty() && unused.skipped.empty())
    drawing.skip({style.place, rule, reason, "", "", true});
  else
    drawing.skip(lost_style(style.place, rule, reason, "write what is in it by itself"));
}

ElementStyle StyleSheet::style_of(std::size_t node) const {
  const XmlElement& element = xml_.element(node);
  // What outdoes the others, by importance and then by where it stands.
  using Weight = std::pair<bool, Specificity>;
  std::map<std::string, std::pair<Weight, std::string>> best;
  const auto offer = [&best](const std::string& name, const Weight& weight, const std::string& text) {
    if (text.empty()) return;
    const auto known = best.find(name);
    if (known == best.end() || known->second.first <= weight) best[name] = {weight, text};
  };
  for (const auto& [name, value] : element.attributes)
    if (read_properties().count(name)) offer(name, {false, {-1, 0, 0}}, trimmed_text(value));
  for (const Rule& rule : rules_)
    if (matches(rule.selector, xml_, node))
      for (const auto& [name, value] : rule.values)
        offer(name, {value.important, rule.selector.specificity}, value.text);
  if (const std::string* style = element.find("style")) {
    each_piece(*style, ';', [&](const std::string& piece) {
      const auto [name, given] = declaration_of(piece);
      if (!matters(name)) return;
      bool important = false;
      const std::string text = without_important(given, important);
      offer(name, {important, {1000000, 0, 0}}, text);
    });
  }
  ElementStyle style;
  for (auto& [name, value] : best) style.values_[name] = std::move(value.second);
  return style;
}

namespace {

/// A value by which nothing changes.
bool is_idle(const std::string& property, const std::string& word) {
  if (word == "none" || word == "auto" || word == "initial" || word == "unset") return true;
  const auto length = parse_length(word);
  if (!length) return false;
  const bool one = length->value == 1 || (length->value == 100 && length->unit == "%");
  return property == "zoom" && one;
}

/// Does the style say what the attribute says?
bool says_the_same(const XmlElement& element, const std::string& property, const std::string& text) {
  const std::string* attribute = element.find(property);
  const auto there = attribute ? parse_length(*attribute) : std::nullopt, given = parse_length(text);
  const auto unit = [](const Length& length) { return length.unit.empty() ? std::string("px") : length.unit; };
  return there && given && there->value == given->value && unit(*there) == unit(*given);
}

}  // namespace

std::string ElementStyle::unread(const XmlElement& element) const {
  const bool has_size = is_svg_shape(element.name) || element.name == "use" || element.name == "svg";
  for (const auto& [name, text] : values_) {
    if (text.find("var(") != std::string::npos) return name + ": " + text;
    if (moving_properties().count(name) && !is_idle(name, word(name))) return name;
    if (has_size && size_properties().count(name) && !is_idle(name, word(name)) && !says_the_same(element, name, text))
      return name;
  }
  return "";
}

bool is_svg_shape(const std::string& name) {
  static const std::set<std::string> shapes{"path", "rect", "circle", "ellipse", "polygon", "polyline", "line"};
  return shapes.count(name) != 0;
}

}  // namespace taut::drawing
