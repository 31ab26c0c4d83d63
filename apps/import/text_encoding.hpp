// Names in drawings, as UTF-8.
#pragma once

#include <string>

namespace taut::drawing {

bool is_utf8(const std::string& text);

/// The text in UTF-8, from an encoding that the system knows, such as CP1252. What is not in that encoding becomes
/// U+FFFD. Of one that is not known, all but ASCII does so.
std::string to_utf8(const std::string& text, const std::string& encoding);

/// In small letters, as far as they are Latin, Greek or Cyrillic: to compare names.
std::string folded_case(const std::string& utf8);

/// Without a byte order mark, and what is UTF-16 as UTF-8.
void to_plain_utf8(std::string& text);

/// A character as UTF-8.
std::string utf8_of(unsigned long character);

}  // namespace taut::drawing
