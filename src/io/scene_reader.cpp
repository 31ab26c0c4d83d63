// The format taut-scene/1.
#include <set>

#include "io/joint_reader.hpp"
#include "io/json_document.hpp"
#include "io/json_numbers.hpp"
#include "io/json_object.hpp"
#include "io/mechanism_reader.hpp"
#include "io/motion_reader.hpp"
#include "io/named_file.hpp"
#include "io/outline_reader.hpp"
#include "io/platform.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/path.hpp"

namespace taut {
using namespace internal;

namespace {

using io::element_path;
using io::JsonDocument;
using io::JsonKind;
using io::JsonObject;

const char* const scene_shape =
    R"(a scene as {"format":"taut-scene/1","time":[0,1],"bodies":[{"name":"P","polygon":[[0,0],[1,0],[0,1]],"motion":null},{...}]})";

const char* const path_shape =
    R"(a scene as {"format":"taut-scene/1","joints":{"x":[0,9]},"bodies":[...],"start":{"x":1},"goal":{"x":8}})";

const char* const linkage_shape =
    R"(a scene with joints as {"format":"taut-scene/1","joints":{"lift":[0,60]},"bodies":[...]})";

class SceneReader {
 public:
  SceneReader(const JsonDocument& document, const std::string& folder, const ReadLimits& limits)
      : document_(document), folder_(folder), limits_(limits) {}

  /// Other files that people have are recognized by what they begin with.
  void refuse_geojson() const {
    if (document_.at(0).kind() != JsonKind::object || !io::has_member(document_, 0, "type")) return;
    if (io::has_member(document_, 0, "format")) return;
    throw document_.error(
        0, "", "this is GeoJSON, not a scene",
        "`taut import` makes scenes of drawings and maps; a body's polygon may be {\"geojson\": file}");
  }

  /// Joints or drives with ranges instead of a time: then what belongs to these is not what is wrong.
  bool has_ranges() const {
    if (document_.at(0).kind() != JsonKind::object) return false;
    const auto has = [this](const char* name) { return io::has_member(document_, 0, name); };
    return has("joints") || (has("mechanism") && !has("time"));
  }
  std::vector<std::string> known_keys() const {
    // "$schema" is for editors.
    std::vector<std::string> keys{"format", "time",   "bodies",    "ignore", "at_rest",
                                  "id",     "joints", "mechanism", "$schema"};
    if (has_ranges()) keys.insert(keys.end(), {"periodic", "start", "goal"});
    return keys;
  }

  Scene read() const {
    refuse_geojson();
    const JsonObject root(document_, 0, "", known_keys(), scene_shape);
    if (has_ranges()) {
      const auto joints = root.find("joints");
      throw document_.error(joints ? *joints : root.get("mechanism"), joints ? "joints" : "mechanism",
                            joints ? "the scene has joints instead of a time" : "the scene has no time",
                            "ask taut envelope or taut path about it, or give it a \"time\" and motions");
    }
    Scene scene;
    read_format(root.get("format"));
    read_time(root.get("time"), scene);
    read_rest(root, scene, [&](std::size_t token, const std::string& path, Body& body) {
      const io::MotionContext context{scene.start, scene.end, folder_, limits_};
      body.motion = io::read_motion(document_, token, path, context);
    });
    const auto mechanism = root.find("mechanism");
    if (!mechanism) return scene;
    scene.mechanism = io::read_mechanism(document_, *mechanism, scene.start, scene.end);
    with_place(*mechanism, [&] { scene = assembled(std::move(scene)); });
    return scene;
  }

  Linkage read_linkage() const {
    PathProblem problem;
    read_joints_and_bodies(problem);
    return std::move(problem.linkage);
  }

  PathProblem read_path_problem() const {
    PathProblem problem;
    const JsonObject root = read_joints_and_bodies(problem);
    if (const auto periodic = root.find("periodic")) io::read_periodic(document_, *periodic, problem);
    io::read_start(document_, root.get("start"), problem);
    io::read_goal(document_, root.get("goal"), problem);
    return problem;
  }

 private:
  /// Errors say where in the file.
  template <class Assemble>
  void with_place(std::size_t token, const Assemble& assemble) const {
    try {
      assemble();
    } catch (const InputError& error) {
      throw document_.error(token, error.place(), error.problem(), error.hint());
    }
  }

