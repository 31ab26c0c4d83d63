// From cells to rings: labels, corners at which a ring would touch itself, and boundaries with the cells to the left.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "taut/error.hpp"
#include "taut/grid.hpp"

namespace taut {
using namespace internal;
namespace {

constexpr int no_cell = -1;

void validate_grid(const OccupancyGrid& grid) {
  const auto refuse = [](const std::string& what, const std::string& hint) { throw InputError("grid", what, hint); };
  if (grid.width < 1 || grid.height < 1 || grid.width > (1 << 15) || grid.height > (1 << 15))
    refuse("it is " + std::to_string(grid.width) + " by " + std::to_string(grid.height) + " cells",
           "a grid has 1 to 32768 cells in each direction");
  if (grid.occupied.size() != static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height))
    refuse("it has " + std::to_string(grid.occupied.size()) + " cells, not width times height", "give one for each");
  if (!(grid.resolution > 0) || !std::isfinite(grid.resolution))
    refuse("the resolution is not a positive number", "it is the side of a cell, in the units of the scene");
  if (!std::isfinite(grid.origin.x) || !std::isfinite(grid.origin.y) || !std::isfinite(grid.yaw))
    refuse("the origin is not finite", "it is [x, y, yaw]");
}

/// A number for each cell: which set it belongs to, or none. Sets hang together by their sides.
class Labels {
 public:
  Labels(int width, int height) : width_(width), height_(height), of_(cells(), no_cell) {}

  int at(int i, int j) const { return inside(i, j) ? of_[index(i, j)] : no_cell; }
  int width() const { return width_; }
  int height() const { return height_; }
  int count() const { return count_; }

  /// Numbers the sets of cells for which taken(i, j), row by row from the lowest.
  template <class Taken>
  void number(const Taken& taken) {
    std::fill(of_.begin(), of_.end(), no_cell);
    count_ = 0;
    for (int j = 0; j < height_; ++j) {
      for (int i = 0; i < width_; ++i) {
        if (of_[index(i, j)] == no_cell && taken(i, j)) flood(i, j, taken);
      }
    }
  }

 private:
  std::size_t cells() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * static_cast<std::size_t>(width_) + i; }
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < width_ && j < height_; }

  template <class Taken>
  void flood(int i, int j, const Taken& taken) {
    std::vector<std::array<int, 2>> todo{{i, j}};
    of_[index(i, j)] = count_;
    while (!todo.empty()) {
      const auto [x, y] = todo.back();
      todo.pop_back();
      const std::array<std::array<int, 2>, 4> neighbours{{{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}};
      for (const auto& [u, v] : neighbours) {
        if (!inside(u, v) || of_[index(u, v)] != no_cell || !taken(u, v)) continue;
        of_[index(u, v)] = count_;
        todo.push_back({u, v});
      }
    }
    ++count_;
  }

  int width_, height_;
  std::vector<int> of_;
  int count_ = 0;
};

/// Takes cells out until no set meets itself at a corner alone. Returns those taken out.
std::vector<std::array<int, 2>> separate_corners(const OccupancyGrid& grid, const Labels& bodies,
                                                 std::vector<bool>& out) {
  const auto at = [&](int i, int j) {
    const bool taken = i >= 0 && j >= 0 && i < grid.width && j < grid.height &&
                       out[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.width) + i];
    return taken ? no_cell : bodies.at(i, j);
  };
  std::vector<std::array<int, 2>> all;
  for (bool again = true; again;) {
    again = false;
    for (int j = 1; j < grid.height; ++j) {
      for (int i = 1; i < grid.width; ++i) {
        const int a = at(i - 1, j - 1), b = at(i, j - 1), c = at(i - 1, j), d = at(i, j);
        const bool rising = a != no_cell && a == d && b != a && c != a;
        const bool falling = b != no_cell && b == c && a != b && d != b;
        if (!rising && !falling) continue;
        const std::array<int, 2> cell = rising ? std::array<int, 2>{i, j} : std::array<int, 2>{i - 1, j};
        out[static_cast<std::size_t>(cell[1]) * static_cast<std::size_t>(grid.width) + cell[0]] = true;
        all.push_back(cell);
        again = true;
      }
    }
  }
  return all;
}

/// Corners of the grid in the plane.
class Corners {
 public:
  explicit Corners(const OccupancyGrid& grid) : grid_(grid), c_(std::cos(grid.yaw)), s_(std::sin(grid.yaw)) {}
  Point at(int i, int j) const {
    const double x = grid_.resolution * i, y = grid_.resolution * j;
    if (grid_.yaw == 0) return {grid_.origin.x + x, grid_.origin.y + y};
    return {grid_.origin.x + (c_ * x - s_ * y), grid_.origin.y + (s_ * x + c_ * y)};
  }

 private:
  const OccupancyGrid& grid_;
  double c_, s_;
};

