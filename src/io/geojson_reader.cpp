// Polygons as GeoJSON (RFC 7946). Members that taut has no use for are allowed, as the RFC demands.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "io/json_document.hpp"
#include "io/json_object.hpp"
#include "io/outline_reader.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::internal::io {

namespace {

const char* const polygon_shape = R"({"type":"Polygon","coordinates":[[[x,y],[x,y],...]]})";

std::string write_polygon() { return fmt::format("write {}", polygon_shape); }

/// The token of a member's value; 0, which is the root and never a member, if there is none.
std::size_t find_member(const JsonDocument& document, std::size_t object, const std::string& key) {
  const std::size_t end = document.after(object);
  for (std::size_t i = object + 1; i < end; i = document.after(i + 1)) {
    if (document.string_at(i) == key) return i + 1;
  }
  return 0;
}

std::size_t get_member(const JsonDocument& document, std::size_t object, const std::string& path,
                       const std::string& key, JsonKind kind) {
  document.require(object, JsonKind::object, path, polygon_shape);
  const std::size_t value = find_member(document, object, key);
  if (value == 0) {
    throw document.error(object, path, "the key \"" + key + "\" is missing", write_polygon());
  }
  document.require(value, kind, path.empty() ? key : path + "." + key, polygon_shape);
  return value;
}

/// Readers differ in which of two they take.
void require_distinct_keys(const JsonDocument& document) {
  std::vector<std::size_t> keys;
  const auto name = [&document](std::size_t key) -> const std::string& { return document.string_at(key); };
  for (std::size_t object = 0; object < document.tokens.size(); ++object) {
    if (document.at(object).kind() != JsonKind::object) continue;
    keys.clear();
    for (std::size_t key = object + 1; key < document.after(object); key = document.after(key + 1)) keys.push_back(key);
    std::stable_sort(keys.begin(), keys.end(), [&](std::size_t a, std::size_t b) { return name(a) < name(b); });
    const auto twice =
        std::adjacent_find(keys.begin(), keys.end(), [&](std::size_t a, std::size_t b) { return name(a) == name(b); });
    if (twice != keys.end()) throw document.error(*(twice + 1), "", "a key appears twice", "keep one of the two");
  }
}

/// Is it a type of GeoJSON that is no polygon? Other words are not quoted: the file may be any.
bool is_point_or_line(const std::string& name) {
  for (const char* known : {"Point", "MultiPoint", "LineString", "MultiLineString"})
    if (name == known) return true;
  return false;
}

std::string found_type(const std::string& name) { return is_point_or_line(name) ? "\"" + name + "\"" : "another type"; }

/// Goes through collections, features and geometries, which nest no deeper than JSON may.
class GeoJsonReader {
 public:
  /// Without `lenient`, what is no polygon is refused.
  GeoJsonReader(const JsonDocument& document, const ReadLimits& limits, bool lenient)
      : document_(document), limits_(limits), lenient_(lenient) {}

  /// `sequence`: of values in an array that was made of them.
  std::vector<GeoFeature> read(bool sequence) {
    if (sequence)
      for_each_element(0, "", [this](std::size_t i, const std::string& p) { read_object(i, p); });
    else
      read_object(0, "");
    const bool any = std::any_of(features_.begin(), features_.end(),
                                 [](const GeoFeature& feature) { return !feature.parts.empty(); });
    if (!lenient_ && !any && empty_) throw *empty_;
    return std::move(features_);
  }

 private:
  void read_object(std::size_t here, const std::string& path) {
    if (path.empty() && find_member(document_, here, "format") > 0 && find_member(document_, here, "bodies") > 0)
      throw document_.error(here, path, "the file is a scene of taut, and no GeoJSON",
                            "ask about it as it is: taut check FILE");
    const std::size_t type = get_member(document_, here, path, "type", JsonKind::string);
    const std::string& name = document_.string_at(type);
    const std::string prefix = path.empty() ? "" : path + ".";
    if (name == "Topology")
      throw document_.error(type, prefix + "type", "the file is TopoJSON, whose shapes share arcs, and no GeoJSON",
                            "convert it to GeoJSON: ogr2ogr map.geojson FILE");
    if (name == "FeatureCollection") {
      const std::size_t list = get_member(document_, here, path, "features", JsonKind::array);
      note_if_empty(list, prefix + "features", "there are no features");
      for_each_element(list, prefix + "features", [this](std::size_t i, const std::string& p) { read_object(i, p); });
    } else if (name == "Feature") {
      features_.push_back({feature_name(here), {}, {}, false});
      read_geometry_of_feature(here, path);
    } else {
      features_.push_back({});
      read_geometry(here, path);
    }
  }

