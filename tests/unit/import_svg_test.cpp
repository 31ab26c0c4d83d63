#include <gtest/gtest.h>

#include <cmath>

#include "import/import.hpp"
#include "support/bad_input.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

drawing::Import svg_import(const std::string& inside, drawing::ImportSettings settings = {},
                           const std::string& root = "<svg>") {
  return drawing::import_drawings({drawing::read_drawing(root + inside + "</svg>", "d.svg", settings)}, settings);
}

/// Shapes that are not read are no error.
drawing::ImportSettings leaving_out() {
  drawing::ImportSettings settings;
  settings.open = drawing::OpenRings::skip;
  return settings;
}

double area_of(const Polygon& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += (a.x * b.y - a.y * b.x) / 2;
  }
  return std::fabs(sum);
}

/// Outline less holes, of all parts.
double area_of(const Body& body) {
  double sum = area_of(body.polygon);
  for (const Part& part : body.parts) {
    sum += area_of(part.outline);
    for (const Polygon& hole : part.holes) sum -= area_of(hole);
  }
  return sum;
}

constexpr double half_turn = 3.14159265358979323846;

TEST(ImportSvg, TakesStraightPathsExactlyWithYUp) {
  const Polygon wanted{{1, -2}, {5, -2}, {5, -6}, {1, -6}};
  for (const char* d : {"M1 2H5V6H1Z", "m1,2h4v4h-4z", "M1 2 5 2 5 6 1 6", "m 1 2 4 0 0 4 -4 0 z",
                        "M1 2L5 2L5 6L1 6L1 2Z", "M1 2l4-0 0 4 -4,0z"})
    EXPECT_EQ(svg_import("<path d=\"" + std::string(d) + "\"/>").scene.bodies.at(0).polygon, wanted) << d;
  EXPECT_EQ(svg_import("<polygon points='1,2 5,2 5,6 1,6'/>").scene.bodies[0].polygon, wanted);
  EXPECT_EQ(svg_import("<polyline points='1,2 5,2 5,6 1,6 1,2' fill='none' stroke='red'/>").scene.bodies[0].polygon,
            wanted);
  const auto rectangle = svg_import("<rect x='1' y='2' width='4' height='4px'/>").scene.bodies[0].polygon;
  EXPECT_EQ(area_of(rectangle), 16);
}

TEST(ImportSvg, HasCurvesWithinTheToleranceAndSaysSo) {
  for (const double tolerance : {0.1, 0.01, 0.0001}) {
    drawing::ImportSettings settings;
    settings.tolerance = tolerance;
    for (const char* shape :
         {"<circle cx='3' cy='4' r='10'/>", "<ellipse cx='3' cy='4' rx='10' ry='10'/>",
          "<path d='M-7 4a10 10 0 0 1 20 0a10 10 0 0 1-20 0'/>", "<rect width='20' height='20' rx='10' x='-7' y='-6'/>",
          "<path d='M-7 4A10 10 0 1 1 3 14 10 10 0 0 1-7 4'/>"}) {
      const auto import = svg_import(shape, settings);
      const auto& counts = import.files[0].curves;
      EXPECT_GT(counts.segments, 0u);
      EXPECT_LE(counts.deviation, tolerance);
      EXPECT_GT(counts.deviation, tolerance / 20);
      const Polygon& ring = import.scene.bodies.at(0).polygon;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        EXPECT_NEAR(std::hypot(a.x - 3, a.y + 4), 10, 1e-9) << shape;
        EXPECT_GE(std::hypot((a.x + b.x) / 2 - 3, (a.y + b.y) / 2 + 4), 10 - counts.deviation - 1e-9) << shape;
      }
      EXPECT_NEAR(area_of(ring), 100 * half_turn, 63 * tolerance) << shape;
    }
  }
}

