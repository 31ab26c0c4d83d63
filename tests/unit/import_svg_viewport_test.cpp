// What of an SVG drawing is to be seen, and how large.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "import/import.hpp"
#include "support/drawings.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using drawing::Import;
using testing::examine;
using testing::totals_of;

Import svg_of(const std::string& root, const std::string& inside) {
  return examine("<svg " + root + ">" + inside + "</svg>", "d.svg");
}

/// Of the first body.
Point size_of(const Import& import) {
  const drawing::BodyReport& body = import.bodies.at(0);
  return {body.high.x - body.low.x, body.high.y - body.low.y};
}

struct Expected {
  const char *root, *inside;
  double width, height;
  double within = 1e-9;
};

void expect_size(const Expected& e) {
  SCOPED_TRACE(std::string(e.root) + " " + e.inside);
  const Import import = svg_of(e.root, e.inside);
  ASSERT_EQ(import.bodies.size(), 1u) << report_text(import, {});
  EXPECT_NEAR(size_of(import).x, e.width, e.within);
  EXPECT_NEAR(size_of(import).y, e.height, e.within);
}

TEST(ImportSvgPaint, LeavesOutWhatHasNeitherFillNorStroke) {
  const std::string plate = "<rect width='9' height='9'/>";
  for (const char* hidden :
       {"fill='none'", "style='fill:none;stroke:none'", "fill='none' stroke='red' stroke-width='0'",
        "fill='none' stroke='red' stroke-opacity='0'", "fill-opacity='0'", "fill-opacity='0%'", "opacity='0.0'",
        "fill='none' stroke='transparent'", "style='FILL:None'"}) {
    const Import import = svg_of("", plate + "<rect x='20' width='5' height='5' " + hidden + "/>");
    EXPECT_EQ(totals_of(import).area, 81) << hidden;
    ASSERT_EQ(import.files[0].skipped.size(), 1u) << hidden;
    EXPECT_FALSE(import.files[0].skipped[0].unread);
  }
  for (const char* seen :
       {"fill='none' stroke='red'", "style='fill:none;stroke:#000'", "stroke='none'", "opacity='0.1'",
        "fill-opacity='0' stroke='red'", "fill='none' stroke='red' stroke-width='0.01'"})
    EXPECT_EQ(totals_of(svg_of("", plate + "<rect x='20' width='5' height='5' " + seen + "/>")).area, 106) << seen;
  // Paints go from groups, and from the drawing itself, to what is in them.
  EXPECT_EQ(totals_of(svg_of("fill='none' stroke='red'", plate + "<circle cx='4' cy='4' r='1'/>")).holes, 1u);
  EXPECT_EQ(totals_of(svg_of("", "<g opacity='0'>" + plate + "</g>" + plate)).area, 81);
}

TEST(ImportSvgPaint, TakesShapesForOutlinesWhereNothingIsPainted) {
  const std::string shapes = "<g fill='none'><rect width='9' height='9'/><circle cx='4' cy='4' r='2'/></g>";
  const Import import = svg_of("", shapes + "<rect x='50' width='3' height='3' display='none'/>");
  EXPECT_EQ(totals_of(import).holes, 1u);
  ASSERT_EQ(import.files[0].notes.size(), 1u);
  EXPECT_EQ(import.files[0].notes[0], "nothing in the file is painted: its 2 shapes are read as outlines");
  // Where anything is painted, what is not is not meant.
  const Import painted = svg_of("", shapes + "<rect x='50' width='3' height='3'/>");
  EXPECT_EQ(totals_of(painted).area, 9);
  EXPECT_EQ(painted.files[0].skipped.size(), 2u);
}

/// What encloses nothing has no filling, whether it is said or not: its stroke is a line, and without one it is not to
/// be seen.
TEST(ImportSvgPaint, ReadsLinesThatHaveTheFillOfPaths) {
  const std::string sides = "<path d='M 0 0 H 80'/><path d='M 80 0 V 80 V 0 V 80'/><polyline points='80,80 0,80'/>",
                    last = "<path d='M 0 80 V 0'/>";
  const std::string hole = "<rect x='30' y='30' width='20' height='20' fill='none' stroke='red'/>";
  testing::expect_totals(svg_of("", "<g stroke='black'>" + sides + last + hole + "</g>"), 6000, 1, 1);
  testing::expect_totals(
      svg_of("", "<g stroke='black'><path d='M 0 0 H 80 M 80 0 V 80 M 80 80 H 0 M 0 80 V 0'/>" + hole + "</g>"), 6000,
      1, 1);
  const Import unseen = svg_of("", "<g>" + sides + last + hole + "</g>");
  testing::expect_totals(unseen, 400, 1, 0);
  ASSERT_EQ(unseen.files[0].skipped.size(), 2u);
  EXPECT_EQ(unseen.files[0].skipped[0].what + unseen.files[0].skipped[1].what, "<path><polyline>");
  EXPECT_NE(unseen.files[0].skipped[0].reason.find("has no stroke"), std::string::npos);
  EXPECT_EQ(unseen.files[0].skipped[0].times, 3);
  // Where nothing is painted, such lines are outlines as others are.
  testing::expect_totals(svg_of("", sides + last), 6400, 1, 0);
  // Halves of circles are known by more than their chords.
  testing::expect_totals(svg_of("", "<path d='M 0 0 A 500 500 0 0 1 1000 0'/>"), 392699, 1, 0, 20);
}

