// Splines through points, and shapes that are not read although they may bound material.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "import/fit_spline.hpp"
#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::FitPoints;
using drawing::Import;
using drawing::ImportSettings;
using testing::DxfText;
using testing::examine;
using testing::totals_of;

/// The second derivative of a cubic Bezier curve by the length of its chord, at its start or end.
Point bend_of(const std::array<Point, 4>& c, bool end) {
  const double h = std::hypot(c[3].x - c[0].x, c[3].y - c[0].y);
  const Point &a = end ? c[3] : c[0], &b = end ? c[2] : c[1], &d = end ? c[1] : c[2];
  return {6 * (a.x - 2 * b.x + d.x) / (h * h), 6 * (a.y - 2 * b.y + d.y) / (h * h)};
}

Point slope_of(const std::array<Point, 4>& c, bool end) {
  const double h = std::hypot(c[3].x - c[0].x, c[3].y - c[0].y);
  const Point &a = end ? c[3] : c[1], &b = end ? c[2] : c[0];
  return {3 * (a.x - b.x) / h, 3 * (a.y - b.y) / h};
}

void expect_near(const Point& p, const Point& q) {
  EXPECT_NEAR(p.x, q.x, 1e-9);
  EXPECT_NEAR(p.y, q.y, 1e-9);
}

const std::vector<Point> fit_points{{0, 0}, {3, 1}, {4, 5}, {1, 7}, {-2, 4}};

TEST(FitSpline, HasContinuousSecondDerivatives) {
  for (const bool closed : {false, true}) {
    const auto curves = drawing::fit_spline({fit_points, {}, {}, closed});
    ASSERT_EQ(curves.size(), closed ? 5u : 4u);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_EQ(curves[i][0], fit_points[i]);
      if (!closed && i + 1 == curves.size()) break;
      const auto& next = curves[(i + 1) % curves.size()];
      EXPECT_EQ(curves[i][3], next[0]);
      expect_near(slope_of(curves[i], true), slope_of(next, false));
      expect_near(bend_of(curves[i], true), bend_of(next, false));
    }
    if (closed) continue;
    expect_near(bend_of(curves.front(), false), {0, 0});
    expect_near(bend_of(curves.back(), true), {0, 0});
  }
}

TEST(FitSpline, BeginsAndEndsAlongItsTangents) {
  const auto curves = drawing::fit_spline({fit_points, Point{0, 2}, Point{-3, 0}, false});
  expect_near(slope_of(curves.front(), false), {0, 1});
  expect_near(slope_of(curves.back(), true), {-1, 0});
}

TEST(FitSpline, TakesRepeatedPointsOnce) {
  EXPECT_TRUE(drawing::fit_spline({{{1, 1}, {1, 1}}, {}, {}, true}).empty());
  EXPECT_EQ(drawing::fit_spline({{{1, 1}, {1, 1}, {2, 1}}, {}, {}, true}).size(), 1u);
  EXPECT_EQ(drawing::fit_spline({{{0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 0}}, {}, {}, true}).size(), 3u);
}

DxfText& fitted(DxfText& text, const std::vector<Point>& points, bool closed) {
  text.begin("SPLINE", "0").group(70, closed ? "11" : "8").group(71, "3").group(74, std::to_string(points.size()));
  for (const Point& p : points) text.at(11, p);
  return text;
}

/// Twelve points of a circle: the spline through them is within a thousandth of it.
std::vector<Point> circle_points(const Point& centre, double r) {
  std::vector<Point> points;
  for (int k = 0; k < 12; ++k)
    points.push_back(
        {centre.x + r * std::cos(k * 0.5235987755982988), centre.y + r * std::sin(k * 0.5235987755982988)});
  return points;
}

