// From world coordinates to the pixels of a picture.
#pragma once

#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::io {

/// A frame of `width` pixels whose inner part shows all the points given; y points up in the world.
class SvgCanvas {
 public:
  /// Pixels around that part, on all sides.
  static constexpr double margin = 24;

  SvgCanvas(const std::vector<Point>& points, int width, double top, double bottom);

  double width() const { return width_; }
  double height() const { return height_; }
  /// Pixels a unit of length.
  double scale() const { return scale_; }
  /// World to pixels.
  Point pixel(const Point& p) const;

 private:
  double width_ = 0, height_ = 0;
  Point world_centre_, pixel_centre_;
  double scale_ = 1;
};

/// The room above a picture for its title.
inline constexpr double title_height = 30;

/// The beginning of a picture of so many pixels, which is no larger than the window that shows it; `more` are further
/// attributes.
std::string svg_tag(double width, double height, const std::string& more);
/// "x,y" with two decimals: finer than any screen shows, and short.
std::string pixel_text(const Point& pixel);
/// A closed outline as the data of a path.
std::string outline_path(const std::vector<Point>& pixels);
/// Text for use between tags or in an attribute.
std::string escape_xml(const std::string& text);

/// Those of the first two bodies in pictures of many: see body_style().
inline constexpr const char* body_fill[2] = {"#2a6f9e", "#e59345"};
inline constexpr const char* body_line[2] = {"#032e4b", "#683e15"};
inline constexpr const char* tiling_colour = "#5f6b76";
inline constexpr const char* pq_colour = "#c2187a";
inline constexpr const char* convex_colour = "#1b1b1b";
inline constexpr const char* reflex_colour = "#138a4e";
inline constexpr const char* geodesic_colour[2] = {"#0b4f9e", "#8f3d00"};
inline constexpr const char* separator_colour = "#6a2fb5";
inline constexpr const char* gone_colour = "#8a8a8a";
inline constexpr const char* come_colour = "#d7191c";
inline constexpr const char* contact_colour = "#d7191c";
/// Of the bar of time of a motion in which nothing is marked: green is a claim, for which somebody has to have asked.
inline const char* bar_colour(bool proved_free) { return proved_free ? reflex_colour : tiling_colour; }

// A panel of a chart over time: axes with round numbers, and where a value is in pixels.

/// At most `count` + 1 round numbers (1, 2 or 5 times a power of ten apart) from lo to hi.
std::vector<double> round_numbers(double lo, double hi, int count);

struct PlotPanel {
  double left = 0, top = 0, width = 0, height = 0;  ///< pixels, within the axes
  double t_lo = 0, t_hi = 1, v_lo = 0, v_hi = 1;

  double x(double t) const;
  double y(double v) const;
  /// Lines and numbers below the panel, and a word for what they are.
  std::string time_axis(const std::string& word) const;
  /// Lines and numbers to the left of it.
  std::string value_axis() const;
};

/// The head of a chart of that size, with its title, on a white ground, and how its text is set.
std::string chart_head(double width, double height, const std::string& title);
std::string chart_text(double x, double y, const std::string& what, const char* anchor = "start");
/// In place of what an answer does not say: "undecided: the time limit was reached", or why nothing was tested.
std::string no_verdict(Outcome outcome, const std::string& reason);
/// With two decimals, as short as it can be.
std::string chart_number(double pixels);

}  // namespace taut::internal::io
