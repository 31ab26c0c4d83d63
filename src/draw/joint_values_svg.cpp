// All combinations of one or two joints' values, as a picture: free, colliding, undecided; and a way among them, or
// what is reached where there is none.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "draw/svg_canvas.hpp"
#include "scene/linkage.hpp"
#include "scene/untested.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/path.hpp"

namespace taut {
using namespace internal;
namespace {

using io::chart_number;

constexpr double left_of_plot = 90, above_plot = 64, strip_height = 60, legend_step = 130;

/// Where the search for a way gets to from its start.
constexpr const char* reached_colour = "#f3dc93";

/// In the order of CellState. An envelope leaves only borders undecided; a search for a way leaves all that it does not
/// need.
using StateColours = std::array<const char*, 3>;
constexpr StateColours envelope_colours{"#bfe3c6", "#d98a80", "#4a4a4a"},
    search_colours{"#bfe3c6", "#d98a80", "#e4e4e4"};
constexpr CellState all_states[] = {CellState::free, CellState::colliding, CellState::undecided};

std::size_t number_of(CellState state) { return static_cast<std::size_t>(state); }

template <class Predicate>
std::vector<EnvelopeCell> selected(const std::vector<EnvelopeCell>& cells, const Predicate& predicate) {
  std::vector<EnvelopeCell> some;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(some), predicate);
  return some;
}

/// Cells in one row are drawn as one rectangle where they are neighbours.
std::vector<EnvelopeCell> merged(std::vector<EnvelopeCell> some) {
  const auto row = [](const EnvelopeCell& c) { return std::tuple(c.lo[1], c.hi[1], c.lo[0]); };
  std::sort(some.begin(), some.end(), [&](const EnvelopeCell& a, const EnvelopeCell& b) { return row(a) < row(b); });
  std::vector<EnvelopeCell> rows;
  for (const EnvelopeCell& cell : some) {
    const bool continues = !rows.empty() && rows.back().lo[1] == cell.lo[1] && rows.back().hi[1] == cell.hi[1] &&
                           rows.back().hi[0] >= cell.lo[0];
    if (continues) {
      rows.back().hi[0] = cell.hi[0];
    } else {
      rows.push_back(cell);
    }
  }
  return rows;
}

std::string cells_path(const io::PlotPanel& panel, std::vector<EnvelopeCell> cells, bool strip, const char* what,
                       const char* colour) {
  std::string path;
  for (const EnvelopeCell& cell : merged(std::move(cells))) {
    const double bottom = strip ? panel.top + panel.height : panel.y(cell.lo[1]);
    const double top = strip ? panel.top : panel.y(cell.hi[1]);
    path += fmt::format("M{},{}H{}V{}H{}Z", chart_number(panel.x(cell.lo[0])), chart_number(bottom),
                        chart_number(panel.x(cell.hi[0])), chart_number(top), chart_number(panel.x(cell.lo[0])));
  }
  return fmt::format("<path class=\"{0}\" d=\"{1}\" fill=\"{2}\" stroke=\"{2}\" stroke-width=\"0.4\"/>\n", what, path,
                     colour);
}

std::string cells_svg(const io::PlotPanel& panel, const std::vector<EnvelopeCell>& cells, bool strip,
                      const StateColours& colours) {
  std::string s;
  for (const CellState state : all_states)
    s += cells_path(panel, selected(cells, [state](const EnvelopeCell& cell) { return cell.state == state; }), strip,
                    to_string(state), colours[number_of(state)]);
  return s;
}

std::string legend_entry(double x, double y, const char* colour, const std::string& text) {
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"12\" fill=\"{}\"/>\n", chart_number(x),
                     chart_number(y - 10), colour) +
         io::chart_text(x + 17, y, text);
}

std::string state_legend(const std::array<double, 3>& shares, double y, const StateColours& colours) {
  std::string s;
  double x = left_of_plot;
  for (const CellState state : all_states) {
    s += legend_entry(x, y, colours[number_of(state)],
                      fmt::format("{} {:.3g} %", to_string(state), 100 * shares[number_of(state)]));
    x += legend_step;
  }
  return s;
}

/// Where values are drawn.
Point place_of(const io::PlotPanel& panel, const JointValues& values, bool strip) {
  return {panel.x(values[0]), strip ? panel.top + panel.height / 2 : panel.y(values[1])};
}

