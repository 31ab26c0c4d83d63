#include "import/dxf_reader.hpp"

#include <map>
#include <set>

#include "import/dxf_entities.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {

namespace {

constexpr int deepest_block = 16;
constexpr std::size_t most_entities = 5000000;

struct Block {
  Point base;
  std::vector<const DxfItem*> items;
};

const char* unit_name(int code) {
  static const std::map<int, const char*> names{
      {0, "none given"}, {1, "in"},          {2, "ft"},   {3, "miles"}, {4, "mm"},           {5, "cm"}, {6, "m"},
      {7, "km"},         {8, "microinches"}, {9, "mils"}, {10, "yd"},   {13, "micrometres"}, {14, "dm"}};
  const auto name = names.find(code);
  return name == names.end() ? "others" : name->second;
}

/// Of a number that no drawing has, what no table knows.
int whole(double value) { return value > -1e9 && value < 1e9 ? static_cast<int>(value) : -1; }

class DxfReader {
 public:
  DxfReader(const std::string& text, const std::string& file, const ImportSettings& settings)
      : items_(read_dxf_items(text, file)), settings_(settings), flattener_(settings, file) {
    drawing_.file = file;
    drawing_.format = "DXF";
    drawing_.units = unit_name(0);
  }

  Drawing read() {
    sort_items();
    const Affine root = scaling(settings_.scale, settings_.scale);
    read_entities(entities_, root, "", 0);
    drawing_.curves = flattener_.counts();
    drawing_.kept = flattener_.take_kept();
    return std::move(drawing_);
  }

 private:
  /// Which items are entities of the drawing, and which belong to blocks; units and hidden layers on the way.
  void sort_items() {
    std::string section;
    Block* block = nullptr;
    for (const DxfItem& item : items_) {
      if (item.type() == "SECTION") {
        section = item.text(2);
        if (section == "HEADER") read_header(item);
      } else if (item.type() == "ENDSEC") {
        section.clear();
      } else if (section == "TABLES" && item.type() == "LAYER") {
        if ((item.integer(70) & 1) != 0 || item.integer(62, 7) < 0) hidden_.insert(item.text(2));
      } else if (section == "BLOCKS" && item.type() == "BLOCK") {
        block = &blocks_[item.text(2)];
        *block = {item.point(10), {}};
      } else if (section == "BLOCKS" && item.type() == "ENDBLK") {
        block = nullptr;
      } else if (section == "BLOCKS" && block) {
        block->items.push_back(&item);
      } else if (section == "ENTITIES") {
        entities_.push_back(&item);
      }
    }
  }

  void read_header(const DxfItem& header) {
    bool units = false;
    for (const DxfGroup& group : header.groups()) {
      if (units && group.code == 70) drawing_.units = unit_name(whole(header.number_of(group)));
      if (group.code == 9) units = group.value == "$INSUNITS";
    }
  }

  /// `inherited`: the layer of what the entities are inserted by.
  void read_entities(const std::vector<const DxfItem*>& items, const Affine& where, const std::string& inherited,
                     int depth) {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const DxfItem& item = *items[i];
      if (++entities_read_ > most_entities)
        throw InputError(item.place(), "blocks within blocks make more than 5000000 entities",
                         "explode the blocks that are wanted");
      std::vector<const DxfItem*> vertices;
      if (item.type() == "POLYLINE" || item.type() == "INSERT") {
        while (i + 1 < items.size() && (items[i + 1]->type() == "VERTEX" || items[i + 1]->type() == "ATTRIB"))
          vertices.push_back(items[++i]);
        if (i + 1 < items.size() && items[i + 1]->type() == "SEQEND") ++i;
      }
      const std::string own = item.text(8, "0");
      read_entity(item, vertices, where, own == "0" && !inherited.empty() ? inherited : own, depth);
    }
  }

