#include "io/number_text.hpp"

#include <fmt/format.h>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <system_error>

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

std::string heights_text(const Layers& z) {
  if (z == Layers{}) return "all layers";
  const auto end = [](double height) { return std::isfinite(height) ? number_text(height) : std::string(); };
  return "z " + end(z.lo) + ".." + end(z.hi);
}

}  // namespace taut::internal::io