std::string value_mark(const io::PlotPanel& panel, const JointValues& values, bool strip, const char* what,
                       const char* colour = "#7d130a") {
  const Point at = place_of(panel, values, strip);
  return fmt::format(
      "<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"#ffffff\" stroke=\"{}\" "
      "stroke-width=\"2\"/>\n",
      what, chart_number(at.x), chart_number(at.y), colour);
}

/// The joint's name, with the unit of one that turns bodies and shifts none.
std::string axis_name(const Linkage& linkage, std::size_t joint) {
  bool turns = false, shifts = false;
  for (const std::optional<JointMotion>& motion : linkage.motions) {
    if (!motion) continue;
    for (const JointMotion& single : single_motions(*motion)) {
      if (single.joint != static_cast<int>(joint)) continue;
      (std::holds_alternative<Revolute>(single.kind) ? turns : shifts) = true;
    }
  }
  return linkage.joints[joint].name + (turns && !shifts ? " (deg)" : "");
}

/// The cells with their legend and the axes; marks come after it.
class JointValuesPlot {
 public:
  JointValuesPlot(const Linkage& linkage, int width, const StateColours& colours)
      : linkage_(linkage), colours_(colours), strip_(linkage.joints.size() == 1) {
    const std::vector<Joint>& joints = linkage.joints;
    if (joints.size() > 2)
      throw InputError("joints", "there are " + std::to_string(joints.size()) + ", and a picture has two directions",
                       "fix one of them by a range of length 0 in a copy of the scene without it, or ask for --json");
    width_ = std::max(width, 480);
    const double inner = width_ - left_of_plot - 24;
    panel_ = {left_of_plot, above_plot, inner, strip_ ? strip_height : 0.75 * inner, joints[0].lo, joints[0].hi, 0, 1};
    if (strip_) return;
    panel_.v_lo = joints[1].lo;
    panel_.v_hi = joints[1].hi;
  }

  const io::PlotPanel& panel() const { return panel_; }
  bool strip() const { return strip_; }

  std::string svg(const std::string& title, const std::array<double, 3>& shares, const std::vector<EnvelopeCell>& cells,
                  const std::vector<EnvelopeCell>& reached = {}) const {
    std::string s = io::chart_head(width_, above_plot + panel_.height + 56, title);
    // Exact signs decide without cells.
    if (!cells.empty()) s += state_legend(shares, 46, colours_);
    s += cells_svg(panel_, cells, strip_, colours_);
    if (!reached.empty()) {
      s += legend_entry(left_of_plot + 3 * legend_step, 46, reached_colour, "reached");
      s += cells_path(panel_, reached, strip_, "reached", reached_colour);
    }
    s += panel_.time_axis(axis_name(linkage_, 0));
    if (strip_) return s;
    const std::string name = axis_name(linkage_, 1);
    const bool fits = name.size() <= 12;
    return s + panel_.value_axis() +
           io::chart_text(fits ? left_of_plot - 9 : 4, above_plot - 6, name, fits ? "end" : "start");
  }

 private:
  const Linkage& linkage_;
  const StateColours& colours_;
  bool strip_;
  double width_;
  io::PlotPanel panel_;
};

/// Of all combinations, by state.
std::array<double, 3> shares_of(const std::vector<EnvelopeCell>& cells, std::size_t joints) {
  std::array<double, 3> shares{};
  double all = 0;
  for (const EnvelopeCell& cell : cells) {
    double size = 1;
    for (std::size_t k = 0; k < joints; ++k) size *= cell.hi[k] - cell.lo[k];
    shares[number_of(cell.state)] += size;
    all += size;
  }
  if (all > 0)
    for (double& share : shares) share /= all;
  return shares;
}

/// A joint with a period may have left its range; the way goes on at the other end then.
JointValues into_range(const PathProblem& problem, JointValues values, JointValues& turns) {
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
    const Joint& joint = problem.linkage.joints[k];
    const double period = joint.hi - joint.lo;
    turns[k] = problem.periodic[k] && period > 0 ? std::floor((values[k] - joint.lo) / period) : 0;
    values[k] -= turns[k] * period;
  }
  return values;
}