  void read_entity(const DxfItem& item, const std::vector<const DxfItem*>& vertices, const Affine& where,
                   const std::string& layer, int depth) {
    const std::string& type = item.type();
    if (item.integer(67) != 0) return skip(item, "is in paper space, not in the model");
    if (hidden_.count(layer)) return skip(item, "is on a layer that is off or frozen");
    if (item.integer(60) != 0) return skip(item, "is not visible");
    const auto plane = own_plane(item);
    if (!plane) return skip(item, "does not lie in the plane of the drawing");
    // Only these are in coordinates of their own; what else there is, is in those of the world.
    const bool own =
        type == "LWPOLYLINE" || type == "POLYLINE" || type == "ARC" || type == "CIRCLE" || type == "INSERT";
    const Affine placed = own ? where * *plane : where;
    if (type == "INSERT") {
      for (const DxfItem* attribute : vertices) skip(*attribute, "is text");
      return insert(item, placed, layer, depth);
    }
    std::optional<Chain> chain;
    if (type == "POLYLINE") {
      if ((item.integer(70) & (16 | 64)) != 0) return skip(item, "is a mesh");
      chain = polyline(item, vertices, placed);
    } else {
      chain = chain_of(item, placed, flattener_);
      tell_chorded(item, layer);
    }
    if (!chain && type == "HATCH") return skip(item, "is a filling: draw its boundary as lines, if it is to be a body");
    if (!chain) return skip(item, "is no line or curve");
    if (chain->points.size() < 2) return skip(item, "has fewer than two points");
    Layer& target = drawing_.layer(layer);
    if (target.sheets.empty()) target.sheets.push_back({"", Fill::even_odd, {}, true});
    target.sheets[0].chains.push_back(std::move(*chain));
  }

  void tell_chorded(const DxfItem& item, const std::string& layer) {
    const CurveCounts chorded = flattener_.take_chorded();
    if (chorded.segments == 0) return;
    const int degree = item.integer(71);
    const std::string what = degree > 3 ? "degree " + std::to_string(degree) : "rational";
    drawing_.count_chorded({item.place(), what + " " + io::excerpt(item.type(), 30), layer, 1, chorded});
  }

  Chain polyline(const DxfItem& item, const std::vector<const DxfItem*>& vertices, const Affine& where) {
    std::vector<BulgedVertex> bulged;
    for (const DxfItem* vertex : vertices) {
      // The frame of a spline that was fitted is not drawn.
      if ((vertex->integer(70) & 16) != 0) continue;
      bulged.push_back({vertex->point(10), vertex->number(42)});
    }
    return bulged_chain(bulged, (item.integer(70) & 1) != 0, item.place(), where, flattener_);
  }

  void insert(const DxfItem& item, const Affine& where, const std::string& layer, int depth) {
    const std::string name = item.text(2);
    const auto block = blocks_.find(name);
    if (block == blocks_.end())
      throw InputError(item.place(), "the block \"" + io::excerpt(name) + "\" is inserted, but not in the file",
                       "bind external references before the drawing is saved");
    if (depth == deepest_block)
      throw InputError(item.place(), "blocks are inserted within blocks more than 16 deep",
                       "a block must not insert itself: explode it");
    const int columns = item.integer(70, 1), rows = item.integer(71, 1);
    const Point at = item.point(10), base = block->second.base;
    const Affine turn = rotation(item.number(50));
    const Affine scaled = turn * scaling(item.number(41, 1), item.number(42, 1)) * translation(-base.x, -base.y);
    for (int row = 0; row < std::max(rows, 1); ++row) {
      for (int column = 0; column < std::max(columns, 1); ++column) {
        const Point step = turn.turn({column * item.number(44), row * item.number(45)});
        const Affine copy = where * translation(at.x + step.x, at.y + step.y) * scaled;
        // Empty blocks are counted, too.
        if (++entities_read_ > most_entities) return skip(item, "has too many copies");
        read_entities(block->second.items, copy, layer, depth + 1);
      }
    }
  }

  void skip(const DxfItem& item, const std::string& reason) {
    drawing_.skip(item.place(), io::excerpt(item.type(), 30), reason);
  }

  std::vector<DxfItem> items_;
  ImportSettings settings_;
  Flattener flattener_;
  Drawing drawing_;
  std::vector<const DxfItem*> entities_;
  std::map<std::string, Block> blocks_;
  std::set<std::string> hidden_;
  std::size_t entities_read_ = 0;
};

}  // namespace

Drawing read_dxf(const std::string& text, const std::string& file, const ImportSettings& settings) {
  return DxfReader(text, file, settings).read();
}

}  // namespace taut::drawing
