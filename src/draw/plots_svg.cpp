// Charts over time: distances, and the intervals in which bodies overlap or a motion is free.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "draw/svg_canvas.hpp"
#include "draw/world_shapes.hpp"
#include "io/text.hpp"
#include "scene/untested.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut {

// The distance of bodies over time, as a plot.

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

// How far bodies can go from an instant, as a chart over time.

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

// When bodies overlap, as a chart: a lane for each pair.

using namespace internal;
namespace {

using io::chart_number;

constexpr double lane_height = 46, lane_bar = 16, chart_top = 44;

struct Lane {
  std::vector<const OverlapInterval*> overlaps;
  const PairAnswer* undecided = nullptr;
};
using LaneOfPair = std::map<std::array<BodyId, 2>, Lane>;

std::string lane_name(const Scene& scene, const std::array<BodyId, 2>& pair) {
  return scene.bodies[static_cast<std::size_t>(pair[0])].name + " x " +
         scene.bodies[static_cast<std::size_t>(pair[1])].name;
}

double middle_of(double lo, double hi) { return lo + (hi - lo) / 2; }

/// "0.25 to 0.5", and of a sweep "0.25 to 0.5 (22.5 to 45 deg)".
std::string ends_text(const Scene& scene, const OverlapInterval& o) {
  const auto at = [&](const TimeInterval& t) {
    return io::instant_text(middle_of(t.lo, t.hi), scene.start, scene.end, 5);
  };
  std::string text = at(o.from) + " to " + at(o.to);
  for (const BodyId id : o.pair) {
    const Motion& motion = scene.bodies[static_cast<std::size_t>(id)].motion;
    const auto from = angle_at(motion, o.from), to = angle_at(motion, o.to);
    if (!from || !to) continue;
    text += fmt::format(" ({:.5g} to {:.5g} deg)", middle_of(from->lo, from->hi), middle_of(to->lo, to->hi));
    break;
  }
  return text;
}

/// An end that is enclosed is a line; where the scene's time cuts an overlap off, it is open, and fades.
std::string end_mark(double x, double y, bool open, double outwards) {
  if (!open)
    return fmt::format("<path class=\"end\" d=\"M{},{}v{}\" stroke=\"{}\" stroke-width=\"2\"/>\n", chart_number(x),
                       chart_number(y - 3), chart_number(lane_bar + 6), io::body_line[1]);
  return fmt::format("<path class=\"open\" d=\"M{},{}l{},{}l{},{}Z\" fill=\"{}\"/>\n", chart_number(x), chart_number(y),
                     chart_number(outwards), chart_number(lane_bar / 2), chart_number(-outwards),
                     chart_number(lane_bar / 2), io::body_fill[1]);
}

std::string overlap_bar(const Scene& scene, const io::PlotPanel& panel, const OverlapInterval& o, double y) {
  const double from = panel.x(middle_of(o.from.lo, o.from.hi)), to = panel.x(middle_of(o.to.lo, o.to.hi));
  std::string s =
      fmt::format("<g class=\"overlap\"><title>overlap from t = {}</title>\n", io::escape_xml(ends_text(scene, o)));
  s += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", chart_number(from),
                   chart_number(y), chart_number(std::max(to - from, 1.0)), chart_number(lane_bar), io::body_fill[1]);
  return s + end_mark(from, y, !o.enter, -7) + end_mark(to, y, !o.exit, 7) + "</g>\n";
}

/// The ends of all bars of a lane, or of none if there is not room for all.
std::string all_ends(const Scene& scene, const io::PlotPanel& panel, const Lane& lane, double y) {
  std::string s;
  double written = 0;
  for (const OverlapInterval* o : lane.overlaps) {
    const std::string ends = ends_text(scene, *o);
    const double half = 3.4 * static_cast<double>(ends.size());
    const double middle = panel.x(middle_of(o->from.lo, o->to.hi));
    const double at = std::min(std::max(middle, panel.left + half), panel.left + panel.width - half);
    if (at - half < written) return {};
    s += io::chart_text(at, y, ends, "middle");
    written = at + half + 6;
  }
  return s;
}

std::string lane_svg(const Scene& scene, const io::PlotPanel& panel, const std::array<BodyId, 2>& pair,
                     const Lane& lane, double y) {
  std::string s = "<g class=\"lane\">\n" + io::chart_text(panel.left - 14, y + 13, lane_name(scene, pair), "end");
  s += fmt::format("<path d=\"M{},{}h{}\" stroke=\"#9aa5b1\"/>\n", chart_number(panel.left),
                   chart_number(y + lane_bar / 2), chart_number(panel.width));
  if (lane.undecided) {
    const double from = panel.x(std::clamp(lane.undecided->free_until, panel.t_lo, panel.t_hi));
    s += fmt::format(
        "<rect class=\"undecided\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"url(#hatched)\" "
        "stroke=\"#5f6b76\"/>\n",
        chart_number(from), chart_number(y), chart_number(panel.left + panel.width - from), chart_number(lane_bar));
  }
  for (const OverlapInterval* o : lane.overlaps) s += overlap_bar(scene, panel, *o, y);
  s += all_ends(scene, panel, lane, y + lane_bar + 14);
  return s + "</g>\n";
}

LaneOfPair lanes_of(const Intervals& answer) {
  LaneOfPair lanes;
  for (const OverlapInterval& o : answer.intervals) lanes[o.pair].overlaps.push_back(&o);
  for (const PairAnswer& p : answer.undecided) lanes[p.bodies].undecided = &p;
  return lanes;
}

}  // namespace

std::string intervals_svg(const Scene& scene, const Intervals& answer, Touch touch, int width) {
  const LaneOfPair lanes = lanes_of(answer);
  std::size_t longest = 8;
  for (const auto& [pair, lane] : lanes) longest = std::max(longest, lane_name(scene, pair).size());
  const double wide = std::max(width, 320), left = 30 + std::min(7.0 * static_cast<double>(longest), wide / 3);
  const double high = lane_height * static_cast<double>(std::max<std::size_t>(lanes.size(), 1));
  const io::PlotPanel panel{left, chart_top, wide - left - 30, high, scene.start, scene.end, 0, 1};
  std::string s =
      io::chart_head(wide, chart_top + high + 48,
                     std::string("Overlaps over time, touch ") + to_string(touch) + untested_note(answer.coverage));
  s += "<defs><pattern id=\"hatched\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\">"
       "<path d=\"M0,7L7,0\" stroke=\"#5f6b76\"/></pattern></defs>\n";
  s += panel.time_axis("t");
  double y = chart_top + 8;
  if (lanes.empty())
    s += io::chart_text(
        left, y + 13,
        answer.outcome == Outcome::free ? "no tested pair overlaps" : io::no_verdict(answer.outcome, answer.reason));
  for (const auto& [pair, lane] : lanes) {
    s += lane_svg(scene, panel, pair, lane, y);
    y += lane_height;
  }
  return s + "</svg>\n";
}

}  // namespace taut
