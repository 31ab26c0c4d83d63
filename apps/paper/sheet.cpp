#include "sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "draw/svg_canvas.hpp"

namespace taut::paper {
using namespace internal;
namespace {

constexpr double caption_height = 26, gap = 14;

double attribute(const std::string& svg, const std::string& name) {
  const std::size_t at = svg.find(" " + name + "=\"");
  if (at == svg.npos) throw std::logic_error("a picture without " + name);
  return std::strtod(svg.c_str() + at + name.size() + 3, nullptr);
}

}  // namespace

void Sheet::add(const std::string& svg, const std::string& caption) {
  panels_.push_back({svg, caption, attribute(svg, "width"), attribute(svg, "height")});
}

std::string Sheet::draw() const {
  double x = gap, y = gap, row = 0, widest = 0;
  std::string body;
  for (std::size_t i = 0; i < panels_.size(); ++i) {
    const Panel& p = panels_[i];
    if (i > 0 && i % static_cast<std::size_t>(columns_) == 0) {
      x = gap;
      y += row + gap;
      row = 0;
    }
    body += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" fill=\"#222\">{}</text>\n", x + 4, y + 17,
                        io::escape_xml(p.caption));
    // A picture within a picture is clipped to its own frame.
    body +=
        fmt::format("<svg x=\"{:.0f}\" y=\"{:.0f}\" {}", x, y + caption_height, p.svg.substr(p.svg.find("<svg ") + 5));
    body += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.0f}\" height=\"{:.0f}\" fill=\"none\" stroke=\"#d8d8d8\"/>\n", x,
        y + caption_height, p.width, p.height);
    x += p.width + gap;
    widest = std::max(widest, x);
    row = std::max(row, p.height + caption_height);
  }
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
             "{1:.0f}\" "
             "font-family=\"sans-serif\" font-size=\"14\">\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
             widest, y + row + gap) +
         body + "</svg>\n";
}

}  // namespace taut::paper
