// Bodies of what drawings enclose.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/segment_strips.hpp"
#include "import/import.hpp"
#include "import/layer_plan.hpp"
#include "import/outlines.hpp"

namespace taut::drawing {
using namespace internal;

/// Adds the bodies of one drawing after the other to an import, with names that differ.
class BodyMaker {
 public:
  BodyMaker(const ImportSettings& settings, Import& import) : settings_(settings), import_(import) {}
  void add(Drawing drawing);

 private:
  /// A part on its way into a body.
  struct Named {
    std::string name, place;
    Part part;
    int nest = -1;                 ///< the number of the outermost outline around it, where that counts
    int source = 0;                ///< parts of one source do not overlap
    bool lines = false;            ///< drawn as lines, not filled
    std::optional<Layers> z = {};  ///< the heights between which it lies
  };
  struct Piece {
    Region region;
    std::size_t layer, set;
    std::string place, name;
  };

  void fail_empty(const Drawing& drawing);
  void choose_layers(Drawing& drawing);
  void give_heights(Drawing& drawing);
  static void merge_layers(Drawing& drawing, const std::vector<std::string>& names, bool all);
  /// Reads the sheets of a drawing between two heights into `parts_`.
  void read_level(Drawing& drawing);
  void read_all_levels(Drawing& drawing);
  void read_lines(Drawing& drawing);
  std::vector<LineLayer> take_line_layers(Drawing& drawing) const;
  /// Reads the lines of set `s` of the plan, and adds what they enclose.
  void read_set(const Drawing& drawing, std::vector<LineLayer>& lines, const LayerPlan& plan, std::size_t s,
                std::vector<Piece>& pieces);
  void place_pieces(std::vector<Piece> pieces);
  void note_coarse_join(const std::vector<LineLayer>& lines);
  void note_border(const Drawing& drawing, const std::vector<Piece>& pieces);
  void drop_repeated_fillings(const Drawing& drawing);
  void note_equal_fillings();
  void note_shapes_in_others();
  void note_conflicts(const Drawing& drawing, const std::vector<LineLayer>& lines, const LayerPlan& plan);
  void cut_out(Layer& layer, std::vector<Named>& parts);
  void require_clear_nesting(const Drawing& drawing, const std::vector<Piece>& pieces);
  bool encloses(const Piece& outer, const Piece& inner) const;
  void fail_nesting(const Drawing& drawing, const Piece& inner, const Piece& outer);
  void require_nothing_lost(const Drawing& drawing);
  void require_nothing_hidden();
  void read_sheet(const Layer& layer, Sheet& sheet, std::vector<Named>& parts);
  void read_parts(const Layer& layer, Sheet& sheet, std::vector<Named>& parts);
  void take_report(const Outlines& outlines, const std::vector<Chain>& chains, const std::vector<std::string>& layers);
  void take_crossed(const Outlines& outlines, const std::vector<Chain>& chains);
  void fail_open(const Outlines& outlines, const Closure& closure, const std::vector<Chain>& chains);
  static double joinable_distance(const Outlines& outlines, const std::vector<Chain>& chains);
  void note_holes(const Outlines& outlines, const std::vector<std::string>& layers);
  /// With all but the part itself as `like` has it.
  void add_region(Region region, const Named& like, std::vector<Named>& parts);
  void make_bodies(const std::string& name, std::vector<Named> parts);
  void add_body(const std::string& wanted, std::vector<Named> named);
  static std::vector<std::optional<Layers>> heights_of(const std::vector<Named>& parts);
  double overlap_of(const std::string& name, const std::vector<Named>& parts);
  double overlap_at_level(const std::string& name, const std::vector<const Named*>& parts);
  void take_curves(const std::vector<Part>& parts, Body& body);
  bool is_valid(const Named& named, const std::string& layer);
  OutlineSettings outline_settings() const;
  std::string unused_name(const std::string& wanted);
  void skip(const std::string& place, const std::string& what, const std::string& reason, const std::string& layer);
  /// The layer on whose material the shape may lie, or that it may bound; nothing if there is none.
  std::optional<std::size_t> layer_at(const LostShape& shape, const SegmentStrips& edges) const;
  struct OpenEnd {
    std::string place;  ///< of the line
    Point at;
  };
  std::optional<OpenEnd> open_end_at(const LostShape& shape) const;
  void fail(const std::string& place, const std::string& problem, const std::string& hint) {
    import_.faults.emplace_back(place, problem, hint);
  }

  ImportSettings settings_;
  Import& import_;
  const class CurveFinder* finder_ = nullptr;  ///< of the file that is read, where curves are kept
  FileReport file_;
  bool coarse_join_ = false;               ///< lines are shorter than the distance at which they are joined
  std::vector<std::vector<Named>> parts_;  ///< of each layer of the drawing
  int sources_ = 0;                        ///< that have a number
  int nests_ = 0;                          ///< outermost outlines that have a number
  std::map<std::string, int> names_;
  std::set<std::string> used_;
};

}  // namespace taut::drawing