  JsonObject read_joints_and_bodies(PathProblem& problem) const {
    refuse_geojson();
    if (document_.at(0).kind() == JsonKind::object && io::has_member(document_, 0, "time"))
      throw document_.error(
          0, "", "the scene has a time instead of joints",
          "ask `taut check` about it, or leave \"time\" out and write \"joints\": {\"lift\": [0, 60]}, or "
          "ranges of a mechanism's drives, \"drive\": {\"A\": [0, 90]}");
    // "periodic", "start" and "goal" are part of one question; the others pass over them.
    JsonObject root(
        document_, 0, "",
        {"format", "joints", "periodic", "start", "goal", "bodies", "ignore", "at_rest", "id", "mechanism", "$schema"},
        linkage_shape);
    read_format(root.get("format"));
    Linkage& linkage = problem.linkage;
    const auto mechanism = root.find("mechanism");
    const auto joints = root.find("joints");
    if (joints || !mechanism) linkage.joints = io::read_joints(document_, root.get("joints"));
    std::vector<std::optional<JointMotion>>& motions = linkage.motions;
    read_rest(root, linkage.scene, [&](std::size_t token, const std::string& path, Body&) {
      // This body is the next one.
      motions.resize(linkage.scene.bodies.size());
      motions.push_back(io::read_joint_motion(document_, token, path, linkage.joints));
    });
    motions.resize(linkage.scene.bodies.size());
    if (!mechanism) return root;
    linkage.scene.mechanism = io::read_mechanism_with_ranges(document_, *mechanism, linkage.joints);
    with_place(*mechanism, [&] { linkage = assembled(std::move(linkage)); });
    return root;
  }

  /// Bodies, what is ignored, and the id. `read_motion(token, path, body)` reads what a body's "motion" says.
  template <class ReadMotion>
  void read_rest(const JsonObject& root, Scene& scene, const ReadMotion& read_motion) const {
    read_bodies(root.get("bodies"), scene, read_motion);
    if (const auto ignore = root.find("ignore")) read_ignored(*ignore, scene);
    if (const auto at_rest = root.find("at_rest")) read_at_rest(*at_rest, scene);
    if (const auto id = root.find("id")) scene.id = io::value_text(document_, *id);
  }

  void read_format(std::size_t token) const {
    document_.require(token, JsonKind::string, "format", R"("format": "taut-scene/1")");
    const std::string& format = document_.string_at(token);
    if (format == "taut-scene/1") return;
    throw document_.error(token, "format", "unknown format \"" + io::excerpt(format) + "\"",
                          R"(this version of taut reads "taut-scene/1")");
  }

  void read_time(std::size_t token, Scene& scene) const {
    const std::string shape = R"("time": [start, end])";
    const auto time = io::read_numbers(document_, token, "time", shape, 2, "write " + shape);
    if (time.size() != 2) {
      throw document_.error(token, "time", "expected two numbers, found " + std::to_string(time.size()),
                            "write " + shape);
    }
    scene.start = time[0];
    scene.end = time[1];
  }

  template <class ReadMotion>
  void read_bodies(std::size_t token, Scene& scene, const ReadMotion& read_motion) const {
    document_.require(token, JsonKind::array, "bodies", R"("bodies": [{...}, {...}])");
    const std::size_t end = document_.after(token);
    std::set<std::string> names;
    for (std::size_t i = token + 1; i < end; i = document_.after(i)) {
      scene.bodies.push_back(read_body(i, element_path("bodies", scene.bodies.size()), read_motion));
      const std::string& name = scene.bodies.back().name;
      if (!names.insert(name).second) {
        throw document_.error(token, "bodies", "two bodies are called \"" + io::excerpt(name) + "\"",
                              "give the bodies different names: answers call them by name");
      }
    }
  }

  template <class ReadMotion>
  Body read_body(std::size_t token, const std::string& path, const ReadMotion& read_motion) const {
    const JsonObject object(document_, token, path, {"name", "polygon", "parts", "z", "motion", "relative_to", "id"},
                            R"(a body as {"name":"P","polygon":[[x,y],...],"motion":null})");
    Body body;
    body.name = read_name(object.get("name"), object.path("name"));
    read_shape(object, token, path, body);
    if (const auto parent = object.find("relative_to"))
      body.relative_to = read_name(*parent, object.path("relative_to"));
    if (const auto z = object.find("z")) body.z = read_layers(*z, object.path("z"));
    if (const auto id = object.find("id")) body.id = io::value_text(document_, *id);
    if (const auto motion = object.find("motion")) read_motion(*motion, object.path("motion"), body);
    return body;
  }

