// Outlines as well-known text (OGC Simple Features).
#include <cctype>
#include <cmath>

#include "io/number_text.hpp"
#include "io/outline_reader.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut {

namespace io {

namespace {

class WktReader {
 public:
  WktReader(const std::string& text, const std::string& name, const ReadLimits& limits)
      : text_(text), name_(name), limits_(limits) {}

  Polygon read() {
    std::string word = read_word();
    if (word == "SRID") {  // EWKT: "SRID=4326;POLYGON ..."
      const std::size_t semicolon = text_.find(';', position_);
      if (semicolon == std::string::npos) fail("\"SRID\" without a \";\" after it");
      position_ = semicolon + 1;
      word = read_word();
    }
    if (word != "POLYGON") fail("expected POLYGON" + found(word));
    const std::string dimensions = read_word();
    if (dimensions == "EMPTY") fail("the polygon is empty");
    expect('(', "before the first ring");
    Polygon ring = read_ring();
    skip_space();
    if (position_ < text_.size() && text_[position_] == ',')
      fail("the polygon has a hole", "a body is a simple polygon: cut it open along a slit, or leave the hole out");
    expect(')', "after the ring");
    skip_space();
    if (position_ < text_.size()) fail("unexpected text after the polygon", "one polygon per file");
    return ring;
  }

 private:
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
    drop_repeated_last_vertex(ring);
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
    for (const char* known :
         {"POINT", "MULTIPOINT", "LINESTRING", "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION"}) {
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
};

}  // namespace

void drop_repeated_last_vertex(Polygon& ring) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

Polygon parse_wkt(const std::string& text, const std::string& name, const ReadLimits& limits) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(name, "the file is empty", "write POLYGON ((x y, x y, x y, ...))");
  }
  return WktReader(text, name, limits).read();
}

}  // namespace io

Polygon read_wkt(const std::string& path, const ReadLimits& limits) {
  return io::parse_wkt(io::read_text_file(path, limits.max_bytes), path, limits);
}

Polygon parse_wkt(const std::string& text, const std::string& name, const ReadLimits& limits) {
  io::require_size(text, name, limits.max_bytes);
  return io::parse_wkt(text, name, limits);
}

}  // namespace taut
