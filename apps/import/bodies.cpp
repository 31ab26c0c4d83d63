#include "import/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/part_validation.hpp"
#include "geometry/predicates.hpp"
#include "geometry/segment_strips.hpp"
#include "geometry/touching_rings.hpp"
#include "import/kept_curves.hpp"
#include "import/layer_plan.hpp"
#include "import/text_encoding.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut::drawing {

namespace {

std::string point_text(const Point& p) { return fmt::format("({:.9g}, {:.9g})", p.x + 0.0, p.y + 0.0); }

std::string counted_text(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

/// What is computed from here on needs numbers that do not overflow.
void require_range(const std::vector<Chain>& chains) {
  for (const Chain& chain : chains) {
    for (const Point& p : chain.points) {
      if (std::fabs(p.x) < max_coordinate && std::fabs(p.y) < max_coordinate) continue;
      throw InputError(chain.place, "a coordinate is beyond 2^400", "choose another unit, or check the drawing");
    }
  }
}

SegmentBox box_of(const Polygon& ring) {
  SegmentBox box(ring[0], ring[0]);
  for (const Point& p : ring) box.include(SegmentBox(p, p));
  return box;
}

bool holds(const SegmentBox& outer, const SegmentBox& inner) {
  return outer.lo_x <= inner.lo_x && outer.lo_y <= inner.lo_y && outer.hi_x >= inner.hi_x && outer.hi_y >= inner.hi_y;
}

/// Do all vertices of the ring lie within the other one?
bool lies_within(const Polygon& ring, const Polygon& outer) {
  return std::all_of(ring.begin(), ring.end(), [&](const Point& p) { return roughly_inside(outer, p); });
}

bool names_layer(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void require_known(const Drawing& drawing, const std::vector<std::string>& names, const char* option) {
  std::string known;
  for (const std::string& name : drawing.layer_names) known += (known.empty() ? "" : ", ") + io::excerpt(name);
  for (const std::string& name : names) {
    if (names_layer(drawing.layer_names, name)) continue;
    throw InputError(option, drawing.file + " has no layer \"" + io::excerpt(name) + "\"",
                     known.empty() ? "leave the option out" : "its layers are: " + known);
  }
}

}  // namespace

OutlineSettings BodyMaker::outline_settings() const {
  const Fineness& fineness = file_.fineness;
  return {fineness.join, fineness.repair, settings_.open == OpenRings::close, 4 * settings_.max_points, file_.file};
}

void BodyMaker::add(Drawing drawing) {
  file_ = {};
  file_.file = drawing.file;
  file_.format = drawing.format;
  file_.units = drawing.units;
  file_.fineness = drawing.fineness;
  file_.curves = drawing.curves;
  file_.skipped = std::move(drawing.skipped);
  file_.chorded = std::move(drawing.chorded);
  if (drawing.layer_names.empty())
    for (const Layer& layer : drawing.layers) drawing.layer_names.push_back(layer.name);
  choose_layers(drawing);
  const CurveFinder finder(drawing.kept);
  finder_ = settings_.curves ? &finder : nullptr;
  const std::size_t before = import_.scene.bodies.size(), faults = import_.faults.size();
  parts_.assign(drawing.layers.size(), {});
  for (std::size_t k = 0; k < drawing.layers.size(); ++k)
    for (Sheet& sheet : drawing.layers[k].sheets)
      if (!sheet.lines) read_sheet(drawing.layers[k], sheet, parts_[k]);
  read_lines(drawing);
  for (std::size_t k = 0; k < parts_.size(); ++k) make_bodies(drawing.layers[k].name, std::move(parts_[k]));
  if (import_.scene.bodies.size() == before && import_.faults.size() == faults) {
    std::string reasons;
    for (const Skipped& s : file_.skipped) {
      if (reasons.size() > 400) break;
      reasons += (reasons.empty() ? "; skipped: " : ", ") + s.what + " at " + s.place + " " + s.reason;
    }
    for (const OpenReport& open : file_.open) {
      if (reasons.size() > 400) break;
      reasons += (reasons.empty() ? "; " : ", ") + ("the line at " + open.place) + " is open";
    }
    fail(drawing.file, "nothing in the file encloses an area" + reasons,
         "draw closed lines; ends that do not meet are joined with --join E, or by --open close");
  }
  file_.kept = finder.found();
  import_.files.push_back(std::move(file_));
}

void BodyMaker::choose_layers(Drawing& drawing) const {
  if (!settings_.layers.empty()) {
    require_known(drawing, settings_.layers, "--layer");
    if (drawing.format != "DXF")
      std::erase_if(drawing.layers, [this](const Layer& layer) { return !names_layer(settings_.layers, layer.name); });
  }
  require_known(drawing, settings_.merged, "--merge-layers");
  if (settings_.merge_all || !settings_.merged.empty() || settings_.by == Grouping::nesting)
    merge_layers(drawing, settings_.merged, settings_.merge_all || settings_.by == Grouping::nesting);
}

/// The first one of them gets what the others have.
void BodyMaker::merge_layers(Drawing& drawing, const std::vector<std::string>& names, bool all) {
  Layer* first = nullptr;
  std::vector<Layer> left;
  left.reserve(drawing.layers.size());
  for (Layer& layer : drawing.layers) {
    if (!all && !names_layer(names, layer.name)) {
      left.push_back(std::move(layer));
    } else if (!first) {
      left.push_back(std::move(layer));
      first = &left.back();
    } else {
      for (Sheet& sheet : layer.sheets) first->sheets.push_back(std::move(sheet));
    }
  }
  drawing.layers = std::move(left);
}

/// Lines of layers, in the sets that the plan says.
void BodyMaker::read_lines(Drawing& drawing) {
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
  LayerPlan plan;
  const OutlineSettings settings = outline_settings();
  if (settings_.by == Grouping::automatic && drawing.nests)
    plan = plan_layers(lines, settings);
  else
    for (std::size_t k = 0; k < lines.size(); ++k) plan.sets.push_back({k});
  std::vector<Piece> pieces;
  for (std::size_t s = 0; s < plan.sets.size(); ++s) {
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
    Outlines outlines = outlines_of_lines(chains, settings);
    take_report(outlines, chains, layers);
    if (plan.sets[s].size() > 1) note_holes(outlines, layers);
    for (std::size_t i = 0; i < outlines.regions.size(); ++i) {
      const std::size_t source = outlines.sources[i];
      pieces.push_back({std::move(outlines.regions[i]), layer_of[source], s, chains[source].place,
                        lines[plan.sets[s].front()].name});
    }
  }
  if (!plan.crossings.empty()) {
    const LayerCrossing& crossing = plan.crossings.front();
    const auto name = [&](std::size_t set) {
      return io::excerpt(drawing.layers[lines[plan.sets[set].front()].layer].name);
    };
    file_.notes.push_back(fmt::format("layers {} and {} cross near {}: layers that cross are different bodies{}",
                                      name(crossing.first), name(crossing.second), point_text(crossing.at),
                                      plan.crossings.size() > 1 ? ", and others do" : ""));
    require_clear_nesting(drawing, pieces);
  }
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
        nest = static_cast<int>(outermost.size());
        outermost.push_back({piece.region.part.outline, nest});
      }
    }
    add_region(std::move(piece.region), piece.name, piece.place, nest, parts_[piece.layer]);
  }
}

