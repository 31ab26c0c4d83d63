// Selectors of style sheets, as far as drawings have them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "import/xml_tree.hpp"

namespace taut::drawing {

/// "[name]", or "[name=value]" with another mark before the equals sign.
struct AttributeTest {
  std::string name, value;
  char mark = 0;  ///< 0: the attribute exists; '=': it is the value; or one of ~ | ^ $ *
  bool any_case = false;
};

/// What is said of one element, without combinators: "rect.cut:not(#frame)".
struct CompoundSelector {
  std::string name;  ///< empty for every name
  std::vector<std::string> ids, classes;
  std::vector<AttributeTest> attributes;
  std::vector<CompoundSelector> none_of;  ///< the arguments of :not
  bool root = false, first = false, last = false;
  bool never = false;  ///< a state that a picture at rest does not have, or a part that is no element: :hover, ::before
};

/// Ids before classes and attributes before names.
using Specificity = std::array<int, 3>;

struct Selector {
  struct Step {
    CompoundSelector compound;
    char combinator = 0;  ///< between the step before and this one: ' ', '>', '+' or '~'
  };
  std::vector<Step> steps;
  Specificity specificity{};
  /// Not read, so that `steps` may match too much: ":nth-child(2)", say. Empty if all of it was read.
  std::string unread;
};

/// A list of selectors. Where the text is none, there is one selector, which is unread and matches everything.
std::vector<Selector> parse_selectors(const std::string& text);

/// Does the selector match the element? What was not read of it is taken for true.
bool matches(const Selector& selector, const XmlTree& xml, std::size_t node);

}  // namespace taut::drawing
