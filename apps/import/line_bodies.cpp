// Of BodyMaker: lines.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/segment_strips.hpp"
#include "import/bodies.hpp"
#include "import/body_text.hpp"
#include "import/layer_plan.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

bool is_near(const Polygon& ring, const Point& p, double distance) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]) <= distance) return true;
  return false;
}

/// Do all vertices of the ring lie within the other one, or so near to it?
bool lies_within(const Polygon& ring, const Polygon& outer, double distance) {
  const AxisBox around(box_of(outer));
  const AxisBox wide({around.lo_x, around.lo_y}, {around.hi_x, around.hi_y}, distance);
  return wide.holds(box_of(ring)) && std::all_of(ring.begin(), ring.end(), [&](const Point& p) {
           return roughly_inside(outer, p) || is_near(outer, p, distance);
         });
}

/// Of any closed chain, or chain that is not one straight line.
double least_extent(const std::vector<Chain>& chains) {
  double least = INFINITY;
  for (const Chain& chain : chains)
    if (chain.points.size() > 2) least = std::min(least, box_of(chain.points).longest());
  return least;
}

std::vector<std::string> names_of(const Drawing& drawing, const std::vector<LineLayer>& lines) {
  std::vector<std::string> names;
  for (const LineLayer& layer : lines) names.push_back(drawing.layers[layer.layer].name);
  return names;
}

}  // namespace

std::vector<LineLayer> BodyMaker::take_line_layers(Drawing& drawing) const {
  std::vector<LineLayer> lines;
  for (std::size_t k = 0; k < drawing.layers.size(); ++k) {
    LineLayer layer{k, {}, {}};
    for (Sheet& sheet : drawing.layers[k].sheets) {
      if (!sheet.lines) continue;
      require_range(sheet.chains);
      if (sheet.alone && !settings_.merge_all) {
        lines.push_back({k, std::move(sheet.chains), sheet.name});
        continue;
      }
      for (Chain& chain : sheet.chains) layer.chains.push_back(std::move(chain));
    }
    if (!layer.chains.empty()) lines.push_back(std::move(layer));
  }
  for (LineLayer& layer : lines)
    if (!layer.chains.empty()) layer.place = layer.chains.front().place;
  return lines;
}

/// Lines of layers, in the sets that the plan says.
void BodyMaker::read_lines(Drawing& drawing) {
  std::vector<LineLayer> lines = take_line_layers(drawing);
  note_coarse_join(lines);
  LayerPlan plan;
  const OutlineSettings settings = outline_settings();
  if (settings_.by == Grouping::automatic && drawing.nests)
    plan = plan_layers(lines, names_of(drawing, lines), settings);
  else
    for (std::size_t k = 0; k < lines.size(); ++k) plan.sets.push_back({k});
  for (const std::size_t k : plan.marks)
    file_.notes.push_back(fmt::format("layer {} encloses nothing, and changes no area: its {} are marks",
                                      layer_title(drawing.layers[lines[k].layer].name),
                                      io::counted(lines[k].chains.size(), "line", "lines")));
  adopt_holes(lines, plan, settings);
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < plan.sets.size(); ++s) read_set(drawing, lines, plan, s, pieces);
  note_conflicts(drawing, lines, plan);
  if (!plan.conflicts.empty()) require_clear_nesting(drawing, pieces);
  note_border(drawing, pieces);
  place_pieces(std::move(pieces));
}

