// Every kind of bad scene is refused with its place, the culprit and a remedy.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/bad_input.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace {

const std::string triangle_text = "[[0,0],[1,0],[0,1]]";
const std::string body_p = R"({"name":"P","polygon":)" + triangle_text + "}";
const std::string body_q = R"({"name":"Q","polygon":)" + triangle_text + "}";

std::string scene_with_bodies(const std::string& bodies) {
  return R"({"format":"taut-scene/1","time":[0,1],"bodies":)" + bodies + "}";
}
std::string scene_with_polygon(const std::string& polygon) {
  return scene_with_bodies("[" + body_p + ",\n" + R"({"name":"Q","polygon":)" + polygon + "}]");
}
std::string scene_with_motion(const std::string& motion) {
  return scene_with_bodies("[" + body_p + ",\n" + R"({"name":"Q","polygon":)" + triangle_text + R"(,"motion":)" +
                           motion + "}]");
}

class BadSceneTest : public ::testing::TestWithParam<testing::BadInput> {};

TEST_P(BadSceneTest, IsRefused) {
  testing::expect_refused(GetParam(), [](const std::string& text) { parse_scene(text, "s.json"); });
}

std::vector<testing::BadInput> syntax() {
  return {
      {"empty", "", "s.json", "the file is empty", R"({"format":"taut-scene/1")"},
      {"blank", " \n\t\r\n", "s.json", "the file is empty", "write a scene"},
      {"truncated", "{\"format\":\"taut-scene/1\",\n\"time\":[0", "s.json:2:9", "unexpected end of input", "cut off"},
      {"truncated_string", "{\"form", "s.json:1:6", "missing closing quote", "cut off"},
      {"trailing_comma", "{\"time\":[0,1],\n}", "s.json:2:1", "unexpected '}'", "syntax"},
      {"text_after_the_end", scene_with_bodies("[]") + "\n x", "s.json:2:2", "not valid JSON", "syntax"},
      {"not_json", "bodies: a, b", "s.json:1:1", "not valid JSON", "syntax"},
      {"wkt", "POLYGON ((0 0, 1 0, 0 1))", "s.json", "this is WKT, not a scene", R"({"wkt": file})"},
      {"svg", "<?xml version=\"1.0\"?><svg/>", "s.json", "perhaps an SVG drawing", "`taut import`"},
      {"dxf", "0\nSECTION\n2\nENTITIES\n", "s.json", "this is a DXF drawing", "`taut import`"},
      {"utf16", std::string("\xFF\xFE{\0", 4), "s.json", "not text in UTF-8", "UTF-8"},
      {"geojson", R"({"type":"FeatureCollection","features":[]})", "s.json:1:1", "this is GeoJSON", "`taut import`"},
      {"comment", "// a scene\n{}", "s.json:1:1", "not valid JSON", "no comments"},
      {"single_quotes", "{'format':1}", "s.json:1:2", "not valid JSON", "double quotes"},
      {"nan", R"({"format":"taut-scene/1","time":[0, NaN],"bodies":[]})", "s.json:1:37", "NaN is not a number in JSON",
       "finite"},
      {"lower_case_nan", "[nan]", "s.json:1:2", "nan is not a number in JSON", "finite"},
      {"minus_infinity", "{\"time\":[0,\n -Infinity]}", "s.json:2:2", "Infinity is not a number in JSON", "finite"},
      {"inf", "[inf]", "s.json:1:2", "inf is not a number in JSON", "finite"},
      {"overflow", "{\"time\":[0,\n  1e999]}", "s.json:2:3", "number overflow parsing '1e999'", "1.8e308"},
      {"negative_overflow", "{\"time\":[-1e400,0]}", "s.json:1:10", "number overflow", "1.8e308"},
      {"bad_utf8", "{\"na\xff\":1}", "s.json:1:5", "ill-formed UTF-8", "syntax"},
      {"zero_byte", std::string("{\"a\0\":1}", 8), "s.json:1:4", "control character", "syntax"},
      {"after_a_nul", scene_with_bodies("[]") + std::string("\0 anything", 10), "s.json:1:51",
       "a NUL character ends the JSON", "remove it"},
      {"depth_bomb", std::string(1000000, '['), "s.json:1:33", "nested more than 32 deep", "shape of a scene"},
      {"object_depth_bomb",
       [] {
         std::string s;
         for (int i = 0; i < 100000; ++i) s += "{\"a\":";
         return s;
       }(),
       "s.json:1:161", "nested more than 32 deep", "shape of a scene"},
  };
}

