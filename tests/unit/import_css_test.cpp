// Selectors of style sheets.
#include <gtest/gtest.h>

#include "import/css_selectors.hpp"
#include "import/import.hpp"
#include "support/drawings.hpp"

namespace taut {
namespace {

using drawing::Import;
using testing::examine;
using testing::totals_of;

const char* const tree =
    "<svg id='root'><g id='a' class='plate steel'><rect id='b' class='cut' data-x='one two' lang='en-GB'/><g id='c'>"
    "<path id='d' class='cut deep'/><path id='e'/></g></g><circle id='f' class='x.y'/><rect id='1g'/></svg>";

/// The ids of the elements that a list of selectors matches, one after the other.
std::string matched(const std::string& selectors) {
  const drawing::XmlTree xml(tree, "d.svg");
  std::string ids;
  for (std::size_t node = 0; node < xml.size(); ++node) {
    for (const drawing::Selector& selector : drawing::parse_selectors(selectors)) {
      if (!selector.unread.empty()) return "unread: " + selector.unread;
      if (!matches(selector, xml, node)) continue;
      ids += *xml.element(node).find("id") + " ";
      break;
    }
  }
  return ids;
}

TEST(CssSelectors, MatchAsTheStandardSays) {
  const std::vector<std::pair<const char*, const char*>> cases{
      {"rect", "b 1g "},
      {"*", "root a b c d e f 1g "},
      {".cut", "b d "},
      {".cut.deep", "d "},
      {"path#d.cut", "d "},
      {"g .cut", "b d "},
      {"g > .cut", "b d "},
      {"svg>.cut", ""},
      {".steel path", "d e "},
      {".plate > path", ""},
      {"svg g g path", "d e "},
      {"g>g>path", "d e "},
      {"#a #c .deep , circle", "d f "},
      {"path + path", "e "},
      {"g + circle", "f "},
      {"g ~ rect", "1g "},
      {"circle ~ g", ""},
      {"[class]", "a b d f "},
      {"[class=cut]", "b "},
      {"[ class = 'cut deep' ]", "d "},
      {"[class~=\"cut\"]", "b d "},
      {"[data-x~=two]", "b "},
      {"[data-x^=one]", "b "},
      {"[data-x$=two]", "b "},
      {"[data-x*='e t']", "b "},
      {"[data-x*='E T' i]", "b "},
      {"[data-x*='E T']", ""},
      {"[lang|=en]", "b "},
      {"rect[lang|=e]", ""},
      {"g:first-child", "a "},
      {"svg > :last-child", "1g "},
      {":root > g", "a "},
      {"path:not(.deep)", "e "},
      {"g :not(path, .cut)", "c "},
      {"rect:hover, circle", "f "},
      {"rect::before", ""},
      {"#\\31 g", "1g "},
      {".x\\.y", "f "},
      {"rect:nth-child(2)", "unread: :nth-child(2)"},
      {"rect:is(g, .b)", "unread: :is(g, .b)"},
      {"rect,", "unread: rect,"},
      {"g >", "unread: g >"},
      {"g..x", "unread: g..x"},
      {"[class", "unread: [class"},
  };
  for (const auto& [selector, ids] : cases) EXPECT_EQ(matched(selector), ids) << selector;
}

TEST(CssSelectors, HaveTheirSpecificity) {
  const auto specificity = [](const char* text) { return drawing::parse_selectors(text).at(0).specificity; };
  EXPECT_EQ(specificity("*"), (drawing::Specificity{0, 0, 0}));
  EXPECT_EQ(specificity("g rect.a[b]:first-child"), (drawing::Specificity{0, 3, 2}));
  EXPECT_EQ(specificity("#a #b g"), (drawing::Specificity{2, 0, 1}));
  EXPECT_EQ(specificity("g:not(.a, #b)"), (drawing::Specificity{1, 0, 1}));
}

TEST(CssSelectors, TryDeepGroupsOnce) {
  std::string text;
  for (int i = 0; i < 250; ++i) text += "<g>";
  for (int i = 0; i < 250; ++i) text += "</g>";
  const drawing::XmlTree xml(text, "d.svg");
  std::string steps = "svg";
  for (int i = 0; i < 30; ++i) steps += " g";
  for (std::size_t node = 0; node < xml.size(); ++node)
    EXPECT_FALSE(matches(drawing::parse_selectors(steps).at(0), xml, node));
}

/// A plate with a disc, which is a hole if neither is filled.
Import plate_with(const std::string& css, const std::string& style = "<style>") {
  return examine("<svg>" + style + css +
                     "</style><g id='p' class='plate'><rect width='9' height='9'/><circle class='cut' cx='4' cy='4' "
                     "r='1'/></g><text/></svg>",
                 "d.svg");
}

TEST(ImportCss, ObeysSelectorsOfAllKinds) {
  const std::string lines = "{fill:none;stroke:red}";
  for (const char* selector :
       {"g *", "svg>g>*", ".plate rect, .plate .cut", "g>rect, rect + circle", "[width], [r='1']", "#p", "*:not(text)"})
    EXPECT_EQ(totals_of(plate_with(selector + lines)).holes, 1u) << selector;
  EXPECT_EQ(totals_of(plate_with("g .cut{display:none}#p circle.cut{display:inline}")).parts, 2u);
  EXPECT_EQ(totals_of(plate_with("g .cut{display:none}circle{display:inline}")).parts, 1u);
  EXPECT_EQ(totals_of(plate_with("@media screen{#p" + lines + "}")).holes, 1u);
  EXPECT_EQ(totals_of(plate_with("@media print{#p{display:none}}")).parts, 2u);
  EXPECT_EQ(totals_of(plate_with("@media (prefers-color-scheme: dark){#p{display:none}}")).parts, 2u);
  EXPECT_EQ(totals_of(plate_with("@media (prefers-color-scheme: light){#p" + lines + "}")).holes, 1u);
  EXPECT_EQ(totals_of(plate_with("#p{display:none}", "<style media='print'>")).parts, 2u);
}

TEST(ImportCss, TakesCustomPropertiesFromWhatSurrounds) {
  const auto parts = [](const std::string& css, const std::string& attributes) {
    return totals_of(examine("<svg><style>" + css + "</style><g " + attributes +
                                 "><rect class='a' width='2' height='1'/></g><rect x='9' width='1' height='1'/></svg>",
                             "d.svg"))
        .parts;
  };
  EXPECT_EQ(parts(".a{fill:var(--cut)}", "style='--cut:none'"), 1u);
  EXPECT_EQ(parts(".a{fill:var( --cut )}", "style='--cut:red'"), 2u);
  EXPECT_EQ(parts(":root{--cut:none} .a{fill:var(--cut)}", ""), 1u);
  EXPECT_EQ(parts(":root{--cut:none} .a{fill:var(--cut)}", "style='--cut:red'"), 2u);
  EXPECT_EQ(parts(":root{--CUT:none} .a{fill:var(--cut)}", ""), 2u) << "capitals count";
  EXPECT_EQ(parts(".a{fill:var(--cut, none)}", ""), 1u);
  EXPECT_EQ(parts(".a{fill:var(--cut, var(--mark, rgb(0 0 0 / 0)))}", ""), 1u);
  EXPECT_EQ(parts(":root{--cut:var(--mark);--mark:none} .a{fill:var(--cut)}", ""), 1u);
  EXPECT_EQ(parts(":root{--clear:0} .a{fill:rgb(1 2 3 / var(--clear))}", ""), 1u);
  // What is not known is as if it were not said; here the rule outdoes the attribute.
  EXPECT_EQ(parts(".a{fill:var(--cut)}", "fill='none'"), 1u);
  const std::string ring = "<style>g{--cut:var(--cut)}</style><g fill='var(--cut)'><rect width='2' height='1'/></g>";
  EXPECT_EQ(examine("<svg>" + ring + "</svg>", "d.svg").faults.size(), 1u);
  const auto filtered =
      examine("<svg><rect width='2' height='1' filter='url(#a)' style='marker-end:url(#b)'/></svg>", "d.svg");
  EXPECT_TRUE(filtered.faults.empty());
  EXPECT_EQ(filtered.files[0].skipped.size(), 2u);
}

TEST(ImportCss, RefusesWhatMayChangeShapes) {
  for (const char* css :
       {"rect:nth-child(2){fill:none}", "g:has(rect){display:none}", "circle:is(.a){opacity:0}",
        "@media (min-width:5px){rect{display:none}}", "rect >{fill:none}", "rect{transform:perspective(2)}",
        "#p{rotate:x 9deg}", "#p{zoom:2}", "circle{offset-path:path('M0 0h9')}", "circle{r:2px}", "@import url(x.css);",
        ".plate{fill:none; .cut{fill:red}}", "@supports (fill:red){rect{visibility:hidden}}"}) {
    const Import import = plate_with(css);
    ASSERT_EQ(import.faults.size(), 1u) << css;
    EXPECT_NE(import.faults[0].problem().find("it may change the shape of any body"), std::string::npos) << css;
    EXPECT_NE(import.faults[0].hint().find("--open skip"), std::string::npos) << css;
  }
  EXPECT_NE(plate_with("rect:nth-child(2){fill:none}").faults.at(0).problem().find(":nth-child(2)"), std::string::npos);
  for (const char* css :
       {"text:nth-child(2){fill:none}", "rect:nth-child(2){font-size:3px}", "rect:hover{fill:none}",
        "@media (min-width:5px){text{font-size:3px}}", "a:focus{fill:none}", "rect{transform:none}", "circle{r:1px}",
        "text{scale:2}", "svg{width:100%;height:auto}", "g{width:3px}", "#p{zoom:1}", "rect{transform-origin:center}"})
    EXPECT_TRUE(plate_with(css).faults.empty()) << css;
}

}  // namespace
}  // namespace taut
