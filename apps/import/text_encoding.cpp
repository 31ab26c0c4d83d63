#include "import/text_encoding.hpp"

#include <cstddef>
#include <optional>

#include "io/platform.hpp"
#include "io/text_file.hpp"

namespace taut::drawing {

namespace {

const char* const replacement = "\xEF\xBF\xBD";

/// How many bytes the character at i has; 0 if there is none.
std::size_t utf8_length(const std::string& s, std::size_t i) {
  const auto byte = [&s](std::size_t k) { return k < s.size() ? static_cast<unsigned char>(s[k]) : 0u; };
  const unsigned c = byte(i);
  if (c < 0x80) return 1;
  const std::size_t n = c >= 0xC2 && c < 0xE0 ? 2 : c >= 0xE0 && c < 0xF0 ? 3 : c >= 0xF0 && c < 0xF5 ? 4 : 0;
  for (std::size_t k = 1; k < n; ++k)
    if ((byte(i + k) & 0xC0) != 0x80) return 0;
  // Spelled too long, surrogates, and beyond Unicode.
  const unsigned second = byte(i + 1);
  if ((c == 0xE0 && second < 0xA0) || (c == 0xED && second > 0x9F)) return 0;
  if ((c == 0xF0 && second < 0x90) || (c == 0xF4 && second > 0x8F)) return 0;
  return n;
}

std::string valid_part(const std::string& text) {
  std::string s;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = utf8_length(text, i);
    s += n == 0 ? replacement : text.substr(i, n);
    i += n == 0 ? 1 : n;
  }
  return s;
}

/// Of characters below U+0800.
unsigned small_letter(unsigned c) {
  const auto within = [c](unsigned first, unsigned last) { return c >= first && c <= last; };
  if (within('A', 'Z') || (within(0xC0, 0xDE) && c != 0xD7) || within(0x391, 0x3A9) || within(0x410, 0x42F))
    return c + 0x20;
  if (within(0x400, 0x40F)) return c + 0x50;
  // Letters that come in pairs, the capital first.
  if (within(0x100, 0x137) || within(0x14A, 0x177) || within(0x460, 0x481) || within(0x48A, 0x4BF)) return c | 1u;
  if (within(0x139, 0x148) || within(0x179, 0x17E)) return c + (c & 1u);
  return c;
}

}  // namespace

std::string folded_case(const std::string& utf8) {
  std::string s;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = static_cast<unsigned char>(utf8[i]);
    if (byte < 0x80) {
      s += utf8_of(small_letter(byte));
    } else if ((byte & 0xE0) == 0xC0 && i + 1 < utf8.size()) {
      const auto second = static_cast<unsigned char>(utf8[++i]);
      s += utf8_of(small_letter((byte & 0x1Fu) << 6 | (second & 0x3Fu)));
    } else {
      s += utf8[i];
    }
  }
  return s;
}

bool is_utf8(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = utf8_length(text, i);
    if (n == 0) return false;
    i += n;
  }
  return true;
}

std::string to_utf8(const std::string& text, const std::string& encoding) {
  const std::optional<std::string> known = internal::io::decoded(text, encoding);
  return valid_part(known ? *known : text);
}

void to_plain_utf8(std::string& text) {
  const auto byte = [&text](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  if (text.size() >= 2) {
    const bool marked = (byte(0) == 0xFF && byte(1) == 0xFE) || (byte(0) == 0xFE && byte(1) == 0xFF);
    // Without a mark: the first character of all that is read is in ASCII.
    if (marked)
      text = to_utf8(text, "UTF-16");
    else if (byte(0) != 0 && byte(1) == 0)
      text = to_utf8(text, "UTF-16LE");
    else if (byte(0) == 0 && byte(1) != 0)
      text = to_utf8(text, "UTF-16BE");
  }
  internal::io::drop_byte_order_mark(text);
}

std::string utf8_of(unsigned long c) {
  std::string s;
  if (c < 0x80) return std::string(1, static_cast<char>(c));
  if (c < 0x800) return {static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 0x3F))};
  if (c < 0x10000) s += static_cast<char>(0xE0 | (c >> 12));
  if (c >= 0x10000) {
    s += static_cast<char>(0xF0 | (c >> 18));
    s += static_cast<char>(0x80 | ((c >> 12) & 0x3F));
  }
  s += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
  return s + static_cast<char>(0x80 | (c & 0x3F));
}

}  // namespace taut::drawing