/// A plate and its hole, both drawn as lines: words of style sheets are the same in capitals, and a colour that lets
/// everything through fills nothing.
TEST(ImportSvg, SeesWhatIsNotFilledInEverySpelling) {
  for (const char* style : {"fill='none'", "style='fill:NONE'", "style='Fill:none'", "fill='transparent'",
                            "fill='rgba(0,0,0,0)'", "fill='rgba(0 0 0 / 0%)'", "fill='#0000'", "fill='#00000000'"}) {
    const std::string group = "<g " + std::string(style) + " stroke='red'>";
    const auto import = svg_import(group + "<rect width='40' height='40'/><circle cx='20' cy='20' r='5'/></g>");
    ASSERT_EQ(import.scene.bodies.size(), 1u) << style;
    ASSERT_EQ(import.scene.bodies[0].parts.size(), 1u) << style;
    EXPECT_EQ(import.scene.bodies[0].parts[0].holes.size(), 1u) << style;
  }
  for (const char* fill : {"#f00", "#0008", "rgba(0,0,0,0.5)", "BLACK"}) {
    const std::string group = "<g fill='" + std::string(fill) + "'>";
    const auto import = svg_import(group + "<rect width='40' height='40'/><circle cx='60' cy='20' r='5'/></g>");
    EXPECT_EQ(import.scene.bodies.size(), 1u) << fill;
  }
  EXPECT_EQ(svg_import("<rect width='4' height='4'/><rect x='9' width='4' height='4' style='display:NONE'/>")
                .scene.bodies[0]
                .polygon.size(),
            4u);
}

TEST(ImportSvg, FollowsBezierCurves) {
  // Under y = x (1 - x), by all spellings of the same parabola: a sixth.
  drawing::ImportSettings settings;
  settings.tolerance = 1e-5;
  for (const char* d : {"M0 0Q.5 1 1 0", "m0 0q.5 1 1 0z",
                        "M0 0C.33333333333333333 .66666666666666666 .66666666666666666 .66666666666666666 1 0"})
    EXPECT_NEAR(area_of(svg_import("<path d='" + std::string(d) + "'/>", settings).scene.bodies[0]), 1.0 / 3, 2e-5)
        << d;
  // Smooth continuations are mirrored: two arcs of the same area above and below.
  const auto wave = svg_import("<path d='M0 0Q.5 1 1 0T2 0V-3H0Z'/>", settings).scene.bodies[0];
  EXPECT_NEAR(area_of(wave), 6, 1e-5);
  const auto smooth = svg_import("<path d='M0 0C0 1 1 1 1 0S2-1 2 0V-3H0Z'/>", settings).scene.bodies[0];
  EXPECT_NEAR(area_of(smooth), 6, 1e-5);
}

TEST(ImportSvg, PlacesGroupsByTheirTransformations) {
  const auto body = [](const std::string& transform) {
    return svg_import("<g transform='translate(10 0)'><rect transform='" + transform + "' width='2' height='1'/></g>")
        .scene.bodies.at(0)
        .polygon;
  };
  const auto has = [](const Polygon& ring, Point p) { return std::count(ring.begin(), ring.end(), p) == 1; };
  EXPECT_TRUE(has(body("rotate(90)"), {9, -2}));
  EXPECT_TRUE(has(body("rotate(90 1 0)"), {11, -1}));
  EXPECT_TRUE(has(body("scale(2,-3)"), {14, 3}));
  EXPECT_TRUE(has(body("translate(1) scale(2)"), {15, -2}));
  EXPECT_TRUE(has(body("matrix(1 0 1 1 0 0)"), {13, -1}));
  EXPECT_NEAR(area_of(body("skewX(30)")), 2, 1e-12);
}

TEST(ImportSvg, CallsBodiesByGroupsAndIds) {
  const std::string two =
      "<g id='a' inkscape:label='arm'><rect id='r' width='1' height='1'/><g id='b'><rect x='3' "
      "width='1' height='1'/></g></g><circle id='c' r='1' cx='9'/><rect x='20' width='1' height='1'/>"
      "<g id='arm'><rect x='30' width='1' height='1'/></g>";
  const auto import = svg_import(two);
  std::vector<std::string> names;
  for (const Body& body : import.scene.bodies) names.push_back(body.name);
  EXPECT_EQ(names, (std::vector<std::string>{"arm", "c", "body", "arm-2"}));
  EXPECT_EQ(import.scene.bodies[0].parts.size(), 2u);
  drawing::ImportSettings split;
  split.split = true;
  names.clear();
  for (const Body& body : svg_import(two, split).scene.bodies) names.push_back(body.name);
  EXPECT_EQ(names, (std::vector<std::string>{"r", "arm", "c", "body", "arm-2"}));
}

TEST(ImportSvg, ObeysTheFillRule) {
  const auto area = [](const std::string& attributes, const std::string& inner) {
    return area_of(svg_import("<path " + attributes + " d='M0 0H10V10H0Z " + inner + "'/>").scene.bodies.at(0));
  };
  const std::string same = "M2 2H4V4H2Z", other = "M2 2V4H4V2Z";
  EXPECT_EQ(area("", other), 96);
  EXPECT_EQ(area("", same), 100);
  EXPECT_EQ(area("fill-rule='evenodd'", same), 96);
  EXPECT_EQ(area("style='fill: red; fill-rule: evenodd'", same), 96);
  EXPECT_EQ(area("fill='none' stroke='red'", same), 96);
  EXPECT_EQ(area("fill-rule='evenodd'", same + "M2.5 2.5H3V3H2.5Z"), 96.25);
  const auto idle = svg_import("<path d='M0 0H10V10H0Z" + same + "'/>").files[0].skipped;
  ASSERT_EQ(idle.size(), 1u);
  EXPECT_EQ(idle[0].reason, "has filled area on both of its sides");
}

