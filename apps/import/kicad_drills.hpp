// The drills of a board of KiCad: of pads, which hold it or its parts, and of vias.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "import/affine.hpp"
#include "import/curves.hpp"
#include "import/s_expression.hpp"

namespace taut::drawing {

/// Gathers the drills that go through the board.
class KicadDrills {
 public:
  /// `root` places the board. Those that are at least `least` wide become holes; none without it.
  KicadDrills(const Affine& root, std::optional<double> least, Flattener& flattener)
      : root_(root), least_(least), flattener_(flattener) {}

  /// A pad, where its footprint places what is in it, or a via.
  void read(const SExpression& item, const Affine& footprint, const std::string& place);

  std::vector<Chain> take_holes() { return std::move(holes_); }
  /// What became of the drills; empty if there are none.
  std::vector<std::string> notes() const;

 private:
  const Affine& root_;
  std::optional<double> least_;
  Flattener& flattener_;
  std::vector<Chain> holes_;
  std::size_t pads_ = 0, vias_ = 0, blind_ = 0;  ///< that are no holes
  double narrowest_ = 0, widest_ = 0;            ///< of those
};

}  // namespace taut::drawing
