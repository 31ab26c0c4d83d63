// What the colours of a picture mean.
#pragma once

#include <string>
#include <vector>

#include "taut/io.hpp"

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

}  // namespace taut::internal::io
