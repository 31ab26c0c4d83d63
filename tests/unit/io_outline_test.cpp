#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "io/motion_reader.hpp"
#include "io/outline_reader.hpp"
#include "support/bad_input.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

const Polygon triangle{{0, 0}, {1.5, 0}, {-0.5, 1e3}};

const Polygon holed_square{{0, 0}, {9, 0}, {9, 9}, {0, 9}};
const Polygon square_hole{{1, 1}, {2, 1}, {2, 2}};

Polygon wkt(const std::string& text) { return parse_wkt(text, "o.wkt", {}); }
Polygon geojson(const std::string& text) { return parse_geojson(text, "o.geojson", {}); }

/// Outline and holes of each part, one after the other, and how many holes each has.
struct Rings {
  explicit Rings(const std::vector<Part>& parts) {
    for (const Part& part : parts) {
      all.push_back(part.outline);
      all.insert(all.end(), part.holes.begin(), part.holes.end());
      holes.push_back(part.holes.size());
    }
  }
  std::vector<Polygon> all;
  std::vector<std::size_t> holes;
};

void expect_parts(const std::vector<Part>& parts) {
  const Rings rings(parts);
  EXPECT_EQ(rings.all, (std::vector<Polygon>{holed_square, square_hole, triangle}));
  EXPECT_EQ(rings.holes, (std::vector<std::size_t>{1, 0}));
}

TEST(Wkt, ReadsPartsAndHoles) {
  const std::string first = "((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 2 1, 2 2, 1 1))",
                    second = "((0 0, 1.5 0, -.5 1e3, 0 0))";
  expect_parts(parse_wkt_parts("MULTIPOLYGON (" + first + ", " + second + ")"));
  expect_parts(parse_wkt_parts("GeometryCollection(POLYGON" + first + ",MultiPolygon(" + second + "))"));
  expect_parts(parse_wkt_parts("SRID=1;GEOMETRYCOLLECTION Z (GEOMETRYCOLLECTION (POLYGON " + first + "), POLYGON Z " +
                               "((0 0 1, 1.5 0 1, -.5 1e3 1)))"));
  EXPECT_EQ(Rings(parse_wkt_parts("POLYGON " + first)).all, (std::vector<Polygon>{holed_square, square_hole}));
}

TEST(GeoJson, ReadsPartsAndHoles) {
  const std::string first = "[[[0,0],[9,0],[9,9],[0,9],[0,0]],[[1,1],[2,1],[2,2],[1,1]]]";
  const std::string second = "[[[0,0],[1.5,0],[-0.5,1000],[0,0]]]";
  const auto polygon = [](const std::string& c) { return R"({"type":"Polygon","coordinates":)" + c + "}"; };
  const auto feature = [](const std::string& g) { return R"({"type":"Feature","geometry":)" + g + "}"; };
  const std::string multi = R"({"type":"MultiPolygon","coordinates":[)" + first + "," + second + "]}";
  const std::string group =
      R"({"type":"GeometryCollection","geometries":[)" + polygon(first) + "," + polygon(second) + "]}";
  for (const std::string& text : {multi, group, feature(multi), feature(group),
                                  R"({"type":"FeatureCollection","features":[)" + feature(polygon(first)) + "," +
                                      feature(polygon(second)) + "]}"})
    expect_parts(parse_geojson_parts(text));
  EXPECT_EQ(Rings(parse_geojson_parts(polygon(first))).all, (std::vector<Polygon>{holed_square, square_hole}));
}

TEST(GeoJson, TellsFeaturesApartAndWhatIsNoPolygon) {
  const std::string geometry = R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[1.5,0],[-0.5,1000]]]})";
  const std::string text = R"({"type":"FeatureCollection","features":[{"type":"Feature","id":7,)" + geometry +
                           R"(},{"type":"Feature","properties":{"name":"bay"},)" + geometry +
                           R"(},{"type":"Feature","geometry":null},
{"type":"Feature","properties":null,"geometry":{"type":"GeometryCollection","geometries":[{"type":"Point"}]}}]})";
  const auto features = io::parse_geojson_features(text, "f", {});
  ASSERT_EQ(features.size(), 4u);
  EXPECT_EQ(features[0].name, "7");
  EXPECT_EQ(features[1].name, "bay");
  EXPECT_EQ(features[0].parts.size() + features[1].parts.size(), 2u);
  ASSERT_EQ(features[2].skipped.size() + features[3].skipped.size(), 2u);
  EXPECT_EQ(features[2].skipped[0].place, "f:1:291: features[2].geometry");
  EXPECT_EQ(features[2].skipped[0].reason, "a feature without a geometry");
  EXPECT_EQ(features[3].skipped[0].place, "f:2:99: features[3].geometry.geometries[0].type");
  EXPECT_EQ(features[3].skipped[0].reason, "\"Point\" is no polygon");
  EXPECT_FALSE(features[3].skipped[0].area);
  EXPECT_THROW(parse_geojson_parts(text), InputError);
}

