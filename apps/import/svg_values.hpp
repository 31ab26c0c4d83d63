// What attributes of SVG say: numbers, lengths, transformations, styles.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "import/affine.hpp"
#include "import/xml_reader.hpp"

namespace taut::drawing {

/// Numbers with commas or spaces between them, as far as there are any.
class NumberScanner {
 public:
  explicit NumberScanner(const std::string& text) : text_(text) {}
  /// The next number, which is finite; nothing if there is none.
  std::optional<double> number();
  /// The next letter or bracket; 0 if a number follows, or nothing.
  char letter();
  bool at_end();
  std::size_t position() const { return position_; }

 private:
  void skip();
  const std::string& text_;
  std::size_t position_ = 0;
};

/// A length with its unit in small letters: "12.5mm".
struct Length {
  double value = 0;
  std::string unit;
};
std::optional<Length> parse_length(const std::string& text);
/// How many millimetres the unit has; nothing for pixels, percent and font sizes.
std::optional<double> millimetres(const std::string& unit);

/// The size that lengths in percent refer to, in the user's own units; NaN where it is not known.
struct Viewport {
  double width = std::numeric_limits<double>::quiet_NaN();
  double height = std::numeric_limits<double>::quiet_NaN();
};

/// The value of an attribute as a length in the user's own units, or `otherwise`, also for "auto"; NaN if it is in
/// percent of what is not known. Throws InputError for units like em.
double user_length(const XmlElement& element, const char* key, const Viewport& viewport, double otherwise);

/// No colour, or one that lets everything through: rgba(0, 0, 0, 0), #0000, #00000000.
bool is_see_through(const std::string& fill);

/// The attribute `transform`. Throws InputError.
Affine parse_transform(const XmlElement& element);

/// Without the spaces around it.
std::string trimmed_text(const std::string& s);

}  // namespace taut::drawing
