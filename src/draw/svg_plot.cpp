#include "draw/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/svg_canvas.hpp"
#include "io/number_text.hpp"

namespace taut::internal::io {

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
