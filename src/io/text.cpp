#include "io/text.hpp"

#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include <fmt/format.h>

namespace taut::internal::io {
namespace {

bool digit_at(const std::string& text, std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; }

/// End of [+-] digits [. digits] [e [+-] digits] with at least one digit before the exponent, else `begin`.
std::size_t end_of_number(const std::string& text, std::size_t begin) {
  std::size_t i = begin;
  bool digits = false;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  for (; digit_at(text, i); ++i) digits = true;
  if (i < text.size() && text[i] == '.') ++i;
  for (; digit_at(text, i); ++i) digits = true;
  if (!digits) return begin;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t j = i + 1;
    if (j < text.size() && (text[j] == '+' || text[j] == '-')) ++j;
    if (digit_at(text, j)) {
      while (digit_at(text, j)) ++j;
      i = j;
    }
  }
  return i;
}

}  // namespace

std::string instant_text(double t, double start, double end, int usual) {
  constexpr int most = 17;
  const double whole = end - start;
  int digits = usual;
  for (double size = std::fabs(t); whole > 0 && size > 10 * whole && digits < most; size /= 10) ++digits;
  return fmt::format("{:.{}g}", t, digits);
}

std::string number_text(double value) {
  // "-0" is an integer to most JSON readers, which lose its sign.
  if (value == 0) return std::signbit(value) ? "-0.0" : "0";
  return fmt::format("{}", value);
}

std::optional<double> scan_number(const std::string& text, std::size_t* position) {
  const std::size_t end = end_of_number(text, *position);
  if (end == *position) return std::nullopt;
  const std::size_t start = *position;
  *position = end;
#ifdef __cpp_lib_to_chars
  double value = 0;
  // Of numbers that are too large or too small it gives none.
  const char* const first = text.data() + start + (text[start] == '+' ? 1 : 0);
  if (std::from_chars(first, text.data() + end, value).ec == std::errc()) return value;
#endif
  // strtod obeys the locale, and std::from_chars for doubles is missing in the browser build.
  std::string number = text.substr(start, end - start);
  const std::size_t point = number.find('.');
  if (point != std::string::npos) number.replace(point, 1, std::localeconv()->decimal_point);
  return std::strtod(number.c_str(), nullptr);
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string s = "\"";
  for (const char c : text) s += c == '"' ? std::string("\"\"") : std::string(1, c);
  return s + "\"";
}

std::string counted(std::size_t n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many.empty() ? one + "s" : many);
}

std::string heights_text(const Layers& z) {
  if (z == Layers{}) return "all layers";
  const auto end = [](double height) { return std::isfinite(height) ? number_text(height) : std::string(); };
  return "z " + end(z.lo) + ".." + end(z.hi);
}

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
