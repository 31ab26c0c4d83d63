#include "import/bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "geometry/part_rings.hpp"
#include "import/body_text.hpp"
#include "import/heights.hpp"
#include "import/kept_curves.hpp"
#include "import/overlaps.hpp"
#include "import/text_encoding.hpp"
#include "io/json_object.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "scene/names.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// Names as the drawing spells them, where it does not matter how.
std::vector<std::string> spelled(const Drawing& drawing, std::vector<std::string> names) {
  if (!drawing.any_case) return names;
  for (std::string& name : names)
    for (const std::string& known : drawing.layer_names)
      if (folded_case(known) == folded_case(name)) name = known;
  return names;
}

bool names_layer(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void require_known(const Drawing& drawing, const std::vector<std::string>& names, const char* option) {
  std::string known;
  for (const std::string& name : drawing.layer_names) known += (known.empty() ? "" : ", ") + io::excerpt(name);
  for (const std::string& name : names) {
    if (names_layer(drawing.layer_names, name)) continue;
    const std::string near = nearest_word(name, drawing.layer_names);
    throw InputError(option, drawing.file + " has no layer \"" + io::excerpt(name) + "\"",
                     known.empty() ? "leave the option out"
                                   : (near.empty() ? "" : "did you mean \"" + io::excerpt(near) + "\"? ") +
                                         "its layers are: " + known);
  }
}

}  // namespace

OutlineSettings BodyMaker::outline_settings() const {
  const Fineness& fineness = file_.fineness;
  return {fineness.join,      fineness.repair,          settings_.open == OpenRings::close,
          settings_.crossing, 4 * settings_.max_points, file_.file};
}

void BodyMaker::add(Drawing drawing) {
  file_ = {};
  coarse_join_ = false;
  file_.file = drawing.file;
  file_.format = drawing.format;
  file_.units = drawing.units;
  file_.fineness = drawing.fineness;
  file_.curves = drawing.curves;
  file_.notes = std::move(drawing.notes);
  file_.skipped = std::move(drawing.skipped);
  file_.chorded = std::move(drawing.chorded);
  if (drawing.layer_names.empty())
    for (const Layer& layer : drawing.layers) drawing.layer_names.push_back(layer.name);
  choose_layers(drawing);
  const CurveFinder finder(drawing.kept);
  finder_ = settings_.curves ? &finder : nullptr;
  const std::size_t before = import_.scene.bodies.size(), faults = import_.faults.size();
  read_all_levels(drawing);
  for (std::size_t k = 0; k < parts_.size(); ++k) cut_out(drawing.layers[k], parts_[k]);
  require_nothing_lost(drawing);
  require_nothing_hidden();
  for (std::size_t k = 0; k < parts_.size(); ++k) make_bodies(drawing.layers[k].name, std::move(parts_[k]));
  if (import_.scene.bodies.size() == before && import_.faults.size() == faults) fail_empty(drawing);
  import_.files.push_back(std::move(file_));
}

/// Shapes between different heights are no holes in each other, and do not repeat each other.
void BodyMaker::read_all_levels(Drawing& drawing) {
  std::vector<std::vector<Named>> all(drawing.layers.size());
  for (Level& level : take_levels(drawing)) {
    read_level(level.drawing);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      for (Named& named : parts_[k]) {
        named.z = level.z;
        all[k].push_back(std::move(named));
      }
    }
  }
  parts_ = std::move(all);
}

void BodyMaker::read_level(Drawing& drawing) {
  parts_.assign(drawing.layers.size(), {});
  for (std::size_t k = 0; k < drawing.layers.size(); ++k)
    for (Sheet& sheet : drawing.layers[k].sheets)
      if (!sheet.lines) read_sheet(drawing.layers[k], sheet, parts_[k]);
  read_lines(drawing);
  drop_repeated_fillings(drawing);
  if (drawing.format == "SVG" || drawing.format == "DXF") note_equal_fillings();
  note_shapes_in_others();
}