TEST(ImportSvgPaint, TakesOneAlternativeOfASwitch) {
  const auto area = [](const std::string& first) {
    return totals_of(svg_of("", "<switch>" + first +
                                    "<g><rect width='9' height='9'/></g><g><rect width='3' "
                                    "height='3' x='20'/></g></switch>"))
        .area;
  };
  EXPECT_EQ(area(""), 81);
  EXPECT_EQ(area("<foreignObject requiredExtensions='http://a.b/'/>"), 81);
  EXPECT_EQ(area("<rect systemLanguage='de' width='5' height='5'/>"), 81);
  EXPECT_EQ(area("<rect systemLanguage='en-GB, de' width='5' height='5'/>"), 25);
}

/// An outline with a gap of 0.0006 and its hole, as they were reported.
TEST(ImportSvgPaint, ReadsWhatGetsAStroke) {
  const auto read = [](const std::string& stroke) {
    return svg_of("width='100mm' height='100mm' viewBox='0 0 100 100'",
                  "<g style='fill:none" + stroke + "'><path d='M 0 0 H 100 V 100 H 0 L 0.0003 0.0005'/>" +
                      "<rect x='20' y='20' width='60' height='60'/></g>");
  };
  EXPECT_NEAR(totals_of(read("")).area, 6400, 0.1);
  EXPECT_NEAR(totals_of(read(";stroke:red")).area, 6400, 0.1);
  EXPECT_EQ(totals_of(read(";stroke:red")).holes, 1u);
}

TEST(ImportSvgViewport, FitsPages) {
  const char* const rect = "<rect width='10' height='20'/>";
  for (const Expected& e : std::vector<Expected>{
           {"width='100mm' height='50mm' viewBox='0 0 100 100'", rect, 5, 10},
           {"width='100mm' height='50mm' viewBox='0 0 100 100' preserveAspectRatio='xMinYMax meet'", rect, 5, 10},
           {"width='100mm' height='50mm' viewBox='0 0 100 100' preserveAspectRatio='xMidYMid slice'", rect, 10, 20},
           {"width='100mm' height='50mm' viewBox='0 0 100 100' preserveAspectRatio='none'", rect, 10, 10},
           {"width='200' height='100' viewBox='0 0 100 100' preserveAspectRatio='none'", rect, 20, 20},
           {"width='200' height='100' viewBox='0 0 100 100'", rect, 10, 20},
           {"height='5CM' viewBox='0 0 100 100'", rect, 5, 10},
           {"height='50mm' viewBox='0 0 100 100' preserveAspectRatio='none'", rect, 5, 10},
           {"width='100%' height='50mm' viewBox='0 0 100 100'", rect, 5, 10},
           {"width='100%' height='100%' viewBox='0 0 100 100'", rect, 10, 20},
           {"width='100MM' viewBox='0 0 200 200'", rect, 5, 10},
           {"width='1In' height='96' viewBox='0 0 254 254'", rect, 1, 2},
           {"width='40Q' viewBox='0 0 10 10'", rect, 10, 20},
           {"height='96mm'", rect, 10 * 25.4 / 96, 20 * 25.4 / 96},
       })
    expect_size(e);
  EXPECT_EQ(svg_of("width='100%' viewBox='0 0 9 9'", rect).files[0].units,
            "the drawing's own (the page's size, 100%, is no length)");
  EXPECT_EQ(svg_of("width='100mm' height='50mm' viewBox='0 0 100 100' preserveAspectRatio='none'", rect).files[0].units,
            "mm (1 mm across and 0.5 mm up for each of the drawing's own)");
  EXPECT_EQ(svg_of("width='100%' viewBox='0 0 9 9' preserveAspectRatio='none'", rect).files[0].notes.size(), 1u);
  for (const char* bad : {"xMidyMid", "XMIDYMID", "none meet now", "xMidYMid cover", ""})
    EXPECT_THROW(svg_of("viewBox='0 0 9 9' preserveAspectRatio='" + std::string(bad) + "'", rect), InputError) << bad;
}

