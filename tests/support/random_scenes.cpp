#include "support/random_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace taut::testing {

namespace {

constexpr int quarter_cos[] = {1, 0, -1, 0}, quarter_sin[] = {0, 1, 0, -1};

struct Track {
  Coefficients x, y;
};

Track straight_way(const Point& d, double reach) { return {{0, d.x * reach}, {0, d.y * reach}}; }

Track polynomial_way(Rng& rng, const Point& d, double reach) {
  const int degree = rng.between(2, 5);
  Track w{Coefficients(degree + 1, 0.0), Coefficients(degree + 1, 0.0)};
  const bool there_and_back = rng.chance(0.4);
  if (there_and_back) w = {{0, 4 * d.x * reach, -4 * d.x * reach}, {0, 4 * d.y * reach, -4 * d.y * reach}};
  w.x.resize(degree + 1);
  w.y.resize(degree + 1);
  const double wild = there_and_back ? 0.1 : 1;
  for (int k = 1; k <= degree; ++k) {
    const Point u = unit_vector(rng.unit());
    const double r = wild * reach * rng.unit();
    w.x[k] += r * u.x + (there_and_back || k > 1 ? 0 : d.x * reach);
    w.y[k] += r * u.y + (there_and_back || k > 1 ? 0 : d.y * reach);
  }
  return w;
}

AngleRotation random_angle(Rng& rng, double turn) {
  AngleRotation r{{0, turn}};
  for (int k = rng.below(3); k > 0; --k) r.angle.push_back(turn * rng.real(-1, 1));
  return r;
}

/// (A, B) in the frame of the start, where it is (1, 0): A >= 1/2 or B > 0 throughout.
DirectionRotation random_direction(Rng& rng, double turn, int quarter) {
  Coefficients a, b;
  if (rng.chance(0.6)) {
    a = {1, rng.real(-0.25, 0.25), rng.real(-0.25, 0.25)};
    b = {0, turn, rng.chance(0.5) ? turn * rng.real(-1, 1) : 0};
  } else {  // half a turn
    const double w = std::copysign(rng.real(0.3, 3), turn);
    a = {1, -2, 0};
    b = {0, w, rng.real(-0.7, 0.7) * w};
  }
  const double c = quarter_cos[quarter], s = quarter_sin[quarter];
  DirectionRotation r;
  for (std::size_t k = 0; k < a.size(); ++k) {
    r.a.push_back(c * a[k] - s * b[k]);
    r.b.push_back(s * a[k] + c * b[k]);
  }
  return r;
}

HalfAngleRotation random_half_angle(Rng& rng, double turn, int quarter) {
  HalfAngleRotation r{{quarter_sin[quarter] + 0.0, turn / 2}};
  for (int k = rng.below(3); k > 0; --k) r.s.push_back(turn * rng.real(-0.5, 0.5));
  return r;
}

CosineRotation random_cosine(Rng& rng, double turn, int quarter) {
  const double size = std::min(1.9, turn * turn / 2 + 1e-4);
  if (quarter == 1) {
    const double c = std::copysign(std::min(0.9, std::fabs(turn)), turn) * rng.real(0.3, 1);
    return {{0, c, (0.95 - std::fabs(c)) * rng.real(-1, 1) * std::min(1.0, std::fabs(turn))}};
  }
  const double from = quarter_cos[quarter];
  if (rng.chance(0.2)) return {{from, -from * size}};  // begins with infinite angular velocity
  return {{from, 0, -from * size}};
}

MotionKind random_rotation_kind(Rng& rng) {
  return rng.pick(
      std::vector<MotionKind>{MotionKind::angle, MotionKind::direction, MotionKind::half_angle, MotionKind::cosine});
}

Rotation random_rotation(Rng& rng, MotionKind kind, double turn, int quarter) {
  switch (kind) {
    case MotionKind::angle:
      return random_angle(rng, turn);
    case MotionKind::direction:
      return random_direction(rng, turn, quarter);
    case MotionKind::half_angle:
      return random_half_angle(rng, turn, quarter);
    case MotionKind::cosine:
      return random_cosine(rng, turn, quarter);
    default:
      return NoRotation{};
  }
}

double multiple_of(double step, double x) { return step * std::floor(x / step + 0.5); }

/// p + d (t - s) + e (t - s)^2 in ascending powers of t. Exact for the numbers used here.
Coefficients expanded(double p, double d, double e, double s) { return {p - d * s + e * s * s, d - 2 * e * s, e}; }

/// A quantity that runs on from piece to piece, in numbers so short that nothing rounds.
struct Runner {
  double value, step;