  std::string read_name(std::size_t token, const std::string& path) const {
    document_.require(token, JsonKind::string, path, R"("name": "lid")");
    const std::string& name = document_.string_at(token);
    if (name.empty()) throw document_.error(token, path, "the name is empty", "name the body, for instance \"lid\"");
    for (char c : name) {
      // A line break or an escape sequence in a name would garble reports.
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
        throw document_.error(token, path, "the name has a control character", "use printable characters only");
      }
    }
    return name;
  }

  /// Pairs of names.
  void read_ignored(std::size_t token, Scene& scene) const {
    const std::string shape = R"("ignore": [["door", "pin"], ["chassis", "*"]])";
    document_.require(token, JsonKind::array, "ignore", shape);
    const std::size_t end = document_.after(token);
    for (std::size_t i = token + 1; i < end; i = document_.after(i)) {
      const std::string path = element_path("ignore", scene.ignore.size());
      document_.require(i, JsonKind::array, path, shape);
      std::vector<std::string> names;
      for (std::size_t k = i + 1; k < document_.after(i); k = document_.after(k)) {
        document_.require(k, JsonKind::string, path, shape);
        names.push_back(document_.string_at(k));
      }
      if (names.size() != 2)
        throw document_.error(i, path, "expected two names, found " + std::to_string(names.size()), "write " + shape);
      scene.ignore.push_back({names[0], names[1]});
    }
  }

  void read_at_rest(std::size_t token, Scene& scene) const {
    const std::string shape = R"("at_rest": "test", or "skip")";
    document_.require(token, JsonKind::string, "at_rest", shape);
    const std::string& word = document_.string_at(token);
    if (word != "test" && word != "skip")
      throw document_.error(token, "at_rest", "unknown word \"" + io::excerpt(word) + "\"", "write " + shape);
    scene.at_rest = word == "test" ? AtRest::test : AtRest::skip;
  }

  /// One polygon, or parts.
  void read_shape(const JsonObject& object, std::size_t token, const std::string& path, Body& body) const {
    const auto polygon = object.find("polygon"), parts = object.find("parts");
    if (polygon && parts)
      throw document_.error(token, path, "both \"polygon\" and \"parts\" are given", "write one of the two");
    if (!parts) {
      const std::size_t given = object.get("polygon");
      if (is_path(given)) return take_curves(read_path(given, object.path("polygon")), body);
      std::vector<Part> read = read_parts(given, object.path("polygon"));
      if (is_plain(read)) {
        body.polygon = std::move(read[0].outline);
      } else {
        body.parts = std::move(read);
      }
      return;
    }
    const std::string shape = R"("parts": [polygon, polygon, ...], each as "polygon" is written)";
    document_.require(*parts, JsonKind::array, object.path("parts"), shape);
    read_part_list(*parts, object.path("parts"), body);
    if (body.parts.empty() && body.curves.empty() && body.polygon.empty())
      throw document_.error(*parts, object.path("parts"), "there are no parts", "write " + shape);
  }

  /// Parts one after the other. Where one of them has curves, all are taken as curves.
  void read_part_list(std::size_t token, const std::string& list, Body& body) const {
    std::vector<CurvedPart> curves;
    const std::size_t end = document_.after(token);
    std::size_t count = 0;
    bool paths = false;
    for (std::size_t i = token + 1; i < end; i = document_.after(i)) paths = paths || is_path(i);
    for (std::size_t i = token + 1; i < end; i = document_.after(i), ++count) {
      const std::string path = element_path(list, count);
      if (is_path(i)) {
        for (CurvedPart& part : read_path(i, path)) curves.push_back(std::move(part));
        continue;
      }
      for (Part& part : read_parts(i, path)) {
        if (paths) {
          curves.push_back(curved(part));
        } else {
          body.parts.push_back(std::move(part));
        }
      }
    }
    if (paths) take_curves(std::move(curves), body);
  }

  /// Is the body one polygon, on the body's layers?
  static bool is_plain(const std::vector<Part>& parts) {
    return parts.size() == 1 && parts[0].holes.empty() && !parts[0].z;
  }

  static CurvedPart curved(const Part& part) {
    CurvedPart curves{outline_of(part.outline), {}, part.z};
    for (const Polygon& hole : part.holes) curves.holes.push_back(outline_of(hole));
    return curves;
  }

