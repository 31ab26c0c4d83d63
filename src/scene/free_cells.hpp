// Where in a map there certainly is something, or nothing, in cells: most questions about what lies inside what end
// here.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/box_tree.hpp"
#include "scene/instance.hpp"

namespace taut::internal {

/// A grid over bodies at rest. A cell is free if no boundary comes near it and no body is around its middle, covered if
/// one is. Boundaries are drawn wider by far more than rounding and the displacement, so that this holds for both
/// readings of touching. A free cell also has its distance from the next one that is not.
class FreeCells {
 public:
  /// Throws InputError where a body has features that are finer than the displacement.
  explicit FreeCells(const std::vector<SharedRings>& bodies);

  enum class Cell : std::uint8_t { mixed, covered, free };
  /// `free`: the point is certainly outside of all bodies. `covered`: certainly inside of one. Internal coordinates.
  Cell at(double x, double y) const {
    if (!(x > lo_x_ && x < hi_x_ && y > lo_y_ && y < hi_y_))
      return x < lo_x_ || x > hi_x_ || y < lo_y_ || y > hi_y_ ? Cell::free : Cell::mixed;
    return static_cast<Cell>(std::min<std::uint8_t>(value_at(x, y), 2));
  }
  /// No body certainly has a point nearer than this, in the larger of the two coordinates; 0 if nothing is known.
  double room(double x, double y) const {
    if (!(x > lo_x_ && x < hi_x_ && y > lo_y_ && y < hi_y_))
      return std::max({0.0, lo_x_ - x, x - hi_x_, lo_y_ - y, y - hi_y_});
    // As many cells on each side; the index of the cell is rounded.
    constexpr double certain = 1 - 0x1p-20;
    const std::uint8_t value = value_at(x, y);
    return value > 3 ? (value - 3) * certain * cell_ : 0;
  }
  /// Adds the bodies of which an outline has its first vertex in the box, in order.
  void outlines_in(const AxisBox& box, std::vector<int>& bodies) const;

 private:
  struct BoundaryEdge {
    double ax, ay, bx, by;
  };
  std::uint8_t value_at(double x, double y) const {
    const auto i = static_cast<std::size_t>((x - lo_x_) * per_cell_);
    const auto j = static_cast<std::size_t>((y - lo_y_) * per_cell_);
    return i < width_ && j < height_ ? cells_[j * width_ + i] : 0;
  }
  void fill(const std::vector<BoundaryEdge>& edges);
  void draw(const BoundaryEdge& edge);
  void measure();

  double lo_x_ = 0, lo_y_ = 0, hi_x_ = 0, hi_y_ = 0, cell_ = 1, per_cell_ = 1;
  std::size_t width_ = 0, height_ = 0;
  std::vector<std::uint8_t> cells_;  ///< a Cell, plus, for a free one, its distance in cells from the next other one
  BoxTree outlines_;
  std::vector<int> outline_of_;
};

/// Made when first asked for, by one thread.
class FreeCellsOnce {
 public:
  const FreeCells& of(const std::vector<SharedRings>& bodies) {
    std::call_once(made_, [&] { cells_ = std::make_unique<const FreeCells>(bodies); });
    return *cells_;
  }

 private:
  std::once_flag made_;
  std::unique_ptr<const FreeCells> cells_;
};

}  // namespace taut::internal
