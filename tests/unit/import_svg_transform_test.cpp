// Where styles and attributes of SVG place shapes.
#include <gtest/gtest.h>

#include "import/svg_transform.hpp"
#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::Affine;
using drawing::Import;
using testing::examine;

void expect_same_transform(const std::string& css, const std::string& attribute) {
  const auto a = drawing::transform_of(css), b = drawing::transform_of(attribute);
  ASSERT_TRUE(a && b) << css;
  for (const auto member : {&Affine::a, &Affine::b, &Affine::c, &Affine::d, &Affine::e, &Affine::f})
    EXPECT_NEAR((*a).*member, (*b).*member, 1e-12) << css;
}

TEST(ImportSvgTransform, StylesWriteUnits) {
  expect_same_transform("rotate(90deg)", "rotate(90)");
  expect_same_transform("rotate(0.25turn) rotate(-100grad)", "rotate(0)");
  expect_same_transform("rotate(1.5707963267948966rad)", "rotate(90)");
  expect_same_transform("translate(10px, 1in)", "translate(10 96)");
  expect_same_transform("translateX(4px) translateY(25.4mm)", "translate(4 96)");
  expect_same_transform("scale(2) scaleX(3) scaleY(50%)", "scale(6,1)");
  expect_same_transform("skew(30deg)", "skewX(30)");
  expect_same_transform("skew(0, 30deg) SKEWX(10deg)", "skewY(30) skewX(10)");
  expect_same_transform("matrix(1, 2, 3, 4, 5, 6)", "matrix(1 2 3 4 5 6)");
  for (const char* other : {"rotate3d(1,0,0,9deg)", "translate(50%)", "scale(2", "rotate()", "matrix(1 2 3)",
                            "scale(1px)", "rotate(1 2)", "turn(3)", "translate(1 2 3)", "perspective(3px)"})
    EXPECT_FALSE(drawing::transform_of(other)) << other;
}

/// The box around what is drawn, in the drawing's own direction of y.
struct DrawnBox {
  double lo_x, lo_y, hi_x, hi_y;
};

DrawnBox box_of_svg(const std::string& body) {
  const Import import = examine("<svg viewBox='0 0 200 100'>" + body + "</svg>", "d.svg");
  EXPECT_TRUE(import.faults.empty()) << body << ": " << (import.faults.empty() ? "" : import.faults[0].what());
  if (import.bodies.size() != 1) return {0, 0, 0, 0};
  return {import.bodies[0].low.x, -import.bodies[0].high.y, import.bodies[0].high.x, -import.bodies[0].low.y};
}

void expect_box(const std::string& body, const DrawnBox& wanted) {
  const DrawnBox box = box_of_svg(body);
  EXPECT_NEAR(box.lo_x, wanted.lo_x, 1e-9) << body;
  EXPECT_NEAR(box.lo_y, wanted.lo_y, 1e-9) << body;
  EXPECT_NEAR(box.hi_x, wanted.hi_x, 1e-9) << body;
  EXPECT_NEAR(box.hi_y, wanted.hi_y, 1e-9) << body;
}

TEST(ImportSvgTransform, OriginsAreInTheViewport) {
  const std::string rect = "<rect x='10' y='10' width='20' height='10' ";
  expect_box(rect + "transform='rotate(90)' transform-origin='20 15'/>", {15, 5, 25, 25});
  expect_box(rect + "style='transform:rotate(90deg);transform-origin:20px 15px'/>", {15, 5, 25, 25});
  expect_box(rect + "transform='scale(2)' transform-origin='center'/>", {-80, -30, -40, -10});
  expect_box(rect + "transform='scale(2)' transform-origin='right top'/>", {-180, 20, -140, 40});
  expect_box(rect + "transform='scale(2)' transform-origin='bottom 10%'/>", {0, -80, 40, -60});
  expect_box(rect + "transform='scale(2)' style='transform-box:view-box;transform-origin:0 0'/>", {20, 20, 60, 40});
  // The rule outdoes the attribute.
  expect_box("<style>rect{transform:none}</style>" + rect + "transform='scale(2)'/>", {10, 10, 30, 20});
  expect_box("<style>g{transform:translate(5px)}</style><g transform='scale(2)'>" + rect + "/></g>", {15, 10, 35, 20});
}

TEST(ImportSvgTransform, PropertiesPlaceInTheirOrder) {
  const std::string rect = "<rect x='10' y='10' width='20' height='10' style='";
  expect_box(rect + "translate:10px 5px'/>", {20, 15, 40, 25});
  expect_box(rect + "translate:10%'/>", {30, 10, 50, 20});
  expect_box(rect + "scale:2 50%'/>", {20, 5, 60, 10});
  expect_box(rect + "rotate:90deg'/>", {-20, 10, -10, 30});
  // First what `transform` says, then scale, rotate and translate.
  expect_box(rect + "transform:translate(-10px,-10px);scale:2;rotate:90deg;translate:100px'/>", {80, 0, 100, 40});
  expect_box(
      "<style>rect{rotate:0.25turn;transform-origin:10px 10px}</style><rect x='10' y='10' width='20' height='10'/>",
      {0, 10, 10, 30});
  // Attributes of these names are not meant.
  expect_box("<rect x='10' y='10' width='20' height='10' rotate='45' scale='7'/>", {10, 10, 30, 20});
}

TEST(ImportSvgTransform, WhatDependsOnTheElementsBoxIsAnError) {
  for (const char* style : {"transform:rotate(9deg);transform-box:fill-box", "transform:translate(10%,0)",
                            "rotate:x 9deg", "transform:rotate(9deg);transform-origin:calc(1px + 2px) 0"})
    EXPECT_EQ(
        examine(std::string("<svg><rect width='2' height='1' style='") + style + "'/></svg>", "d.svg").faults.size(),
        1u)
        << style;
}

}  // namespace
}  // namespace taut
