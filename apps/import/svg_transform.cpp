#include "import/svg_transform.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <vector>

#include "io/text.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr double degrees_of_radian = 180 / 3.14159265358979323846;

std::optional<double> plain_number(const Length& value) {
  return value.unit.empty() ? std::optional(value.value) : std::nullopt;
}

/// Of a scale, which may be in percent.
std::optional<double> factor_in(const Length& value) {
  return value.unit == "%" ? std::optional(value.value / 100) : plain_number(value);
}

std::optional<double> degrees_in(const Length& value) {
  if (value.unit.empty() || value.unit == "deg") return value.value;
  if (value.unit == "rad") return value.value * degrees_of_radian;
  if (value.unit == "turn") return value.value * 360;
  if (value.unit == "grad") return value.value * 0.9;
  return std::nullopt;
}

/// In pixels; `all` is what percentages refer to, NaN if that is not known.
std::optional<double> pixels_in(const Length& value, double all) {
  if (value.unit.empty() || value.unit == "px") return value.value;
  if (const auto unit = millimetres(value.unit)) return value.value * *unit * (96 / 25.4);
  if (value.unit == "%" && !std::isnan(all)) return value.value / 100 * all;
  return std::nullopt;
}

constexpr double unknown_size = std::numeric_limits<double>::quiet_NaN();

struct TransformFunction {
  std::string name;  ///< in small letters
  std::vector<Length> values;

  /// All values by the same rule, with as many as are given up to `most`; empty where one is not read.
  template <class Read>
  std::vector<double> read(std::size_t least, std::size_t most, const Read& read_one) const {
    std::vector<double> all;
    if (values.size() < least || values.size() > most) return all;
    for (const Length& value : values) {
      const auto number = read_one(value);
      if (!number) return {};
      all.push_back(*number);
    }
    return all;
  }
};

/// "name(1 2mm, 3)" one after the other; nothing if the text is something else.
std::optional<std::vector<TransformFunction>> functions_in(const std::string& text) {
  std::vector<TransformFunction> functions;
  std::size_t at = 0;
  const auto skip = [&] {
    while (at < text.size() && (std::isspace(static_cast<unsigned char>(text[at])) || text[at] == ',')) ++at;
  };
  const auto word = [&] {
    std::string s;
    while (at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '%'))
      s += static_cast<char>(std::tolower(static_cast<unsigned char>(text[at++])));
    return s;
  };
  for (skip(); at < text.size(); skip()) {
    TransformFunction function{word(), {}};
    skip();
    if (function.name.empty() || at >= text.size() || text[at++] != '(') return std::nullopt;
    for (skip(); at < text.size() && text[at] != ')'; skip()) {
      const auto number = io::scan_number(text, &at);
      if (!number || !std::isfinite(*number)) return std::nullopt;
      function.values.push_back({*number, word()});
    }
    if (at++ >= text.size()) return std::nullopt;
    functions.push_back(std::move(function));
  }
  return functions;
}

std::optional<Affine> rotated(const TransformFunction& f) {
  if (f.values.empty() || (f.values.size() != 1 && f.values.size() != 3)) return std::nullopt;
  const auto angle = degrees_in(f.values[0]);
  if (!angle) return std::nullopt;
  if (f.values.size() == 1) return rotation(*angle);
  const auto x = pixels_in(f.values[1], unknown_size), y = pixels_in(f.values[2], unknown_size);
  if (!x || !y) return std::nullopt;
  return translation(*x, *y) * rotation(*angle) * translation(-*x, -*y);
}

std::optional<Affine> skewed(const TransformFunction& f) {
  const std::vector<double> v = f.read(1, f.name == "skew" ? 2 : 1, degrees_in);
  if (v.empty()) return std::nullopt;
  const double x = f.name == "skewy" ? 0 : v[0], y = f.name == "skewy" ? v[0] : v.size() > 1 ? v[1] : 0;
  return Affine{1, std::tan(y / degrees_of_radian), std::tan(x / degrees_of_radian), 1, 0, 0};
}