void BodyMaker::read_set(const Drawing& drawing, std::vector<LineLayer>& lines, const LayerPlan& plan, std::size_t s,
                         std::vector<Piece>& pieces) {
  std::vector<Chain> chains;
  std::vector<std::size_t> layer_of;
  std::vector<std::string> layers;
  for (const std::size_t k : plan.sets[s]) {
    for (Chain& chain : lines[k].chains) {
      layer_of.push_back(lines[k].layer);
      layers.push_back(drawing.layers[lines[k].layer].name);
      chains.push_back(std::move(chain));
    }
  }
  const OutlineSettings settings = outline_settings();
  Outlines outlines = outlines_of_lines(chains, settings);
  take_report(outlines, chains, layers);
  if (plan.sets[s].size() > 1) note_holes(outlines, layers);
  for (std::size_t i = 0; i < outlines.regions.size(); ++i) {
    std::map<std::pair<std::string, std::size_t>, double> shares;
    for (const auto& [chain, length] : outlines.lengths[i]) shares[{layers[chain], layer_of[chain]}] += length;
    const auto most = std::max_element(shares.begin(), shares.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    pieces.push_back({std::move(outlines.regions[i]), most->first.second, s, chains[outlines.sources[i]].place,
                      lines[plan.sets[s].front()].name});
  }
}

void BodyMaker::place_pieces(std::vector<Piece> pieces) {
  // The larger ones first: the outermost outline around a piece is known before the piece.
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return doubled_area(a.region.part.outline) > doubled_area(b.region.part.outline);
  });
  std::vector<std::pair<Polygon, int>> outermost;
  for (Piece& piece : pieces) {
    int nest = -1;
    if (settings_.by == Grouping::nesting) {
      const Point inner = piece.region.part.outline.front();
      for (const auto& [ring, number] : outermost)
        if (roughly_inside(ring, inner)) nest = number;
      if (nest < 0) {
        nest = nests_++;
        outermost.push_back({piece.region.part.outline, nest});
      }
    }
    // Sets of lines are read apart, and may overlap.
    const int source = -1 - static_cast<int>(piece.set);
    add_region(std::move(piece.region), {piece.name, piece.place, {}, nest, source, true}, parts_[piece.layer]);
  }
}

/// A distance that was given, and is larger than what is drawn, joins all of it.
void BodyMaker::note_coarse_join(const std::vector<LineLayer>& lines) {
  if (!settings_.join) return;
  std::size_t all = 0, small = 0;
  std::string first;
  for (const LineLayer& layer : lines) {
    for (const Chain& chain : layer.chains) {
      const double extent = box_of(chain.points).longest();
      ++all;
      if (!(extent > 0 && extent <= *settings_.join)) continue;
      if (small++ == 0) first = chain.place;
    }
  }
  if (small == 0) return;
  file_.notes.push_back(
      fmt::format("--join {:.4g} is larger than {} of {}, the first one at {}: they may vanish or move",
                  *settings_.join, small, io::counted(all, "line", "lines"), first));
  coarse_join_ = true;
}

void BodyMaker::note_conflicts(const Drawing& drawing, const std::vector<LineLayer>& lines, const LayerPlan& plan) {
  const auto name = [&](std::size_t set) {
    const LineLayer& first = lines[plan.sets[set].front()];
    const std::string& known = drawing.layers[first.layer].name;
    return known.empty() ? "at " + first.place : io::excerpt(known);
  };
  using Kind = LayerConflict::Kind;
  for (const Kind kind : {Kind::cross, Kind::along, Kind::touch}) {
    std::size_t count = 0;
    const LayerConflict* first = nullptr;
    for (const LayerConflict& conflict : plan.conflicts)
      if (conflict.kind == kind && count++ == 0) first = &conflict;
    if (!first) continue;
    const std::string others =
        count > 1 ? fmt::format(", and {} do", io::counted(count - 1, "other pair", "other pairs")) : "";
    file_.notes.push_back(
        kind == Kind::cross
            ? fmt::format(
                  "layers {} and {} cross near {}{}: layers that cross are different bodies (--merge-layers reads "
                  "them as one)",
                  name(first->first), name(first->second), point_text(first->at), others)
            : fmt::format(
                  "layers {} and {} {} near {}{}: each layer is read by itself (--merge-layers reads them as one)",
                  name(first->first), name(first->second),
                  kind == Kind::along ? "share a part of a line" : "touch at several points, one of them",
                  point_text(first->at), others));
  }
}

