// When bodies overlap, as a chart: a lane for each pair.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "draw/svg_canvas.hpp"
#include "draw/svg_plot.hpp"
#include "io/number_text.hpp"
#include "scene/untested.hpp"
#include "taut/intervals.hpp"
#include "taut/motions.hpp"

namespace taut {
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
