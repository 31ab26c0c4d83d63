// The format taut-scene/1.
#include <set>

#include "io/joint_reader.hpp"
#include "io/json_document.hpp"
#include "io/json_object.hpp"
#include "io/mechanism_reader.hpp"
#include "io/motion_reader.hpp"
#include "io/pair_reader.hpp"
#include "io/platform.hpp"
#include "io/shape_reader.hpp"
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

  std::vector<std::string> known_keys() const {
    // "$schema" is for editors.
    std::vector<std::string> keys{"format", "time",   "bodies",    "ignore", "at_rest",
                                  "id",     "joints", "mechanism", "$schema"};
    // With ranges instead of a time, what belongs to these is not what is wrong.
    if (io::has_ranges(document_)) keys.insert(keys.end(), {"periodic", "start", "goal"});
    if (!io::has_ranges(document_)) keys.push_back("clearances");
    return keys;
  }

  Scene read() const {
    refuse_geojson();
    const JsonObject root(document_, 0, "", known_keys(), scene_shape);
    if (io::has_ranges(document_)) {
      const auto joints = root.find("joints");
      throw document_.error(
          joints ? *joints : root.get("mechanism"), joints ? "joints" : "mechanism",
          joints ? "the scene has joints instead of a time" : "the scene has no time",
          joints ? "ask taut envelope or taut path about it, or give it a \"time\" and motions"
                 : "give it a \"time\", as \"time\": [0, 1]; with ranges as drives, ask taut envelope or "
                   "taut path about it");
    }
    Scene scene;
    read_format(root.get("format"));
    read_time(root.get("time"), scene);
    if (const auto clearances = root.find("clearances")) scene.clearances = io::read_clearances(document_, *clearances);
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
    read_joints_and_bodies(problem, linkage_shape);
    return std::move(problem.linkage);
  }

  PathProblem read_path_problem() const {
    PathProblem problem;
    const JsonObject root = read_joints_and_bodies(problem, path_shape);
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

  JsonObject read_joints_and_bodies(PathProblem& problem, const char* shape) const {
    refuse_geojson();
    if (document_.at(0).kind() == JsonKind::object && io::has_member(document_, 0, "time"))
      throw document_.error(
          0, "", "the scene has a time instead of joints",
          "ask `taut check` about it, or leave \"time\" out and write \"joints\": {\"lift\": [0, 60]}, or "
          "ranges of a mechanism's drives, \"drive\": {\"A\": [0, 90]}");
    if (document_.at(0).kind() == JsonKind::object && io::has_member(document_, 0, "clearances"))
      throw document_.error(0, "clearances", "a scene with joints has no clearances of single pairs",
                            "leave them out; `taut path --clearance` keeps one distance of all pairs");
    // "periodic", "start" and "goal" are part of one question; the others pass over them.
    JsonObject root(
        document_, 0, "",
        {"format", "joints", "periodic", "start", "goal", "bodies", "ignore", "at_rest", "id", "mechanism", "$schema"},
        shape);
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
    if (const auto ignore = root.find("ignore")) scene.ignore = io::read_ignored(document_, *ignore);
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
    io::read_shape(document_, object, token, path, {folder_, limits_}, body);
    if (const auto parent = object.find("relative_to"))
      body.relative_to = read_name(*parent, object.path("relative_to"));
    if (const auto z = object.find("z")) body.z = io::read_layers(document_, *z, object.path("z"));
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

  void read_at_rest(std::size_t token, Scene& scene) const {
    const std::string shape = R"("at_rest": "test", or "skip")";
    document_.require(token, JsonKind::string, "at_rest", shape);
    const std::string& word = document_.string_at(token);
    if (word != "test" && word != "skip")
      throw document_.error(token, "at_rest", "unknown word \"" + io::excerpt(word) + "\"", "write " + shape);
    scene.at_rest = word == "test" ? AtRest::test : AtRest::skip;
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