  void read_geometry_of_feature(std::size_t here, const std::string& path) {
    const std::string inner = path.empty() ? "geometry" : path + ".geometry";
    const std::size_t geometry = find_member(document_, here, "geometry");
    if (geometry != 0 && document_.at(geometry).kind() == JsonKind::null) {
      const InputError error = document_.error(geometry, inner, "a feature without a geometry", write_polygon());
      if (!empty_) empty_ = error;
      return features_.back().skipped.push_back({error.place(), error.problem()});
    }
    read_geometry(get_member(document_, here, path, "geometry", JsonKind::object), inner);
  }

  void read_geometry(std::size_t here, const std::string& path) {
    const std::size_t type = get_member(document_, here, path, "type", JsonKind::string);
    const std::string& name = document_.string_at(type);
    const std::string prefix = path.empty() ? "" : path + ".";
    if (name == "GeometryCollection") {
      const std::size_t list = get_member(document_, here, path, "geometries", JsonKind::array);
      note_if_empty(list, prefix + "geometries", "there are no geometries");
      for_each_element(list, prefix + "geometries",
                       [this](std::size_t i, const std::string& p) { read_geometry(i, p); });
    } else if (name == "Polygon") {
      read_polygon(get_member(document_, here, path, "coordinates", JsonKind::array), prefix + "coordinates");
    } else if (name == "MultiPolygon") {
      const std::size_t list = get_member(document_, here, path, "coordinates", JsonKind::array);
      note_if_empty(list, prefix + "coordinates", "there are no polygons");
      for_each_element(list, prefix + "coordinates",
                       [this](std::size_t i, const std::string& p) { read_polygon(i, p); });
    } else if (!has_empty_coordinates(here)) {
      const InputError error = document_.error(
          type, prefix + "type", "expected a Polygon or MultiPolygon, found " + found_type(name), write_polygon());
      if (!lenient_) throw error;
      if (is_point_or_line(name))
        features_.back().skipped.push_back({error.place(), "\"" + name + "\" is no polygon"});
      else
        features_.back().skipped.push_back({error.place(), "is of none of the types of GeoJSON", true});
    }
  }

  void read_polygon(std::size_t rings, const std::string& path) {
    document_.require(rings, JsonKind::array, path, polygon_shape);
    const bool none = note_if_empty(rings, path, "the polygon is empty");
    if (none || note_if_empty(rings + 1, element_path(path, 0), "the polygon is empty")) return;
    Part part;
    for_each_element(rings, path, [&](std::size_t i, const std::string& p) {
      Polygon ring = read_ring(i, p);
      if (i == rings + 1)
        part.outline = std::move(ring);
      else if (!ring.empty())
        part.holes.push_back(std::move(ring));
    });
    add_parts(features_.back().parts, std::move(part));
  }

  Polygon read_ring(std::size_t token, const std::string& path) {
    // One more than the limit, for the repeated vertex.
    Polygon ring = read_points(document_, token, path, limits_.max_vertices + 1, true);
    for (std::size_t i = token + 1; i < document_.after(token); i = document_.after(i))
      if (document_.after(i) > i + 3 && document_.at(i + 3).number != 0) features_.back().heights = true;
    drop_repeated_vertices(ring);
    if (ring.size() > limits_.max_vertices) fail_size(document_, token, path, limits_.max_vertices);
    return ring;
  }

