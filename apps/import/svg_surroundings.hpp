// What surrounds an element of SVG: where it is placed, how it is painted, and what frames it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "import/affine.hpp"
#include "import/drawing.hpp"
#include "import/svg_clip.hpp"
#include "import/svg_styles.hpp"
#include "import/svg_values.hpp"
#include "import/xml_tree.hpp"

namespace taut::drawing {

/// What an element hands down to those inside it.
struct Surroundings {
  Affine where;
  Viewport viewport;
  std::vector<Frame> frames;
  bool nested = false;  ///< in a drawing in the drawing, or a symbol
  bool filled = true, displayed = true, hidden = false;
  bool stroked = false, clear_filling = false, clear_line = false, no_width = false;
  std::shared_ptr<const Variables> variables = nullptr;
  std::string color;  ///< of the line, or else of the filling
  Fill fill = Fill::nonzero;
  int layer = -1;
  int clones = 0;  ///< how many <use> it is within

  bool paints_filling() const { return filled && !clear_filling; }
  bool paints_line() const { return stroked && !clear_line && !no_width; }
};

/// Reads what elements say to those inside them. What is not obeyed is a lost shape of the drawing.
class SurroundingsReader {
 public:
  SurroundingsReader(const XmlTree& xml, const StyleSheet& styles, Drawing& drawing)
      : xml_(xml), styles_(styles), drawing_(drawing) {}

  /// What surrounds those within the element, which itself is within `around`. The outermost element makes a layer.
  /// `named`: by which the layer is called where the element itself has no name.
  Surroundings inside(std::size_t node, Surroundings around, bool group, const XmlElement* named = nullptr);

 private:
  std::string paint_of(const ElementStyle& style, const char* name) const;
  void paint(const ElementStyle& style, Surroundings& s) const;
  void tell_what_is_not_read(const XmlElement& element, const ElementStyle& style);
  Affine placement(std::size_t node, const ElementStyle& style, const Viewport& viewport);
  void clip(const XmlElement& element, const ElementStyle& style, Surroundings& s);

  const XmlTree& xml_;
  const StyleSheet& styles_;
  Drawing& drawing_;
};

/// The label of a group, or else the element's id; empty if it has neither.
std::string svg_name_of(const XmlElement& element, bool group);

}  // namespace taut::drawing