std::vector<testing::BadInput> structure() {
  return {
      {"number_as_scene", "3", "s.json:1:1", "expected an object, found a number", "taut-scene/1"},
      {"array_as_scene", "[]", "s.json:1:1", "expected an object, found an array", "taut-scene/1"},
      {"empty_object", "{}", "s.json:1:1", "the key \"format\" is missing", "taut-scene/1"},
      {"wrong_format", R"({"format":"taut-scene/2","time":[0,1],"bodies":[]})", "s.json:1:11: format",
       "unknown format \"taut-scene/2\"", "\"taut-scene/1\""},
      {"format_as_number", R"({"format":1,"time":[0,1],"bodies":[]})", "s.json:1:11: format",
       "expected a string, found a number", "taut-scene/1"},
      {"missing_time", R"({"format":"taut-scene/1","bodies":[]})", "s.json:1:1", "the key \"time\" is missing", "time"},
      {"missing_bodies", R"({"format":"taut-scene/1","time":[0,1]})", "s.json:1:1", "the key \"bodies\" is missing",
       "bodies"},
      {"misspelt_key", "{\"format\":\"taut-scene/1\",\n \"boddies\":[]}", "s.json:2:2", "unknown key \"boddies\"",
       "did you mean \"bodies\"? the keys here are \"format\", \"time\", \"bodies\""},
      {"foreign_key", R"({"colour":"red"})", "s.json:1:2", "unknown key \"colour\"", "the keys here are \"format\""},
      {"upper_case_key", R"({"Time":[0,1]})", "s.json:1:2", "unknown key \"Time\"", "did you mean \"time\"?"},
      {"very_long_key", "{\"" + std::string(5000, 'k') + "\":1}", "s.json:1:2", "kkkkk...\"", "the keys here"},
      {"duplicate_key", "{\"time\":[0,1],\n\"time\":[0,2]}", "s.json:2:1", "the key \"time\" appears twice",
       "keep one"},
      {"time_as_number", R"({"format":"taut-scene/1","time":1,"bodies":[]})", "s.json:1:33: time",
       "expected an array, found a number", "[start, end]"},
      {"time_of_one", R"({"format":"taut-scene/1","time":[1],"bodies":[]})", "s.json:1:33: time",
       "expected two numbers, found 1", "[start, end]"},
      {"time_of_three", R"({"format":"taut-scene/1","time":[1,2,3],"bodies":[]})", "s.json:1:38: time",
       "more than 2 numbers", "[start, end]"},
      {"time_as_text", R"({"format":"taut-scene/1","time":[0,"1"],"bodies":[]})", "s.json:1:36: time[1]",
       "expected a number, found a string", "[start, end]"},
  };
}

