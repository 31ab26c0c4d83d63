#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "generators/generators.hpp"
#include "generators/shapes.hpp"

namespace taut::gen {

namespace {

constexpr double corridor_half_width = 0.5;  ///< of the corridor
constexpr double spacing = 1.2;              ///< between passes: the walls are 0.2 thick

/// The corridor's middle line: in from below, up, over, down, over, up, ...
std::vector<Point> middle_line(const MazeOptions& o) {
  Random random(o.seed);
  std::vector<Point> line{{0, 0}};
  for (int i = 0; i < o.passes; ++i) {
    const double shift = o.seed == 0 ? 0 : random.uniform(0, 1.5);
    const double y = i % 2 == 0 ? 8 + shift : 2 - shift;
    line.push_back({spacing * i, y});
    if (i + 1 < o.passes) line.push_back({spacing * (i + 1), y});
  }
  return line;
}

Point direction(const Point& from, const Point& to) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  return {dx / length, dy / length};
}

/// The line moved by corridor_half_width to the left (side = 1) or right (side = -1); the ends are moved sideways only,
/// and the last one on to the dead end's wall. All directions are axis-parallel, so the sum of two normals is the
/// corner.
Polygon wall(const std::vector<Point>& line, double side) {
  Polygon points;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point in = direction(line[i == 0 ? 0 : i - 1], line[i == 0 ? 1 : i]);
    const double h = side * corridor_half_width;
    Point p{line[i].x - h * in.y, line[i].y + h * in.x};
    if (i + 1 == line.size()) {
      p = {p.x + corridor_half_width * in.x, p.y + corridor_half_width * in.y};
    } else if (i > 0) {
      const Point out = direction(line[i], line[i + 1]);
      p = {p.x - h * out.y, p.y + h * out.x};
    }
    points.push_back(p);
  }
  return points;
}

/// A box with the corridor cut into it from below.
Polygon walls(const std::vector<Point>& line) {
  double high = 0, right = 0;
  for (const Point& p : line) {
    high = std::max(high, p.y);
    right = std::max(right, p.x);
  }
  const double frame = corridor_half_width + 0.2, bottom = -0.7;
  Polygon left = wall(line, 1);
  left.front().y = bottom;
  // The mouth is in the box's lower side: in along the left wall, out along the right one.
  Polygon result{{right + frame, bottom}, {right + frame, high + frame}, {-frame, high + frame}, {-frame, bottom}};
  result.insert(result.end(), left.begin(), left.end());
  const Polygon other = wall(line, -1);
  result.insert(result.end(), other.rbegin(), other.rend());
  result.back().y = bottom;
  return result;
}

/// A slim hull with its bow at the right, of half length `length`.
Polygon ship(int points, double length) {
  Polygon polygon;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * pi * i / points;
    polygon.push_back({length * std::cos(angle), 0.45 * length * std::sin(angle) * (1 - 0.3 * std::cos(angle))});
  }
  return polygon;
}

class Voyage {
 public:
  explicit Voyage(const Point& start) : here_(start) {}

  /// Straight at unit speed.
  void drive(const Point& to, double heading) {
    const Point d = direction(here_, to);
    MotionPiece piece = translation({here_.x - d.x * time_, d.x}, {here_.y - d.y * time_, d.y});
    piece.rotation = AngleRotation{{heading}};
    add(piece, std::hypot(to.x - here_.x, to.y - here_.y));
    here_ = to;
  }

  /// On the spot, within time 1/2.
  void turn(double from, double to) {
    const double speed = (to - from) / 0.5;
    MotionPiece piece = translation({here_.x}, {here_.y});
    piece.rotation = AngleRotation{{from - speed * time_, speed}};
    add(piece, 0.5);
  }

  double time() const { return time_; }
  const Motion& motion() const { return motion_; }

 private:
  void add(MotionPiece piece, double duration) {
    time_ += duration;
    piece.until = time_;
    motion_.pieces.push_back(std::move(piece));
  }

  Point here_;
  double time_ = 0;
  Motion motion_;
};

}  // namespace

Scene make_maze(const MazeOptions& o) {
  require_range("--passes", o.passes, 1, 100000);
  require_range("--ship-points", o.ship_points, 3, 10000000);
  const std::vector<Point> line = middle_line(o);
  // From outside, below the mouth, to the dead end.
  Voyage voyage({0, -3});
  double heading = pi / 2;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point d = direction(line[i - 1], line[i]);
    const double next = std::atan2(d.y, d.x);
    if (i > 1) voyage.turn(heading, next);
    heading = next;
    voyage.drive(line[i], heading);
  }
  Scene scene;
  scene.end = voyage.time();
  Motion motion = voyage.motion();
  motion.pieces.back().until = std::numeric_limits<double>::infinity();
  scene.bodies = {{"maze", walls(line), {}}, {"ship", ship(o.ship_points, o.hit ? 0.6 : 0.42), motion}};
  return scene;
}

}  // namespace taut::gen