void BodyMaker::fail_empty(const Drawing& drawing) {
  std::string reasons;
  for (const Skipped& s : file_.skipped) {
    if (reasons.size() > 400) break;
    reasons += (reasons.empty() ? "; skipped: " : ", ") + s.what + " at " + s.place + " " + s.reason;
  }
  for (const OpenReport& open : file_.open) {
    if (reasons.size() > 400) break;
    reasons += (reasons.empty() ? "; " : ", ") + ("the line at " + open.place) + " is open";
  }
  const char* const usual = "draw closed lines; ends that do not meet are joined with --join E, or by --open close";
  fail(drawing.file, "nothing in the file encloses an area" + reasons,
       !drawing.remedy.empty() ? drawing.remedy
       : coarse_join_          ? "give a smaller distance to --join: lines are shorter than it"
                               : usual);
}

void BodyMaker::choose_layers(Drawing& drawing) {
  const std::vector<std::string> layers = spelled(drawing, settings_.layers),
                                 merged = spelled(drawing, settings_.merged);
  if (!layers.empty()) {
    require_known(drawing, layers, "--layer");
    if (drawing.format != "DXF")
      std::erase_if(drawing.layers, [&](const Layer& layer) { return !names_layer(layers, layer.name); });
  }
  give_heights(drawing);
  require_known(drawing, merged, "--merge-layers");
  if (settings_.merge_all || !merged.empty() || settings_.by == Grouping::nesting)
    merge_layers(drawing, merged, settings_.merge_all || settings_.by == Grouping::nesting);
}

/// Bodies on layers without heights meet those on all others: somebody may have forgotten them.
void BodyMaker::give_heights(Drawing& drawing) {
  std::string without;
  for (Layer& layer : drawing.layers) {
    const LayerHeights* given = nullptr;
    for (const LayerHeights& heights : settings_.heights) {
      if (spelled(drawing, {heights.name}).front() != layer.name) continue;
      if (given && !(given->z == heights.z))
        throw InputError("--layer",
                         fmt::format("layer \"{}\" is given two pairs of heights, {} and {}", io::excerpt(layer.name),
                                     io::heights_text(given->z), io::heights_text(heights.z)),
                         "give each layer one pair of heights");
      given = &heights;
    }
    if (given)
      for (Sheet& sheet : layer.sheets) sheet.z = given->z;
    const bool none = std::any_of(layer.sheets.begin(), layer.sheets.end(), [](const Sheet& s) { return !s.z; });
    if (none) without += (without.empty() ? "" : ", ") + layer_title(layer.name);
  }
  if (settings_.heights.empty() || without.empty()) return;
  file_.notes.push_back("no heights are given for layer " + without +
                        ": its bodies reach through all layers, and are no holes in those that have heights");
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
      std::move(layer.sheets.begin(), layer.sheets.end(), std::back_inserter(first->sheets));
      std::move(layer.cutouts.begin(), layer.cutouts.end(), std::back_inserter(first->cutouts));
    }
  }
  drawing.layers = std::move(left);
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
  for (const auto& [at, source] : outlines.crossings)
    file_.crossings.push_back({sheet.chains[source].place, layer.name, at});
  const int source = sources_++;
  for (std::size_t i = 0; i < outlines.regions.size(); ++i)
    add_region(std::move(outlines.regions[i]),
               {sheet.name, sheet.chains[outlines.sources[i]].place, {}, -1, source, false}, parts);
}

void BodyMaker::add_region(Region region, const Named& like, std::vector<Named>& parts) {
  for (Part& part : cut_where_rings_touch(std::move(region.part))) {
    parts.push_back(like);
    parts.back().part = std::move(part);
  }
}

/// What is in a part once, and in no cutout: outlines run counterclockwise, holes and cutouts clockwise.
void BodyMaker::cut_out(Layer& layer, std::vector<Named>& parts) {
  if (layer.cutouts.empty()) return;
  require_range(layer.cutouts);
  OutlineSettings settings = outline_settings();
  settings.repair = 0;
  std::vector<Named> left;
  for (Named& named : parts) {
    const AxisBox box = box_of(named.part.outline);
    std::vector<Chain> rings{{named.part.outline, true, named.place}};
    for (const Polygon& hole : named.part.holes) rings.push_back({hole, true, named.place});
    for (const Chain& cutout : layer.cutouts)
      if (box.meets(box_of(cutout.points))) rings.push_back(cutout);
    for (std::size_t k = 0; k < rings.size(); ++k)
      if ((doubled_area(rings[k].points) < 0) == (k == 0)) std::reverse(rings[k].points.begin(), rings[k].points.end());
    for (Region& region : outlines_of_fill(rings, Fill::once, settings).regions)
      add_region(std::move(region), {named.name, named.place, {}, named.nest, named.source, named.lines, named.z},
                 left);
  }
  parts = std::move(left);
}

