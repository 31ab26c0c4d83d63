// What SVG says about what is seen of a shape: clips, masks, clear colours, and styles that move it.
#include <gtest/gtest.h>

#include "support/drawings.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using drawing::Import;
using testing::examine;
using testing::totals_of;

/// Is the file refused because of something that is not read?
std::string refused(const std::string& inside) {
  const Import import = examine("<svg>" + inside + "</svg>", "d.svg");
  return import.faults.empty() ? "" : import.faults[0].what();
}

TEST(ImportSvgClip, ObeysRectanglesAndRefusesOtherClips) {
  const std::string defs =
      "<defs><clipPath id='page'><rect width='100' height='100'/></clipPath>"
      "<clipPath id='path'><path d='M0 0H100V100H0z' transform='translate(1)'/></clipPath>"
      "<clipPath id='disc'><circle r='50'/></clipPath>"
      "<clipPath id='box' clipPathUnits='objectBoundingBox'><rect width='1' height='1'/></clipPath>"
      "<clipPath id='two'><rect width='100' height='100'/><rect width='9' height='9'/></clipPath>"
      "<mask id='white' maskUnits='userSpaceOnUse' x='0' y='0' width='100' height='100'><path fill='white' "
      "d='M0 0h100v100H0z'/></mask>"
      "<mask id='small' maskUnits='userSpaceOnUse' x='0' y='0' width='15' height='15'><path fill='white' "
      "d='M0 0h100v100H0z'/></mask>"
      "<mask id='black'><rect width='100' height='100' fill='black'/></mask></defs>";
  const auto clipped = [&](const std::string& how) {
    return defs + "<g " + how + "><rect x='10' y='10' width='20' height='10'/></g>";
  };
  for (const char* fine :
       {"clip-path='url(#page)'", "style='clip-path:url(\"#page\")'", "clip-path='url(#path)'", "mask='url(#white)'",
        "clip-path='none'", "clip-path='url(#missing)'", "clip-path='url(#page)' transform='rotate(90 50 50)'"}) {
    EXPECT_EQ(refused(clipped(fine)), "") << fine;
    EXPECT_NEAR(totals_of(examine("<svg>" + clipped(fine) + "</svg>", "d.svg")).area, 200, 1e-9) << fine;
  }
  for (const char* other : {"clip-path='url(#disc)'", "clip-path='url(#box)'", "clip-path='url(#two)'",
                            "mask='url(#small)'", "mask='url(#black)'", "clip-path='circle(3px)'"})
    EXPECT_NE(refused(clipped(other)).find("hint"), 0u) << other;
  EXPECT_NE(refused(clipped("clip-path='url(#disc)'")).find("not obeyed"), std::string::npos);
  EXPECT_NE(refused(clipped("mask='url(#small)'")).find("reaches beyond the frame"), std::string::npos);
  // What lies beyond the clip is not seen, and what lies across it would be cut.
  EXPECT_NE(refused(defs + "<rect clip-path='url(#page)' x='90' width='20' height='10'/>").find("remove the clip"),
            std::string::npos);
  const Import beyond = examine("<svg>" + defs +
                                    "<rect clip-path='url(#page)' x='200' width='20' height='10'/>"
                                    "<rect width='1' height='1'/></svg>",
                                "d.svg");
  EXPECT_NEAR(totals_of(beyond).area, 1, 1e-12);
}

TEST(ImportSvgClip, NamesWhatMovesShapesAndIsNotRead) {
  const std::string end = " width='2' height='1'/>";
  EXPECT_NE(refused("<rect transform='rotate(90)' transform-origin='center' transform-box='fill-box'" + end)
                .find("transform-box"),
            std::string::npos);
  EXPECT_EQ(refused("<rect transform='rotate(90)' transform-origin='0 0'" + end), "");
  EXPECT_EQ(refused("<rect transform='translate(3)' transform-origin='5 5'" + end), "");
  EXPECT_EQ(refused("<rect transform-origin='5 5'" + end), "");
  EXPECT_NE(refused("<g style='rotate:x 30deg'><rect" + end + "</g>").find("\"rotate\""), std::string::npos);
  const Import sheet = examine("<?xml-stylesheet href='a.css'?><svg><rect" + end + "</svg>", "d.svg");
  ASSERT_EQ(sheet.faults.size(), 1u);
  EXPECT_NE(std::string(sheet.faults[0].what()).find("xml-stylesheet"), std::string::npos);
  for (const char* name : {"link", "html:link"})
    EXPECT_NE(refused("<" + std::string(name) + " rel='stylesheet' href='a.css'/><rect" + end).find("another file"),
              std::string::npos);
}