std::vector<testing::BadInput> bodies() {
  const std::string nothing = R"({"name":"Q"})";
  return {
      {"same_names_of_three", scene_with_bodies("[" + body_p + "," + body_q + "," + body_q + "]"),
       "s.json:1:48: bodies", "two bodies are called \"Q\"", "different names"},
      {"bodies_as_object", scene_with_bodies("{}"), "s.json:1:48: bodies", "expected an array, found an object", "[{"},
      {"body_as_number", scene_with_bodies("[1,2]"), "s.json:1:49: bodies[0]", "expected an object, found a number",
       "\"name\""},
      {"missing_polygon", scene_with_bodies("[" + body_p + ",\n" + nothing + "]"), "s.json:2:1: bodies[1]",
       "the key \"polygon\" is missing", "\"polygon\""},
      {"missing_name", scene_with_bodies("[{\"polygon\":[]},2]"), "s.json:1:49: bodies[0]",
       "the key \"name\" is missing", "\"name\""},
      {"empty_name", scene_with_bodies("[{\"name\":\"\",\"polygon\":[]},2]"), "s.json:1:57: bodies[0].name",
       "the name is empty", "lid"},
      {"escape_in_name", scene_with_bodies(R"([{"name":"\u001b[31m","polygon":[]},2])"), "s.json:1:57: bodies[0].name",
       "control character", "printable"},
      {"name_as_number", scene_with_bodies("[{\"name\":7,\"polygon\":[]},2]"), "s.json:1:57: bodies[0].name",
       "expected a string, found a number", "\"lid\""},
      {"same_names", scene_with_bodies("[" + body_p + "," + body_p + "]"), "s.json:1:48: bodies",
       "two bodies are called \"P\"", "different names"},
      {"polygon_as_text", scene_with_polygon("\"square\""), "s.json:2:23: bodies[1].polygon",
       "expected an array, found a string", "[[x, y]"},
      {"flat_polygon", scene_with_polygon("[0,0,1,0]"), "s.json:2:24: bodies[1].polygon[0]",
       "expected an array, found a number", "[x, y]"},
      {"vertex_of_one", scene_with_polygon("[[0,0],\n[1]]"), "s.json:3:1: bodies[1].polygon[1]",
       "a vertex has two coordinates, found 1", "[x, y]"},
      {"vertex_of_three", scene_with_polygon("[[0,0],[1,0,5]]"), "s.json:2:30: bodies[1].polygon[1]",
       "a vertex has two coordinates, found 3", "[x, y]"},
      {"coordinate_as_text", scene_with_polygon("[[0,0],[1,\"0\"]]"), "s.json:2:33: bodies[1].polygon[1][1]",
       "expected a number, found a string", "[x, y]"},
      {"coordinate_null", scene_with_polygon("[[null,0]]"), "s.json:2:25: bodies[1].polygon[0][0]",
       "expected a number, found null", "[x, y]"},
      {"nested_vertex", scene_with_polygon("[[[0,0],[1,0],[0,1]]]"), "s.json:2:25: bodies[1].polygon[0][0]",
       "expected a number, found an array", "[x, y]"},
      {"outline_of_nothing", scene_with_polygon("{}"), "s.json:2:23: bodies[1].polygon", "no outline is given", "wkt"},
      {"outline_of_both", scene_with_polygon(R"({"wkt":"a","geojson":"b"})"), "s.json:2:23: bodies[1].polygon",
       "both \"wkt\" and \"geojson\" are given", "wkt"},
      {"outline_of_unknown_kind", scene_with_polygon(R"({"dxf":"a"})"), "s.json:2:24: bodies[1].polygon",
       "unknown key \"dxf\"", "\"wkt\", \"geojson\""},
      {"outline_as_number", scene_with_polygon(R"({"wkt":3})"), "s.json:2:30: bodies[1].polygon.wkt",
       "expected a string, found a number", "{\"wkt\": file}"},
      {"outline_missing", scene_with_polygon(R"({"wkt":"no/such.wkt"})"), "s.json:2:30: bodies[1].polygon: no/such.wkt",
       "cannot open the file: No such file", "path"},
  };
}

std::vector<testing::BadInput> motions() {
  const std::string at = ": bodies[1].motion";
  return {
      {"motion_as_text", scene_with_motion("\"still\""), "s.json:2:52" + at, "expected an object, found a string",
       "\"x\":[c0"},
      {"motion_unknown_key", scene_with_motion("{\"z\":[1]}"), "s.json:2:53" + at, "unknown key \"z\"",
       "\"x\", \"y\", \"rotation\", \"until\""},
      {"motion_of_no_pieces", scene_with_motion("[]"), "s.json:2:52" + at, "no pieces", "null"},
      {"coefficients_as_number", scene_with_motion("{\"x\":1}"), "s.json:2:57" + at + ".x",
       "expected an array, found a number", "ascending powers"},
      {"coefficient_as_text", scene_with_motion("{\"x\":[0,\"t\"]}"), "s.json:2:60" + at + ".x[1]",
       "expected a number, found a string", "ascending powers"},
      {"degree_17", scene_with_motion("{\"x\":[1,2,3,4,5,6,7,8,9,0,1,2,3,4,5,6,7,8]}"), "s.json:2:92" + at + ".x",
       "more than 17 numbers", "the highest degree is 16"},
      {"rotation_of_nothing", scene_with_motion("{\"rotation\":{}}"), "s.json:2:64" + at + ".rotation",
       "the object is empty", "{\"angle\":"},
      {"rotation_of_two", scene_with_motion("{\"rotation\":{\"angle\":[1],\"cosine\":[0]}}"),
       "s.json:2:64" + at + ".rotation", "both \"angle\" and \"cosine\" are given", "exactly one of"},
      {"rotation_misspelt", scene_with_motion("{\"rotation\":{\"angel\":[1]}}"), "s.json:2:65" + at + ".rotation",
       "unknown key \"angel\"", "did you mean \"angle\"?"},
      {"rotation_as_number", scene_with_motion("{\"rotation\":90}"), "s.json:2:64" + at + ".rotation",
       "expected an object, found a number", "angle"},
      {"direction_without_b", scene_with_motion("{\"rotation\":{\"direction\":{\"a\":[1]}}}"),
       "s.json:2:77" + at + ".rotation.direction", "the key \"b\" is missing", "\"b\":[...]"},
      {"until_as_text", scene_with_motion("{\"until\":\"1\"}"), "s.json:2:61" + at + ".until",
       "expected a number, found a string", "without quotes"},
      {"until_missing", scene_with_motion("[{\"x\":[1]},\n{\"x\":[1]}]"), "s.json:2:53" + at + "[0]",
       "the key \"until\" is missing", "only the last piece"},
      {"until_equal", scene_with_motion("[{\"until\":1},\n{\"until\":1},{}]"), "s.json:3:1" + at + "[1].until",
       "not later than", "order the pieces"},
      {"until_descending", scene_with_motion("[{\"until\":1},{\"until\":2},\n {\"until\":1.5}]"),
       "s.json:3:2" + at + "[2].until", "not later than", "order the pieces"},
      {"deep_path", scene_with_motion("[{\"until\":1},{\"until\":2},\n{\"rotation\":[]}]"),
       "s.json:3:13" + at + "[2].rotation", "expected an object, found an array", "angle"},
  };
}

/// Motions of taut/motions.hpp.
std::vector<testing::BadInput> functions() {
  const std::string at = ": bodies[1].motion";
  const auto frames = [](const std::string& list) { return scene_with_motion("{\"keyframes\":" + list + "}"); };
  const std::string two = R"([{"t":0,"x":1},{"t":1,"x":2}])";
  return {
      {"keyframes_misspelt", scene_with_motion(R"({"keyframe":[{"t":0}]})"), "s.json:2:53" + at,
       "unknown key \"keyframe\"", "did you mean \"keyframes\"?"},
      {"keyframes_as_object", frames("{}"), "s.json:2:65" + at + ".keyframes", "expected an array, found an object",
       "\"angle_deg\":90"},
      {"no_keyframes", frames("[]"), "s.json:2:65" + at + ".keyframes", "there are no keyframes", "\"angle_deg\":90"},
      {"keyframe_without_time", frames("[{\"x\":1}]"), "s.json:2:66" + at + ".keyframes[0]", "the key \"t\" is missing",
       "a keyframe as"},
      {"keyframe_key_misspelt", frames(R"([{"t":0,"angle":1}])"), "s.json:2:73" + at + ".keyframes[0]",
       "unknown key \"angle\"", "did you mean \"angle_deg\"?"},
      {"keyframe_as_array", frames("[[0,1,2]]"), "s.json:2:66" + at + ".keyframes[0]",
       "expected an object, found an array", "a keyframe as"},
      {"keyframe_time_as_text", frames(R"([{"t":"0"}])"), "s.json:2:71" + at + ".keyframes[0].t",
       "expected a number, found a string", "without quotes"},
      {"keyframes_same_time", frames("[{\"t\":0},\n{\"t\":0}]"), "s.json:3:6" + at + ".keyframes[1].t",
       "not later than", "no two may have the same"},
      {"keyframes_unsorted", frames("[{\"t\":1},\n{\"t\":0.5}]"), "s.json:3:6" + at + ".keyframes[1].t",
       "not later than", "by time"},
      {"keyframe_lacks_a_column", frames("[{\"t\":0,\"x\":1},\n{\"t\":1}]"), "s.json:3:1" + at + ".keyframes[1]",
       "the key \"x\" is missing", "in every keyframe or in none"},
      {"keyframe_has_a_new_column", frames("[{\"t\":0},\n{\"t\":1,\"y\":1}]"), "s.json:3:1" + at + ".keyframes[1]",
       "\"y\" is given, but not in the first", "in every keyframe or in none"},
      {"keyframes_and_x", scene_with_motion("{\"keyframes\":" + two + ",\"x\":[1]}"), "s.json:2:52" + at,
       "both \"keyframes\" and \"x\" are given", "leave out \"x\""},
      {"keyframes_and_rotation", scene_with_motion("{\"rotation\":{\"angle\":[1]},\"keyframes\":" + two + "}"),
       "s.json:2:52" + at, "both \"keyframes\" and \"rotation\" are given", "leave out \"rotation\""},
      {"keyframes_and_velocity", scene_with_motion("{\"velocity\":[1,0],\"keyframes\":" + two + "}"),
       "s.json:2:52" + at, "both \"keyframes\" and \"velocity\" are given", "leave out \"velocity\""},
      {"keyframes_as_piece", scene_with_motion("[{\"until\":1},\n{\"keyframes\":" + two + "}]"),
       "s.json:3:2" + at + "[1]", "describes a whole motion", "without the array"},
      {"keyframes_too_steep", frames(R"([{"t":0,"x":1e308},{"t":1e-300,"x":-1e308}])"),
       "s.json:2:65" + at + ".keyframes", "too large for a double", "other units"},
      {"velocity_of_three", scene_with_motion("{\"velocity\":[1,2,3]}"), "s.json:2:69" + at + ".velocity",
       "more than 2 numbers", "[x, y]"},
      {"velocity_of_one", scene_with_motion("{\"velocity\":[1]}"), "s.json:2:64" + at + ".velocity",
       "expected two numbers, found 1", "[x, y]"},
      {"velocity_and_until", scene_with_motion("{\"velocity\":[1,2],\"until\":3}"), "s.json:2:52" + at,
       "both \"velocity\" and \"until\" are given", "leave out \"until\""},
      {"spin_as_text", scene_with_motion("{\"spin_deg\":\"fast\"}"), "s.json:2:64" + at + ".spin_deg",
       "expected a number, found a string", "without quotes"},
      {"pivot_as_number", scene_with_motion("{\"spin_deg\":1,\"pivot\":0}"), "s.json:2:74" + at + ".pivot",
       "expected an array, found a number", "[x, y]"},
      {"sweep_without_angle", scene_with_motion("{\"sweep\":{\"from_deg\":0}}"), "s.json:2:61" + at + ".sweep",
       "the key \"to_deg\" is missing", "\"to_deg\":90"},
      {"sweep_misspelt", scene_with_motion("{\"sweep\":{\"from\":0,\"to_deg\":1}}"), "s.json:2:62" + at + ".sweep",
       "unknown key \"from\"", "did you mean \"from_deg\"?"},
      {"sweep_with_pivot_outside", scene_with_motion(R"({"sweep":{"from_deg":0,"to_deg":9},"pivot":[1,2]})"),
       "s.json:2:52" + at, "both \"sweep\" and \"pivot\" are given", "{\"sweep\":{\"pivot\":[x,y]"},
      {"sweep_in_no_time",
       R"({"format":"taut-scene/1","time":[1,1],"bodies":[)" + body_p + ",\n" + R"({"name":"Q","polygon":)" +
           triangle_text + R"(,"motion":{"sweep":{"from_deg":0,"to_deg":9}}}]})",
       "s.json:2:61" + at + ".sweep", "no length", "start < end"},
      {"csv_as_number", scene_with_motion("{\"csv\":1}"), "s.json:2:59" + at + ".csv",
       "expected a string, found a number", "{\"csv\": \"file.csv\"}"},
      {"csv_missing", scene_with_motion("{\"csv\":\"no/such.csv\"}"), "s.json:2:59" + at + ".csv: no/such.csv",
       "cannot open the file: No such file", "path"},
      {"csv_and_keyframes", scene_with_motion("{\"csv\":\"a\",\"keyframes\":" + two + "}"), "s.json:2:52" + at,
       "both \"keyframes\" and \"csv\" are given", "leave out \"csv\""},
  };
}

INSTANTIATE_TEST_SUITE_P(Syntax, BadSceneTest, ::testing::ValuesIn(syntax()), testing::name_of);
INSTANTIATE_TEST_SUITE_P(Structure, BadSceneTest, ::testing::ValuesIn(structure()), testing::name_of);
INSTANTIATE_TEST_SUITE_P(Bodies, BadSceneTest, ::testing::ValuesIn(bodies()), testing::name_of);
INSTANTIATE_TEST_SUITE_P(Motions, BadSceneTest, ::testing::ValuesIn(motions()), testing::name_of);
INSTANTIATE_TEST_SUITE_P(Forms, BadSceneTest, ::testing::ValuesIn(functions()), testing::name_of);

TEST(ReadLimitsTest, AreKept) {
  const std::string text = scene_with_motion("[{\"until\":1},{\"until\":2},{}]");
  const auto problem = [&text](const ReadLimits& limits) -> std::string {
    try {
      parse_scene(text, "s.json", ".", limits);
      return "";
    } catch (const InputError& e) {
      return e.what();
    }
  };
  EXPECT_EQ(problem({}), "");
  EXPECT_EQ(problem({.max_bytes = text.size()}), "");
  EXPECT_NE(problem({.max_bytes = text.size() - 1}).find("larger than the limit of"), std::string::npos);
  EXPECT_EQ(problem({.max_vertices = 3}), "");
  EXPECT_NE(problem({.max_vertices = 2}).find("bodies[0].polygon: more vertices than the limit of 2"),
            std::string::npos);
  EXPECT_EQ(problem({.max_pieces = 3}), "");
  EXPECT_NE(problem({.max_pieces = 2}).find("bodies[1].motion: more pieces than the limit of 2"), std::string::npos);
  const std::string frames = scene_with_motion(R"({"keyframes":[{"t":0},{"t":1},{"t":2}]})");
  EXPECT_NO_THROW(parse_scene(frames, "s.json", ".", {.max_pieces = 3}));
  EXPECT_THROW(parse_scene(frames, "s.json", ".", {.max_pieces = 2}), InputError);
}

// A parser must not do worse than refuse, whatever is cut off or changed.
TEST(BadSceneTest, EveryPrefixAndEveryChangedByteIsReadOrRefused) {
  const std::string good = scene_with_motion(
      R"([{"x":[1,-2.5e-3],"rotation":{"direction":{"a":[1],"b":[0,1]}},"until":1},{"rotation":{"cosine":[0.5]}}])");
  ASSERT_NO_THROW(parse_scene(good));
  for (std::size_t i = 0; i < good.size(); ++i) {
    EXPECT_THROW(parse_scene(good.substr(0, i)), InputError);
    for (char c : std::string("[]{}\",:0-e\n\x80 x")) {
      std::string changed = good;
      changed[i] = c;
      try {
        parse_scene(changed);
      } catch (const InputError&) {
      }
    }
  }
}

}  // namespace
}  // namespace taut
