// Styles of SVG: as far as they say what is part of a body.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "import/drawing.hpp"
#include "import/xml_reader.hpp"

namespace taut::drawing {

/// The rules of a drawing's style sheets. Selectors are names, classes, ids, and these written together; other ones,
/// and properties by which a sheet would move shapes, are told where they would matter.
class StyleSheet {
 public:
  /// Adds the rules of one <style> element. Throws InputError where there are too many.
  void read(const std::string& css, const XmlElement& style, Drawing& drawing);

  /// The property of an element by itself, as the cascade has it: its attribute `style`, rules, its attribute of that
  /// name; empty if none of them says anything. Of "fill", "fill-rule", "stroke", "display" and "visibility".
  std::string property(const XmlElement& element, const std::string& name) const;

 private:
  struct Value {
    std::string text;
    bool important = false;
  };
  struct Rule {
    std::string name, id;
    std::vector<std::string> classes;
    std::map<std::string, Value> values;
    int weight = 0;  ///< ids before classes before names

    bool fits(const XmlElement& element) const;
  };
  /// A declaration, and by what it outdoes others.
  struct Found {
    const Value* value = nullptr;
    int weight = -1;
  };

  static bool read_selector(const std::string& text, Rule& rule);
  std::map<std::string, Value> read_declarations(const std::string& text, const XmlElement& style,
                                                 Drawing& drawing) const;
  void add(const std::string& selectors, const std::map<std::string, Value>& values, const XmlElement& style,
           Drawing& drawing);
  Found find(const XmlElement& element, const std::string& name) const;

  std::vector<Rule> rules_;  ///< later ones outdo earlier ones of the same weight
};

/// What an element's attribute `style` says about where and what it is, and is not read: "transform", say; or empty.
std::string unread_in_style(const XmlElement& element);

}  // namespace taut::drawing