TEST(ImportSvgClip, TakesColoursWithoutCoverForNone) {
  // The last two name what is not in the file.
  for (const char* clear : {"rgb(0 0 0 / 0%)", "rgba(0,0,0,0)", "hsl(120deg 10% 10% / 0)", "color(srgb 1 0 0 / 0.0)",
                            "rgb(1,2,3,0)", "url(#nowhere)", "url(#nowhere) none"})
    EXPECT_EQ(
        totals_of(examine(std::string("<svg><rect width='9' height='9'/><rect x='20' width='9' height='9' fill='") +
                              clear + "'/></svg>",
                          "d.svg"))
            .parts,
        1u)
        << clear;
  for (const char* solid : {"rgb(0 0 0 / 10%)", "rgb(0,0,0)", "rgb(10 20 0)", "url(#a/0)", "url(#a/0) none",
                            "url(#nowhere) red", "hsl(0,0,0)"})
    EXPECT_EQ(
        totals_of(
            examine(
                std::string(
                    "<svg><pattern id='a/0'/><rect width='9' height='9'/><rect x='20' width='9' height='9' fill='") +
                    solid + "'/></svg>",
                "d.svg"))
            .parts,
        2u)
        << solid;
}

TEST(ImportSvgClip, ObeysTheClipsOfIllustrator) {
  const std::string defs =
      "<defs><rect id='r' width='100' height='100'/><clipPath id='c'><use xlink:href='#r' x='2'/></clipPath></defs>";
  EXPECT_NEAR(
      totals_of(examine("<svg>" + defs + "<rect clip-path='url(#c)' x='5' width='40' height='40'/></svg>", "d.svg"))
          .area,
      1600, 1e-9);
  EXPECT_NE(refused(defs + "<rect clip-path='url(#c)' width='40' height='40'/>"), "") << "it reaches beyond the clip";
}

/// Whatever its spelling, what fills the page without a line is its background if it is white, and unclear otherwise.
TEST(ImportSvgClip, LeavesOutThePagesBackgroundHoweverItIsSpelled) {
  const std::string disc = "<circle cx='20' cy='20' r='5' fill='red'/>";
  const auto page = [&](const std::string& shape) {
    return examine("<svg width='40mm' height='40mm' viewBox='0 0 40 40'>" + shape + disc + "</svg>", "d.svg");
  };
  for (const char* spelled : {"<rect width='100%' height='100%' ", "<rect width='40' height='40' ",
                              "<path d='M0 40H40V0H0z' ", "<polygon points='0,0 40,0 40,40 0,40' "}) {
    const Import white = page(std::string(spelled) + "fill='#FFF'/>");
    EXPECT_NEAR(totals_of(white).area, 78.5, 0.3) << spelled;
    EXPECT_EQ(white.files[0].skipped.size(), 1u) << spelled;
    EXPECT_EQ(page(std::string(spelled) + "fill='#ccc'/>").faults.size(), 1u) << spelled;
    EXPECT_EQ(page(std::string(spelled) + "/>").faults.size(), 1u) << spelled;
    EXPECT_NEAR(totals_of(page(std::string(spelled) + "fill='white' stroke='red'/>")).area, 1600 + 78.5, 0.3)
        << spelled;
  }
  for (const char* shape :
       {"<rect width='100%' height='100%' rx='4' fill='white'/>", "<rect width='40' height='39' fill='white'/>"})
    EXPECT_TRUE(page(shape).faults.empty() && page(shape).files[0].skipped.empty()) << shape;
}

}  // namespace
}  // namespace taut
