#include "plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/svg_canvas.hpp"

namespace taut::paper {
using namespace internal;
namespace {

/// Okabe and Ito's palette, distinguishable by the colour-blind, without its yellow.
const char* const palette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9",
                               "#e69f00", "#4d4d4d", "#8c510a", "#7b3294"};
constexpr int colours = 9;
constexpr double left = 74, right = 24, top = 44, bottom = 58, legend_row = 19;

class Scale {
 public:
  Scale(const Axis& axis, double low, double high, double from, double to) : base_(axis.base), from_(from), to_(to) {
    const double a = logarithm(low), b = logarithm(high), pad = 0.04 * std::max(b - a, 0.5);
    low_ = a - pad;
    high_ = b + pad;
  }
  double operator()(double value) const { return from_ + (logarithm(value) - low_) / (high_ - low_) * (to_ - from_); }
  /// Powers of the base within, at most about ten; between powers of ten also 2 and 5 where there is room.
  std::vector<double> ticks() const {
    std::vector<double> out;
    const int first = static_cast<int>(std::ceil(low_)), last = static_cast<int>(std::floor(high_));
    const int step = std::max(1, (last - first + 9) / 10);
    const bool sparse = base_ == 10 && high_ - low_ < 2.2;
    for (int k = first - (sparse ? 1 : 0); k <= last; ++k) {
      for (const double m : {1.0, 2.0, 5.0}) {
        if (m > 1 && !sparse) break;
        if (m == 1 && (k - first) % step != 0) continue;
        const double value = m * std::pow(base_, k), at = logarithm(value);
        if (at >= low_ && at <= high_) out.push_back(value);
      }
    }
    return out;
  }

 private:
  double logarithm(double v) const { return base_ == 2 ? std::log2(v) : std::log10(v); }
  int base_;
  double from_, to_, low_ = 0, high_ = 1;
};

std::string tick_text(double value) {
  if (value >= 1e6 || value < 1e-3) return fmt::format("{:.0e}", value);
  std::string s = fmt::format("{:.6g}", value);
  return s;
}

std::string mark(int shape, double x, double y, const char* colour) {
  switch (shape % 4) {
    case 0:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.4\" fill=\"{}\"/>", x, y, colour);
    case 1:
      return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"6.2\" height=\"6.2\" fill=\"{}\"/>", x - 3.1, y - 3.1,
                         colour);
    case 2:
      return fmt::format("<path d=\"M{:.1f} {:.1f}l4 7h-8z\" fill=\"{}\"/>", x, y - 4.5, colour);
    default:
      return fmt::format("<path d=\"M{:.1f} {:.1f}l4 4l-4 4l-4-4z\" fill=\"{}\"/>", x, y - 4, colour);
  }
}

std::string stroke(const Series& s, const char* colour) {
  return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}", colour, s.dashed ? 1.3 : 1.8,
                     s.dashed ? " stroke-dasharray=\"5 4\"" : "");
}

/// The plot's series as they are drawn: each with a colour, and without points that a logarithm does not have.
std::vector<Series> drawn_series(const Plot& plot) {
  std::vector<Series> series = plot.series;
  int next_colour = 0;
  for (Series& s : series) {
    if (s.colour < 0) s.colour = next_colour++;
    s.points.erase(
        std::remove_if(s.points.begin(), s.points.end(), [](const auto& p) { return !(p.first > 0 && p.second > 0); }),
        s.points.end());
  }
  return series;
}

/// Where points are in the picture.
struct Scales {
  Scale x, y;
};

Scales scales_of(const Plot& plot, const std::vector<Series>& series) {
  double low_x = INFINITY, high_x = 0, low_y = INFINITY, high_y = 0;
  for (const Series& s : series) {
    for (const auto& [x, y] : s.points) {
      low_x = std::min(low_x, x);
      high_x = std::max(high_x, x);
      low_y = std::min(low_y, y);
      high_y = std::max(high_y, y);
    }
  }
  if (!(low_x <= high_x)) low_x = low_y = 1, high_x = high_y = 10;
  return {Scale(plot.x, low_x, high_x, left, plot.width - right),
          Scale(plot.y, low_y, high_y, plot.height - bottom, top)};
}

/// Ticks with their lines, the axes and their labels.
std::string axes_text(const Plot& plot, const Scales& at) {
  const double h = plot.height;
  std::string out;
  for (const double v : at.x.ticks()) {
    out += fmt::format(
        "<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#e4e4e4\"/><text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\" "
        "fill=\"#444\">{4}</text>\n",
        at.x(v), top, h - bottom, h - bottom + 18, tick_text(v));
  }
  for (const double v : at.y.ticks()) {
    out += fmt::format(
        "<path d=\"M{1} {0:.1f}H{2}\" stroke=\"#e4e4e4\"/><text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\" "
        "fill=\"#444\">{5}</text>\n",
        at.y(v), left, plot.width - right, left - 8, at.y(v) + 4, tick_text(v));
  }
  out += fmt::format("<path d=\"M{0} {1}V{2}H{3}\" fill=\"none\" stroke=\"#777\"/>\n", left, top, h - bottom,
                     plot.width - right);
  out += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" text-anchor=\"middle\" fill=\"#222\">{}</text>\n",
                     (left + plot.width - right) / 2, h - 16, io::escape_xml(plot.x.label));
  out += fmt::format(
      "<text transform=\"translate(20 {:.0f}) rotate(-90)\" text-anchor=\"middle\" fill=\"#222\">{}</text>\n",
      (top + h - bottom) / 2, io::escape_xml(plot.y.label));
  return out;
}

std::string curve_text(const Series& s, const Scales& at) {
  const char* colour = palette[s.colour % colours];
  std::string out, path;
  for (const auto& [x, y] : s.points)
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", at.x(x), at.y(y));
  if (s.line && !path.empty()) out += fmt::format("<path d=\"{}\" {}/>\n", path, stroke(s, colour));
  if (s.marks) {
    for (const auto& [x, y] : s.points) out += mark(s.colour, at.x(x), at.y(y), colour);
    out += "\n";
  }
  return out;
}

/// A series' line of the legend.
std::string legend_text(const Series& s, double x, double y) {
  const char* colour = palette[s.colour % colours];
  std::string out;
  if (s.line) out += fmt::format("<path d=\"M{} {}h24\" {}/>", x, y, stroke(s, colour));
  if (s.marks) out += mark(s.colour, x + 12, y, colour);
  return out + fmt::format("<text x=\"{}\" y=\"{}\" fill=\"#333\">{}</text>\n", x + 32, y + 4, io::escape_xml(s.label));
}

}  // namespace

std::string draw(const Plot& plot) {
  const std::vector<Series> series = drawn_series(plot);
  const Scales at = scales_of(plot, series);
  const double legend_width = 250;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
      "<text x=\"{2}\" y=\"24\" font-size=\"15\" fill=\"#222\">{3}</text>\n",
      plot.width + legend_width, double(plot.height), left, io::escape_xml(plot.title));
  out += axes_text(plot, at);
  double legend_y = top + 8;
  for (const Series& s : series) {
    out += curve_text(s, at);
    out += legend_text(s, plot.width + 4, legend_y);
    legend_y += legend_row;
  }
  return out + "</svg>\n";
}

}  // namespace taut::paper
