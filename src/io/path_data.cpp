#include "io/path_data.hpp"

#include <cctype>
#include <cmath>
#include <cstring>

#include "io/number_text.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::internal::io {
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
