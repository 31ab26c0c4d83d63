#include "import/svg_path.hpp"

#include <cctype>
#include <cmath>
#include <cstring>

#include "import/svg_values.hpp"
#include "io/text_file.hpp"
#include "taut/error.hpp"

namespace taut::drawing {

namespace {

class PathReader {
 public:
  PathReader(const std::string& data, const std::string& place, const Affine& where, Flattener& flattener)
      : data_(data), place_(place), scanner_(data), where_(where), flattener_(flattener) {}

  std::vector<Chain> read() {
    char command = 0;
    while (!scanner_.at_end()) {
      const char letter = scanner_.letter();
      if (letter != 0 && !std::strchr("MmLlHhVvCcSsQqTtAaZz", letter)) fail("a command that SVG does not have");
      if (letter == 0 && (command == 0 || command == 'Z' || command == 'z')) fail("expected a command");
      if (command == 0 && letter != 'M' && letter != 'm') fail("a path begins with M or m");
      if (letter != 0) command = letter;
      step(command);
      // Further pairs after a move are lines.
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    return std::move(chains_);
  }

 private:
  void step(char command) {
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    base_ = kind == command ? Point{} : at_;
    if (kind == 'Z') return close();
    if (kind == 'M') return move(point());
    if (kind == 'L') line(point());
    if (kind == 'H') line({number() + base_.x, at_.y});
    if (kind == 'V') line({at_.x, number() + base_.y});
    if (kind == 'C' || kind == 'S') {
      const Point a = kind == 'C' ? point() : mirrored('C'), b = point();
      curve({a, b}, point());
    }
    if (kind == 'Q' || kind == 'T') {
      const Point a = kind == 'Q' ? point() : mirrored('Q');
      curve({a}, point());
    }
    if (kind == 'A') arc();
    last_ = kind == 'S' ? 'C' : kind == 'T' ? 'Q' : kind;
  }

  void move(const Point& p) {
    start_ = at_ = p;
    open_ = false;
    last_ = 'M';
  }

  void close() {
    if (open_) chains_.back().closed = true;
    at_ = start_;
    open_ = false;
    last_ = 'Z';
  }

  /// The points of the present subpath, which begins where the pen is.
  std::vector<Point>& points() {
    if (!open_) chains_.push_back({{where_(at_)}, false, place_});
    open_ = true;
    return chains_.back().points;
  }

  void line(const Point& to) {
    points().push_back(where_(to));
    at_ = to;
  }

  void curve(const std::vector<Point>& inner, const Point& to) {
    std::vector<ControlPoint> control;
    const auto add = [&](const Point& p) {
      const Point placed = where_(p);
      control.push_back({placed.x, placed.y, 1});
    };
    add(at_);
    for (const Point& p : inner) add(p);
    add(to);
    flattener_.bezier(points(), control);
    control_ = inner.back();
    at_ = to;
  }

  /// The last curve's control point, on the other side of its end.
  Point mirrored(char kind) const {
    if (last_ != kind) return at_;
    return {2 * at_.x - control_.x, 2 * at_.y - control_.y};
  }

  /// As section B.2.4 of SVG 2 has it.
  void arc() {
    double rx = std::fabs(number()), ry = std::fabs(number());
    const Affine turn = rotation(number());
    const bool large = flag(), sweep = flag();
    const Point to = point();
    if (to == at_) return;
    if (rx == 0 || ry == 0) return line(to);
    // In the frame of the axes, half the way from the end to the start.
    const Point half{(at_.x - to.x) / 2, (at_.y - to.y) / 2};
    const double x = turn.a * half.x + turn.b * half.y, y = turn.c * half.x + turn.d * half.y;
    const double reach = std::hypot(x / rx, y / ry);
    if (reach > 1) {
      rx *= reach;
      ry *= reach;
    }
    const double left = std::max(0.0, 1 / (std::min(reach, 1.0) * std::min(reach, 1.0)) - 1);
    const double factor = (large == sweep ? -1 : 1) * (reach < 1 ? std::sqrt(left) : 0);
    const double cx = factor * rx * y / ry, cy = -factor * ry * x / rx;
    const Point shift = turn.turn({cx, cy});
    const Point centre{shift.x + (at_.x + to.x) / 2, shift.y + (at_.y + to.y) / 2};
    const double from = std::atan2((y - cy) / ry, (x - cx) / rx);
    double angle = std::atan2((-y - cy) / ry, (-x - cx) / rx) - from;
    constexpr double full_angle = 2 * 3.14159265358979323846;
    if (sweep && angle < 0) angle += full_angle;
    if (!sweep && angle > 0) angle -= full_angle;
    flattener_.arc(points(), where_(centre), where_.turn(turn.turn({rx, 0})), where_.turn(turn.turn({0, ry})), from,
                   angle, where_(to));
    at_ = to;
  }

  double number() {
    const auto value = scanner_.number();
    if (!value) fail("expected a number");
    return *value;
  }

  bool flag() {
    const auto value = scanner_.flag();
    if (!value) fail("expected a flag of an arc, 0 or 1");
    return *value;
  }

  Point point() {
    const double x = number(), y = number();
    return {base_.x + x, base_.y + y};
  }

  [[noreturn]] void fail(const std::string& problem) const {
    const std::size_t here = scanner_.position();
    throw InputError(place_,
                     "the path's data cannot be read: " + problem + " at character " + std::to_string(here + 1) +
                         ", before \"" + io::excerpt(data_.substr(here), 20) + "\"",
                     "write M, L, H, V, C, S, Q, T, A and Z with their numbers, or save the drawing again");
  }

  const std::string& data_;
  const std::string& place_;
  NumberScanner scanner_;
  Affine where_;
  Flattener& flattener_;
  std::vector<Chain> chains_;
  Point at_, start_, control_, base_;
  char last_ = 0;
  bool open_ = false;  ///< is there a subpath that what comes next continues?
};

}  // namespace

std::vector<Chain> read_path(const XmlElement& element, const Affine& where, Flattener& flattener) {
  const std::string* data = element.find("d");
  if (!data) return {};
  return PathReader(*data, element.place, where, flattener).read();
}

}  // namespace taut::drawing