/// A piece within material of a layer that is read apart could be a hole in it, or a body on it.
void BodyMaker::require_clear_nesting(const Drawing& drawing, const std::vector<Piece>& pieces) {
  for (const Piece& inner : pieces) {
    const Polygon& ring = inner.region.part.outline;
    for (const Piece& outer : pieces) {
      if (inner.set == outer.set || !holds(box_of(outer.region.part.outline), box_of(ring))) continue;
      const auto& holes = outer.region.part.holes;
      const bool in_hole = std::any_of(holes.begin(), holes.end(),
                                       [&](const Polygon& hole) { return roughly_inside(hole, ring.front()); });
      if (in_hole || !lies_within(ring, outer.region.part.outline)) continue;
      return fail(
          inner.place,
          fmt::format("the layer \"{}\" has an outline within layer \"{}\", and one of the two crosses another "
                      "layer: is it a hole or a body?",
                      io::excerpt(drawing.layers[inner.layer].name), io::excerpt(drawing.layers[outer.layer].name)),
          "say --by layer, if each layer is a body, or --merge-layers, if all of them are lines to cut");
    }
  }
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
  file_.repeated += outlines.repeated;
  for (const std::size_t k : outlines.idle)
    skip(chains[k].place, "line", "divides nothing: on both of its sides is the same", layers[k]);
  if (outlines.cuts > 0)
    file_.notes.push_back(fmt::format("parts share cuts, {}, the first one at {}: the areas between cuts are parts",
                                      counted_text(outlines.cuts, "segment", "segments"),
                                      point_text(outlines.first_cut)));
  if (settings_.open != OpenRings::error) return;
  for (const Closure& closure : outlines.suspicious) {
    const std::size_t source = outlines.open[closure.lines.front()].source;
    const auto widest = std::max_element(closure.gaps.begin(), closure.gaps.end(), [](const auto& a, const auto& b) {
      return std::hypot(a.first.x - a.second.x, a.first.y - a.second.y) <
             std::hypot(b.first.x - b.second.x, b.first.y - b.second.y);
    });
    const double width = std::hypot(widest->first.x - widest->second.x, widest->first.y - widest->second.y);
    fail(chains[source].place,
         fmt::format("an outline stays open, with a gap of {:.4g} from {} to {}{}", width, point_text(widest->first),
                     point_text(widest->second),
                     closure.gaps.size() > 1
                         ? fmt::format(", and {} more", counted_text(closure.gaps.size() - 1, "gap", "gaps"))
                         : ""),
         fmt::format("close it with --join {:.3g}, or by straight lines with --open close, or leave it out with --open "
                     "skip",
                     width * 1.01));
  }
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
                                      counted_text(all, "contour", "contours")));
    return;
  }
  for (const auto& [names, n] : holes)
    file_.notes.push_back(
        fmt::format("layer {}: {} in material of layer {} (--by layer keeps layers apart)", io::excerpt(names.first),
                    counted_text(n, "contour is a hole", "contours are holes"), io::excerpt(names.second)));
}