  Coefficients advance(double slope, double second, double from, double until) {
    const double d = multiple_of(step, slope), e = multiple_of(step, second), h = until - from;
    const Coefficients c = expanded(value, d, e, from);
    value += d * h + e * h * h;
    return c;
  }
};

Motion random_pieces(Rng& rng, const Drive& drive, const Point& d) {
  Motion motion;
  Runner x{drive.pivot.x, 64}, y{drive.pivot.y, 64}, angle{0, 0x1p-10};
  const int function = rng.below(3);  // none, angle, half angle
  double from = 0;
  while (from < 1) {
    const double until = std::min(1.0, from + rng.between(1, 4) / 8.0);
    const Point u = rng.chance(0.5) ? d : unit_vector(rng.unit());
    const double speed = drive.reach * rng.real(0, 2), second = rng.chance(0.4) ? drive.reach * rng.real(-2, 2) : 0;
    MotionPiece piece;
    piece.x = x.advance(u.x * speed, u.y * second, from, until);
    piece.y = y.advance(u.y * speed, -u.x * second, from, until);
    const double turn = drive.turn * rng.real(-1, 1.5);
    if (function == 1) piece.rotation = AngleRotation{angle.advance(turn, 0, from, until)};
    if (function == 2) piece.rotation = HalfAngleRotation{angle.advance(turn / 2, 0, from, until)};
    if (until < 1) piece.until = until;
    motion.pieces.push_back(std::move(piece));
    from = until;
  }
  return motion;
}

Point centre(const Polygon& polygon) {
  Point c;
  for (const Point& p : polygon) c = {c.x + p.x, c.y + p.y};
  const double n = static_cast<double>(polygon.size());
  return {std::floor(c.x / n), std::floor(c.y / n)};
}

double extent(const Polygon& polygon) {
  double r = 0;
  for (const Point& a : polygon)
    for (const Point& b : polygon) r = std::max({r, std::fabs(a.x - b.x), std::fabs(a.y - b.y)});
  return r;
}

Point random_heading(Rng& rng, Family family, const Point& from, const Point& to, bool grid) {
  const Point axis = unit_vector(0.25 * rng.below(4));
  if (grid && rng.chance(0.6)) return axis;
  if (family == Family::combs && rng.chance(0.6)) return {0, double(rng.sign())};
  if (family == Family::corridor && rng.chance(0.6)) return {-1, 0};
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
  if (length > 0 && rng.chance(0.6)) return {dx / length, dy / length};
  return unit_vector(rng.unit());
}

Drive random_drive(Rng& rng, Family family, const Polygon& own, const Polygon& other, const SceneOptions& options) {
  Drive drive;
  drive.kind = options.kinds.empty() ? all_motions[1 + rng.below(8)] : rng.pick(options.kinds);
  const double small = std::min(extent(own), extent(other)), large = std::max(extent(own), extent(other));
  drive.reach = (rng.chance(0.5) ? small : large) * std::exp2(rng.real(-4, 2));
  if (options.grid && rng.chance(0.6)) drive.reach = 500 * std::ceil(drive.reach / 500);
  drive.turn = rng.sign() * std::exp2(rng.real(-6, 2));
  const Point c = centre(own), o = centre(other);
  drive.heading = random_heading(rng, family, c, o, options.grid);
  const bool beside = family == Family::apart || family == Family::stars || family == Family::convex;
  if (beside && rng.chance(0.6))
    drive.reach = std::sqrt((o.x - c.x) * (o.x - c.x) + (o.y - c.y) * (o.y - c.y)) * std::exp2(rng.real(-2, 1));
  drive.pivot = c;
  if (drive.kind == MotionKind::orbit) {
    drive.pivot = family == Family::spirals ? Point{0, 0} : o;
  } else if (rng.chance(0.6)) {
    const int r = static_cast<int>(extent(own) / 2) + 1;
    drive.pivot = {c.x + rng.between(-r, r), c.y + rng.between(-r, r)};
  }
  drive.quarter_turns = rng.pick(start_turns(drive.kind));
  return drive;
}

}  // namespace

