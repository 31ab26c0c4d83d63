// Polygons as well-known text (OGC Simple Features).
#include <algorithm>
#include <cctype>
#include <cmath>

#include "geometry/touching_rings.hpp"
#include "io/number_text.hpp"
#include "io/outline_reader.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::internal::io {

namespace {

/// As deep as JSON may be nested.
constexpr int max_nesting = 32;

class WktReader {
 public:
  WktReader(const std::string& text, const std::string& name, const ReadLimits& limits)
      : text_(text), name_(name), limits_(limits) {}

  /// Geometries one after the other, each on a line of its own, say, or with semicolons between them.
  std::vector<Part> read() {
    for (;;) {
      std::string word = read_word();
      if (word == "SRID") {  // EWKT: "SRID=4326;POLYGON ..."
        const std::size_t semicolon = text_.find(';', position_);
        if (semicolon == std::string::npos) fail("\"SRID\" without a \";\" after it");
        position_ = semicolon + 1;
        word = read_word();
      }
      read_geometry(word, 0);
      while (take(';')) {
      }
      skip_space();
      if (position_ == text_.size()) return std::move(parts_);
      if (!std::isalpha(static_cast<unsigned char>(text_[position_])))
        fail("unexpected text after the " + std::string(word == "POLYGON" ? "polygon" : "geometry"),
             "write one geometry after the other, each with its own brackets");
    }
  }

 private:
  /// What follows its name; `depth` collections are around it.
  void read_geometry(const std::string& word, int depth) {
    const bool collection = word == "GEOMETRYCOLLECTION", several = word == "MULTIPOLYGON";
    if (word != "POLYGON" && !several && !collection) fail("expected POLYGON or MULTIPOLYGON" + found(word));
    if (depth == max_nesting) fail("collections are nested more than " + std::to_string(max_nesting) + " deep");
    const std::string dimensions = read_word();
    if (dimensions == "EMPTY") fail_empty();
    if (word == "POLYGON") return read_polygon();
    expect('(', several ? "before the first polygon" : "before the first geometry");
    do {
      const std::string inner = read_word();
      if (collection)
        read_geometry(inner, depth + 1);
      else if (inner == "EMPTY")
        fail_empty();
      else
        read_polygon();
    } while (take(','));
    expect(')', several ? "after the polygons" : "after the geometries");
  }

  void read_polygon() {
    expect('(', "before the first ring");
    Part part;
    part.outline = read_ring();
    while (take(',')) part.holes.push_back(read_ring());
    expect(')', "after the ring");
    add_parts(parts_, std::move(part));
  }

  Polygon read_ring() {
    Polygon ring;
    expect('(', "before the vertices");
    do {
      // One more than the limit, for the repeated vertex.
      if (ring.size() > limits_.max_vertices) fail_size();
      const double x = read_coordinate(), y = read_coordinate();
      ring.push_back({x, y});
      skip_space();
      while (position_ < text_.size() && text_[position_] != ',' && text_[position_] != ')') {
        read_coordinate();  // Z, M
        skip_space();
      }
    } while (take(','));
    expect(')', "after the vertices");
    drop_repeated_vertices(ring);
    if (ring.size() > limits_.max_vertices) fail_size();
    return ring;
  }

  double read_coordinate() {
    skip_space();
    const std::size_t start = position_;
    const auto number = scan_number(text_, &position_);
    if (!number) fail("expected a number");
    if (!std::isfinite(*number)) {
      position_ = start;
      fail("the number is too large", "numbers must fit a 64-bit floating-point number (about 1.8e308 at most)");
    }
    return *number;
  }

  /// The geometries of WKT that are not polygons; other words are not quoted, the file may be any.
  static std::string found(const std::string& word) {
    if (word.empty()) return "";
    for (const char* known : {"POINT", "MULTIPOINT", "LINESTRING", "MULTILINESTRING", "CURVEPOLYGON", "MULTISURFACE"}) {
      if (word == known) return ", found " + word;
    }
    return ", found another word";
  }

  std::string read_word() {
    skip_space();
    std::string word;
    while (position_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[position_]))) {
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(text_[position_++])));
    }
    return word;
  }

  void skip_space() {
    while (position_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[position_]))) ++position_;
  }

  bool take(char c) {
    skip_space();
    if (position_ >= text_.size() || text_[position_] != c) return false;
    ++position_;
    return true;
  }

  void expect(char c, const char* where) {
    if (!take(c)) fail(std::string("expected \"") + c + "\" " + where);
  }

  [[noreturn]] void fail_empty() { fail("the polygon is empty"); }

  [[noreturn]] void fail_size() {
    fail("more vertices than the limit of " + std::to_string(limits_.max_vertices),
         "simplify the outline, or raise ReadLimits::max_vertices");
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& hint = "write POLYGON ((x y, x y, x y, ...))") {
    throw InputError(place_in_text(text_, name_, position_), problem, hint);
  }

  const std::string& text_;
  std::string name_;
  const ReadLimits& limits_;
  std::size_t position_ = 0;
  std::vector<Part> parts_;
};

}  // namespace

void drop_repeated_vertices(Polygon& ring) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

void add_parts(std::vector<Part>& parts, Part part) {
  for (Part& piece : cut_where_rings_touch(std::move(part))) parts.push_back(std::move(piece));
}

Polygon only_outline(std::vector<Part> parts, const std::string& name) {
  if (parts.size() == 1 && parts[0].holes.empty()) return std::move(parts[0].outline);
  throw InputError(name, parts.size() == 1 ? "the polygon has a hole" : "there are several polygons",
                   "one outline is wanted here: leave the rest out, or read the file as parts, as scenes do");
}

std::vector<Part> parse_wkt(const std::string& text, const std::string& name, const ReadLimits& limits) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(name, "the file is empty", "write POLYGON ((x y, x y, x y, ...))");
  }
  return WktReader(text, name, limits).read();
}

}  // namespace taut::internal::io

namespace taut {
using namespace internal;

std::vector<Part> read_wkt_parts(const std::string& path, const ReadLimits& limits) {
  return io::parse_wkt(io::read_text_file(path, limits.max_bytes), path, limits);
}

std::vector<Part> parse_wkt_parts(const std::string& text, const std::string& name, const ReadLimits& limits) {
  io::require_size(text, name, limits.max_bytes);
  return io::parse_wkt(text, name, limits);
}

Polygon read_wkt(const std::string& path, const ReadLimits& limits) {
  return io::only_outline(read_wkt_parts(path, limits), path);
}

Polygon parse_wkt(const std::string& text, const std::string& name, const ReadLimits& limits) {
  return io::only_outline(parse_wkt_parts(text, name, limits), name);
}

}  // namespace taut