/// The combinations that are the goal, unless that is outside; a single one is a mark.
std::string goal_svg(const JointValuesPlot& plot, const PathProblem& problem) {
  if (problem.goal_outside) return {};
  JointValues lo{}, hi{};
  for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
    const Joint& joint = problem.linkage.joints[k];
    const std::array<double, 2> goal = problem.goal[k] ? *problem.goal[k] : std::array<double, 2>{joint.lo, joint.hi};
    lo[k] = std::clamp(goal[0], joint.lo, joint.hi);
    hi[k] = std::clamp(goal[1], joint.lo, joint.hi);
  }
  if (lo == hi) return value_mark(plot.panel(), lo, plot.strip(), "goal", "#1f4e9c");
  const io::PlotPanel& panel = plot.panel();
  const Point a = place_of(panel, lo, plot.strip()), b = place_of(panel, hi, plot.strip());
  const double top = plot.strip() ? panel.top : b.y, bottom = plot.strip() ? panel.top + panel.height : a.y;
  return fmt::format(
      "<rect class=\"goal\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#1f4e9c\" "
      "stroke-width=\"1.5\" stroke-dasharray=\"5 3\"/>\n",
      chart_number(a.x), chart_number(top), chart_number(b.x - a.x), chart_number(bottom - top));
}

/// The way, in pieces where a joint goes on at the other end of its range.
std::string way_svg(const JointValuesPlot& plot, const PathProblem& problem, const std::vector<JointValues>& way) {
  std::string path;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    JointValues from_turns{}, to_turns{};
    JointValues from = into_range(problem, way[i], from_turns), to = into_range(problem, way[i + 1], to_turns);
    const auto line = [&](const JointValues& a, const JointValues& b) {
      const Point p = place_of(plot.panel(), a, plot.strip()), q = place_of(plot.panel(), b, plot.strip());
      path += fmt::format("M{},{}L{},{}", chart_number(p.x), chart_number(p.y), chart_number(q.x), chart_number(q.y));
    };
    // The segment is drawn from each of its ends; the frame cuts off what lies in another period.
    JointValues ahead = way[i + 1], behind = way[i];
    for (std::size_t k = 0; k < problem.linkage.joints.size(); ++k) {
      const double period = problem.linkage.joints[k].hi - problem.linkage.joints[k].lo;
      ahead[k] -= from_turns[k] * period;
      behind[k] -= to_turns[k] * period;
    }
    line(from, ahead);
    if (from_turns != to_turns) line(behind, to);
  }
  const io::PlotPanel& p = plot.panel();
  return fmt::format(
      "<clipPath id=\"frame\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n"
      "<path class=\"way\" d=\"{}\" fill=\"none\" stroke=\"#1f4e9c\" stroke-width=\"2\" clip-path=\"url(#frame)\"/>\n",
      chart_number(p.left), chart_number(p.top), chart_number(p.width), chart_number(p.height), path);
}

}  // namespace

std::string envelope_svg(const Linkage& linkage, const Envelope& answer, int width) {
  const JointValuesPlot plot(linkage, width, envelope_colours);
  std::string s = plot.svg("Envelope: " + std::string(to_string(answer.outcome)) + untested_note(answer.coverage),
                           {answer.free, answer.colliding, answer.undecided}, answer.cells);
  if (answer.witness) s += value_mark(plot.panel(), answer.witness->values, plot.strip(), "witness");
  return s + "</svg>\n";
}

std::string path_svg(const PathProblem& problem, const PathAnswer& answer, int width) {
  const JointValuesPlot plot(problem.linkage, width, search_colours);
  std::string s = plot.svg("Way: " + std::string(to_string(answer.outcome)) + untested_note(answer.coverage),
                           shares_of(answer.cells, problem.linkage.joints.size()), answer.cells,
                           selected(answer.cells, [](const EnvelopeCell& cell) { return cell.reached; }));
  if (!answer.waypoints.empty()) s += way_svg(plot, problem, answer.waypoints);
  s += goal_svg(plot, problem) + value_mark(plot.panel(), problem.start, plot.strip(), "start");
  if (answer.tight) s += value_mark(plot.panel(), answer.tight->values, plot.strip(), "tight");
  return s + "</svg>\n";
}

}  // namespace taut
