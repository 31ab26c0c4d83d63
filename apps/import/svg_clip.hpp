// What is seen of shapes of SVG: frames of drawings in drawings, clips and masks.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "import/affine.hpp"
#include "import/drawing.hpp"
#include "import/svg_styles.hpp"
#include "import/svg_values.hpp"

namespace taut::drawing {

/// A drawing in the drawing, a symbol, or a rectangle that clips: what reaches beyond it is not seen.
struct Frame {
  Affine where;  ///< from the unit square
  std::string place, remedy;
};

std::vector<Point> corners_of(const Frame& frame);
/// The frame of a parallelogram; nothing if the chains are something else.
std::optional<Frame> frame_of(const std::vector<Chain>& chains);

/// How far a shape reaches beyond a frame.
enum class Beyond { nothing, part, all };
Beyond beyond_frame(const std::vector<Chain>& chains, const Frame& frame);

/// The id in "url(#id)"; empty if the text is something else.
std::string id_in_url(const std::string& text);

/// Of a <clipPath>, or a <mask>, that shows one rectangle; of a mask perhaps a second frame, of its region. None if it
/// is something else. `where` places what is clipped.
std::vector<Frame> clipping_frames(std::size_t node, const XmlTree& xml, const StyleSheet& styles, const Affine& where,
                                   const Viewport& viewport);

}  // namespace taut::drawing