std::optional<Affine> transformation_by(const TransformFunction& f) {
  const std::string& name = f.name;
  if (name == "rotate") return rotated(f);
  if (name == "skewx" || name == "skewy" || name == "skew") return skewed(f);
  if (name == "matrix") {
    const std::vector<double> v = f.read(6, 6, plain_number);
    return v.empty() ? std::nullopt : std::optional(Affine{v[0], v[1], v[2], v[3], v[4], v[5]});
  }
  const bool one = name.ends_with("x") || name.ends_with("y"), up = name.ends_with("y");
  if (name == "scale" || name == "scalex" || name == "scaley") {
    const std::vector<double> v = f.read(1, one ? 1 : 2, factor_in);
    if (v.empty()) return std::nullopt;
    return one ? scaling(up ? 1 : v[0], up ? v[0] : 1) : scaling(v[0], v.size() > 1 ? v[1] : v[0]);
  }
  if (name == "translate" || name == "translatex" || name == "translatey") {
    const auto length = [](const Length& value) { return pixels_in(value, unknown_size); };
    const std::vector<double> v = f.read(1, one ? 1 : 2, length);
    if (v.empty()) return std::nullopt;
    return one ? translation(up ? 0 : v[0], up ? v[0] : 0) : translation(v[0], v.size() > 1 ? v[1] : 0);
  }
  return std::nullopt;
}

/// The values of a property, of which the first `most` count; nothing if one is no number.
std::optional<std::vector<Length>> values_in(const std::string& text, std::size_t most) {
  std::istringstream words(text);
  std::vector<Length> values;
  for (std::string word; words >> word;) {
    const auto value = parse_length(word);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  if (values.empty() || values.size() > most) return std::nullopt;
  return values;
}

/// By one of the properties translate, rotate and scale.
std::optional<Affine> placed_by(const std::string& property, const std::string& text, const Viewport& viewport) {
  const auto values = values_in(text, property == "rotate" ? 1 : 2);
  if (!values) return std::nullopt;
  const Length &first = values->front(), &last = values->back();
  if (property == "rotate") {
    const auto angle = degrees_in(first);
    return angle ? std::optional(rotation(*angle)) : std::nullopt;
  }
  const bool scale = property == "scale";
  const auto x = scale ? factor_in(first) : pixels_in(first, viewport.width);
  const auto y = scale ? factor_in(last) : values->size() > 1 ? pixels_in(last, viewport.height) : std::optional(0.0);
  if (!x || !y) return std::nullopt;
  return scale ? scaling(*x, *y) : translation(*x, *y);
}

/// A `transform-origin`: "left top", "50% 20px", "center".
std::optional<Point> origin_of(const std::string& text, const Viewport& viewport) {
  if (text.empty() || text == "initial") return Point{0, 0};
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  // A third one is a depth.
  if (words.size() == 3) words.pop_back();
  if (words.size() == 1) words.push_back("center");
  if (words.size() != 2) return std::nullopt;
  const auto is = [](const std::string& word, const char* a, const char* b) { return word == a || word == b; };
  if (is(words[0], "top", "bottom") || is(words[1], "left", "right")) std::swap(words[0], words[1]);
  const auto place = [](const std::string& word, const char* low, const char* high, double all) {
    const auto value = word == "center" ? Length{50, "%"} : word == low ? Length{0, "%"} : Length{100, "%"};
    if (word == "center" || word == low || word == high) return pixels_in(value, all);
    const auto given = parse_length(word);
    return given ? pixels_in(*given, all) : std::nullopt;
  };
  const auto x = place(words[0], "left", "right", viewport.width),
             y = place(words[1], "top", "bottom", viewport.height);
  if (!x || !y) return std::nullopt;
  return Point{*x, *y};
}

}  // namespace

std::optional<Affine> transform_of(const std::string& text) {
  const auto functions = functions_in(text);
  if (!functions) return std::nullopt;
  Affine result;
  for (const TransformFunction& function : *functions) {
    const auto step = transformation_by(function);
    if (!step) return std::nullopt;
    result = result * *step;
  }
  return result;
}

std::optional<Affine> placement_of(const ElementStyle& style, const Viewport& viewport, std::string& unread) {
  const auto is_said = [&style](const char* property) {
    const std::string word = style.word(property);
    return !word.empty() && word != "none" && word != "initial";
  };
  Affine result;
  bool any = false;
  for (const char* property : {"translate", "rotate", "scale", "transform"}) {
    if (!is_said(property)) continue;
    const bool functions = property == std::string("transform");
    const auto step =
        functions ? transform_of(style.text(property)) : placed_by(property, style.word(property), viewport);
    if (!step) {
      unread = property;
      return std::nullopt;
    }
    result = result * *step;
    any = true;
  }
  if (!any) return result;
  const std::string box = style.word("transform-box");
  if (!box.empty() && box != "view-box" && box != "initial") {
    unread = "transform-box";
    return std::nullopt;
  }
  const auto origin = origin_of(style.word("transform-origin"), viewport);
  if (!origin) {
    unread = "transform-origin";
    return std::nullopt;
  }
  // At the origin itself there is nothing to round.
  if (origin->x == 0 && origin->y == 0) return result;
  return translation(origin->x, origin->y) * result * translation(-origin->x, -origin->y);
}

}  // namespace taut::drawing