TEST(OneOutline, IsNeitherSeveralNorOneWithAHole) {
  const auto refused = [](const auto& read, const char* problem) {
    try {
      read();
      ADD_FAILURE() << "was accepted";
    } catch (const InputError& e) {
      EXPECT_EQ(e.problem(), problem);
      EXPECT_FALSE(e.hint().empty());
    }
  };
  refused([] { wkt("POLYGON ((0 0,9 0,0 9),(1 1,2 1,1 2))"); }, "the polygon has a hole");
  refused([] { wkt("MULTIPOLYGON (((0 0,9 0,0 9)),((1 1,2 1,1 2)))"); }, "there are several polygons");
  refused([] { geojson(R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[0,9]],[[1,1],[2,1],[1,2]]]})"); },
          "the polygon has a hole");
}

TEST(Wkt, ReadsAPolygonHoweverItIsSpelt) {
  EXPECT_EQ(wkt("POLYGON ((0 0, 1.5 0, -0.5 1e3, 0 0))"), triangle);
  EXPECT_EQ(wkt("polygon((0 0,1.5 0,-.5 1E+3))\n"), triangle);
  EXPECT_EQ(wkt(" SRID=4326;POLYGON((+0 0.,1.5 -0,-0.5 1000,0 0))"), triangle);
  EXPECT_EQ(wkt("POLYGON Z ((0 0 7, 1.5 0 7, -0.5 1000 7, 0 0 7))"), triangle);
  EXPECT_EQ(wkt("POLYGON ZM((0 0 7 1,\n1.5 0 7 1,\n-0.5 1000 7 1))"), triangle);
}

TEST(GeoJson, ReadsAPolygonAlsoInsideAFeature) {
  const std::string polygon = R"({"type":"Polygon","coordinates":[[[0,0],[1.5,0],[-0.5,1000],[0,0]]]})";
  const std::string feature = R"({"type":"Feature","properties":{"a":[1,{"b":2}]},"geometry":)" + polygon + "}";
  EXPECT_EQ(geojson(polygon), triangle);
  EXPECT_EQ(geojson(feature), triangle);
  EXPECT_EQ(geojson(R"({"features":[)" + feature + R"(],"type":"FeatureCollection","bbox":[0,0,1,1]})"), triangle);
  EXPECT_EQ(geojson(R"({"coordinates":[[[0,0,9],[1.5,0,9],[-0.5,1000,9]]],"type":"Polygon"})"), triangle);
}

class BadOutlineTest : public ::testing::TestWithParam<testing::BadInput> {};

TEST_P(BadOutlineTest, IsRefused) {
  const bool is_wkt = GetParam().place.rfind("o.wkt", 0) == 0;
  testing::expect_refused(GetParam(), [&](const std::string& text) { is_wkt ? wkt(text) : geojson(text); });
}

std::vector<testing::BadInput> bad_wkt() {
  const std::string shape = "POLYGON ((x y, x y, x y, ...))";
  return {
      {"empty", "\n", "o.wkt", "the file is empty", shape},
      {"point", "POINT (1 2)", "o.wkt:1:6", "expected POLYGON or MULTIPOLYGON, found POINT", shape},
      {"half_a_multipolygon", "MULTIPOLYGON (((0 0,1 0,0 1)),", "o.wkt:1:31", "expected \"(\" before the first ring",
       shape},
      {"multipolygon_of_nothing", "MULTIPOLYGON (EMPTY)", "o.wkt:1:20", "the polygon is empty", shape},
      {"point_in_a_collection", "GEOMETRYCOLLECTION (POLYGON ((0 0,1 0,0 1)), POINT (1 2))", "o.wkt:1:51",
       "expected POLYGON or MULTIPOLYGON, found POINT", shape},
      {"number", "12", "o.wkt:1:1", "expected POLYGON", shape},
      {"empty_polygon", "POLYGON EMPTY", "o.wkt:1:14", "the polygon is empty", shape},
      {"flat", "POLYGON (0 0, 1 0, 0 1)", "o.wkt:1:10", "expected \"(\" before the vertices", shape},
      {"half_a_hole", "POLYGON ((0 0,9 0,0 9),(1 1,2 1,1))", "o.wkt:1:34", "expected a number", shape},
      {"half_a_vertex", "POLYGON ((0 0,\n1,2 2))", "o.wkt:2:2", "expected a number", shape},
      {"nan", "POLYGON ((0 nan,1 1,2 2))", "o.wkt:1:13", "expected a number", shape},
      {"overflow", "POLYGON ((0 1e999,1 1,2 2))", "o.wkt:1:13", "the number is too large", "1.8e308"},
      {"truncated", "POLYGON ((0 0, 1 1", "o.wkt:1:19", "expected \")\" after the vertices", shape},
      {"rest", "POLYGON ((0 0,1 0,0 1)) , 0", "o.wkt:1:25", "unexpected text", "one geometry after the other"},
      {"rest_geometry", "POLYGON ((0 0,1 0,0 1))\nPOINT (0 0)", "o.wkt:2:6", "found POINT", "write POLYGON"},
      {"srid", "SRID=12", "o.wkt:1:5", "without a \";\"", shape},
      {"after_a_nul", std::string("POLYGON ((0 0,1 0,0 1))\0 POLYGON", 32), "o.wkt:1:24", "unexpected text",
       "one geometry"},
  };
}

