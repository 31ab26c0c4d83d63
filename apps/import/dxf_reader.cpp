#include "import/dxf_reader.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "import/body_text.hpp"
#include "import/dxf_entities.hpp"
#include "import/dxf_hatch.hpp"
#include "import/dxf_structure.hpp"
#include "import/text_encoding.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "numeric/budget.hpp"
#include "taut/error.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

constexpr int deepest_block = 16;
constexpr std::size_t most_entities = 5000000;

/// What an entity hands down to those that are inserted by it.
struct Inherited {
  std::string layer, group;
  int color = 7;
};

std::vector<Point> corners_of(const std::vector<const DxfItem*>& items, const Affine& where) {
  std::vector<Point> corners;
  for (const DxfItem* item : items)
    for (const Point& p : corners_of(*item, where)) corners.push_back(p);
  return corners;
}

/// Goes through the entities of a file whose text has been read.
class DxfReader {
 public:
  DxfReader(const std::vector<DxfItem>& items, const std::string& file, const ImportSettings& settings,
            double tolerance)
      : settings_(settings), flattener_(settings, tolerance, file), structure_(items) {
    drawing_.file = file;
    drawing_.format = "DXF";
    drawing_.any_case = true;
    const DxfUnit& unit = structure_.unit();
    drawing_.state_unit(unit.name, unit.millimetres > 0 ? std::optional(unit.millimetres) : std::nullopt, settings_);
  }

  Drawing read() {
    const Affine root = scaling(settings_.scale, settings_.scale);
    read_entities(structure_.entities(), root, {}, 0);
    add_fillings();
    std::vector<std::string> notes = structure_.notes();
    std::move(notes.begin(), notes.end(), std::back_inserter(drawing_.notes));
    drawing_.layer_names.assign(layers_.begin(), layers_.end());
    if (settings_.by != Grouping::automatic && settings_.by != Grouping::layer)
      for (const Layer& layer : drawing_.layers)
        if (!layers_.count(layer.name)) drawing_.layer_names.push_back(layer.name);
    note_doubtful_curves();
    if (heights_.lo < heights_.hi)
      drawing_.notes.push_back("z runs from " + io::number_text(heights_.lo) + " to " + io::number_text(heights_.hi) +
                               ", and is left out: the drawing is seen from above");
    drawing_.curves = flattener_.counts();
    drawing_.kept = flattener_.take_kept();
    return std::move(drawing_);
  }

 private:
  /// Curves that other programs may read otherwise.
  void note_doubtful_curves() {
    if (fitted_.count > 0)
      drawing_.notes.push_back(std::to_string(fitted_.count) + (fitted_.count == 1 ? " spline has" : " splines have") +
                               " no control points, the first one at " + fitted_.first +
                               ": cubic through the fit points by chord lengths, and natural at ends without a tangent;"
                               " other programs may draw another curve");
    if (whole_turns_.count > 0)
      drawing_.notes.push_back(
          (whole_turns_.count == 1 ? "1 arc ends" : std::to_string(whole_turns_.count) + " arcs end") +
          " at the angle of the start, the first one at " + whole_turns_.first +
          ": a full circle, as LibreCAD and QCAD read it; other programs may draw nothing");
  }