/// Polygons whose holes the file itself states. Those that are not valid are repaired if that was asked for.
void BodyMaker::read_parts(const Layer& layer, Sheet& sheet, std::vector<Named>& parts) {
  for (Part& part : sheet.parts) {
    Named named{sheet.name, file_.file, std::move(part), -1, sources_++, false};
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
      const bool loop = repair.kind == Repair::Kind::loop, spike = repair.kind == Repair::Kind::spike;
      file_.repairs.push_back({loop    ? "loop"
                               : spike ? "spike"
                                       : "crossing",
                               file_.file, layer.name, repair.at, repair.size});
      if (repair.size > file_.fineness.repair)
        fail(file_.file + ": " + io::excerpt(layer.name),
             fmt::format("a ring {} near {}, and what would be cut off is {:.4g} {}",
                         spike ? "goes to and fro along a line" : "crosses itself or another one",
                         point_text(repair.at), repair.size, spike ? "long" : "wide"),
             fmt::format("allow it with --repair {:.3g}, or mend the file", repair.size * 1.01));
    }
    for (Region& region : outlines.regions)
      add_region(std::move(region), {sheet.name, file_.file, {}, -1, named.source, false}, parts);
  }
}

/// Contours drawn as lines in filled shapes of other bodies, and filled shapes in contours of others. Within one body
/// overlap_of() reports them.
void BodyMaker::note_shapes_in_others() {
  struct Shape {
    const Named* named;
    std::size_t layer;
    AxisBox box;
  };
  std::vector<Shape> shapes;
  for (std::size_t k = 0; k < parts_.size(); ++k)
    for (const Named& named : parts_[k]) shapes.push_back({&named, k, box_of(named.part.outline)});
  for (const bool lines : {true, false}) {
    std::size_t count = 0;
    std::string first;
    std::vector<const Shape*> outers;
    std::vector<AxisBox> boxes;
    for (const Shape& shape : shapes) {
      if (shape.named->lines == lines) continue;
      outers.push_back(&shape);
      boxes.push_back(shape.box);
    }
    if (outers.empty() || outers.size() == shapes.size()) continue;
    const SegmentStrips strips(std::move(boxes));
    for (const Shape& inner : shapes) {
      if (inner.named->lines != lines) continue;
      const Shape* around = nullptr;
      strips.each_near(inner.box, [&](std::size_t k) {
        const Shape& outer = *outers[k];
        if ((around && around < &outer) || outer.layer == inner.layer || !outer.box.holds(inner.box)) return;
        if (roughly_inside(outer.named->part, inner.named->part.outline.front())) around = &outer;
      });
      if (around && count++ == 0) first = inner.named->place + ", in that at " + around->named->place;
    }
    if (count == 0) continue;
    const bool one = count == 1;
    const std::string what =
        lines ? (one ? "1 contour drawn as a line lies in a filled shape of another body"
                     : fmt::format("{} contours drawn as lines lie in filled shapes of other bodies", count))
              : (one ? "1 filled shape lies in a contour of another body that is drawn as a line"
                     : fmt::format("{} filled shapes lie in contours of other bodies that are drawn as lines", count));
    file_.notes.push_back(fmt::format(
        "{}, the first one at {}: {} (if one is meant as a hole, draw both as lines, in one "
        "layer or group)",
        what, first, one ? "it is a body of its own, not a hole" : "they are bodies of their own, not holes"));
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
    for (Named& named : parts) {
      const std::string own = named.name.empty() ? name : named.name;
      std::vector<Named> alone;
      alone.push_back(std::move(named));
      add_body(own, std::move(alone));
    }
    return;
  }
  std::map<int, std::vector<Named>> bodies;
  for (Named& named : parts) bodies[named.nest].push_back(std::move(named));
  for (auto& [nest, all] : bodies) add_body(name, std::move(all));
}

