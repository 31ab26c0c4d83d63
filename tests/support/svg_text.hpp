// Looking into pictures: enough of XML for what we write.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace taut::testing {

/// Tags nest, attributes are quoted, nothing forbidden stands between. Enough XML for what we write.
inline ::testing::AssertionResult well_formed(const std::string& s) {
  std::vector<std::string> open;
  std::size_t i = 0;
  while (i < s.size()) {
    if (s[i] != '<') {
      if (s[i] == '&' && s.find(';', i) > i + 6) return ::testing::AssertionFailure() << "bare & at " << i;
      if (s[i] == '>') return ::testing::AssertionFailure() << "bare > at " << i;
      ++i;
      continue;
    }
    const std::size_t end = s.find('>', i);
    if (end == s.npos) return ::testing::AssertionFailure() << "tag without end";
    const std::string tag = s.substr(i + 1, end - i - 1);
    if (tag.find('<') != tag.npos) return ::testing::AssertionFailure() << "< in tag " << tag;
    const std::string name = tag.substr(tag[0] == '/', tag.find_first_of(" /", 1) - (tag[0] == '/'));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return ::testing::AssertionFailure() << "unexpected " << tag;
      open.pop_back();
    } else {
      if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return ::testing::AssertionFailure() << "quotes in " << tag;
      if (tag.back() != '/') open.push_back(tag.substr(0, tag.find(' ')));
    }
    i = end + 1;
  }
  if (!open.empty()) return ::testing::AssertionFailure() << open.back() << " is not closed";
  return ::testing::AssertionSuccess();
}

inline std::size_t count(const std::string& s, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t i = s.find(part); i != s.npos; i = s.find(part, i + part.size())) ++n;
  return n;
}

inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// The attributes of all elements <animate...>.
inline std::vector<std::string> animations(const std::string& svg) {
  std::vector<std::string> all;
  for (std::size_t i = svg.find("<animate"); i != svg.npos; i = svg.find("<animate", i + 1))
    all.push_back(svg.substr(i, svg.find("/>", i) - i));
  return all;
}

inline std::string attribute(const std::string& element, const std::string& name) {
  const std::size_t begin = element.find(" " + name + "=\"");
  if (begin == element.npos) return "";
  const std::size_t value = begin + name.size() + 3;
  return element.substr(value, element.find('"', value) - value);
}

}  // namespace taut::testing
