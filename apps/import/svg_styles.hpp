// Styles of SVG: as far as they say what is part of a body.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "import/css_selectors.hpp"
#include "import/drawing.hpp"
#include "import/xml_tree.hpp"

namespace taut::drawing {

/// Custom properties, "--cut", and what they say.
using Variables = std::map<std::string, std::string>;

/// The properties of an element by itself, as the cascade has them.
class ElementStyle {
 public:
  /// As it is written; empty if nothing is said.
  std::string text(const std::string& name) const;
  /// In small letters: the words of style sheets are the same in capitals. Empty if the element takes over what
  /// surrounds it.
  std::string word(const std::string& name) const;
  /// A number or a percentage that is 0.
  bool is_zero(const std::string& name) const;
  /// Replaces var(--name) by what the element, or what surrounds it, says. `around` becomes what is within the element.
  void take_variables(std::shared_ptr<const Variables>& around);
  /// What the style says about where and what the element is, and is not read: "transform", say; or empty.
  std::string unread(const XmlElement& element) const;

 private:
  friend class StyleSheet;
  std::map<std::string, std::string> values_;
};

/// The rules of a drawing's style sheets. What is not read of them, and may change a shape, is a lost shape.
class StyleSheet {
 public:
  explicit StyleSheet(const XmlTree& xml) : xml_(xml) {}

  /// Adds the rules of one <style> element. Throws InputError where there are too many.
  void read(const std::string& css, const XmlElement& style, Drawing& drawing);

  /// From the element's attribute `style`, the rules that match it, and its attributes of the properties' names.
  ElementStyle style_of(std::size_t node) const;

 private:
  struct Value {
    std::string text;
    bool important = false;
  };
  using Values = std::map<std::string, Value>;
  struct Rule {
    Selector selector;
    Values values;
  };

  void read_rules(const std::string& css, const XmlElement& style, Drawing& drawing);
  void read_at_rule(const std::string& head, const std::string& block, const XmlElement& style, Drawing& drawing);
  static Values read_declarations(const std::string& text);
  void add(const std::string& selectors, const Values& values, const XmlElement& style, Drawing& drawing);
  bool may_change_shapes(const Selector& selector) const;

  const XmlTree& xml_;
  std::vector<Rule> rules_;  ///< later ones outdo earlier ones of the same specificity
};

/// path, rect, circle, ellipse, polygon, polyline and line.
bool is_svg_shape(const std::string& name);

}  // namespace taut::drawing
