// Drawings as text, for tests of the import.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "import/import.hpp"
#include "io/text.hpp"

namespace taut::testing {
using namespace internal;

/// The entities of a DXF drawing, one after the other.
class DxfText {
 public:
  DxfText& line(const Point& a, const Point& b, const std::string& layer = "0") {
    begin("LINE", layer);
    return at(10, a).at(11, b);
  }
  DxfText& circle(const Point& centre, double radius, const std::string& layer = "0") {
    begin("CIRCLE", layer);
    return at(10, centre).group(40, io::number_text(radius));
  }
  /// From one angle counterclockwise to the other, in degrees.
  DxfText& arc(const Point& centre, double radius, double from, double to, const std::string& layer = "0") {
    begin("ARC", layer);
    at(10, centre).group(40, io::number_text(radius));
    return group(50, io::number_text(from)).group(51, io::number_text(to));
  }
  DxfText& polyline(const std::vector<Point>& points, bool closed, const std::string& layer = "0") {
    begin("LWPOLYLINE", layer);
    group(70, closed ? "1" : "0");
    for (const Point& p : points) at(10, p);
    return *this;
  }
  /// The four sides as lines.
  DxfText& box(const Point& low, const Point& high, const std::string& layer = "0") {
    line(low, {high.x, low.y}, layer).line({high.x, low.y}, high, layer);
    return line(high, {low.x, high.y}, layer).line({low.x, high.y}, low, layer);
  }
  DxfText& begin(const std::string& type, const std::string& layer) { return group(0, type).group(8, layer); }
  DxfText& at(int code, const Point& p) {
    return group(code, io::number_text(p.x)).group(code + 10, io::number_text(p.y));
  }
  DxfText& group(int code, const std::string& value) {
    entities_ += std::to_string(code) + "\n" + value + "\n";
    return *this;
  }

  /// With millimetres as its unit.
  std::string file(int unit = 4) const {
    return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n" + std::to_string(unit) +
           "\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" + entities_ + "0\nENDSEC\n0\nEOF\n";
  }

 private:
  std::string entities_;
};

inline drawing::Import examine(const std::string& text, const std::string& name,
                               const drawing::ImportSettings& settings = {}) {
  return drawing::examine_drawings({drawing::read_drawing(text, name, settings)}, settings);
}

inline drawing::Import examine(const DxfText& drawing, const drawing::ImportSettings& settings = {}) {
  return examine(drawing.file(), "d.dxf", settings);
}

struct Totals {
  double area = 0;
  std::size_t bodies = 0, parts = 0, holes = 0;
};

inline Totals totals_of(const drawing::Import& import) {
  Totals totals;
  for (const drawing::BodyReport& body : import.bodies) {
    totals.area += body.area;
    totals.parts += body.parts;
    totals.holes += body.holes;
    ++totals.bodies;
  }
  return totals;
}

inline void expect_totals(const drawing::Import& import, double area, std::size_t parts, std::size_t holes,
                          double within = 1e-9) {
  const Totals totals = totals_of(import);
  EXPECT_TRUE(import.faults.empty()) << import.faults.front().what();
  EXPECT_NEAR(totals.area, area, within) << drawing::report_text(import, {});
  EXPECT_EQ(totals.parts, parts) << drawing::report_text(import, {});
  EXPECT_EQ(totals.holes, holes) << drawing::report_text(import, {});
}

}  // namespace taut::testing