void BodyMaker::read_sheet(const Layer& layer, Sheet& sheet, std::vector<Named>& parts) {
  if (!sheet.parts.empty()) return read_parts(layer, sheet, parts);
  require_range(sheet.chains);
  Outlines outlines = outlines_of_fill(sheet.chains, sheet.fill, outline_settings());
  for (const std::size_t k : outlines.empty) skip(sheet.chains[k].place, "line", "encloses nothing", layer.name);
  for (const std::size_t k : outlines.idle)
    skip(sheet.chains[k].place, "subpath", "has filled area on both of its sides", layer.name);
  for (const Repair& repair : outlines.repairs)
    file_.repairs.push_back({"loop", sheet.chains[repair.source].place, layer.name, repair.at, repair.size});
  for (std::size_t i = 0; i < outlines.regions.size(); ++i)
    add_region(std::move(outlines.regions[i]), sheet.name, sheet.chains[outlines.sources[i]].place, -1, parts);
}

void BodyMaker::add_region(Region region, const std::string& name, const std::string& place, int nest,
                           std::vector<Named>& parts) {
  for (Part& part : cut_where_rings_touch(std::move(region.part)))
    parts.push_back({name, place, std::move(part), nest});
}

/// Polygons whose holes the file itself states. Those that are not valid are repaired if that was asked for.
void BodyMaker::read_parts(const Layer& layer, Sheet& sheet, std::vector<Named>& parts) {
  for (Part& part : sheet.parts) {
    Named named{sheet.name, file_.file, std::move(part)};
    const std::size_t faults = import_.faults.size();
    if (is_valid(named, layer.name) || !settings_.repair) {
      parts.push_back(std::move(named));
      continue;
    }
    import_.faults.erase(import_.faults.begin() + static_cast<std::ptrdiff_t>(faults), import_.faults.end());
    std::vector<Chain> rings;
    for (std::size_t k = 0; k <= named.part.holes.size(); ++k) {
      Polygon& ring = k == 0 ? named.part.outline : named.part.holes[k - 1];
      // Outlines counterclockwise and holes clockwise: where they run otherwise, a ring crosses itself.
      if ((doubled_area(ring) < 0) == (k == 0)) std::reverse(ring.begin(), ring.end());
      rings.push_back({std::move(ring), true, file_.file});
    }
    require_range(rings);
    Outlines outlines = outlines_of_repair(rings, outline_settings());
    for (const Repair& repair : outlines.repairs) {
      file_.repairs.push_back(
          {repair.kind == Repair::Kind::loop ? "loop" : "crossing", file_.file, layer.name, repair.at, repair.size});
      if (repair.size > file_.fineness.repair)
        fail(file_.file + ": " + io::excerpt(layer.name),
             fmt::format("a ring crosses itself or another one near {}, and what would be cut off is {:.4g} wide",
                         point_text(repair.at), repair.size),
             fmt::format("allow it with --repair {:.3g}, or mend the file", repair.size * 1.01));
    }
    for (Region& region : outlines.regions) add_region(std::move(region), sheet.name, file_.file, -1, parts);
  }
}