/// Each pair of heights once, from the lowest one up.
std::vector<std::optional<Layers>> BodyMaker::heights_of(const std::vector<Named>& parts) {
  std::vector<std::optional<Layers>> heights;
  for (const Named& named : parts)
    if (std::find(heights.begin(), heights.end(), named.z) == heights.end()) heights.push_back(named.z);
  std::sort(heights.begin(), heights.end(), [](const auto& a, const auto& b) {
    const Layers x = a.value_or(Layers{}), y = b.value_or(Layers{});
    return std::pair(x.lo, x.hi) < std::pair(y.lo, y.hi);
  });
  return heights;
}

/// By how much the parts' areas exceed that of their union. What is drawn on material may be a hole to one who reads
/// it otherwise: the report says how it was read.
double BodyMaker::overlap_of(const std::string& name, const std::vector<Named>& parts) {
  // Rings that are not valid have been reported.
  if (!import_.faults.empty()) return 0;
  double area = 0;
  for (const std::optional<Layers>& z : heights_of(parts)) {
    std::vector<const Named*> level;
    for (const Named& named : parts)
      if (named.z == z) level.push_back(&named);
    area += overlap_at_level(name, level);
  }
  return area;
}

double BodyMaker::overlap_at_level(const std::string& name, const std::vector<const Named*>& parts) {
  std::vector<SourcedPart> sourced;
  for (const Named* named : parts) sourced.push_back({&named->part, named->source, named->lines});
  const Overlaps overlaps = overlaps_of(sourced, outline_settings());
  const auto note = [&](const std::vector<std::size_t>& inner, const char* one, const char* many, const char* remedy) {
    if (inner.empty()) return;
    file_.notes.push_back(fmt::format("body {}: {} {}, the first one at {}: no hole, it adds nothing to the body ({})",
                                      io::excerpt(name), inner.size(), inner.size() == 1 ? one : many,
                                      parts[inner.front()]->place, remedy));
  };
  note(overlaps.lines_in_filled, "contour drawn as a line lies in a filled shape",
       "contours drawn as lines lie in filled shapes", "if it is one, draw the shape around it as a line, too");
  note(overlaps.filled_in_lines, "filled shape lies in a contour drawn as a line",
       "filled shapes lie in contours drawn as lines", "if it is one, draw it as a line, too");
  note(overlaps.filled_in_filled, "filled shape lies in another one", "filled shapes lie in others",
       "if it is one, make one path of both, or draw both as lines");
  return overlaps.area;
}

void BodyMaker::add_body(const std::string& wanted, std::vector<Named> named) {
  Body body;
  body.name = unused_name(wanted);
  const double overlap = overlap_of(body.name, named);
  const std::vector<std::optional<Layers>> heights = heights_of(named);
  const bool one_level = heights.size() == 1;
  if (one_level) body.z = heights[0].value_or(Layers{});
  std::vector<Part> parts;
  for (Named& one : named) {
    parts.push_back(std::move(one.part));
    if (!one_level) parts.back().z = one.z;
  }
  BodyReport report{body.name, file_.file, parts.size(), 0, 0, -overlap, overlap, {}, {}, {}};
  for (const auto& z : heights)
    if (!one_level || z) report.z.push_back(z.value_or(Layers{}));

  AxisBox box = box_of(parts.front().outline);
  for (const Part& part : parts) {
    box.include(box_of(part.outline));
    report.holes += part.holes.size();
    report.vertices += part.outline.size();
    report.area += area_of(part);
    for (const Polygon& hole : part.holes) report.vertices += hole.size();
  }
  report.low = {box.lo_x, box.lo_y};
  report.high = {box.hi_x, box.hi_y};
  take_curves(parts, body);
  if (body.curves.empty()) {
    if (parts.size() == 1 && parts[0].holes.empty() && !parts[0].z)
      body.polygon = std::move(parts[0].outline);
    else
      body.parts = std::move(parts);
  }
  import_.scene.bodies.push_back(std::move(body));
  import_.bodies.push_back(std::move(report));
}

/// Bodies are distinguished by their names; a name is UTF-8 and has no line breaks in it.
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
