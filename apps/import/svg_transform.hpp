// Where attributes and styles of SVG place an element.
#pragma once

#include <optional>
#include <string>

#include "import/affine.hpp"
#include "import/svg_styles.hpp"
#include "import/svg_values.hpp"

namespace taut::drawing {

/// The functions of a `transform`, also as style sheets write them: "rotate(90deg) translateX(1in)". Nothing where it
/// has something else, or lengths in percent.
std::optional<Affine> transform_of(const std::string& text);

/// How the element is placed by its `transform`, `translate`, `rotate` and `scale` about its `transform-origin`, which
/// is in the viewport, or in the box of the element, which is not known here. Nothing where that is not read; `unread`
/// is then the property.
std::optional<Affine> placement_of(const ElementStyle& style, const Viewport& viewport, std::string& unread);

}  // namespace taut::drawing