void BodyMaker::skip(const std::string& place, const std::string& what, const std::string& reason,
                     const std::string& layer) {
  Drawing tally;
  tally.skipped = std::move(file_.skipped);
  tally.skip({place, what, reason, layer});
  file_.skipped = std::move(tally.skipped);
}

bool BodyMaker::is_valid(const Named& named, const std::string& layer) {
  const std::string name = named.place + (layer.empty() ? "" : ": " + io::excerpt(layer));
  try {
    validate_polygon(named.part.outline, name);
    for (std::size_t i = 0; i < named.part.holes.size(); ++i)
      validate_polygon(named.part.holes[i], name + ", hole " + std::to_string(i + 1));
    validate_holes(named.part, name);
    return true;
  } catch (const InputError& error) {
    const bool repairable = file_.format == "WKT" || file_.format == "GeoJSON";
    import_.faults.emplace_back(
        error.place(), error.problem(),
        error.hint() + (repairable ? std::string(error.hint().empty() ? "" : "; ") + "or let --repair D mend it" : ""));
    return false;
  }
}

void BodyMaker::make_bodies(const std::string& name, std::vector<Named> parts) {
  std::erase_if(parts, [&](const Named& named) {
    const bool known = file_.format == "WKT" || file_.format == "GeoJSON";
    return !known && !is_valid(named, name);
  });
  if (parts.empty()) return;
  if (settings_.split) {
    for (Named& named : parts) add_body(named.name.empty() ? name : named.name, {std::move(named.part)});
    return;
  }
  std::map<int, std::vector<Part>> bodies;
  for (Named& named : parts) bodies[named.nest].push_back(std::move(named.part));
  for (auto& [nest, all] : bodies) add_body(name, std::move(all));
}

void BodyMaker::add_body(const std::string& wanted, std::vector<Part> parts) {
  Body body;
  body.name = unused_name(wanted);
  BodyReport report{body.name, file_.file, parts.size(), 0, 0, 0, {}, {}};
  SegmentBox box = box_of(parts.front().outline);
  for (const Part& part : parts) {
    box.include(box_of(part.outline));
    report.holes += part.holes.size();
    report.vertices += part.outline.size();
    report.area += std::fabs(doubled_area(part.outline)) / 2;
    for (const Polygon& hole : part.holes) {
      report.vertices += hole.size();
      report.area -= std::fabs(doubled_area(hole)) / 2;
    }
  }
  report.low = {box.lo_x, box.lo_y};
  report.high = {box.hi_x, box.hi_y};
  take_curves(parts, body);
  if (body.curves.empty()) {
    if (parts.size() == 1 && parts[0].holes.empty())
      body.polygon = std::move(parts[0].outline);
    else
      body.parts = std::move(parts);
  }
  import_.scene.bodies.push_back(std::move(body));
  import_.bodies.push_back(std::move(report));
}

/// The curves that the rings were made of, if there are any.
void BodyMaker::take_curves(const std::vector<Part>& parts, Body& body) const {
  if (!finder_) return;
  bool any = false;
  for (const Part& part : parts) {
    CurvedPart curved{finder_->outline(part.outline), {}};
    for (const Polygon& hole : part.holes) curved.holes.push_back(finder_->outline(hole));
    any = any || !polygons_of(curved);
    body.curves.push_back(std::move(curved));
  }
  if (!any) return body.curves.clear();
  // Throws where curves meet though their chords do not.
  flatten(body.curves, CurveSide::outer, 1e300, body.name);
}

/// Bodies are told apart by their names; a name is UTF-8 and has no line breaks in it.
std::string BodyMaker::unused_name(const std::string& wanted) {
  std::string base;
  const std::string valid = is_utf8(wanted) ? wanted : to_utf8(wanted, "CP1252");
  for (const char c : valid.empty() ? "body" : valid)
    base += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
  std::string name = base;
  int& count = names_[base];
  while (!used_.insert(name).second) name = base + "-" + std::to_string(++count + 1);
  return name;
}

}  // namespace taut::drawing
