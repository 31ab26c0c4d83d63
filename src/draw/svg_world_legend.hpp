// What the colours and numbers of a world's picture stand for.
#pragma once

#include <string>
#include <vector>

#include "taut/scene.hpp"

namespace taut::internal::io {

/// Bodies in columns, each below its parent and indented by its depth, families together; then the pairs that nobody
/// asked about. So many bodies and pairs are listed as one can still read; how many more there are is said.
class WorldLegend {
 public:
  WorldLegend(const Scene& scene, int width);

  /// Room needed below the picture, in pixels.
  double height() const;
  /// The elements, from this height on.
  std::string draw(double top) const;

 private:
  struct Entry {
    std::size_t body = 0;
    int depth = 0;
    std::size_t column = 0, row = 0;
    std::string layers = {};  ///< what is written behind the name
  };
  void add_family(const std::vector<std::vector<std::size_t>>& children, std::size_t body, int depth);
  std::size_t place(std::size_t rows);
  std::size_t family_at(std::size_t entry) const;
  void choose_rows();
  void add_notes();
  std::string draw_entry(const Entry& entry, double top) const;
  double column_width() const;

  const Scene& scene_;
  double width_;
  std::vector<Entry> entries_;  ///< in the order of the tree
  std::size_t shown_ = 0;
  std::size_t rows_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace taut::internal::io