  bool is_path(std::size_t token) const {
    return document_.at(token).kind() == JsonKind::object && io::has_member(document_, token, "path");
  }

  std::vector<CurvedPart> read_path(std::size_t token, const std::string& path) const {
    const std::string shape = R"({"path": "M0 0 H10 A5 5 0 0 1 10 10 Z", "fill-rule": "nonzero"})";
    const JsonObject object(document_, token, path, {"path", "fill-rule", "z"}, shape);
    FillRule rule = FillRule::nonzero;
    if (const auto given = object.find("fill-rule")) {
      document_.require(*given, JsonKind::string, object.path("fill-rule"), shape);
      const std::string& word = document_.string_at(*given);
      if (word != "nonzero" && word != "evenodd")
        throw document_.error(*given, object.path("fill-rule"), "unknown rule \"" + io::excerpt(word) + "\"",
                              R"(write "nonzero" or "evenodd")");
      if (word == "evenodd") rule = FillRule::evenodd;
    }
    const std::size_t data = object.get("path");
    document_.require(data, JsonKind::string, object.path("path"), shape);
    try {
      return on_layers(object, parse_path(document_.string_at(data), rule, ""));
    } catch (const InputError& error) {
      throw error.within(document_.error(data, object.path("path"), "", "").place());
    }
  }

  /// Parts that are bounded by lines only are polygons.
  static void take_curves(std::vector<CurvedPart> curves, Body& body) {
    std::vector<Part> straight;
    for (const CurvedPart& part : curves) {
      const auto polygons = polygons_of(part);
      if (!polygons) {
        body.curves = std::move(curves);
        return;
      }
      straight.push_back(*polygons);
      straight.back().z = part.z;
    }
    if (is_plain(straight)) {
      body.polygon = std::move(straight[0].outline);
    } else {
      body.parts = std::move(straight);
    }
  }

  /// What stands for a polygon: points, an outline with holes, or a file, which may have several.
  std::vector<Part> read_parts(std::size_t token, const std::string& path) const {
    if (document_.at(token).kind() != JsonKind::object) return {{read_points(token, path), {}}};
    const JsonObject object(
        document_, token, path, {"outline", "holes", "wkt", "geojson", "z"},
        R"("polygon": [[x, y], ...], or {"outline": ..., "holes": ...}, or {"path": ...}, or {"wkt": file})");
    if (object.find("outline") || object.find("holes")) return on_layers(object, std::vector{read_part(token, path)});
    return on_layers(object, read_file(token, path));
  }

  /// The layers that the object names, for all of these parts.
  template <class Parts>
  Parts on_layers(const JsonObject& object, Parts parts) const {
    if (const auto z = object.find("z")) {
      for (auto& part : parts) part.z = read_layers(*z, object.path("z"));
    }
    return parts;
  }

  Layers read_layers(std::size_t token, const std::string& path) const {
    const std::string shape = R"("z": [lo, hi], the lowest and the highest height, or null for no end)";
    document_.require(token, JsonKind::array, path, shape);
    const std::size_t end = document_.after(token);
    std::vector<std::optional<double>> ends;
    for (std::size_t i = token + 1; i < end; i = document_.after(i)) {
      const bool none = document_.at(i).kind() == JsonKind::null;
      ends.push_back(none ? std::nullopt
                          : std::optional(io::read_number(document_, i, element_path(path, ends.size()))));
    }
    Layers z;
    if (ends.size() == 2) z = {ends[0].value_or(z.lo), ends[1].value_or(z.hi)};
    if (ends.size() != 2 || !(z.lo < z.hi))
      throw document_.error(token, path, "the layers are not two heights, the lower one first", "write " + shape);
    return z;
  }

  Part read_part(std::size_t token, const std::string& path) const {
    const std::string shape = R"({"outline": [[x, y], ...], "holes": [[[x, y], ...], ...]})";
    const JsonObject object(document_, token, path, {"outline", "holes", "z"}, shape);
    Part part;
    part.outline = read_points(object.get("outline"), object.path("outline"));
    const auto holes = object.find("holes");
    if (!holes) return part;
    document_.require(*holes, JsonKind::array, object.path("holes"), shape);
    const std::size_t end = document_.after(*holes);
    for (std::size_t i = *holes + 1; i < end; i = document_.after(i))
      part.holes.push_back(read_points(i, element_path(object.path("holes"), part.holes.size())));
    return part;
  }