TEST(ImportSvg, TakesMillimetresFromTheSizeOfThePage) {
  const auto width = [](const std::string& root, const std::string& shape = "<rect width='10' height='1'/>") {
    double most = 0;
    const auto imported = svg_import(shape, {}, root);
    for (const Point& p : imported.scene.bodies[0].polygon) most = std::max(most, p.x);
    return most;
  };
  EXPECT_EQ(width("<svg width='100mm' viewBox='0 0 200 100'>"), 5);
  EXPECT_DOUBLE_EQ(width("<svg width='1in' viewBox='0 0 254 100'>"), 1);
  EXPECT_EQ(width("<svg width='100' viewBox='0 0 200 100'>"), 10);
  EXPECT_EQ(width("<svg>", "<rect width='1in' height='1'/>"), 96);
  EXPECT_EQ(svg_import("<rect width='1' height='1'/>", {}, "<svg width='4mm' viewBox='0 0 2 2'>").files[0].units,
            "mm (2 mm for each of the drawing's own)");
}

TEST(ImportSvg, TellsWhatItSkips) {
  const auto skipped =
      svg_import(
          "<rect width='1' height='1'/>\n<text>a</text><text>b</text><use href='#x'/><defs><rect "
          "width='9' height='9'/></defs>\n<rect width='0' height='1'/><g style='display:none'><circle "
          "r='1'/></g><line x2='5' y2='5' stroke='red'/><metadata><a/></metadata><sodipodi:namedview/>")
          .files[0]
          .skipped;
  std::vector<std::string> what;
  for (const auto& s : skipped) what.push_back(s.what + " " + s.place + " " + std::to_string(s.times));
  EXPECT_EQ(what, (std::vector<std::string>{"<text> d.svg:2:1 2", "<use> d.svg:2:29 1", "<rect> d.svg:3:1 1",
                                            "<circle> d.svg:3:53 1", "<defs> d.svg:2:45 1"}));
}

std::vector<std::string> names_of(const drawing::Import& import) {
  std::vector<std::string> names;
  for (const Body& body : import.scene.bodies) names.push_back(body.name);
  return names;
}

/// "what reason" of all that was skipped.
std::vector<std::string> decided_by(const drawing::Import& import) {
  std::vector<std::string> decided;
  for (const drawing::Skipped& s : import.files[0].skipped) decided.push_back(s.what + " " + s.reason);
  return decided;
}

TEST(ImportSvg, DrawsClonesWhereTheyStand) {
  const auto import = svg_import(
      "<defs><g id='pair'><rect width='2' height='1'/><rect id='right' x='3' width='1' height='1'/></g>"
      "<symbol id='sign'><circle r='1'/></symbol><linearGradient id='paint'/></defs>"
      "<use href='#pair' x='10' transform='scale(2)'/><use id='left' xlink:href='#right' y='5'/>"
      "<g id='both'><use href='#sign'/><use href='#sign' x='9'/></g>");
  EXPECT_EQ(names_of(import), (std::vector<std::string>{"pair", "left", "both"}));
  EXPECT_EQ(decided_by(import), std::vector<std::string>{});
  const Body& pair = import.scene.bodies[0];
  ASSERT_EQ(pair.parts.size(), 2u);
  EXPECT_EQ(area_of(pair), 12);
  double least = 1e9, most = -1e9;
  for (const Part& part : pair.parts) {
    for (const Point& p : part.outline) {
      least = std::min(least, p.x);
      most = std::max(most, p.x);
    }
  }
  EXPECT_EQ(least, 20);
  EXPECT_EQ(most, 28);
  EXPECT_EQ(import.scene.bodies[2].parts.size(), 2u);
}