  /// The id, or the name among the properties.
  std::string feature_name(std::size_t feature) const {
    std::size_t name = find_member(document_, feature, "id");
    const std::size_t properties = find_member(document_, feature, "properties");
    if (name == 0 && properties != 0 && document_.at(properties).kind() == JsonKind::object)
      name = find_member(document_, properties, "name");
    if (name == 0) return "";
    if (document_.at(name).kind() == JsonKind::string) return document_.string_at(name);
    return document_.at(name).kind() == JsonKind::number ? value_text(document_, name) : "";
  }

  /// What is empty adds nothing; it is an error where nothing else is there.
  bool note_if_empty(std::size_t array, const std::string& path, const char* problem) {
    if (document_.at(array).kind() != JsonKind::array || document_.after(array) != array + 1) return false;
    if (!empty_) empty_ = document_.error(array, path, problem, write_polygon());
    return true;
  }

  bool has_empty_coordinates(std::size_t geometry) {
    const std::size_t coordinates = find_member(document_, geometry, "coordinates");
    return coordinates != 0 && note_if_empty(coordinates, "coordinates", "the geometry is empty");
  }

  template <class Visit>
  void for_each_element(std::size_t array, const std::string& path, const Visit& visit) const {
    std::size_t count = 0;
    for (std::size_t i = array + 1; i < document_.after(array); i = document_.after(i))
      visit(i, element_path(path, count++));
  }

  const JsonDocument& document_;
  const ReadLimits& limits_;
  bool lenient_;
  std::vector<GeoFeature> features_;
  std::optional<InputError> empty_;  ///< the first thing in which there is nothing
};

/// Values one after the other, as newline-delimited GeoJSON and RFC 8142 have them, as one array; no line changes its
/// place. False where the text is one value, or something else.
bool make_array(std::string& text) {
  constexpr char separator = '\x1E';
  std::string array;
  int depth = 0, values = 0;
  bool quoted = false;
  array.reserve(text.size() + 16);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      array += c;
      if (c == '\\' && i + 1 < text.size()) array += text[++i];
      quoted = c != '"';
      continue;
    }
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    if (depth == 0 && c != '{' && c != separator && !space) return false;
    if (depth == 0 && c == '{') array += values++ == 0 ? '[' : ',';
    depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
    quoted = c == '"';
    array += c == separator && depth == 0 ? ' ' : c;
  }
  if (values < 2 && text.find(separator) == std::string::npos) return false;
  text = std::move(array) + "]";
  return values > 0;
}

std::vector<GeoFeature> read_features(std::string text, const std::string& name, const ReadLimits& limits, bool lenient,
                                      Quoting quoting) {
  drop_byte_order_mark(text);
  const bool sequence = make_array(text);
  const JsonDocument document = parse_json(std::move(text), name, write_polygon(), quoting);
  require_distinct_keys(document);
  return GeoJsonReader(document, limits, lenient).read(sequence);
}

}  // namespace

std::vector<Part> parse_geojson(std::string text, const std::string& name, const ReadLimits& limits) {
  std::vector<Part> parts;
  for (GeoFeature& feature : read_features(std::move(text), name, limits, false, Quoting::never)) {
    for (Part& part : feature.parts) parts.push_back(std::move(part));
  }
  return parts;
}

std::vector<GeoFeature> parse_geojson_features(std::string text, const std::string& name, const ReadLimits& limits) {
  return read_features(std::move(text), name, limits, true, Quoting::allowed);
}

}  // namespace taut::internal::io

namespace taut {
using namespace internal;

std::vector<Part> read_geojson_parts(const std::string& path, const ReadLimits& limits) {
  return io::parse_geojson(io::read_text_file(path, limits.max_bytes), path, limits);
}

std::vector<Part> parse_geojson_parts(const std::string& text, const std::string& name, const ReadLimits& limits) {
  io::require_size(text, name, limits.max_bytes);
  return io::parse_geojson(text, name, limits);
}

Polygon read_geojson(const std::string& path, const ReadLimits& limits) {
  return io::only_outline(read_geojson_parts(path, limits), path);
}

Polygon parse_geojson(const std::string& text, const std::string& name, const ReadLimits& limits) {
  return io::only_outline(parse_geojson_parts(text, name, limits), name);
}

}  // namespace taut
