// Keyframes as CSV: a header that names the columns, then a keyframe a line.
#include <algorithm>
#include <cmath>

#include "io/json_object.hpp"
#include "io/motion_reader.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "scene/names.hpp"
#include "taut/error.hpp"

namespace taut::internal::io {

namespace {

const char* const csv_shape = "write the header t,x,y,angle_deg, then a line of numbers for each keyframe";

struct KnownColumn {
  const char* name;
  double Keyframe::*member;
};
constexpr KnownColumn known_columns[] = {
    {"t", &Keyframe::t}, {"x", &Keyframe::x}, {"y", &Keyframe::y}, {"angle_deg", &Keyframe::angle_deg}};

class CsvReader {
 public:
  CsvReader(const std::string& text, const std::string& name, const ReadLimits& limits)
      : text_(text), name_(name), limits_(limits) {}

  std::vector<Keyframe> read() {
    if (text_.compare(0, 3, "\xEF\xBB\xBF") == 0) position_ = 3;
    skip_blank_lines();
    read_header();
    std::vector<Keyframe> keyframes;
    for (skip_blank_lines(); position_ < text_.size(); skip_blank_lines()) {
      if (keyframes.size() == limits_.max_pieces)
        fail("more keyframes than the limit of " + std::to_string(limits_.max_pieces),
             "split the scene in time, or raise ReadLimits::max_pieces");
      const std::size_t line = position_;
      keyframes.push_back(read_line());
      const std::size_t n = keyframes.size();
      if (n > 1 && !(keyframes[n - 2].t < keyframes[n - 1].t)) {
        position_ = line;
        fail("the time is not later than that of the line before", "order the lines by time; no two may be the same");
      }
    }
    if (keyframes.empty()) fail("there are no keyframes", csv_shape);
    return keyframes;
  }

 private:
  void read_header() {
    do {
      skip_space();
      const std::size_t begin = position_;
      position_ = std::min(text_.find_first_of(", \t\r\n", position_), text_.size());
      add_column(text_.substr(begin, position_ - begin), begin);
      skip_space();
    } while (take_comma());
    end_line();
    if (std::find(columns_.begin(), columns_.end(), &Keyframe::t) == columns_.end()) {
      position_ = 0;
      fail("the header has no column \"t\"", csv_shape);
    }
  }

  void add_column(const std::string& name, std::size_t begin) {
    const auto* column = std::find_if(std::begin(known_columns), std::end(known_columns),
                                      [&name](const KnownColumn& c) { return c.name == name; });
    const bool known = column != std::end(known_columns);
    if (known && std::find(columns_.begin(), columns_.end(), column->member) == columns_.end()) {
      columns_.push_back(column->member);
      return;
    }
    position_ = begin;
    if (name.find(';') != std::string::npos) fail_semicolons();
    if (known) fail("the column \"" + name + "\" appears twice", "keep one of the two");
    const std::string near = nearest_word(name, {"angle_deg"});
    // It is not quoted: the file may be any.
    fail("unknown column in the header",
         (near.empty() ? "" : "did you mean \"" + near + "\"? ") + std::string(csv_shape));
  }

  Keyframe read_line() {
    Keyframe keyframe;
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      if (k > 0 && !take_comma()) {
        if (position_ < text_.size() && text_[position_] == ';') fail_semicolons();
        fail("expected " + std::to_string(columns_.size()) + " numbers as in the header, found " + std::to_string(k),
             "separate the numbers by commas");
      }
      keyframe.*columns_[k] = read_field();
      skip_space();
    }
    if (position_ < text_.size() && text_[position_] == ',')
      fail("more numbers than columns in the header", "write one number for each column");
    end_line();
    return keyframe;
  }

  /// As spreadsheets write where the comma is the sign of decimals.
  [[noreturn]] void fail_semicolons() const {
    fail("the columns are separated by semicolons",
         "separate them by commas, and write decimals with a point: t,x,y (spreadsheets have this in the settings of "
         "their export as CSV)");
  }

  double read_field() {
    skip_space();
    const std::size_t begin = position_;
    const auto number = scan_number(text_, &position_);
    if (!number) fail("expected a number", "write decimal numbers with a point, separated by commas");
    if (std::isfinite(*number)) return *number;
    position_ = begin;
    fail("the number is too large", "numbers must fit a 64-bit floating-point number (about 1.8e308 at most)");
  }

  void skip_space() { position_ = std::min(text_.find_first_not_of(" \t", position_), text_.size()); }
  void skip_blank_lines() { position_ = std::min(text_.find_first_not_of(" \t\r\n", position_), text_.size()); }

  bool take_comma() {
    if (position_ >= text_.size() || text_[position_] != ',') return false;
    ++position_;
    return true;
  }

  void end_line() {
    if (position_ < text_.size() && text_[position_] != '\r' && text_[position_] != '\n')
      fail("unexpected text", "separate the numbers by commas");
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& hint) const {
    throw InputError(place_in_text(text_, name_, position_), problem, hint);
  }

  const std::string& text_;
  std::string name_;
  const ReadLimits& limits_;
  std::size_t position_ = 0;
  std::vector<double Keyframe::*> columns_;
};

}  // namespace

std::vector<Keyframe> parse_keyframes_csv(const std::string& text, const std::string& name, const ReadLimits& limits) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw InputError(name, "the file is empty", csv_shape);
  return CsvReader(text, name, limits).read();
}

}  // namespace taut::internal::io

namespace taut {
using namespace internal;

std::vector<Keyframe> read_keyframes_csv(const std::string& path, const ReadLimits& limits) {
  return io::parse_keyframes_csv(io::read_text_file(path, limits.max_bytes), path, limits);
}

}  // namespace taut
