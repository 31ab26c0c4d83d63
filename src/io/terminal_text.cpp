#include "io/terminal_text.hpp"

#include <cstdio>

namespace taut::internal::io {
namespace {

std::string escaped(const std::string& text, bool keep_line_breaks) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    const auto character = next_character(text, at);
    const bool line_break = keep_line_breaks && character == U'\n';
    if (character && (line_break || !is_hidden(*character))) {
      out.append(text, begin, at - begin);
      continue;
    }
    char code[16];
    if (character) {
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(*character));
    } else {
      std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(text[begin])));
    }
    out += code;
  }
  return out;
}

}  // namespace

std::optional<char32_t> next_character(const std::string& text, std::size_t& at) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at++);
  if (first < 0x80) return first;
  const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
  if (first < 0xC2 || first > 0xF4 || text.size() - at < more) return std::nullopt;
  char32_t character = first & (0x3Fu >> more);
  for (std::size_t k = 0; k < more; ++k) {
    if ((byte(at + k) & 0xC0) != 0x80) return std::nullopt;
    character = character << 6 | (byte(at + k) & 0x3Fu);
  }
  // Longer than need be, half of a pair, or beyond the last character.
  const char32_t least = more == 3 ? 0x10000 : more == 2 ? 0x800 : 0x80;
  if (character < least || (character >= 0xD800 && character < 0xE000) || character > 0x10FFFF) return std::nullopt;
  at += more;
  return character;
}

bool is_hidden(char32_t c) {
  const auto within = [c](char32_t first, char32_t last) { return first <= c && c <= last; };
  return c < 0x20 || within(0x7F, 0x9F) ||                               // control characters
         c == 0x61C || within(0x200E, 0x200F) || within(0x202A, 0x202E)  // direction of writing
         || within(0x2066, 0x2069) || within(0x2028, 0x2029);            // the same; lines and paragraphs
}

std::string for_terminal(const std::string& text) { return escaped(text, true); }
std::string line_for_terminal(const std::string& text) { return escaped(text, false); }

std::string for_terminal(const InputError& error) {
  std::string text = error.place().empty() ? "" : line_for_terminal(error.place()) + ": ";
  text += line_for_terminal(error.problem());
  if (!error.hint().empty()) text += "\nhint: " + line_for_terminal(error.hint());
  return text;
}

}  // namespace taut::internal::io