TEST(ImportSvg, HandsStylesDownToClones) {
  const std::string path = "<path id='p' d='M0 0H10V10H0ZM2 2H4V4H2Z'/>";
  EXPECT_EQ(area_of(svg_import("<defs>" + path + "</defs><use href='#p' fill-rule='evenodd'/>").scene.bodies.at(0)),
            96);
  EXPECT_EQ(area_of(svg_import("<defs>" + path + "</defs><use href='#p'/>").scene.bodies.at(0)), 100);
  const auto import = svg_import("<rect width='1' height='1'/><defs>" + path +
                                     "<circle r='1'/></defs>"
                                     "<use href='#p' display='none'/><use href='other.svg#p'/><use/>"
                                     "<symbol id='s'><circle r='1'/></symbol>",
                                 leaving_out());
  EXPECT_EQ(
      decided_by(import),
      (std::vector<std::string>{
          "<path> is not visible", "<use> clones what is in another file", "<use> clones what is not in the file",
          "<defs> is not drawn where it stands, nor cloned", "<symbol> is not drawn where it stands, nor cloned"}));
}

TEST(ImportSvg, ObeysStyleSheets) {
  const auto names = [](const std::string& css, const std::string& more = "") {
    return names_of(
        svg_import("<style>" + css +
                   "</style><rect id='a' class='thick cut' width='1' height='1'/><rect id='b' class='cut' x='3' "
                   "width='1' height='1' " +
                   more + "/><circle id='c' cx='9' r='1'/>"));
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(""), (Names{"a", "b", "c"}));
  EXPECT_EQ(names(".thick{display:none}"), (Names{"b", "c"}));
  EXPECT_EQ(names(".cut{display:none}"), (Names{"c"}));
  EXPECT_EQ(names("rect{display:none} /* not .c */ #b { display : inline }"), (Names{"b", "c"}));
  EXPECT_EQ(names("#b{display:inline}rect.cut{display:none}"), (Names{"b", "c"}));
  EXPECT_EQ(names(".cut.thick, circle{visibility:hidden;fill:red}"), (Names{"b"}));
  EXPECT_EQ(names("<![CDATA[ *{visibility:hidden} .cut{visibility:visible} ]]>"), (Names{"a", "b"}));
  EXPECT_EQ(names(".cut{display:none}", "style='display:inline'"), (Names{"b", "c"}));
  EXPECT_EQ(names(".cut{display:none !important}", "style='display:inline'"), (Names{"c"}));
  EXPECT_EQ(names(".cut{display:none !important}", "style='display:inline !important'"), (Names{"b", "c"}));
  EXPECT_EQ(names("rect{display:none}", "display='inline'"), (Names{"c"})) << "an attribute is weaker than a rule";
  EXPECT_EQ(names(".thic{display:none}.utter{display:none}"), (Names{"a", "b", "c"}));
  const auto hidden = svg_import(
      "<style>.s{visibility:hidden}.v{visibility:visible}</style><g class='s'><rect width='1' "
      "height='1'/><g class='v'><rect x='3' width='1' height='1'/></g></g>");
  EXPECT_EQ(area_of(hidden.scene.bodies.at(0)), 1);
}

TEST(ImportSvg, TellsWhatOfStylesItDoesNotRead) {
  EXPECT_EQ(
      decided_by(svg_import("<style>@import url(x.css); @media print{rect{display:none}} @font-face{src:url(y)} "
                            "g>rect{display:none} rect:hover{fill:none} g rect{stroke:red} rect{transform:none}</style>"
                            "<rect width='1' height='1' clip-path='url(#x)' style='zoom: 2'/>",
                            leaving_out())),
      (std::vector<std::string>{"the rule \"@import url(x.css)\" takes styles from another file, which is not read",
                                "\"zoom\" in a style is not read", "\"clip-path\" refers to what is not in the file"}));
  EXPECT_EQ(decided_by(svg_import("<style>rect{fill:red</style><rect width='1' height='1'/>")),
            std::vector<std::string>{});
}

TEST(ImportSvg, ReplacesEntitiesThatAreTexts) {
  const std::string head =
      "<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" \"x.dtd\" [<!-- names --> <!ENTITY ns \"http://a.b/\">\n"
      "<!ENTITY st0 'fill:none'> ]>";
  const std::string text = head + "<svg xmlns:x='&ns;'><rect style='&st0;' stroke='red' width='9' height='9'/></svg>";
  const auto import = drawing::import_drawings({drawing::read_drawing(text, "d.svg", {})}, {});
  EXPECT_EQ(area_of(import.scene.bodies.at(0)), 81);
}

TEST(ImportSvg, RefusesTooManyChords) {
  drawing::ImportSettings settings;
  settings.tolerance = 1e-9;
  try {
    svg_import("<circle r='1e30'/>", settings);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_NE(e.problem().find("more than 20000000 chords"), std::string::npos) << e.what();
    EXPECT_NE(e.hint().find("--tolerance"), std::string::npos) << e.what();
  }
}

