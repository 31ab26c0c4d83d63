// All combinations of two joints' values, as a picture: free, colliding, undecided.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "draw/svg_plot.hpp"
#include "scene/untested.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

using io::chart_number;

constexpr double left_of_plot = 90, above_plot = 64, strip_height = 60;

const char* colour_of(CellState state) {
  switch (state) {
    case CellState::free:
      return "#bfe3c6";
    case CellState::colliding:
      return "#d98a80";
    case CellState::undecided:
      break;
  }
  return "#4a4a4a";
}

/// Cells of one state in one row are drawn as one rectangle where they are neighbours.
std::vector<EnvelopeCell> merged(const std::vector<EnvelopeCell>& cells, CellState state) {
  std::vector<EnvelopeCell> some;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(some),
               [&](const EnvelopeCell& cell) { return cell.state == state; });
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

std::string cells_svg(const io::PlotPanel& panel, const Envelope& answer, bool strip) {
  std::string s;
  for (const CellState state : {CellState::free, CellState::colliding, CellState::undecided}) {
    std::string path;
    for (const EnvelopeCell& cell : merged(answer.cells, state)) {
      const double bottom = strip ? panel.top + panel.height : panel.y(cell.lo[1]);
      const double top = strip ? panel.top : panel.y(cell.hi[1]);
      path += fmt::format("M{},{}H{}V{}H{}Z", chart_number(panel.x(cell.lo[0])), chart_number(bottom),
                          chart_number(panel.x(cell.hi[0])), chart_number(top), chart_number(panel.x(cell.lo[0])));
    }
    s += fmt::format("<path class=\"{0}\" d=\"{1}\" fill=\"{2}\" stroke=\"{2}\" stroke-width=\"0.4\"/>\n",
                     to_string(state), path, colour_of(state));
  }
  return s;
}

std::string envelope_legend(const Envelope& answer, double y) {
  std::string s;
  double x = left_of_plot;
  const std::pair<CellState, double> shares[] = {{CellState::free, answer.free},
                                                 {CellState::colliding, answer.colliding},
                                                 {CellState::undecided, answer.undecided}};
  for (const auto& [state, share] : shares) {
    s += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"12\" fill=\"{}\"/>\n", chart_number(x),
                     chart_number(y - 10), colour_of(state));
    s += io::chart_text(x + 17, y, fmt::format("{} {:.3g} %", to_string(state), 100 * share));
    x += 160;
  }
  return s;
}

std::string witness_mark(const io::PlotPanel& panel, const EnvelopeWitness& witness, bool strip) {
  const double x = panel.x(witness.values[0]), y = strip ? panel.top + panel.height / 2 : panel.y(witness.values[1]);
  return fmt::format(
      "<circle class=\"witness\" cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"#ffffff\" stroke=\"#7d130a\" "
      "stroke-width=\"2\"/>\n",
      chart_number(x), chart_number(y));
}

}  // namespace

std::string envelope_svg(const Linkage& linkage, const Envelope& answer, int width) {
  if (linkage.joints.size() > 2)
    throw InputError("joints",
                     "there are " + std::to_string(linkage.joints.size()) + ", and a picture has two directions",
                     "fix one of them by a range of length 0 in a copy of the scene without it, or ask for --json");
  const bool strip = linkage.joints.size() == 1;
  const Joint& across = linkage.joints[0];
  const double wide = std::max(width, 480), inner = wide - left_of_plot - 24;
  io::PlotPanel panel{left_of_plot, above_plot, inner, strip ? strip_height : 0.75 * inner, across.lo, across.hi, 0, 1};
  if (!strip) {
    panel.v_lo = linkage.joints[1].lo;
    panel.v_hi = linkage.joints[1].hi;
  }
  std::string s =
      io::chart_head(wide, above_plot + panel.height + 56,
                     "Envelope: " + std::string(to_string(answer.outcome)) + untested_note(answer.coverage));
  s += envelope_legend(answer, 46) + cells_svg(panel, answer, strip) + panel.time_axis(across.name);
  if (!strip) {
    s += panel.value_axis();
    s += io::chart_text(left_of_plot - 9, above_plot - 6, linkage.joints[1].name, "end");
  }
  if (answer.witness) s += witness_mark(panel, *answer.witness, strip);
  return s + "</svg>\n";
}

}  // namespace taut
