#include "import/svg_values.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "import/svg_transform.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

bool is_gap(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// A hundredth of what the attribute's percentages refer to; of lengths in any direction, that is a mean.
double percent_of(const std::string& key, const Viewport& viewport) {
  const double w = viewport.width / 100, h = viewport.height / 100;
  if (key == "r") return std::sqrt((w * w + h * h) / 2);
  return key == "height" || key.find('y') != std::string::npos ? h : w;
}

}  // namespace

std::string trimmed_text(const std::string& s) {
  std::size_t a = 0, b = s.size();
  while (a < b && is_gap(s[a])) ++a;
  while (b > a && is_gap(s[b - 1])) --b;
  return s.substr(a, b - a);
}

void NumberScanner::skip() {
  while (position_ < text_.size() && (is_gap(text_[position_]) || text_[position_] == ',')) ++position_;
}

std::optional<double> NumberScanner::number() {
  skip();
  const std::size_t start = position_;
  const auto value = io::scan_number(text_, &position_);
  if (value && std::isfinite(*value)) return value;
  position_ = start;
  return std::nullopt;
}

char NumberScanner::letter() {
  skip();
  if (position_ >= text_.size()) return 0;
  const char c = text_[position_];
  if (!std::isalpha(static_cast<unsigned char>(c)) && c != '(' && c != ')') return 0;
  ++position_;
  return c;
}

bool NumberScanner::at_end() {
  skip();
  return position_ == text_.size();
}

std::optional<Length> parse_length(const std::string& text) {
  const std::string s = trimmed_text(text);
  std::size_t position = 0;
  const auto value = io::scan_number(s, &position);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  std::string unit = trimmed_text(s.substr(position));
  for (char& c : unit) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return Length{*value, std::move(unit)};
}

std::optional<double> millimetres(const std::string& unit) {
  if (unit == "mm") return 1;
  if (unit == "cm") return 10;
  if (unit == "in") return 25.4;
  if (unit == "pt") return 25.4 / 72;
  if (unit == "pc") return 25.4 / 6;
  if (unit == "q") return 0.25;
  return std::nullopt;
}

double user_length(const XmlElement& element, const char* key, const Viewport& viewport, double otherwise) {
  const std::string* text = element.find(key);
  if (!text || trimmed_text(*text) == "auto") return otherwise;
  const auto length = parse_length(*text);
  if (length && (length->unit.empty() || length->unit == "px")) return length->value;
  // A user's unit is a pixel where nothing else is said: 96 to the inch.
  if (length && millimetres(length->unit)) return length->value * *millimetres(length->unit) * (96 / 25.4);
  if (length && length->unit == "%") return length->value * percent_of(key, viewport);
  throw InputError(element.place, std::string(key) + "=\"" + io::excerpt(*text) + "\" is no length",
                   "write a number, in the drawing's own units");
}

bool is_see_through(const std::string& fill) {
  if (fill == "none" || fill == "transparent") return true;
  if (fill.starts_with('#')) {
    return (fill.size() == 5 && fill.back() == '0') || (fill.size() == 9 && fill.ends_with("00"));
  }
  // "rgba(0, 0, 0, 0)", or "rgb(0 0 0 / 0%)", and so for other functions: the fourth value, or what is behind a slash.
  const std::size_t open = fill.find('('), slash = fill.find('/');
  if (open == std::string::npos || fill.starts_with("url(")) return false;
  if (slash == std::string::npos && std::count(fill.begin(), fill.end(), ',') != 3) return false;
  const std::string alpha = fill.substr(slash == std::string::npos ? fill.rfind(',') + 1 : slash + 1);
  return !alpha.empty() && alpha.find_first_not_of(" 0.%)") == std::string::npos &&
         alpha.find('0') != std::string::npos;
}

Affine parse_transform(const XmlElement& element) {
  const std::string* text = element.find("transform");
  if (!text) return {};
  if (const auto transform = transform_of(*text)) return *transform;
  throw InputError(element.place, "transform=\"" + io::excerpt(*text) + "\" cannot be read",
                   "write matrix(a b c d e f), translate(x y), scale(x y), rotate(a x y), skewX(a) or skewY(a)");
}

}  // namespace taut::drawing