  Polygon read_points(std::size_t token, const std::string& path) const {
    return io::read_points(document_, token, path, limits_.max_vertices, false);
  }

  std::vector<Part> read_file(std::size_t token, const std::string& path) const {
    const std::string shape =
        R"("polygon": [[x, y], ...], or {"outline": ..., "holes": ...}, or {"path": "M..."}, or {"wkt": file}, or {"geojson": file})";
    const JsonObject object(document_, token, path, {"wkt", "geojson", "z"}, shape);
    const auto wkt = object.find("wkt"), geojson = object.find("geojson");
    if (wkt.has_value() == geojson.has_value()) {
      throw document_.error(token, path, wkt ? "both \"wkt\" and \"geojson\" are given" : "no outline is given",
                            "write " + shape);
    }
    const std::size_t file = wkt ? *wkt : *geojson;
    document_.require(file, JsonKind::string, object.path(wkt ? "wkt" : "geojson"), shape);
    try {
      const std::string outline = io::named_file(folder_, document_.string_at(file), limits_.allow_outside);
      return wkt ? read_wkt_parts(outline, limits_) : read_geojson_parts(outline, limits_);
    } catch (const InputError& e) {
      throw e.within(document_.error(file, path, "", "").place());
    }
  }

  const JsonDocument& document_;
  std::string folder_;
  const ReadLimits& limits_;
};

/// Text that is no JSON, but something that people have. The parser would complain of its first letter.
void refuse_other_formats(const std::string& text, const std::string& name) {
  const auto begins = [&](std::string_view with) { return std::string_view(text).substr(0, with.size()) == with; };
  if (begins("\xFF\xFE") || begins("\xFE\xFF") || begins(std::string_view("{\0", 2)))
    throw InputError(name, "this is not text in UTF-8", "a scene is a JSON file; save it as UTF-8");
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string::npos) return;
  const std::string_view rest = std::string_view(text).substr(first);
  const bool svg = rest[0] == '<', dxf = rest.substr(0, 1) == "0" && rest.find("SECTION") < 20;
  const bool wkt = rest.substr(0, 7) == "POLYGON" || rest.substr(0, 12) == "MULTIPOLYGON";
  if (svg || dxf || wkt)
    throw InputError(name,
                     std::string("this is ") +
                         (svg   ? "XML, perhaps an SVG drawing"
                          : dxf ? "a DXF drawing"
                                : "WKT") +
                         ", not a scene",
                     wkt ? "a body's polygon may be {\"wkt\": file}" : "`taut import` makes a scene of a drawing");
}

template <class Read>
auto read_text(std::string text, const std::string& name, const std::string& folder, const ReadLimits& limits,
               const char* shape, const Read& read) {
  refuse_other_formats(text, name);
  const JsonDocument document = io::parse_json(std::move(text), name, std::string("write ") + shape);
  return (SceneReader(document, folder, limits).*read)();
}

}  // namespace

Scene parse_scene(const std::string& text, const std::string& name, const std::string& folder,
                  const ReadLimits& limits) {
  io::require_size(text, name, limits.max_bytes);
  return read_text(text, name, folder, limits, scene_shape, &SceneReader::read);
}

Scene read_scene(const std::string& path, const ReadLimits& limits) {
  return read_text(io::read_text_file(path, limits.max_bytes), path, io::folder_of(path), limits, scene_shape,
                   &SceneReader::read);
}

Linkage parse_linkage(const std::string& text, const std::string& name, const std::string& folder,
                      const ReadLimits& limits) {
  io::require_size(text, name, limits.max_bytes);
  return read_text(text, name, folder, limits, linkage_shape, &SceneReader::read_linkage);
}

Linkage read_linkage(const std::string& path, const ReadLimits& limits) {
  return read_text(io::read_text_file(path, limits.max_bytes), path, io::folder_of(path), limits, linkage_shape,
                   &SceneReader::read_linkage);
}

PathProblem parse_path_problem(const std::string& text, const std::string& name, const std::string& folder,
                               const ReadLimits& limits) {
  io::require_size(text, name, limits.max_bytes);
  return read_text(text, name, folder, limits, path_shape, &SceneReader::read_path_problem);
}

PathProblem read_path_problem(const std::string& path, const ReadLimits& limits) {
  return read_text(io::read_text_file(path, limits.max_bytes), path, io::folder_of(path), limits, path_shape,
                   &SceneReader::read_path_problem);
}

}  // namespace taut
