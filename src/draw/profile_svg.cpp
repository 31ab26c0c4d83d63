// The distance of bodies over time, as a plot.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "draw/svg_canvas.hpp"
#include "draw/svg_plot.hpp"
#include "io/number_text.hpp"
#include "scene/untested.hpp"
#include "taut/clearance.hpp"

namespace taut {
using namespace internal;
namespace {

using io::chart_number;

constexpr double panel_room = 250, panel_height = 160, panel_left = 90;

std::string curve_title(const Scene& scene, const DistanceCurve& c) {
  if (!c.pair) return "least distance of all pairs";
  return scene.bodies[static_cast<std::size_t>((*c.pair)[0])].name + " x " +
         scene.bodies[static_cast<std::size_t>((*c.pair)[1])].name;
}

std::string rectangle(const io::PlotPanel& panel, const DistanceWithin& s) {
  const double top = panel.y(std::min(s.hi, panel.v_hi));
  return fmt::format("M{},{}H{}V{}H{}Z", chart_number(panel.x(s.from)), chart_number(top), chart_number(panel.x(s.to)),
                     chart_number(panel.y(s.lo)), chart_number(panel.x(s.from)));
}

/// Boxes that the curve does not leave, the curve through its instants, and its highest point.
std::string curve_marks(const io::PlotPanel& panel, const DistanceCurve& c) {
  std::string boxes, line;
  for (const DistanceWithin& s : c.stretches) boxes += rectangle(panel, s);
  for (const DistanceAt& d : c.instants)
    line += fmt::format("{}{},{}", line.empty() ? "M" : "L", chart_number(panel.x(d.t)),
                        chart_number(panel.y(d.lo + (d.hi - d.lo) / 2)));
  std::string s = fmt::format("<path class=\"within\" d=\"{}\" fill=\"#9db8d2\" fill-opacity=\"0.55\"/>\n", boxes);
  s += fmt::format("<path class=\"distance\" d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", line,
                   io::body_line[0]);
  s += fmt::format("<circle class=\"largest\" cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"{}\"/>\n",
                   chart_number(panel.x(c.largest_at)), chart_number(panel.y(c.largest_lo)), io::contact_colour);
  return s;
}

std::string panel_svg(const Scene& scene, const DistanceCurve& c, double top, double width) {
  const double highest = c.largest_hi > 0 ? 1.08 * c.largest_hi : 1;
  const io::PlotPanel panel{panel_left, top + 30, width - panel_left - 24, panel_height, scene.start, scene.end,
                            0,          highest};
  std::string s = "<g class=\"curve\">\n" + io::chart_text(panel_left, top + 16, curve_title(scene, c));
  const std::string word = c.settled ? "" : ", at most " + fmt::format("{:.9g}", c.largest_hi);
  s += io::chart_text(width - 24, top + 16,
                      fmt::format("greatest {:.6g}{} at t = {}", c.largest_lo, word,
                                  io::instant_text(c.largest_at, scene.start, scene.end, 6)),
                      "end");
  return s + panel.time_axis("t") + panel.value_axis() + curve_marks(panel, c) + "</g>\n";
}

}  // namespace

std::string profile_svg(const Scene& scene, const DistanceProfile& answer, int width) {
  const double wide = std::max(width, 320), rows = static_cast<double>(std::max<std::size_t>(answer.curves.size(), 1));
  std::string s = io::chart_head(wide, 40 + panel_room * rows, "Distance over time" + untested_note(answer.coverage));
  if (answer.curves.empty()) s += io::chart_text(16, 60, io::no_verdict(answer.outcome, answer.reason));
  for (std::size_t i = 0; i < answer.curves.size(); ++i)
    s += panel_svg(scene, answer.curves[i], 36 + panel_room * static_cast<double>(i), wide);
  return s + "</svg>\n";
}

}  // namespace taut
