// The sizes that SVG gives to what is drawn: pages, drawings in drawings, symbols.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "import/affine.hpp"
#include "import/svg_values.hpp"

namespace taut::drawing {

/// The attribute `viewBox`: the part of the user's own plane that is to be seen.
struct ViewBox {
  double x = 0, y = 0, width = 0, height = 0;
};

/// Nothing if there is none. Throws InputError.
std::optional<ViewBox> view_box_of(const XmlElement& element);

/// How the box comes to lie in a viewport at the origin, by the element's preserveAspectRatio. Throws InputError.
Affine fitted(const ViewBox& box, const Viewport& viewport, const XmlElement& element);

/// What the outermost element says about lengths.
struct Page {
  double across = 1, up = 1;  ///< how long the user's units are: in millimetres, if the page has a size
  bool physical = false;      ///< has the page a size in millimetres?
  Viewport viewport;
  std::string units;  ///< for people
  std::string note;   ///< of what cannot be obeyed; or empty
};
Page page_of(const XmlElement& root);

}  // namespace taut::drawing