const char* to_string(MotionKind kind) {
  static constexpr const char* names[] = {"rest",       "linear", "polynomial", "angle", "direction",
                                          "half_angle", "cosine", "orbit",      "pieces"};
  return names[static_cast<int>(kind)];
}

std::vector<int> start_turns(MotionKind kind) {
  switch (kind) {
    case MotionKind::direction:
      return {0, 1, 2, 3};
    case MotionKind::half_angle:
      return {0, 1, 3};
    case MotionKind::cosine:
      return {0, 1, 2};
    default:
      return {0};
  }
}

Motion random_motion(Rng& rng, const Drive& drive) {
  if (drive.kind == MotionKind::rest && drive.pivot == Point{}) return {};
  const Point d = drive.heading == Point{} ? unit_vector(rng.unit()) : drive.heading;
  if (drive.kind == MotionKind::pieces) return random_pieces(rng, drive, d);
  MotionKind function = drive.kind;
  double turn = drive.turn, reach = drive.reach;
  if (function == MotionKind::orbit) {
    function = drive.quarter_turns == 0 ? random_rotation_kind(rng) : MotionKind::direction;
    if (function == MotionKind::angle && rng.chance(0.5)) turn *= 4;
    reach *= rng.pick(std::vector<double>{0, 0.1});
  } else if (function >= MotionKind::angle) {
    reach *= rng.pick(std::vector<double>{0, 0.3, 1});
  }
  Track way;
  if (function == MotionKind::rest) {
    way = {{0}, {0}};
  } else if (function == MotionKind::linear || (function >= MotionKind::angle && rng.chance(0.5))) {
    way = straight_way(d, reach);
  } else {
    way = polynomial_way(rng, d, reach);
  }
  way.x[0] = drive.pivot.x;
  way.y[0] = drive.pivot.y;
  Motion motion;
  motion.pieces.push_back({way.x, way.y, random_rotation(rng, function, turn, drive.quarter_turns)});
  return motion;
}

Motion random_motion(Rng& rng, double scale, MotionKind kind) {
  Drive drive;
  drive.kind = kind;
  drive.reach = scale;
  drive.turn = rng.sign() * std::exp2(rng.real(-4, 2));
  return random_motion(rng, drive);
}

Body animate(Rng& rng, const char* name, const Polygon& polygon, const Drive& drive) {
  Body body{name, polygon, random_motion(rng, drive)};
  if (body.motion.pieces.empty()) return body;
  const double c = quarter_cos[drive.quarter_turns], s = quarter_sin[drive.quarter_turns];
  for (Point& p : body.polygon) {
    const double x = p.x - drive.pivot.x, y = p.y - drive.pivot.y;
    p = {c * x + s * y, c * y - s * x};
  }
  return body;
}

Scene random_scene(std::uint64_t seed, Family family, const SceneOptions& options) {
  Rng rng(seed * 64 + static_cast<std::uint64_t>(family) * 2 + options.grid);
  PolygonPair pair = random_pair(rng, family, options.grid);
  if (rng.chance(0.1)) std::reverse(pair.p.begin(), pair.p.end());  // either orientation is valid input
  if (rng.chance(0.1)) std::reverse(pair.q.begin(), pair.q.end());
  Scene scene;
  scene.end = 1;
  const bool both = rng.chance(0.4);
  const Drive p = random_drive(rng, family, pair.p, pair.q, options);
  const Drive q = random_drive(rng, family, pair.q, pair.p, options);
  scene.bodies.push_back(both ? animate(rng, "P", pair.p, p) : Body{"P", pair.p, {}});
  scene.bodies.push_back(animate(rng, "Q", pair.q, q));
  if (rng.chance(0.3)) std::swap(scene.bodies[0], scene.bodies[1]);
  return scene;
}

}  // namespace taut::testing