  void read_entities(const std::vector<const DxfItem*>& items, const Affine& where, const Inherited& inherited,
                     int depth) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const DxfItem& item = *items[i];
      if (entities_read_ % 256 == 0) report_parts("entities read", entities_read_);
      if (++entities_read_ > most_entities)
        throw InputError(drawing_.file, "blocks within blocks make more than 5000000 entities",
                         "explode the blocks that are wanted");
      std::vector<const DxfItem*> vertices;
      if (item.type() == "POLYLINE" || item.type() == "INSERT") {
        while (i + 1 < items.size() && (items[i + 1]->type() == "VERTEX" || items[i + 1]->type() == "ATTRIB"))
          vertices.push_back(items[++i]);
        if (i + 1 < items.size() && items[i + 1]->type() == "SEQEND") ++i;
      }
      Inherited own = inherited;
      const std::string& layer = structure_.layer_named(item.text(8, "0"));
      if (layer != "0" || inherited.layer.empty()) own.layer = layer;
      try {
        own.color = color_of(item, own.layer, inherited.color);
        read_entity(item, vertices, where, own, depth);
      } catch (const InputError& error) {
        // What holds for the whole file stops; what one entity has wrong does not.
        if (error.place() == drawing_.file) throw;
        lose(item, own.layer, "cannot be read: " + error.problem(), corners_of(item, where));
      }
    }
  }

  int color_of(const DxfItem& item, const std::string& layer, int inherited) const {
    const int own = item.integer(62, 256);
    if (own == 0) return inherited;
    return own == 256 ? structure_.color_of_layer(layer) : std::abs(own);
  }

  /// What the entity is grouped by.
  std::string group_of(const DxfItem& item, const Inherited& own) const {
    if (settings_.by == Grouping::color) {
      const int mixed = item.integer(420, -1);
      if (mixed < 0) return "color " + std::to_string(own.color);
      char text[16];
      std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(mixed) & 0xFFFFFFu);
      return text;
    }
    return settings_.by == Grouping::group && !own.group.empty() ? own.group : own.layer;
  }

  void read_entity(const DxfItem& item, const std::vector<const DxfItem*>& vertices, const Affine& where,
                   const Inherited& own, int depth) {
    const std::string& type = item.type();
    if (item.integer(67) != 0) return skip(item, own.layer, "is in paper space, not in the model", false);
    // A layer that is off hides of a block what lies on it. One that is frozen hides the block.
    const bool block = type == "INSERT";
    const bool off = structure_.is_frozen(own.layer) || (structure_.is_off(own.layer) && !block);
    if (!off && !block && !wanted(own.layer)) return;
    const auto placed = placement_of(item, where);
    if (off || item.integer(60) != 0)
      return hide(item, vertices, placed, own.layer, off ? "is on a layer that is off or frozen" : "is not visible");
    if (!placed) {
      const std::string reason = "does not lie in the plane of the drawing";
      // What stands on the plane is seen as a line.
      return item.number(230, 1) == 0 ? skip(item, own.layer, reason, true) : lose(item, own.layer, reason, {});
    }
    if (block) {
      for (const DxfItem* attribute : vertices) lose(*attribute, own.layer, "is text", {});
      return insert(item, *placed, own, depth);
    }
    if (type == "HATCH" || type == "MPOLYGON" || type == "SOLID" || type == "TRACE")
      return read_filling(item, *placed, own);
    read_line(item, vertices, *placed, own);
  }

  /// Nothing if the entity does not lie in the plane of the drawing.
  static std::optional<Affine> placement_of(const DxfItem& item, const Affine& where) {
    const auto plane = own_plane(item);
    if (!plane) return std::nullopt;
    // Only these are in coordinates of their own; what else there is, is in those of the world.
    static const std::set<std::string> in_own_plane{"LWPOLYLINE", "POLYLINE", "ARC",   "CIRCLE", "INSERT",
                                                    "HATCH",      "MPOLYGON", "SOLID", "TRACE"};
    return in_own_plane.count(item.type()) ? where * *plane : where;
  }

  void read_filling(const DxfItem& item, const Affine& placed, const Inherited& own) {
    if (item.type() == "SOLID" || item.type() == "TRACE")
      return fillings_.push_back(
          {&item, own.layer, group_of(item, own), {solid_boundary(item, placed)}, Fill::even_odd});
    Filling filling{&item, own.layer, group_of(item, own), hatch_boundaries(item, placed, flattener_),
                    fill_of_hatch(item)};
    if (filling.chains.empty()) return lose(item, own.layer, "has no boundary", {});
    fillings_.push_back(std::move(filling));
  }

  void read_line(const DxfItem& item, const std::vector<const DxfItem*>& vertices, const Affine& placed,
                 const Inherited& own) {
    heights_.include(item);
    for (const DxfItem* vertex : vertices) heights_.include(*vertex);
    if (is_mesh(item)) return lose(item, own.layer, "is a mesh", corners_of(vertices, placed));
    std::optional<Chain> chain = line_of(item, vertices, placed, flattener_);
    tell_chorded(item, own.layer);
    if (!chain) return lose(item, own.layer, reason_for(item.type()), corners_of(item, placed));
    if (item.type() == "SPLINE" && !item.has(10)) fitted_.add(item);
    if (ends_at_its_start(item)) whole_turns_.add(item);
    if (chain->points.empty() || box_of(chain->points).longest() == 0)
      return skip(item, own.layer, "has no extent", false);
    Layer& target = drawing_.layer(group_of(item, own));
    if (target.sheets.empty()) target.sheets.push_back({"", Fill::even_odd, {}, true});
    target.sheets[0].chains.push_back(std::move(*chain));
  }

  static bool is_mesh(const DxfItem& item) { return item.type() == "POLYLINE" && (item.integer(70) & (16 | 64)) != 0; }

  static std::optional<Chain> line_of(const DxfItem& item, const std::vector<const DxfItem*>& vertices,
                                      const Affine& placed, Flattener& flattener) {
    return item.type() == "POLYLINE" ? polyline(item, vertices, placed, flattener) : chain_of(item, placed, flattener);
  }

  /// What is not to be seen; lines may go on where it ends.
  void hide(const DxfItem& item, const std::vector<const DxfItem*>& vertices, const std::optional<Affine>& placed,
            const std::string& layer, const std::string& reason) {
    std::vector<LostShape> shapes;
    try {
      ImportSettings plain = settings_;
      plain.curves = false;
      Flattener flattener(plain, coarsest, drawing_.file);
      const auto chain = placed && !is_mesh(item) ? line_of(item, vertices, *placed, flattener) : std::nullopt;
      if (chain && !chain->closed && chain->points.size() > 1)
        shapes.push_back({item.place(), {chain->points.front(), chain->points.back()}, false, true});
    } catch (const InputError&) {
      // It is not read in any case.
    }
    drawing_.skip(skipped(item, layer, reason, false, std::move(shapes)));
  }

  bool wanted(const std::string& layer) {
    layers_.insert(layer);
    return settings_.layers.empty() ||
           std::any_of(settings_.layers.begin(), settings_.layers.end(),
                       [&layer](const std::string& name) { return folded_case(name) == folded_case(layer); });
  }

  static const char* reason_for(const std::string& type) {
    static const std::set<std::string> solids{"REGION", "3DSOLID", "BODY", "SURFACE"};
    return solids.count(type) ? "is data of a solid modeller: explode it into lines" : "is no line or curve";
  }

  /// Fillings repeat what lines draw. By themselves, or apart from all lines of their layer, they are shapes.
  void add_fillings() {
    std::map<std::string, AxisBox> drawn;
    for (const Layer& layer : drawing_.layers) {
      for (const Sheet& sheet : layer.sheets) {
        for (const Chain& chain : sheet.chains) {
          const AxisBox box = box_of(chain.points);
          const auto [known, fresh] = drawn.emplace(layer.name, box);
          if (!fresh) known->second.include(box);
        }
      }
    }
    const auto repeats_lines = [&drawn](const Filling& filling) {
      const auto lines = drawn.find(filling.group);
      return lines != drawn.end() && std::any_of(filling.chains.begin(), filling.chains.end(), [&](const Chain& chain) {
               return !chain.points.empty() && lines->second.meets(box_of(chain.points));
             });
    };
    for (Filling& filling : fillings_) {
      const DxfItem& item = *filling.item;
      if (item.type() != "MPOLYGON" && repeats_lines(filling)) {
        std::vector<LostShape> shapes;
        for (Chain& chain : filling.chains) shapes.push_back({item.place(), std::move(chain.points), true});
        drawing_.skip(skipped(item, filling.layer, "is a filling on a layer that has lines: these count", false,
                              std::move(shapes)));
        continue;
      }
      drawing_.layer(filling.group).sheets.push_back({"", filling.fill, std::move(filling.chains)});
    }
  }

  void tell_chorded(const DxfItem& item, const std::string& layer) {
    const CurveCounts chorded = flattener_.take_chorded();
    if (chorded.segments == 0) return;
    const int degree = item.integer(71);
    const std::string what = degree > 3 ? "degree " + std::to_string(degree) : "rational";
    drawing_.count_chorded({item.place(), what + " " + io::excerpt(item.type(), 30), layer, 1, chorded});
  }

  static Chain polyline(const DxfItem& item, const std::vector<const DxfItem*>& vertices, const Affine& where,
                        Flattener& flattener) {
    std::vector<BulgedVertex> bulged;
    for (const DxfItem* vertex : vertices) {
      // The frame of a spline that was fitted is not drawn.
      if ((vertex->integer(70) & 16) != 0) continue;
      bulged.push_back({vertex->point(10), vertex->number(42)});
    }
    return bulged_chain(bulged, (item.integer(70) & 1) != 0, item.place(), where, flattener);
  }

  void insert(const DxfItem& item, const Affine& where, Inherited own, int depth) {
    const std::string name = item.text(2);
    const DxfBlock* block = structure_.block(name);
    if ((!block || block->external) && !wanted(own.layer)) return;
    const std::string what = "inserts the block \"" + io::excerpt(name) + "\", ";
    if (!block) return lose(item, own.layer, what + "which is not in the file", {});
    if (block->external) return lose(item, own.layer, what + "which is in another file", {});
    if (structure_.is_clipped(item)) {
      Skipped clip = skipped(item, own.layer, what + "and shows only a part of it (XCLIP), which is not obeyed", true,
                             {{item.place(), {}}});
      clip.remedy = "explode the block and trim its lines, or switch the clip off (XCLIP OFF)";
      drawing_.skip(std::move(clip));
    }
    if (depth == deepest_block) return lose(item, own.layer, "is within blocks that are more than 16 deep", {});
    const std::string& spelled = block->name;
    if (depth == 0) own.group = spelled + (inserted_[spelled]++ > 0 ? " " + std::to_string(inserted_[spelled]) : "");
    const int columns = item.integer(70, 1), rows = item.integer(71, 1);
    const Point at = item.point(10), base = block->base;
    const Affine turn = rotation(item.number(50));
    const Affine scaled = turn * scaling(item.number(41, 1), item.number(42, 1)) * translation(-base.x, -base.y);
    for (int row = 0; row < std::max(rows, 1); ++row) {
      for (int column = 0; column < std::max(columns, 1); ++column) {
        const Point step = turn.turn({column * item.number(44), row * item.number(45)});
        const Affine copy = where * translation(at.x + step.x, at.y + step.y) * scaled;
        // Empty blocks are counted, too.
        if (++entities_read_ > most_entities) return lose(item, own.layer, "has too many copies", {});
        read_entities(block->items, copy, own, depth + 1);
      }
    }
  }

  static Skipped skipped(const DxfItem& item, const std::string& layer, const std::string& reason, bool unread,
                         std::vector<LostShape> shapes = {}) {
    return {item.place(), io::excerpt(item.type(), 30), reason, layer, item.text(5), unread, 1, std::move(shapes)};
  }

  /// What is not to be seen, or has no extent.
  void skip(const DxfItem& item, const std::string& layer, const std::string& reason, bool unread) {
    drawing_.skip(skipped(item, layer, reason, unread));
  }

  /// What is to be seen, and is not read; it lies in the box of the corners, or anywhere.
  void lose(const DxfItem& item, const std::string& layer, const std::string& reason, std::vector<Point> corners) {
    std::vector<LostShape> shapes;
    if (!is_annotation(item)) shapes.push_back({item.place(), std::move(corners)});
    drawing_.skip(skipped(item, layer, reason, true, std::move(shapes)));
  }

  struct Filling {
    const DxfItem* item;
    std::string layer, group;
    std::vector<Chain> chains;
    Fill fill;
  };

  /// How many there are of a kind, and where the first one is.
  struct Tally {
    std::size_t count = 0;
    std::string first;
    void add(const DxfItem& item) {
      if (count++ == 0) first = item.place();
    }
  };

  ImportSettings settings_;
  Flattener flattener_;
  DxfStructure structure_;
  Drawing drawing_;
  std::map<std::string, int> inserted_;
  std::set<std::string> layers_;
  std::vector<Filling> fillings_;
  Heights heights_;
  std::size_t entities_read_ = 0;
  Tally fitted_, whole_turns_;  ///< splines without control points, arcs of which only the start is known
};

}  // namespace

Drawing read_dxf(const std::string& text, const std::string& file, const ImportSettings& settings) {
  const std::vector<DxfItem> items = read_dxf_items(text, file);
  return with_fineness(settings, [&](double tolerance) { return DxfReader(items, file, settings, tolerance).read(); });
}

}  // namespace taut::drawing