std::vector<testing::BadInput> bad_geojson() {
  const std::string shape = R"({"type":"Polygon")";
  return {
      {"empty", "", "o.geojson", "the file is empty", shape},
      {"syntax", "{\"type\":", "o.geojson:1:8", "unexpected end of input", "cut off"},
      {"array", "[]", "o.geojson:1:1", "expected an object, found an array", shape},
      {"no_type", "{}", "o.geojson:1:1", "the key \"type\" is missing", shape},
      {"point", R"({"type":"Point","coordinates":[0,0]})", "o.geojson:1:9: type", "found \"Point\"", shape},
      {"two_features", R"({"type":"FeatureCollection","features":[1,2]})", "o.geojson:1:41: features[0]",
       "expected an object, found a number", shape},
      {"no_features", R"({"type":"FeatureCollection","features":[]})", "o.geojson:1:40: features",
       "there are no features", shape},
      {"line_in_a_collection", R"({"type":"GeometryCollection","geometries":[{"type":"LineString"}]})",
       "o.geojson:1:52: geometries[0].type", "found \"LineString\"", shape},
      {"no_polygons", R"({"type":"MultiPolygon","coordinates":[]})", "o.geojson:1:38: coordinates",
       "there are no polygons", shape},
      {"no_geometry", R"({"type":"Feature","geometry":null})", "o.geojson:1:30: geometry",
       "a feature without a geometry", shape},
      {"half_a_hole", R"({"type":"Polygon","coordinates":[[[0,0]],[[1]]]})", "o.geojson:1:43: coordinates[1][0]",
       "two coordinates, found 1", "[x, y]"},
      {"no_ring", R"({"type":"Polygon","coordinates":[]})", "o.geojson:1:33: coordinates", "the polygon is empty",
       shape},
      {"flat", R"({"type":"Polygon","coordinates":[[0,0],[1,1]]})", "o.geojson:1:35: coordinates[0][0]",
       "expected an array, found a number", "[x, y]"},
      {"text", R"({"type":"Feature","geometry":{"type":"Polygon","coordinates":[[[0,"a"]]]}})",
       "o.geojson:1:67: geometry.coordinates[0][0][1]", "expected a number, found a string", "[x, y]"},
      {"twice", R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1]]],"coordinates":[]})", "o.geojson:1:55",
       "a key appears twice", "one of the two"},
      {"twice_within", R"({"type":"Feature","properties":{"a":[{"b":1,"c":2,"b":3}]},"geometry":{}})", "o.geojson:1:51",
       "a key appears twice", "one of the two"},
      {"after_a_nul", std::string(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1]]]})") + std::string("\0x", 2),
       "o.geojson:1:55", "a NUL character ends the JSON", "remove it"},
  };
}

INSTANTIATE_TEST_SUITE_P(Wkt, BadOutlineTest, ::testing::ValuesIn(bad_wkt()), testing::name_of);
INSTANTIATE_TEST_SUITE_P(GeoJson, BadOutlineTest, ::testing::ValuesIn(bad_geojson()), testing::name_of);

template <class Read>
std::string problem_of(const Read& read) {
  try {
    read();
    return "";
  } catch (const InputError& e) {
    return e.problem();
  }
}