/// The boundaries of the sets, cells to the left; no ring touches itself or another one of its set.
class Boundaries {
 public:
  Boundaries(const Labels& sets, const Corners& corners) : sets_(sets), corners_(corners) {
    const auto size = static_cast<std::size_t>(sets.width()) * static_cast<std::size_t>(sets.height());
    seen_.assign(size * 2, false);
  }

  /// A part for each set, in the order of their numbers.
  std::vector<Part> parts() {
    std::vector<Part> parts(static_cast<std::size_t>(sets_.count()));
    // Every ring has a lower side: an outline's with cells above it, a hole's with cells below it. The first side of a
    // set, row by row, is its outline's.
    for (int j = 0; j <= sets_.height(); ++j) {
      for (int i = 0; i < sets_.width(); ++i) {
        const int above = sets_.at(i, j), below = sets_.at(i, j - 1);
        if (above == below) continue;
        if (above != no_cell && !seen(i, j, true)) add(parts[static_cast<std::size_t>(above)], trace(i, j, 0, above));
        if (below != no_cell && !seen(i, j - 1, false))
          add(parts[static_cast<std::size_t>(below)], trace(i + 1, j, 2, below));
      }
    }
    return parts;
  }

 private:
  static void add(Part& part, Polygon ring) {
    if (part.outline.empty())
      part.outline = std::move(ring);
    else
      part.holes.push_back(std::move(ring));
  }
  /// Has the lower (or upper) side of the cell been traced?
  std::vector<bool>::reference seen(int i, int j, bool lower) {
    const std::size_t cell = static_cast<std::size_t>(j) * static_cast<std::size_t>(sets_.width()) + i;
    return seen_[2 * cell + (lower ? 0 : 1)];
  }
  /// From the corner (i, j) towards direction d: 0 right, 1 up, 2 left, 3 down; the set's cells are to the left.
  Polygon trace(int i, int j, int d, int set) {
    static constexpr std::array<std::array<int, 2>, 4> step{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    // The cells ahead of a corner, to the left of direction d and to the right of it.
    static constexpr std::array<std::array<int, 2>, 4> left{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    static constexpr std::array<std::array<int, 2>, 4> right{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
    Polygon ring;
    const int first_i = i, first_j = j, first_d = d;
    do {
      if (d == 0) seen(i, j, true) = true;
      if (d == 2) seen(i - 1, j - 1, false) = true;
      i += step[static_cast<std::size_t>(d)][0];
      j += step[static_cast<std::size_t>(d)][1];
      const auto k = static_cast<std::size_t>(d);
      const bool l = sets_.at(i + left[k][0], j + left[k][1]) == set;
      const bool r = sets_.at(i + right[k][0], j + right[k][1]) == set;
      const int turned = l && !r ? d : r ? (d + 3) % 4 : (d + 1) % 4;
      if (turned != d) ring.push_back(corners_.at(i, j));
      d = turned;
    } while (i != first_i || j != first_j || d != first_d);
    return ring;
  }

  const Labels& sets_;
  const Corners& corners_;
  std::vector<bool> seen_;
};

}  // namespace

std::vector<Body> grid_bodies(const OccupancyGrid& grid) {
  validate_grid(grid);
  Labels bodies(grid.width, grid.height), sets(grid.width, grid.height);
  bodies.number([&](int i, int j) { return grid.at(i, j); });
  if (bodies.count() == 0)
    throw InputError("grid", "no cell is occupied", "an empty map needs no questions; look at the thresholds");
  std::vector<bool> out(grid.occupied.size(), false);
  const std::vector<std::array<int, 2>> alone = separate_corners(grid, bodies, out);
  sets.number([&](int i, int j) {
    return grid.at(i, j) && !out[static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.width) + i];
  });
  const Corners corners(grid);
  std::vector<Body> all(static_cast<std::size_t>(bodies.count()));
  for (std::size_t k = 0; k < all.size(); ++k) all[k].name = "cells " + std::to_string(k + 1);
  // The cell of each set with the lowest number determines whose it is.
  std::vector<int> owner(static_cast<std::size_t>(sets.count()), no_cell);
  for (int j = 0; j < grid.height; ++j) {
    for (int i = 0; i < grid.width; ++i) {
      if (sets.at(i, j) != no_cell) owner[static_cast<std::size_t>(sets.at(i, j))] = bodies.at(i, j);
    }
  }
  std::vector<Part> parts = Boundaries(sets, corners).parts();
  for (std::size_t k = 0; k < parts.size(); ++k)
    all[static_cast<std::size_t>(owner[k])].parts.push_back(std::move(parts[k]));
  for (const auto& [i, j] : alone) {
    all[static_cast<std::size_t>(bodies.at(i, j))].parts.push_back(
        {{corners.at(i, j), corners.at(i + 1, j), corners.at(i + 1, j + 1), corners.at(i, j + 1)}, {}});
  }
  return all;
}

}  // namespace taut
