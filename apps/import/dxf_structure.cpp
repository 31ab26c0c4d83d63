#include "import/dxf_structure.hpp"

#include <cstdlib>

#include "import/text_encoding.hpp"
#include "io/text_file.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

/// Of a number that no drawing has, what no table knows.
int whole(double value) { return value > -1e9 && value < 1e9 ? static_cast<int>(value) : -1; }

/// Objects that the item owns.
std::vector<std::string> owned_by(const DxfItem& item) {
  std::vector<std::string> handles;
  for (const DxfGroup& group : item.groups())
    if (group.code == 360 || group.code == 350) handles.push_back(folded_case(group.value));
  return handles;
}

}  // namespace

DxfStructure::DxfStructure(const std::vector<DxfItem>& items) {
  std::string section;
  DxfBlock* block = nullptr;
  for (const DxfItem& item : items) {
    if (item.type() == "SECTION") {
      section = item.text(2);
      if (section == "HEADER") read_header(item);
    } else if (item.type() == "ENDSEC") {
      section.clear();
    } else if (section == "TABLES" && item.type() == "LAYER") {
      read_layer(item);
    } else if (section == "BLOCKS" && item.type() == "BLOCK") {
      block = &blocks_[folded_case(item.text(2))];
      *block = {item.text(2), item.point(10), {}, (item.integer(70) & 4) != 0};
    } else if (section == "BLOCKS" && item.type() == "ENDBLK") {
      block = nullptr;
    } else if (section == "BLOCKS" && block) {
      block->items.push_back(&item);
    } else if (section == "ENTITIES") {
      entities_.push_back(&item);
    } else if (section == "OBJECTS" && (item.type() == "DICTIONARY" || item.type() == "SPATIAL_FILTER")) {
      objects_[folded_case(item.text(5))] = &item;
    }
  }
}

const DxfUnit& DxfStructure::unit() const {
  static const std::map<int, DxfUnit> units{{0, {"none given", 0}},
                                            {1, {"in", 25.4}},
                                            {2, {"ft", 304.8}},
                                            {3, {"miles", 1609344}},
                                            {4, {"mm", 1}},
                                            {5, {"cm", 10}},
                                            {6, {"m", 1000}},
                                            {7, {"km", 1e6}},
                                            {8, {"microinches", 25.4e-6}},
                                            {9, {"mils", 0.0254}},
                                            {10, {"yd", 914.4}},
                                            {11, {"angstroms", 1e-7}},
                                            {12, {"nm", 1e-6}},
                                            {13, {"micrometres", 1e-3}},
                                            {14, {"dm", 100}},
                                            {15, {"dam", 1e4}},
                                            {16, {"hm", 1e5}},
                                            {21, {"US survey ft", 304.8006}}};
  static const DxfUnit others{"others", 0};
  const auto unit = units.find(unit_code_);
  return unit == units.end() ? others : unit->second;
}

void DxfStructure::read_header(const DxfItem& header) {
  std::string variable;
  for (const DxfGroup& group : header.groups()) {
    if (group.code == 9) variable = group.value;
    if (variable == "$INSUNITS" && group.code == 70) unit_code_ = whole(header.number_of(group));
  }
}

void DxfStructure::read_layer(const DxfItem& item) {
  const int color = item.integer(62, 7);
  const std::string name = layer_named(item.text(2));
  if ((item.integer(70) & 1) != 0) frozen_.insert(name);
  if (color < 0) off_.insert(name);
  colors_[name] = std::abs(color);
}

const std::string& DxfStructure::layer_named(const std::string& name) {
  const auto [known, is_new] = spellings_.emplace(folded_case(name), name);
  if (!is_new && known->second != name && respelled_.insert(name).second)
    notes_.push_back("layers \"" + io::excerpt(known->second) + "\" and \"" + io::excerpt(name) +
                     "\" are one: DXF does not distinguish capitals from small letters");
  return known->second;
}

int DxfStructure::color_of_layer(const std::string& layer) const {
  const auto known = colors_.find(layer);
  return known == colors_.end() ? 7 : known->second;
}

const DxfBlock* DxfStructure::block(const std::string& name) const {
  const auto known = blocks_.find(folded_case(name));
  return known == blocks_.end() ? nullptr : &known->second;
}

bool DxfStructure::is_clipped(const DxfItem& insert) const {
  // The dictionary of the entity, in it ACAD_FILTER, in it SPATIAL.
  constexpr int deepest_dictionary = 3;
  std::vector<std::string> handles = owned_by(insert);
  for (int depth = 0; depth < deepest_dictionary; ++depth) {
    std::vector<std::string> next;
    for (const std::string& handle : handles) {
      const auto known = objects_.find(handle);
      if (known == objects_.end()) continue;
      if (known->second->type() == "SPATIAL_FILTER") {
        if (known->second->integer(71, 1) != 0) return true;
        continue;
      }
      for (std::string& owned : owned_by(*known->second)) next.push_back(std::move(owned));
    }
    handles = std::move(next);
  }
  return false;
}

}  // namespace taut::drawing
