// What a DXF file says besides its entities: its unit, layers, blocks, and clips of inserted blocks.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "import/dxf_text.hpp"

namespace taut::drawing {

struct DxfBlock {
  std::string name;
  Point base;
  std::vector<const DxfItem*> items;
  bool external = false;  ///< it is in another file
};

/// A unit of $INSUNITS.
struct DxfUnit {
  const char* name;
  double millimetres;  ///< that it has; 0 if that is not known
};

/// Refers to the items that it is made of.
class DxfStructure {
 public:
  explicit DxfStructure(const std::vector<DxfItem>& items);

  const DxfUnit& unit() const;
  /// Those of the drawing, and not of blocks.
  const std::vector<const DxfItem*>& entities() const { return entities_; }
  /// The layer as the file spells it first: "CUT" and "cut" are one.
  const std::string& layer_named(const std::string& name);
  bool is_off(const std::string& layer) const { return off_.count(layer) != 0; }
  bool is_frozen(const std::string& layer) const { return frozen_.count(layer) != 0; }
  int color_of_layer(const std::string& layer) const;
  /// Null if it is not there.
  const DxfBlock* block(const std::string& name) const;
  /// Does the INSERT show only a part of its block? So says a SPATIAL_FILTER in its dictionary.
  bool is_clipped(const DxfItem& insert) const;
  /// Decisions that a person should know of.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  void read_header(const DxfItem& header);
  void read_layer(const DxfItem& item);

  int unit_code_ = 0;
  std::vector<const DxfItem*> entities_;
  std::map<std::string, DxfBlock> blocks_;        ///< by their names in small letters
  std::map<std::string, std::string> spellings_;  ///< of layers, by their names in small letters
  std::map<std::string, int> colors_;
  std::set<std::string> off_, frozen_, respelled_;
  std::map<std::string, const DxfItem*> objects_;  ///< dictionaries and filters, by their handles
  std::vector<std::string> notes_;
};

}  // namespace taut::drawing
