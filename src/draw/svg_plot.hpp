// A panel of a chart over time: axes with round numbers, and where a value is in pixels.
#pragma once

#include <string>
#include <vector>

#include "taut/check.hpp"

namespace taut::internal::io {

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
