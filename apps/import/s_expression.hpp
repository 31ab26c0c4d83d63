// Nested lists in brackets, as KiCad writes its files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::drawing {

/// A word, or a list whose first word is its name.
struct SExpression {
  std::string word;  ///< of a list, its name
  bool list = false;
  std::vector<SExpression> items;  ///< behind the name
  std::size_t offset = 0;          ///< in the text

  /// The first list of this name among the items; null if there is none.
  const SExpression* find(const std::string& name) const;
  /// Item i as a number; nothing if it is none.
  std::optional<double> number(std::size_t i) const;
  /// The first two items of the list called `name`, as a point.
  std::optional<Point> point(const std::string& name) const;
  /// The first item of the list called `name`; empty if there is none.
  std::string text(const std::string& name) const;
};

/// The one list in a text. Throws InputError.
SExpression parse_s_expression(const std::string& text, const std::string& file);

}  // namespace taut::drawing