TEST(ImportLost, ReadsSplinesWithoutControlPoints) {
  DxfText plate;
  plate.box({0, 0}, {20, 20});
  fitted(plate, circle_points({10, 10}, 4), true);
  const Import import = examine(plate);
  EXPECT_TRUE(import.faults.empty());
  EXPECT_EQ(totals_of(import).holes, 1u);
  EXPECT_NEAR(totals_of(import).area, 400 - 16 * 3.14159265, 0.2);
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_NE(import.files[0].notes[0].find("1 spline has no control points"), std::string::npos);
}

/// Exit 0 only if nothing that may bound the plate was left out; each of these may, or lies elsewhere.
TEST(ImportLost, RefusesToSkipWhatMayBoundMaterial) {
  const auto with = [](const std::function<void(DxfText&)>& draw, const ImportSettings& settings = {}) {
    DxfText plate;
    plate.box({0, 0}, {20, 20});
    draw(plate);
    return examine(plate, settings);
  };
  const auto face = [](const Point& at) {
    return [at](DxfText& text) {
      text.begin("3DFACE", "0");
      for (int k = 0; k < 4; ++k) text.at(10 + k, {at.x + k % 2, at.y + k / 2.0});
    };
  };
  const auto region = [](DxfText& text) { text.begin("REGION", "0").group(1, "mno ..."); };
  const auto insert = [](DxfText& text) { text.begin("INSERT", "0").group(2, "gone").at(10, {50, 50}); };
  const auto spline = [](DxfText& text) { text.begin("SPLINE", "0").group(71, "3").at(10, {3, 3}).at(10, {5, 4}); };
  for (const std::function<void(DxfText&)>& draw :
       {std::function<void(DxfText&)>(face({5, 5})), std::function<void(DxfText&)>(face({19.5, 5})),
        std::function<void(DxfText&)>(region), std::function<void(DxfText&)>(insert),
        std::function<void(DxfText&)>(spline)}) {
    const Import import = with(draw);
    ASSERT_EQ(import.faults.size(), 1u);
    EXPECT_NE(import.faults[0].hint().find("--open skip"), std::string::npos);
    ImportSettings skip;
    skip.open = drawing::OpenRings::skip;
    EXPECT_TRUE(with(draw, skip).faults.empty());
  }
  EXPECT_TRUE(with(face({40, 5})).faults.empty());
  for (const char* type : {"TEXT", "POINT", "DIMENSION", "LEADER"})
    EXPECT_TRUE(with([&](DxfText& text) { text.begin(type, "0").at(10, {5, 5}); }).faults.empty()) << type;
}

TEST(ImportLost, TakesFillingsForMaterialAndNotForHoles) {
  const auto solid = [](double x, const std::string& layer) {
    DxfText text;
    text.box({0, 0}, {20, 20}).begin("SOLID", layer);
    text.at(10, {x, 5}).at(11, {x + 4, 5}).at(12, {x, 8}).at(13, {x + 4, 8});
    return examine(text);
  };
  // Corners in the order 1, 2, 4, 3: not a bow.
  EXPECT_EQ(totals_of(solid(30, "filled")).area, 412);
  EXPECT_TRUE(solid(5, "0").faults.empty());
  EXPECT_EQ(solid(18, "0").faults.size(), 1u);
}

TEST(ImportLost, RefusesShapesOfSvgThatMayBeAnywhere) {
  const auto with = [](const std::string& more) {
    return examine("<svg><rect width='20' height='20'/>" + more + "</svg>", "d.svg");
  };
  EXPECT_EQ(with("<use href='other.svg#gone'/>").faults.size(), 1u);
  EXPECT_EQ(with("<circle cx='50%' cy='9' r='3'/>").faults.size(), 1u);
  EXPECT_EQ(with("<circle r='3' style='zoom:2'/>").faults.size(), 1u);
  EXPECT_TRUE(with("<rect width='100%' height='100%' fill='white'/>").faults.empty());
  EXPECT_TRUE(with("<text x='5' y='5'>hole</text>").faults.empty());
}

}  // namespace
}  // namespace taut
