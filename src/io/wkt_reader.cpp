// Polygons as well-known text (OGC Simple Features).
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/part_rings.hpp"
#include "io/outline_reader.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::internal::io {

namespace {

/// As deep as JSON may be nested.
constexpr int max_nesting = 32;

class WktReader {
 public:
  /// Without `rest`, what is no polygon is refused.
  WktReader(const std::string& text, const std::string& name, const ReadLimits& limits, WktRest* rest)
      : text_(text), name_(name), limits_(limits), rest_(rest) {}

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
      if (position_ == text_.size()) {
        if (parts_.empty() && (!rest_ || rest_->others.empty())) fail_empty();
        return std::move(parts_);
      }
      if (!std::isalpha(static_cast<unsigned char>(text_[position_])))
        fail("unexpected text after the " + std::string(word == "POLYGON" ? "polygon" : "geometry"),
             "write one geometry after the other, each with its own brackets");
    }
  }

 private:
  enum class Kind { polygon, polygons, surface, collection, curved, other, unknown };

  /// "POLYGONZ" is "POLYGON Z". Words that are unknown are not quoted, the file may be any.
  static Kind kind_of(std::string word, std::string* dimensions) {
    static const std::map<std::string, Kind> kinds{
        {"POLYGON", Kind::polygon},       {"TRIANGLE", Kind::polygon},
        {"MULTIPOLYGON", Kind::polygons}, {"POLYHEDRALSURFACE", Kind::surface},
        {"TIN", Kind::surface},           {"GEOMETRYCOLLECTION", Kind::collection},
        {"POINT", Kind::other},           {"MULTIPOINT", Kind::other},
        {"LINESTRING", Kind::other},      {"MULTILINESTRING", Kind::other},
        {"CIRCULARSTRING", Kind::other},  {"COMPOUNDCURVE", Kind::other},
        {"MULTICURVE", Kind::other},      {"CURVEPOLYGON", Kind::curved},
        {"MULTISURFACE", Kind::curved},
    };
    for (const char* end : {"", "ZM", "Z", "M"}) {
      if (!word.ends_with(end)) continue;
      const auto kind = kinds.find(word.substr(0, word.size() - std::string(end).size()));
      if (kind == kinds.end()) continue;
      *dimensions = end;
      return kind->second;
    }
    return Kind::unknown;
  }

  /// What follows its name; `depth` collections are around it. What is empty adds nothing.
  void read_geometry(const std::string& word, int depth) {
    std::string dimensions;
    const Kind kind = kind_of(word, &dimensions);
    if (kind == Kind::unknown)
      fail(std::string("expected POLYGON or MULTIPOLYGON") + (word.empty() ? "" : ", found another word"));
    const std::size_t before = position_;
    const std::size_t start = before - std::min(before, word.size());
    if (depth == max_nesting) fail("collections are nested more than " + std::to_string(max_nesting) + " deep");
    std::string next = read_word();
    if (next == "Z" || next == "M" || next == "ZM") {
      dimensions = next;
      next = read_word();
    }
    if (!next.empty() && next != "EMPTY") fail("expected \"(\" or EMPTY after " + word);
    if (next == "EMPTY") return note_empty();
    if (kind == Kind::other || kind == Kind::curved) {
      if (rest_) return pass_over(word, start, kind == Kind::curved);
      position_ = before;
      fail("expected POLYGON or MULTIPOLYGON, found " + word);
    }
    has_z_ = dimensions != "M";
    height_.reset();
    if (kind == Kind::polygon) return read_polygon(false);
    expect('(', kind == Kind::collection ? "before the first geometry" : "before the first polygon");
    do {
      const std::string inner = read_word();
      if (kind == Kind::collection)
        read_geometry(inner, depth + 1);
      else if (inner == "EMPTY")
        note_empty();
      else
        read_polygon(kind == Kind::surface);
    } while (take(','));
    expect(')', kind == Kind::collection ? "after the geometries" : "after the polygons");
  }

  /// Of a geometry that is no polygon, all that its brackets hold.
  void pass_over(const std::string& word, std::size_t start, bool area) {
    rest_->others.push_back({place_in_text(text_, name_, start), word, area});
    expect('(', "before the coordinates");
    for (int depth = 1; depth > 0; ++position_) {
      if (position_ >= text_.size()) fail("expected \")\" after the coordinates");
      depth += text_[position_] == '(' ? 1 : text_[position_] == ')' ? -1 : 0;
    }
  }

  /// Faces of a surface must be in one plane, above that of the scene.
  void read_polygon(bool flat) {
    expect('(', "before the first ring");
    Part part;
    part.outline = read_ring(flat);
    while (take(',')) part.holes.push_back(read_ring(flat));
    expect(')', "after the ring");
    std::erase_if(part.holes, [](const Polygon& hole) { return hole.empty(); });
    if (part.outline.empty()) return note_empty();
    add_parts(parts_, std::move(part));
  }

  Polygon read_ring(bool flat) {
    Polygon ring;
    if (read_word() == "EMPTY") return ring;
    expect('(', "before the vertices");
    do {
      // One more than the limit, for the repeated vertex.
      if (ring.size() > limits_.max_vertices) fail_size();
      const double x = read_coordinate(), y = read_coordinate();
      ring.push_back({x, y});
      skip_space();
      for (int k = 0; position_ < text_.size() && text_[position_] != ',' && text_[position_] != ')'; ++k) {
        const double more = read_coordinate();  // Z, M
        if (rest_ && more != 0) rest_->heights = true;
        if (flat && has_z_ && k == 0 && height_.value_or(more) != more)
          fail("the surface is not flat: its z coordinates differ", "project it into the plane of the scene");
        if (k == 0) height_ = more;
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

  void note_empty() { empty_at_ = position_; }

  [[noreturn]] void fail_empty() {
    position_ = empty_at_;
    fail("the polygon is empty");
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
  WktRest* rest_;
  std::size_t position_ = 0, empty_at_ = 0;
  bool has_z_ = true;             ///< is the third coordinate z, and not m?
  std::optional<double> height_;  ///< z of the surface that is read
  std::vector<Part> parts_;
};

std::vector<Part> read_all_wkt(std::string text, const std::string& name, const ReadLimits& limits, WktRest* rest) {
  drop_byte_order_mark(text);
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw InputError(name, "the file is empty", "write POLYGON ((x y, x y, x y, ...))");
  }
  return WktReader(text, name, limits, rest).read();
}

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

std::vector<Part> parse_wkt(std::string text, const std::string& name, const ReadLimits& limits) {
  return read_all_wkt(std::move(text), name, limits, nullptr);
}

std::vector<Part> parse_wkt_polygons(std::string text, const std::string& name, const ReadLimits& limits,
                                     WktRest& rest) {
  return read_all_wkt(std::move(text), name, limits, &rest);
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
