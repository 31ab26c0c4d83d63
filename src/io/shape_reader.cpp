// What a body of a scene looks like: polygons, parts, paths with curves, outlines in files of their own, and layers.
#include "io/shape_reader.hpp"

#include <cctype>
#include <cmath>
#include <cstring>
#include <optional>

#include "io/json_object.hpp"
#include "io/outline_reader.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::internal::io {
namespace {

class ShapeReader {
 public:
  ShapeReader(const JsonDocument& document, const NamedFiles& files) : document_(document), files_(files) {}

  /// One polygon, or parts.
  void read(const JsonObject& object, std::size_t token, const std::string& path, Body& body) const {
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

 private:
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
    return document_.at(token).kind() == JsonKind::object && has_member(document_, token, "path");
  }

  std::vector<CurvedPart> read_path(std::size_t token, const std::string& path) const {
    const std::string shape = R"({"path": "M0 0 H10 A5 5 0 0 1 10 10 Z", "fill-rule": "nonzero"})";
    const JsonObject object(document_, token, path, {"path", "fill-rule", "z"}, shape);
    FillRule rule = FillRule::nonzero;
    if (const auto given = object.find("fill-rule")) {
      document_.require(*given, JsonKind::string, object.path("fill-rule"), shape);
      const std::string& word = document_.string_at(*given);
      if (word != "nonzero" && word != "evenodd")
        throw document_.error(*given, object.path("fill-rule"), "unknown rule \"" + excerpt(word) + "\"",
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
      for (auto& part : parts) part.z = read_layers(document_, *z, object.path("z"));
    }
    return parts;
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
    return internal::io::read_points(document_, token, path, files_.limits.max_vertices, false);
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
      const std::string outline = named_file(files_.folder, document_.string_at(file), files_.limits.allow_outside);
      return wkt ? read_wkt_parts(outline, files_.limits) : read_geojson_parts(outline, files_.limits);
    } catch (const InputError& e) {
      throw e.within(document_.error(file, path, "", "").place());
    }
  }

  const JsonDocument& document_;
  const NamedFiles& files_;
};

}  // namespace

Layers read_layers(const JsonDocument& document, std::size_t token, const std::string& path) {
  const std::string shape = R"("z": [lo, hi], the lowest and the highest height, or null for no end)";
  document.require(token, JsonKind::array, path, shape);
  const std::size_t end = document.after(token);
  std::vector<std::optional<double>> ends;
  for (std::size_t i = token + 1; i < end; i = document.after(i)) {
    const bool none = document.at(i).kind() == JsonKind::null;
    ends.push_back(none ? std::nullopt : std::optional(read_number(document, i, element_path(path, ends.size()))));
  }
  Layers z;
  if (ends.size() == 2) z = {ends[0].value_or(z.lo), ends[1].value_or(z.hi)};
  if (ends.size() != 2 || !(z.lo < z.hi))
    throw document.error(token, path, "the layers are not two heights, the lower one first", "write " + shape);
  return z;
}

void read_shape(const JsonDocument& document, const JsonObject& object, std::size_t token, const std::string& path,
                const NamedFiles& files, Body& body) {
  ShapeReader(document, files).read(object, token, path, body);
}

namespace {

class PathDataReader {
 public:
  PathDataReader(std::string_view data, const std::string& place) : data_(data), place_(place) {}

  std::vector<Subpath> read() {
    char command = 0;
    for (skip(); position_ < data_.size(); skip()) {
      const bool letter = std::isalpha(static_cast<unsigned char>(data_[position_])) != 0;
      if (letter && !std::strchr("MmLlHhVvCcSsQqTtAaZz", data_[position_])) fail("this is no command of a path");
      if (!letter && (command == 0 || command == 'Z' || command == 'z')) fail("a command is expected");
      if (command == 0 && data_[position_] != 'M' && data_[position_] != 'm') fail("a path begins with M or m");
      if (letter) command = data_[position_++];
      step(command);
      // Further pairs after a move are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    return std::move(subpaths_);
  }

 private:
  void step(char command) {
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    base_ = kind == command ? Point{} : at_;
    if (kind == 'Z') return close();
    if (kind == 'M') return move(point());
    if (kind == 'L') add(LineTo{point()});
    if (kind == 'H') add(LineTo{{number() + base_.x, at_.y}});
    if (kind == 'V') add(LineTo{{at_.x, number() + base_.y}});
    if (kind == 'C' || kind == 'S') {
      const Point first = kind == 'C' ? point() : mirrored('C');
      const Point second = point();
      add(CubicTo{first, second, point()});
      control_ = second;
    }
    if (kind == 'Q' || kind == 'T') {
      control_ = kind == 'Q' ? point() : mirrored('Q');
      add(QuadraticTo{control_, point()});
    }
    if (kind == 'A') arc();
    last_ = kind == 'S' ? 'C' : kind == 'T' ? 'Q' : kind;
  }

  void arc() {
    const double rx = std::fabs(number()), ry = std::fabs(number()), rotation = number();
    const bool large = flag(), sweep = flag();
    const Point to = point();
    if (to == at_) return;
    if (rx == 0 || ry == 0) return add(LineTo{to});
    add(ArcTo{rx, ry, rotation, large, sweep, to});
  }

  void move(const Point& p) {
    start_ = at_ = p;
    open_ = false;
    last_ = 'M';
  }

  void close() {
    if (open_) subpaths_.back().closed = true;
    at_ = start_;
    open_ = false;
    last_ = 'Z';
  }

  void add(const CurveSegment& segment) {
    if (!open_) subpaths_.push_back({{at_, {}}, false});
    open_ = true;
    subpaths_.back().outline.segments.push_back(segment);
    at_ = end_of(segment);
  }

  /// The last curve's control point, on the other side of its end.
  Point mirrored(char kind) const {
    if (last_ != kind) return at_;
    return {2 * at_.x - control_.x, 2 * at_.y - control_.y};
  }

  void skip() {
    while (position_ < data_.size() && std::strchr(" \t\n\r\f,", data_[position_])) ++position_;
  }

  double number() {
    skip();
    // A path may be long: only what may be a number is read.
    const std::string near(data_.substr(position_, 400));
    std::size_t length = 0;
    const auto value = io::scan_number(near, &length);
    if (!value || !std::isfinite(*value)) fail("a number is expected");
    position_ += length;
    return *value;
  }

  bool flag() {
    skip();
    if (position_ >= data_.size() || (data_[position_] != '0' && data_[position_] != '1'))
      fail("a flag of an arc, 0 or 1, is expected");
    return data_[position_++] == '1';
  }

  Point point() {
    const double x = number(), y = number();
    return {base_.x + x, base_.y + y};
  }

  [[noreturn]] void fail(const std::string& problem) const {
    const std::string rest(data_.substr(position_, 40));
    throw InputError(place_,
                     problem + ", at character " + std::to_string(position_ + 1) +
                         (rest.empty() ? " (its end)" : ", before \"" + io::excerpt(rest, 20) + "\""),
                     "write M, L, H, V, C, S, Q, T, A and Z with their numbers, as in \"M0 0 H10 A5 5 0 0 1 10 10 Z\"");
  }

  std::string_view data_;
  const std::string& place_;
  std::size_t position_ = 0;
  std::vector<Subpath> subpaths_;
  Point at_, start_, control_, base_;
  char last_ = 0;
  bool open_ = false;  ///< is there a subpath that what comes next continues?
};

}  // namespace

std::vector<Subpath> read_path_data(std::string_view data, const std::string& place) {
  return PathDataReader(data, place).read();
}

}  // namespace taut::internal::io
