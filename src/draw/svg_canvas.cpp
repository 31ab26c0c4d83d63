#include "draw/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/terminal_text.hpp"

namespace taut::internal::io {

namespace {

/// "12.50" as "12.5", "3.00" as "3", "-0.00" as "0".
std::string short_decimal(double value) {
  if (!std::isfinite(value)) value = 0;
  std::string s = fmt::format("{:.2f}", value);
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

}  // namespace

SvgCanvas::SvgCanvas(const std::vector<Point>& points, int width, double top, double bottom) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point low{infinity, infinity}, high{-infinity, -infinity};
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  if (!(low.x <= high.x)) low = high = {0, 0};
  // Halves first: the extent of huge coordinates must not overflow.
  const double half_x = high.x / 2 - low.x / 2, half_y = high.y / 2 - low.y / 2;
  width_ = std::max(width, 200);
  const double inner_width = width_ - 2 * margin;
  const double aspect = half_x > 0 ? half_y / half_x : 1.5;
  const double inner_height = inner_width * std::clamp(aspect, 0.15, 1.5);
  height_ = std::ceil(top + inner_height + 2 * margin + bottom);
  const double fit_x = half_x > 0 ? inner_width / half_x : infinity;
  const double fit_y = half_y > 0 ? inner_height / half_y : infinity;
  scale_ = std::min(fit_x, fit_y) / 2;
  if (!std::isfinite(scale_)) scale_ = 1;
  world_centre_ = {low.x + half_x, low.y + half_y};
  pixel_centre_ = {width_ / 2, top + margin + inner_height / 2};
}

Point SvgCanvas::pixel(const Point& p) const {
  return {pixel_centre_.x + (p.x - world_centre_.x) * scale_, pixel_centre_.y - (p.y - world_centre_.y) * scale_};
}

std::string pixel_text(const Point& pixel) { return short_decimal(pixel.x) + "," + short_decimal(pixel.y); }

std::string svg_tag(double width, double height, const std::string& more) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "style=\"max-width:100%;max-height:100vh\" {2}>\n",
      width, height, more);
}

std::string outline_path(const std::vector<Point>& pixels) {
  std::string s;
  for (const Point& p : pixels) s += (s.empty() ? "M" : "L") + pixel_text(p);
  return s + "Z";
}

/// What the eye would not see, and a terminal might obey, is written so that it is seen; so are the two characters
/// besides that XML does not have.
std::string escape_xml(const std::string& raw) {
  const std::string text = for_terminal(raw);
  std::string s;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    const char32_t character = *next_character(text, at);
    switch (character) {
      case U'<':
        s += "&lt;";
        break;
      case U'>':
        s += "&gt;";
        break;
      case U'&':
        s += "&amp;";
        break;
      case U'"':
        s += "&quot;";
        break;
      case U'\'':
        s += "&#39;";
        break;
      case 0xFFFE:
      case 0xFFFF:
        s += character == 0xFFFE ? "\\ufffe" : "\\uffff";
        break;
      default:
        s.append(text, begin, at - begin);
    }
  }
  return s;
}

}  // namespace taut::internal::io
