#include "draw/svg_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "io/text.hpp"

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

std::vector<double> round_numbers(double lo, double hi, int count) {
  if (!(lo < hi) || !std::isfinite(hi - lo)) return {lo};
  const double wanted = (hi - lo) / count, power = std::pow(10, std::floor(std::log10(wanted)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= wanted) step = factor * power;
  }
  std::vector<double> numbers;
  const double first = std::ceil(lo / step);
  for (int k = 0; (first + k) * step <= hi + 1e-9 * step && k <= count; ++k) numbers.push_back((first + k) * step);
  return numbers;
}

double PlotPanel::x(double t) const { return t_lo < t_hi ? left + (t - t_lo) / (t_hi - t_lo) * width : left; }
double PlotPanel::y(double v) const { return top + height - (v_lo < v_hi ? (v - v_lo) / (v_hi - v_lo) * height : 0); }

std::string chart_number(double pixels) {
  std::string s = fmt::format("{:.2f}", std::isfinite(pixels) ? pixels : 0);
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

std::string chart_text(double x, double y, const std::string& what, const char* anchor) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\">{}</text>\n", chart_number(x), chart_number(y), anchor,
                     escape_xml(what));
}

std::string PlotPanel::time_axis(const std::string& word) const {
  const double below = top + height;
  std::string s = "<g class=\"axis\">\n";
  // Late instants have long names, which must fit next to each other, and into the room that charts leave on the right.
  constexpr double digit_width = 8, room = 24;
  const double name_width = digit_width * static_cast<double>(instant_text(t_hi, t_lo, t_hi, 6).size() + 2);
  for (const double t : round_numbers(t_lo, t_hi, std::clamp(static_cast<int>(width / name_width), 2, 10))) {
    s += fmt::format("<path d=\"M{0},{1}V{2}\" stroke=\"#d9dee3\"/>\n", chart_number(x(t)), chart_number(top),
                     chart_number(below + 5));
    s += chart_text(std::min(x(t), left + width + room - name_width / 2), below + 19, instant_text(t, t_lo, t_hi, 6),
                    "middle");
  }
  s += chart_text(left + width, below + 36, word, "end");
  return s + "</g>\n";
}

std::string PlotPanel::value_axis() const {
  std::string s = "<g class=\"axis\">\n";
  for (const double v : round_numbers(v_lo, v_hi, 5)) {
    s += fmt::format("<path d=\"M{},{}H{}\" stroke=\"#d9dee3\"/>\n", chart_number(left - 5), chart_number(y(v)),
                     chart_number(left + width));
    s += chart_text(left - 9, y(v) + 4, fmt::format("{:.6g}", v), "end");
  }
  return s + "</g>\n";
}

std::string no_verdict(Outcome outcome, const std::string& reason) {
  return outcome == Outcome::untested ? reason : "undecided: " + reason;
}

std::string chart_head(double width, double height, const std::string& title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\" "
      "font-family=\"sans-serif\" font-size=\"12\" fill=\"#27303a\">\n<title>{2}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
      "<text x=\"16\" y=\"22\" font-size=\"14\" font-weight=\"bold\">{2}</text>\n",
      chart_number(width), chart_number(height), escape_xml(title));
}

}  // namespace taut::internal::io