/// A sheet's border makes holes of what is drawn on it, and bodies of their holes.
void BodyMaker::note_border(const Drawing& drawing, const std::vector<Piece>& pieces) {
  // Who names layers has chosen, and a board is no sheet.
  if (pieces.empty() || !drawing.nests || settings_.by == Grouping::nesting || !settings_.layers.empty()) return;
  const Piece& largest = *std::max_element(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return doubled_area(a.region.part.outline) < doubled_area(b.region.part.outline);
  });
  const AxisBox around = box_of(largest.region.part.outline);
  bool any = false;
  for (const Piece& piece : pieces) {
    if (piece.layer == largest.layer) continue;
    if (!around.holds(box_of(piece.region.part.outline))) return;
    any = true;
  }
  if (!any || largest.region.part.holes.empty()) return;
  std::string names;
  for (std::size_t k = 0; k < drawing.layers.size(); ++k)
    if (k != largest.layer) names += " --layer \"" + io::excerpt(drawing.layers[k].name) + "\"";
  constexpr std::size_t longest = 200;
  file_.notes.push_back(fmt::format(
      "layer {} encloses all others, and bodies lie in its holes: if it is the border of a sheet, leave it out with{}",
      layer_title(drawing.layers[largest.layer].name),
      names.size() > longest ? " --layer for each of the others" : names));
}

/// A piece within material of a layer that is read apart could be a hole in it, or a body on it.
void BodyMaker::require_clear_nesting(const Drawing& drawing, const std::vector<Piece>& pieces) {
  std::vector<AxisBox> boxes;
  for (const Piece& piece : pieces) boxes.emplace_back(box_of(piece.region.part.outline));
  const SegmentStrips strips(boxes);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& inner = pieces[i];
    std::size_t first = pieces.size();
    const AxisBox wide({boxes[i].lo_x, boxes[i].lo_y}, {boxes[i].hi_x, boxes[i].hi_y}, file_.fineness.join);
    strips.each_near(wide, [&](std::size_t k) {
      if (k < first && encloses(pieces[k], inner)) first = k;
    });
    if (first < pieces.size()) return fail_nesting(drawing, inner, pieces[first]);
  }
}

bool BodyMaker::encloses(const Piece& outer, const Piece& inner) const {
  return inner.set != outer.set &&
         lies_within(inner.region.part.outline, outer.region.part.outline, file_.fineness.join) &&
         roughly_inside(outer.region.part, inner_point(inner.region.part));
}

void BodyMaker::fail_nesting(const Drawing& drawing, const Piece& inner, const Piece& outer) {
  fail(inner.place,
       fmt::format("layer {} has an outline (area {:.6g}) within layer {} (area {:.6g}), and one of the "
                   "two crosses another layer, shares a line with it, or touches it at several points: is it a hole or "
                   "a body?",
                   layer_title(drawing.layers[inner.layer].name), area_of(inner.region.part),
                   layer_title(drawing.layers[outer.layer].name), area_of(outer.region.part)),
       "say --by layer, if each layer is a body, or --merge-layers, if all of them are lines to cut");
}

void BodyMaker::take_report(const Outlines& outlines, const std::vector<Chain>& chains,
                            const std::vector<std::string>& layers) {
  for (const Gap& gap : outlines.gaps)
    file_.gaps.push_back({chains[gap.source].place, layers[gap.source], gap.from, gap.to, gap.width});
  for (const OpenLine& line : outlines.open)
    file_.open.push_back({chains[line.source].place, layers[line.source], line.points, line.nearest_start,
                          line.nearest_end, line.gap_start, line.gap_end});
  const auto ring = [&](const Closure& closure, std::size_t source) {
    return RingReport{chains[source].place, layers[source], closure.gaps, closure.gap_length, closure.line_length};
  };
  for (const Closure& closure : outlines.suspicious)
    file_.suspicious.push_back(ring(closure, outlines.open[closure.lines.front()].source));
  for (const auto& [source, closure] : outlines.closed) file_.closed.push_back(ring(closure, source));
  for (const Repair& repair : outlines.repairs)
    file_.repairs.push_back({repair.kind == Repair::Kind::loop ? "loop" : "sliver", chains[repair.source].place,
                             layers[repair.source], repair.at, repair.size});
  for (const auto& [at, source] : outlines.crossings)
    file_.crossings.push_back({chains[source].place, layers[source], at});
  file_.repeated += outlines.repeated;
  for (const std::size_t k : outlines.idle)
    skip(chains[k].place, "line", "divides nothing: on both of its sides is the same", layers[k]);
  if (outlines.cuts > 0)
    file_.notes.push_back(fmt::format(
        "parts share cuts, {}, the first one at {}: the areas between cuts are parts, the smallest one {:.6g} (if it "
        "is "
        "waste, trim the lines around it)",
        io::counted(outlines.cuts, "segment", "segments"), point_text(outlines.first_cut), outlines.smallest_cut));
  take_crossed(outlines, chains);
  if (settings_.open == OpenRings::skip) return;
  for (const Closure& closure : outlines.suspicious) fail_open(outlines, closure, chains);
}