TEST(OutlineLimits, CountVerticesWithoutTheRepeatedOne) {
  const auto wkt = [](const std::string& ring, std::size_t limit) {
    return problem_of([&] { io::parse_wkt("POLYGON ((" + ring + "))", "o.wkt", {.max_vertices = limit}); });
  };
  const auto geojson = [](const std::string& ring, std::size_t limit) {
    const std::string text = R"({"type":"Polygon","coordinates":[[)" + ring + "]]}";
    return problem_of([&] { io::parse_geojson(text, "o.geojson", {.max_vertices = limit}); });
  };
  EXPECT_EQ(wkt("0 0,1 0,0 1),(0 0,1 0,1 1,0 1", 3), "more vertices than the limit of 3");
  for (const char* ring : {"0 0,1 0,0 1", "0 0,1 0,0 1,0 0"}) {
    EXPECT_EQ(wkt(ring, 3), "");
    EXPECT_EQ(wkt(ring, 2), "more vertices than the limit of 2");
  }
  for (const char* ring : {"[0,0],[1,0],[0,1]", "[0,0],[1,0],[0,1],[0,0]"}) {
    EXPECT_EQ(geojson(ring, 3), "");
    EXPECT_EQ(geojson(ring, 2).find("more vertices than the limit of"), 0u);
  }
  EXPECT_EQ(wkt("0 0,1 0,1 1,0 1", 3), "more vertices than the limit of 3");
  EXPECT_EQ(geojson("[0,0],[1,0],[1,1],[0,1]", 3), "more vertices than the limit of 3");
}

/// The file may be any: a scene names it, and its author is to learn nothing of what is in it.
TEST(OutlineErrors, QuoteNothing) {
  const std::string secret = "root:$6$salt$hash:19000:0:99999:7:::";
  const auto message_of = [](const auto& read) {
    try {
      read();
      return std::string("accepted");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
  };
  const std::vector<std::string> texts{secret,           "{\"type\":\"" + secret + "\"}",
                                       "\"" + secret,    "{\"" + secret + "\":1,\"" + secret + "\":2}",
                                       "[root",          "123456e789",
                                       "t,root,x\n1,2,3"};
  for (const std::string& text : texts) {
    for (const std::string& message : {message_of([&] { wkt(text); }), message_of([&] { geojson(text); }),
                                       message_of([&] { io::parse_keyframes_csv(text, "k.csv", {}); })}) {
      EXPECT_EQ(message.find("root"), std::string::npos) << message;
      EXPECT_EQ(message.find("ROOT"), std::string::npos) << message;
      EXPECT_EQ(message.find("123456"), std::string::npos) << message;
    }
  }
}

TEST(OutlineLimits, NestingEndsAtOnceAndWithoutRecursion) {
  std::string text;
  for (int i = 0; i < 1000000; ++i) text += R"({"type":"FeatureCollection","features":[)";
  const auto problem = problem_of([&] { io::parse_geojson(text, "o.geojson", {}); });
  EXPECT_EQ(problem, "arrays or objects are nested more than 32 deep");
  EXPECT_EQ(problem_of([] { io::parse_wkt(std::string(1000000, '('), "o.wkt", {}); }),
            "expected POLYGON or MULTIPOLYGON");
  EXPECT_EQ(problem_of([] { io::parse_wkt("POLYGON " + std::string(1000000, '('), "o.wkt", {}); }),
            "expected a number");
  std::string collections;
  for (int i = 0; i < 1000000; ++i) collections += "GEOMETRYCOLLECTION(";
  EXPECT_EQ(problem_of([&] { io::parse_wkt(collections, "o.wkt", {}); }), "collections are nested more than 32 deep");
}

TEST(OutlineLimits, FilesAreReadNoFurtherThanTheLimit) {
  const std::string file = (std::filesystem::path(::testing::TempDir()) / "taut_outline_limit").string();
  write_file(file, "POLYGON ((0 0, 1 0, 0 1))");
  EXPECT_EQ(problem_of([&] { read_wkt(file, {.max_bytes = 25}); }), "");
  const std::string large = "the file is larger than the limit of 24 bytes";
  EXPECT_EQ(problem_of([&] { read_wkt(file, {.max_bytes = 24}); }), large);
  EXPECT_EQ(problem_of([&] { read_geojson(file, {.max_bytes = 24}); }), large);
  EXPECT_EQ(problem_of([&] { read_scene(file, {.max_bytes = 24}); }), large);
  // It has no end; that of Windows has.
#ifdef _WIN32
  const std::string device = "NUL";
#else
  const std::string device = "/dev/zero";
#endif
  EXPECT_EQ(problem_of([&] { read_wkt(device, {.max_bytes = 1 << 20}); }), "cannot read the file: it is a device");
  std::filesystem::remove(file);
}

/// A scene in `inner` that names this outline.
class OutlineOutside : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) / (std::string("taut_outside_") + info->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "inner" / "deep");
    for (const char* name : {"secret.wkt", "inner/deep/o.wkt", "inner/..o.wkt"})
      write_file((folder_ / name).string(), "POLYGON ((0 0, 1 0, 0 1))");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string problem(const std::string& outline, const ReadLimits& limits = {}) const {
    const std::string scene = (folder_ / "inner" / "scene.json").string();
    write_file(scene, R"({"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"P","polygon":{"wkt":")" + outline +
                          R"("}},{"name":"Q","polygon":[[5,0],[6,0],[5,1]]}]})");
    return problem_of([&] { read_scene(scene, limits); });
  }

  std::filesystem::path folder_;
};