TEST(ImportSvgViewport, TakesPercentOfTheViewport) {
  for (const Expected& e : std::vector<Expected>{
           {"viewBox='0 0 40 20'", "<rect x='5%' width='50%' height='50%'/>", 20, 10},
           {"width='40' height='20'", "<rect width='50%' height='50%'/>", 20, 10},
           {"viewBox='0 0 40 20'", "<ellipse rx='10%' ry='10%'/>", 8, 4, 0.02},
           {"viewBox='0 0 40 20'", "<ellipse rx='4'/>", 8, 8, 0.02},
           {"viewBox='0 0 40 20'", "<svg width='50%' height='50%'><rect width='50%' height='50%'/></svg>", 10, 5},
           {"viewBox='0 0 40 20'", "<svg viewBox='0 0 4 2'><rect width='50%' height='1'/></svg>", 20, 10},
       })
    expect_size(e);
  const Import round = svg_of("viewBox='0 0 30 40'", "<circle r='10%'/>");
  EXPECT_NEAR(size_of(round).x, 2 * std::sqrt(12.5), 0.02);
  const Import unknown = svg_of("", "<rect width='50%' height='5'/><rect width='3' height='3'/>");
  EXPECT_EQ(unknown.faults.size(), 1u) << "it may lie anywhere";
  // The page's background is left out, and a frame around it, or one of a drawing in it, is a shape.
  const std::string all = "<rect width='100%' height='100%' ";
  EXPECT_EQ(totals_of(svg_of("viewBox='0 0 9 9'", all + "fill='white'/><circle cx='4' cy='4' r='1'/>")).parts, 1u);
  EXPECT_EQ(totals_of(svg_of("viewBox='0 0 9 9'", all + "fill='none' stroke='red'/>")).area, 81);
  EXPECT_EQ(totals_of(svg_of("viewBox='0 0 9 9'", "<svg width='3' height='3'>" + all + "/></svg>")).area, 9);
}

TEST(ImportSvgViewport, PlacesDrawingsInDrawingsAndSymbols) {
  const auto box = [](const std::string& inside) {
    const Import import = svg_of("viewBox='0 0 100 100'", inside);
    EXPECT_TRUE(import.faults.empty() && import.files[0].skipped.empty()) << report_text(import, {});
    const drawing::BodyReport& body = import.bodies.at(0);
    return std::vector<double>{body.low.x, -body.high.y, body.high.x, -body.low.y};
  };
  using Box = std::vector<double>;
  const std::string unit = "<rect width='1' height='1'/>";
  EXPECT_EQ(box("<svg x='5' y='7' width='20' height='10'>" + unit + "</svg>"), (Box{5, 7, 6, 8}));
  EXPECT_EQ(box("<svg x='5' y='7' width='20' height='10' viewBox='0 0 1 1'>" + unit + "</svg>"), (Box{10, 7, 20, 17}));
  EXPECT_EQ(box("<svg width='20' height='10' viewBox='-1 -1 2 2' preserveAspectRatio='xMaxYMid'>" + unit + "</svg>"),
            (Box{15, 5, 20, 10}));
  EXPECT_EQ(box("<svg width='20' height='10' viewBox='0 0 1 1' preserveAspectRatio='none'>" + unit + "</svg>"),
            (Box{0, 0, 20, 10}));
  const std::string symbol = "<symbol id='s' viewBox='0 0 2 2' fill='red'>" + unit + "</symbol>";
  EXPECT_EQ(box(symbol + "<use href='#s' x='10' y='20' width='8' height='8'/>"), (Box{10, 20, 14, 24}));
  EXPECT_EQ(box(symbol + "<use href='#s' width='50%' height='40'/>"), (Box{5, 0, 25, 20}));
  EXPECT_EQ(box(symbol + "<use href='#s'/>"), (Box{0, 0, 50, 50}));
  EXPECT_EQ(box("<defs><svg id='s' width='9' height='9' viewBox='0 0 2 2'>" + unit +
                "</svg></defs><use href='#s' x='10' width='8' height='8'/>"),
            (Box{10, 0, 14, 4}));
  // A symbol's own style counts.
  const Import lines =
      svg_of("viewBox='0 0 9 9'",
             "<symbol id='s' fill='none' stroke='red'><rect width='9' height='9'/><circle cx='4' cy='4' "
             "r='1'/></symbol><use href='#s'/>");
  EXPECT_EQ(totals_of(lines).holes, 1u);
}

TEST(ImportSvgViewport, RefusesWhatFramesHideInPart) {
  const auto read = [](const std::string& frame, drawing::OpenRings open = drawing::OpenRings::error) {
    drawing::ImportSettings settings;
    settings.open = open;
    return examine("<svg viewBox='0 0 100 100'><rect x='50' width='9' height='9'/><svg " + frame +
                       "><rect width='9' height='9'/></svg></svg>",
                   "d.svg", settings);
  };
  const Import part = read("width='5' height='5'");
  ASSERT_EQ(part.faults.size(), 1u);
  EXPECT_NE(part.faults[0].problem().find("reaches beyond the frame at d.svg:1:"), std::string::npos);
  EXPECT_NE(part.faults[0].hint().find("overflow"), std::string::npos);
  const Import whole = read("width='5' height='5'", drawing::OpenRings::skip);
  EXPECT_TRUE(whole.faults.empty());
  EXPECT_EQ(totals_of(whole).area, 162);
  const Import hidden = read("width='5' height='5' viewBox='20 20 3 3'");
  EXPECT_TRUE(hidden.faults.empty());
  EXPECT_EQ(totals_of(hidden).area, 81);
  for (const char* seen :
       {"width='9' height='9'", "width='5' height='5' overflow='visible'", "width='5' height='5' viewBox='0 0 9 9'"})
    EXPECT_TRUE(read(seen).files[0].skipped.empty()) << seen;
}

}  // namespace
}  // namespace taut