void BodyMaker::fail_open(const Outlines& outlines, const Closure& closure, const std::vector<Chain>& chains) {
  const auto width_of = [](const std::pair<Point, Point>& gap) {
    return std::hypot(gap.first.x - gap.second.x, gap.first.y - gap.second.y);
  };
  const auto widest = std::max_element(closure.gaps.begin(), closure.gaps.end(),
                                       [&](const auto& a, const auto& b) { return width_of(a) < width_of(b); });
  const double width = width_of(*widest), join = width * 1.01;
  const bool closing = settings_.open == OpenRings::close;
  // Of two sides, say, nobody knows what the others were.
  constexpr double of_two_sides = 0.7;
  const bool wide = closure.gap_length > of_two_sides * closure.line_length;
  std::string hint = closing ? "draw the line that is missing, or leave it out with --open skip"
                     : wide  ? "if it is an axis or a mark, leave it out with --open skip; else draw what is missing"
                             : "close it by straight lines with --open close";
  if (!closing && !wide && join < joinable_distance(outlines, chains))
    hint += fmt::format(", or with --join {:.3g}", join);
  if (!closing && !wide) hint += ", or leave it out with --open skip";
  fail(chains[outlines.open[closure.lines.front()].source].place,
       fmt::format("an outline stays open, with a gap of {:.4g} from {} to {}{}{}", width, point_text(widest->first),
                   point_text(widest->second),
                   closure.gaps.size() > 1
                       ? fmt::format(", and {} more", io::counted(closure.gaps.size() - 1, "gap", "gaps"))
                       : "",
                   closure.encloses ? "; what is closed at " + chains[*closure.encloses].place +
                                          (closure.partly ? " lies partly in it" : " lies in it")
                                    : ""),
       hint);
}

/// Ends that are joined so far apart spare what is drawn: half of the least line, and of the least width of what is
/// enclosed.
double BodyMaker::joinable_distance(const Outlines& outlines, const std::vector<Chain>& chains) {
  double least = least_extent(chains) / 2;
  const auto include = [&least](const Polygon& ring) {
    double around = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      around += std::hypot(a.x - b.x, a.y - b.y);
    }
    // Of a long strip, half of its width.
    least = std::min(least, std::fabs(doubled_area(ring)) / around / 2);
  };
  for (const Region& region : outlines.regions) {
    include(region.part.outline);
    for (const Polygon& hole : region.part.holes) include(hole);
  }
  return least;
}

void BodyMaker::note_holes(const Outlines& outlines, const std::vector<std::string>& layers) {
  std::map<std::pair<std::string, std::string>, std::size_t> holes;
  for (std::size_t i = 0; i < outlines.regions.size(); ++i)
    for (const std::size_t source : outlines.hole_sources[i])
      if (layers[source] != layers[outlines.sources[i]]) ++holes[{layers[source], layers[outlines.sources[i]]}];
  if (holes.size() > 20) {
    std::size_t all = 0;
    for (const auto& [names, n] : holes) all += n;
    file_.notes.push_back(fmt::format("{} are holes in material of other layers (--by layer keeps layers apart)",
                                      io::counted(all, "contour", "contours")));
    return;
  }
  for (const auto& [names, n] : holes)
    file_.notes.push_back(
        fmt::format("layer {}: {} in material of layer {} (--by layer keeps layers apart)", layer_title(names.first),
                    io::counted(n, "contour is a hole", "contours are holes"), layer_title(names.second)));
}

}  // namespace taut::drawing