TEST_F(OutlineOutside, IsRefusedUnlessAllowed) {
  const std::string absolute = (folder_ / "secret.wkt").generic_string();
  std::vector<std::string> outside = {"../secret.wkt", absolute, "deep/../../secret.wkt"};
  std::vector<std::string> inside = {"deep/o.wkt", "deep/../deep/o.wkt", "../inner/deep/o.wkt", "..o.wkt"};
#ifndef _WIN32  // where not everybody may make links
  std::filesystem::create_symlink("../secret.wkt", folder_ / "inner" / "link.wkt");
  std::filesystem::create_symlink("..", folder_ / "inner" / "up");
  std::filesystem::create_symlink("deep/o.wkt", folder_ / "inner" / "fine.wkt");
  outside.insert(outside.end(), {"link.wkt", "up/secret.wkt"});
  inside.push_back("fine.wkt");
#endif
  for (const std::string& outline : outside) {
    EXPECT_EQ(problem(outline), "the file \"" + outline + "\" is not below the scene's folder");
    EXPECT_EQ(problem(outline, {.allow_outside = true}), "");
  }
  for (const std::string& outline : inside) EXPECT_EQ(problem(outline), "") << outline;
  EXPECT_EQ(problem((folder_ / "inner/deep/o.wkt").generic_string()), "");
  EXPECT_EQ(problem("missing.wkt").rfind("cannot open the file", 0), 0u);
  EXPECT_EQ(problem("../missing.wkt").find("cannot open"), std::string::npos) << "it tells what is there";
  EXPECT_EQ(problem("deep/o.wkt\\u0000.png"), "the name of a file has a NUL in it");
}

TEST(Outline, IsFoundNextToTheScene) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "taut_outline_test" / "inner";
  std::filesystem::create_directories(folder);
  write_file((folder / "p.wkt").string(), "POLYGON ((0 0, 1.5 0, -0.5 1e3, 0 0))");
  write_file((folder / "q.geojson").string(), R"({"type":"Polygon","coordinates":[[[0,0],[1.5,0],[-0.5,1000]]]})");
  const std::string text = R"({"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"P","polygon":{"wkt":"p.wkt"}},)"
                           R"({"name":"Q","polygon":{"geojson":"../inner/q.geojson"}}]})";
  write_file((folder / "scene.json").string(), text);
  const Scene scene = read_scene((folder / "scene.json").string());
  EXPECT_EQ(scene.bodies[0].polygon, triangle);
  EXPECT_EQ(scene.bodies[1].polygon, triangle);
  EXPECT_EQ(parse_scene(text, "scene", folder.string()).bodies[0].polygon, triangle);
  write_file((folder / "p.wkt").string(), "POLYGON ((0 0, 9 0, 9 9, 0 9), (1 1, 2 1, 2 2))");
  const Body holed = read_scene((folder / "scene.json").string()).bodies[0];
  EXPECT_TRUE(holed.polygon.empty());
  EXPECT_EQ(Rings(holed.parts).all, (std::vector<Polygon>{holed_square, square_hole}));
  const std::string parts = R"({"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"P","parts":[{"wkt":"p.wkt"},)"
                            R"({"geojson":"q.geojson"}]}]})";
  expect_parts(parse_scene(parts, "scene", folder.string()).bodies[0].parts);
  write_file((folder / "p.wkt").string(), "POLYGON ((0 0, 1.5 0, x))");
  try {
    read_scene((folder / "scene.json").string());
    FAIL();
  } catch (const InputError& e) {
    const std::string file = (folder / "scene.json").string();
    EXPECT_EQ(e.place(), file + ":1:78: bodies[0].polygon: " + folder.string() + "/p.wkt:1:23");
  }
  std::filesystem::remove_all(folder.parent_path());
}

}  // namespace
}  // namespace taut