class BadSvgTest : public ::testing::TestWithParam<testing::BadInput> {};

TEST_P(BadSvgTest, IsRefused) {
  testing::expect_refused(GetParam(), [](const std::string& text) {
    drawing::import_drawings({drawing::read_drawing(text, "d.svg", {})}, {});
  });
}

std::vector<testing::BadInput> bad_svg() {
  std::string deep, rules, laughs = "<svg><defs><g id='a0'/>";
  for (int i = 1; i < 15; ++i) {
    laughs += "<g id='a" + std::to_string(i) + "'>";
    for (int k = 0; k < 9; ++k) laughs += "<use href='#a" + std::to_string(i - 1) + "'/>";
    laughs += "</g>";
  }
  laughs += "</defs><use href='#a14'/></svg>";
  for (int i = 0; i < 300; ++i) deep += "<g>";
  for (int i = 0; i < 1001; ++i) rules += "a{fill:none}";
  return {
      {"empty", "", "d.svg", "there is no <svg> element", "SVG"},
      {"html", "<html/>", "d.svg:1:1", "its element is <html>", "SVG"},
      {"cut_off", "<svg>\n<g", "d.svg:2:1", "without a \">\"", "cut off"},
      {"open", "<svg><g></g>", "d.svg:1:13", "ends inside the element \"svg\"", "cut off"},
      {"crossed", "<svg><g></svg></g>", "d.svg:1:9", "not open", "save"},
      {"entity", "<svg id='&lol;'/>", "d.svg:1:10", "an entity that XML does not have", "character"},
      {"entities", "<!DOCTYPE svg [<!ENTITY a 'b'><!ENTITY b '&a;&a;'>]><svg/>", "d.svg:1:31", "more than short texts",
       "plain SVG"},
      {"entity_file", "<!DOCTYPE svg [<!ENTITY a SYSTEM 'b'>]><svg/>", "d.svg:1:16", "not declared as a text",
       "plain SVG"},
      {"entity_parameter", "<!DOCTYPE svg [<!ENTITY % a 'b'>]><svg/>", "d.svg:1:16", "for itself", "plain SVG"},
      {"attribute", "<svg><rect width=4/></svg>", "d.svg:1:12", "name=\"value\"", "save"},
      {"twice", "<svg><rect x='1' x='1'/></svg>", "d.svg:1:18", "appears twice", "keep one"},
      {"deep", "<svg>" + deep, "d.svg:1:771", "more than 256 deep", "ungroup"},
      {"no_shape", "<svg/>", "d.svg", "nothing in the file encloses an area", "--join"},
      {"command", "<svg>\n <path d='M0 0X'/></svg>", "d.svg:2:2", "no command of a path, at character 5", "A and Z"},
      {"half_a_point", "<svg><path d='M0 0L1'/></svg>", "d.svg:1:6", "a number is expected, at character 7", "A and Z"},
      {"no_move", "<svg><path d='L1 1'/></svg>", "d.svg:1:6", "begins with M", "A and Z"},
      {"flag", "<svg><path d='M0 0A1 1 0 2 0 1 1'/></svg>", "d.svg:1:6", "a flag of an arc", "A and Z"},
      {"transform", "<svg><g transform='turn(3)'/></svg>", "d.svg:1:6", "cannot be read", "rotate"},
      {"points", "<svg><polygon points='1 2 3'/></svg>", "d.svg:1:6", "pairs of numbers", "points="},
      {"clone_of_itself", "<svg><g id='a'><use href='#a'/></g></svg>", "d.svg:1:16", "more than 16 deep", "unlink"},
      {"clones_of_clones", laughs, "d.svg:1:12", "more than 1000000 elements", "unlink"},
      {"rules", "<svg><style>" + rules + "</style></svg>", "d.svg:1:6", "more than 1000 rules", "plain SVG"},
      {"length", "<svg><rect width='5em' height='1'/></svg>", "d.svg:1:6", "is no length", "number"},
      {"viewbox", "<svg width='1mm' viewBox='0 0 0 1'/>", "d.svg:1:1", "viewBox", "four numbers"},
      {"far", "<svg><rect width='1e200' height='1' transform='scale(1e100)'/></svg>", "d.svg:1:6", "beyond 2^400",
       "unit"},
  };
}

INSTANTIATE_TEST_SUITE_P(Svg, BadSvgTest, ::testing::ValuesIn(bad_svg()), testing::name_of);

}  // namespace
}  // namespace taut
