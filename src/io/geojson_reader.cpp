// Outlines as GeoJSON (RFC 7946). Members that taut has no use for are allowed, as the RFC demands.
#include <algorithm>

#include "io/json_document.hpp"
#include "io/json_numbers.hpp"
#include "io/outline_reader.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut {

namespace io {

namespace {

const char* const polygon_shape = R"({"type":"Polygon","coordinates":[[[x,y],[x,y],...]]})";

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
    throw document.error(object, path, "the key \"" + key + "\" is missing", std::string("write ") + polygon_shape);
  }
  document.require(value, kind, path.empty() ? key : path + "." + key, polygon_shape);
  return value;
}

std::size_t count_elements(const JsonDocument& document, std::size_t array) {
  std::size_t count = 0;
  for (std::size_t i = array + 1; i < document.after(array); i = document.after(i)) ++count;
  return count;
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

/// The types of GeoJSON that are not polygons; other words are not quoted.
std::string found_type(const std::string& name) {
  for (const char* known :
       {"Point", "MultiPoint", "LineString", "MultiLineString", "MultiPolygon", "GeometryCollection"}) {
    if (name == known) return "\"" + name + "\"";
  }
  return "another type";
}

/// Goes down through FeatureCollection and Feature, and leaves the path of the geometry in `path`.
std::size_t find_geometry(const JsonDocument& document, std::string* path) {
  std::size_t here = 0;
  for (;;) {
    const std::size_t type = get_member(document, here, *path, "type", JsonKind::string);
    const std::string& name = document.string_at(type);
    const std::string prefix = path->empty() ? "" : *path + ".";
    if (name == "FeatureCollection") {
      const std::size_t features = get_member(document, here, *path, "features", JsonKind::array);
      const std::size_t count = count_elements(document, features);
      if (count != 1) {
        throw document.error(features, prefix + "features", "found " + std::to_string(count) + " features",
                             "keep the one whose polygon is wanted");
      }
      here = features + 1;
      *path = prefix + "features[0]";
    } else if (name == "Feature") {
      here = get_member(document, here, *path, "geometry", JsonKind::object);
      *path = prefix + "geometry";
    } else if (name == "Polygon") {
      return here;
    } else {
      throw document.error(type, prefix + "type", "expected a Polygon, found " + found_type(name),
                           std::string("write ") + polygon_shape);
    }
  }
}

}  // namespace

Polygon parse_geojson(std::string text, const std::string& name, const ReadLimits& limits) {
  const JsonDocument document =
      parse_json(std::move(text), name, std::string("write ") + polygon_shape, Quoting::never);
  require_distinct_keys(document);
  std::string path;
  const std::size_t geometry = find_geometry(document, &path);
  const std::size_t rings = get_member(document, geometry, path, "coordinates", JsonKind::array);
  path += path.empty() ? "coordinates" : ".coordinates";
  const std::size_t count = count_elements(document, rings);
  if (count == 0) throw document.error(rings, path, "the polygon is empty", std::string("write ") + polygon_shape);
  if (count > 1) {
    throw document.error(rings, path, "the polygon has a hole",
                         "a body is a simple polygon: cut it open along a slit, or leave the hole out");
  }
  // One more than the limit, for the repeated vertex.
  Polygon ring = read_points(document, rings + 1, path + "[0]", limits.max_vertices + 1, true);
  drop_repeated_last_vertex(ring);
  if (ring.size() > limits.max_vertices) fail_size(document, rings + 1, path + "[0]", limits.max_vertices);
  return ring;
}

}  // namespace io

Polygon read_geojson(const std::string& path, const ReadLimits& limits) {
  return io::parse_geojson(io::read_text_file(path, limits.max_bytes), path, limits);
}

Polygon parse_geojson(const std::string& text, const std::string& name, const ReadLimits& limits) {
  io::require_size(text, name, limits.max_bytes);
  return io::parse_geojson(text, name, limits);
}

}  // namespace taut
