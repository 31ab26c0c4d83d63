// How far bodies can go from an instant, as a chart over time.
#include <fmt/format.h>

#include <algorithm>

#include "draw/svg_canvas.hpp"
#include "draw/svg_plot.hpp"
#include "draw/world_shapes.hpp"
#include "io/number_text.hpp"
#include "scene/untested.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

using io::chart_number;

constexpr double range_top = 70, range_bar = 22;
constexpr const char* range_colour = "#0f6b4f";

/// What stops it, and where; at an end of the scene's time that alone.
std::string stop_text(const Scene& scene, const std::optional<TimeInterval>& end,
                      const std::optional<OverlapInterval>& stop, const char* otherwise) {
  if (!end || !stop) return otherwise;
  return fmt::format("{}: {}", io::instant_text(end->lo, scene.start, scene.end, 9),
                     io::pair_text(scene, stop->pair[0], stop->pair[1]));
}

std::string bar_of_range(const Scene& scene, double around, const Range& answer, const io::PlotPanel& panel) {
  const double from = panel.x(answer.from ? answer.from->hi : scene.start);
  const double to = panel.x(answer.to ? answer.to->lo : scene.end);
  std::string s = fmt::format("<rect class=\"free\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                              chart_number(from), chart_number(range_top), chart_number(std::max(to - from, 1.0)),
                              chart_number(range_bar), range_colour);
  s += io::chart_text(from, range_top + range_bar + 16, stop_text(scene, answer.from, answer.before, "the start"));
  s += io::chart_text(to, range_top + range_bar + 16, stop_text(scene, answer.to, answer.after, "the end"), "end");
  const double x = panel.x(around);
  s += fmt::format("<path d=\"M{0},{1}V{2}\" stroke=\"#16202b\" stroke-width=\"2\"/>\n", chart_number(x),
                   chart_number(range_top - 8), chart_number(range_top + range_bar + 4));
  return s + io::chart_text(x, range_top - 12, io::instant_text(around, scene.start, scene.end, 9), "middle");
}

}  // namespace

std::string range_svg(const Scene& scene, double from, const Range& answer, int width) {
  const double wide = std::max(width, 320), high = range_bar + 44;
  const io::PlotPanel panel{30, range_top - 20, wide - 60, high, scene.start, scene.end, 0, 1};
  std::string s = io::chart_head(wide, range_top + high + 30,
                                 "Without overlap around t = " + io::instant_text(from, scene.start, scene.end, 9) +
                                     untested_note(answer.coverage));
  s += panel.time_axis("t");
  s += answer.outcome == Outcome::free
           ? bar_of_range(scene, from, answer, panel)
           : io::chart_text(30, range_top + 14, io::no_verdict(answer.outcome, answer.reason));
  return s + "</svg>\n";
}

}  // namespace taut
