// What the colours of a picture mean.
#pragma once

#include <string>
#include <vector>

#include "taut/io.hpp"
#include "taut/scene.hpp"

namespace taut::internal::io {

/// How a path over the picture is drawn.
struct PathStyle {
  const char* colour;
  double width;
  bool dashed;
  const char* label;
};
PathStyle path_style(DrawnPath::Kind kind);

/// Entries in rows that fit the picture's width.
class SvgLegend {
 public:
  SvgLegend(const Scene& scene, const Tiling& tiling, const TilingDrawOptions& options);

  /// Room needed below the picture, in pixels.
  double height() const;
  /// The elements, for a picture of this height.
  std::string draw(double picture_height) const;

 private:
  struct Entry {
    std::string mark, label;
    double x = 0;
    int row = 0;
  };
  void add(std::string mark, const std::string& label);

  double width_, x_;
  int row_ = 0;
  std::vector<Entry> entries_;
};

// What the colours and numbers of a world's picture stand for.

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
