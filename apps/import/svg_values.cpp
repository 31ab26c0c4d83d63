#include "import/svg_values.hpp"

#include <cctype>
#include <cmath>
#include <utility>

#include "io/number_text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

bool is_gap(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }

/// One function of a `transform`; nothing if it is not one.
std::optional<Affine> transformation(const std::string& name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return translation(v[0], n == 2 ? v[1] : 0);
  if (name == "scale" && (n == 1 || n == 2)) return scaling(v[0], n == 2 ? v[1] : v[0]);
  if (name == "rotate" && n == 1) return rotation(v[0]);
  if (name == "rotate" && n == 3) return translation(v[1], v[2]) * rotation(v[0]) * translation(-v[1], -v[2]);
  constexpr double degree = 3.14159265358979323846 / 180;
  if (name == "skewX" && n == 1) return Affine{1, 0, std::tan(v[0] * degree), 1, 0, 0};
  if (name == "skewY" && n == 1) return Affine{1, std::tan(v[0] * degree), 0, 1, 0, 0};
  return std::nullopt;
}

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

Affine parse_transform(const XmlElement& element) {
  const std::string* text = element.find("transform");
  Affine result;
  if (!text) return result;
  NumberScanner scanner(*text);
  while (!scanner.at_end()) {
    std::string name;
    char c;
    while ((c = scanner.letter()) != 0 && c != '(' && c != ')') name += c;
    std::vector<double> values;
    while (const auto value = c == '(' && values.size() < 6 ? scanner.number() : std::nullopt) values.push_back(*value);
    const auto step = transformation(name, values);
    if (!step || scanner.letter() != ')') {
      throw InputError(element.place, "transform=\"" + io::excerpt(*text) + "\" cannot be read",
                       "write matrix(a b c d e f), translate(x y), scale(x y), rotate(a x y), skewX(a) or skewY(a)");
    }
    result = result * *step;
  }
  return result;
}

}  // namespace taut::drawing
