#include "geometry/cell.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "geometry/vector.hpp"

namespace taut::internal::curve {
namespace {

double length(Vector v) { return std::sqrt(v.x * v.x + v.y * v.y); }
Vector unit(Vector v) {
  const double l = length(v);
  return l > 0 ? Vector{v.x / l, v.y / l} : v;
}

/// b - a, rounded once.
Vector between(const WidePoint& a, const WidePoint& b) {
  const Point d = (b - a).rounded();
  return {d.x, d.y};
}

double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }

/// Walls for one piece. Which control points become corners of which wall, and by how much they are moved off the
/// curve, is guessed in doubles; whether it will do is for the proof.
class WallBuilder {
 public:
  explicit WallBuilder(const Piece& piece) : piece_(piece), chord_(unit(between(piece.first(), piece.last()))) {
    for (int k = 1; k + 1 < piece.size; ++k) {
      away_[at(k)] = cross(chord_, between(piece.first(), piece.control[at(k)]));
      thickness_ = std::max(thickness_, std::fabs(away_[at(k)]));
    }
  }

  /// How far the control points are from the chord.
  double thickness() const { return thickness_; }

  bool has_near_chord(double distance) const {
    for (int k = 1; k + 1 < piece_.size; ++k) {
      if (std::fabs(away_[at(k)]) < distance) return true;
    }
    return false;
  }

  /// The wall on one side (+1 left, -1 right) through these inner control points. Corners are moved outwards by
  /// `shift`, those on a level tangent along it.
  std::vector<Point> wall(const std::vector<int>& corners, int side, double shift) const {
    std::vector<Point> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const int before = i == 0 ? 0 : corners[i - 1];
      const int after = i + 1 == corners.size() ? piece_.size - 1 : corners[i + 1];
      points.push_back(moved(corners[i], before, after, side, shift));
    }
    return points;
  }

  /// Inner control points farther than this to that side of the chord.
  std::vector<int> on_side(int side, double least) const {
    std::vector<int> points;
    for (int k = 1; k + 1 < piece_.size; ++k) {
      const bool repeated = (k == 1 && piece_.still[0]) || (k + 2 == piece_.size && piece_.still[1]);
      if (side * away_[at(k)] > least && !repeated) points.push_back(k);
    }
    return points;
  }

 private:
  Point moved(int k, int before, int after, int side, double shift) const {
    const WidePoint& c = piece_.control[at(k)];
    const Vector e = unit(between(piece_.control[at(before)], c)), f = unit(between(c, piece_.control[at(after)]));
    const bool along_e = before == 0 && k == 1 && piece_.level[0] != Level::unknown;
    const bool along_f = after == piece_.size - 1 && k == piece_.size - 2 && piece_.level[1] != Level::unknown;
    const double second = std::max(std::fabs(cross(e, f)), 0x1p-40);
    Vector away{0, 0};
    if (along_e && along_f) return c.rounded();
    if (along_e) {
      away = {e.x * shift / second, e.y * shift / second};
    } else if (along_f) {
      away = {-f.x * shift / second, -f.y * shift / second};
    } else {
      // Both edges move outwards by `shift`.
      const Vector outwards{side * -(e.y + f.y), side * (e.x + f.x)};
      const double factor = shift / std::max(1 + dot(e, f), 0x1p-10);
      away = {outwards.x * factor, outwards.y * factor};
    }
    const Point p = c.rounded();
    Point to{p.x + away.x, p.y + away.y};
    const Level level = along_e ? piece_.level[0] : along_f ? piece_.level[1] : Level::unknown;
    if (level == Level::horizontal) to.y = p.y;
    if (level == Level::vertical) to.x = p.x;
    return to;
  }

  const Piece& piece_;
  Vector chord_;
  std::array<double, 4> away_{};
  double thickness_ = 0;
};

/// Subsets of a wall's corners: all of them, then each one alone.
std::vector<std::vector<int>> choices(const std::vector<int>& corners) {
  std::vector<std::vector<int>> all{corners};
  if (corners.size() == 2) {
    all.push_back({corners[0]});
    all.push_back({corners[1]});
  }
  return all;
}

/// How far the walls are apart, measured across the chord, with room for the roundings.
double thickness_of(const Cell& cell, const Gate& first, const Gate& last) {
  const Vector chord = unit(between(cell.piece.first(), cell.piece.last()));
  const Point origin = cell.piece.first().rounded();
  double least = 0, most = 0;
  for (const Point& p : corners_of(cell, first, last)) {
    const double away = cross(chord, {p.x - origin.x, p.y - origin.y});
    least = std::min(least, away);
    most = std::max(most, away);
  }
  const double size = std::max(std::fabs(origin.x), std::fabs(origin.y));
  return (most - least) * (1 + 0x1p-40) + size * 0x1p-48;
}

bool within(const std::vector<Point>& cell, const Point& p) {
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (orientation(cell[i], cell[(i + 1) % cell.size()], p) < 0) return false;
  }
  return true;
}

/// What a cell is made of, and where it must be.
struct Site {
  const Gate& first;
  const Gate& last;
  const Resolution& resolution;
  const std::vector<Point>* outside = nullptr;  ///< a convex polygon that it has to stay within, if any

  bool holds(const Cell& cell) const {
    if (!outside) return true;
    const std::vector<Point> points = corners_of(cell, first, last);
    return std::all_of(points.begin(), points.end(), [&](const Point& p) { return within(*outside, p); });
  }
};

/// A cell with corners moved by `shift`, those control points being corners that are farther than `least` to their
/// side.
std::optional<Cell> attempt_with(const WallBuilder& builder, const Piece& piece, const Site& site, double least,
                                 double shift) {
  for (const auto& left : choices(builder.on_side(1, least))) {
    for (const auto& right : choices(builder.on_side(-1, least))) {
      Cell cell{piece, builder.wall(left, 1, shift), builder.wall(right, -1, shift), 0, false};
      if (!verified(cell, site.first, site.last) || !site.holds(cell)) continue;
      cell.thickness = thickness_of(cell, site.first, site.last);
      return cell;
    }
  }
  return std::nullopt;
}

/// Shifts and corners until one makes a cell.
std::optional<Cell> attempt(const Piece& piece, const Site& site, double least) {
  const WallBuilder builder(piece);
  // Different from segment to segment, so that neighbours that mirror each other are moved differently. Halving nearly
  // always divides the thickness by four, so that halves find room in their cell.
  const double share = 0x1p-8 * (1 + 0x1p-6 * (piece.segment % 7));
  const double usual = std::max(builder.thickness() * share, site.resolution.size * 0x1p-51);
  // A control point on the chord, or nearly, is a corner of both walls: halves of the cell need room around it.
  if (builder.has_near_chord(usual / 2)) {
    if (auto cell = attempt_with(builder, piece, site, -usual / 2, usual)) return cell;
  }
  for (const double times : {1.0, 0.25, 0x1p-4, 0x1p-6, 3.0, 9.0}) {
    if (auto cell = attempt_with(builder, piece, site, least, usual * times)) return cell;
  }
  return attempt_with(builder, piece, site, least, site.resolution.size * 0x1p-51);
}

std::optional<Cell> cell_at(const Piece& piece, const Site& site) {
  if (piece.is_line()) return Cell{piece, {}, {}, 0, true};
  // Between two gates there is room for control points that are nearly on the chord.
  if (!site.first.exact && !site.last.exact) {
    if (auto cell = attempt(piece, site, site.resolution.gate() / 2)) return cell;
  }
  return attempt(piece, site, 0);
}

}  // namespace

Gate gate_at_end(const Piece& piece, const Resolution& resolution) {
  if (piece.last().is_exact()) {
    const Point p = piece.last().rounded();
    return {p, p, true};
  }
  const int before = piece.still[1] ? piece.size - 3 : piece.size - 2;
  const Vector along = unit(between(piece.control[at(before)], piece.last()));
  const Point p = piece.last().rounded();
  const double x = -along.y * resolution.gate(), y = along.x * resolution.gate();
  return {{p.x + x, p.y + y}, {p.x - x, p.y - y}, false};
}

std::vector<Point> corners_of(const Cell& cell, const Gate& first, const Gate& last) {
  std::vector<Point> points{first.right};
  points.insert(points.end(), cell.right.begin(), cell.right.end());
  points.push_back(last.right);
  if (cell.is_line()) return points;
  if (!last.exact) points.push_back(last.left);
  points.insert(points.end(), cell.left.rbegin(), cell.left.rend());
  if (!first.exact) points.push_back(first.left);
  return points;
}

std::optional<Cell> make_cell(const Piece& piece, const Gate& first, const Gate& last, const Resolution& resolution) {
  return cell_at(piece, {first, last, resolution});
}

std::optional<Split> split(const Cell& cell, const Gate& first, const Gate& last, const Resolution& resolution) {
  if (cell.is_final) return std::nullopt;
  const std::array<Piece, 2> half = halves(cell.piece);
  const Gate gate = gate_at_end(half[0], resolution);
  const std::vector<Point> outside = corners_of(cell, first, last);
  auto before = cell_at(half[0], {first, gate, resolution, &outside});
  if (!before) return std::nullopt;
  auto after = cell_at(half[1], {gate, last, resolution, &outside});
  if (!after) return std::nullopt;
  return Split{std::move(*before), std::move(*after), gate};
}

namespace {

/// Is p certainly not to the right of the line from a to b? Where a tangent is level, control points lie on the line
/// itself, which only their coordinates show.
bool not_right_of(const Point& a, const Point& b, const WidePoint& p) {
  if (p.is_exact()) return orientation(a, b, p.rounded()) >= 0;
  if (a.y == b.y) return b.x > a.x ? p.y.lower() >= a.y : p.y.upper() <= a.y;
  if (a.x == b.x) return b.y > a.y ? p.x.upper() <= a.x : p.x.lower() >= a.x;
  return turn(WidePoint::of(a), WidePoint::of(b), p) > 0;
}

bool strictly_convex(const std::vector<Point>& ring) {
  const std::size_t n = ring.size();
  if (n < 3) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (orientation(ring[i], ring[(i + 1) % n], ring[(i + 2) % n]) <= 0) return false;
  }
  // All turns are to the left; that they are one turn together shows at any vertex.
  for (std::size_t i = 2; i + 1 < n; ++i) {
    if (orientation(ring[0], ring[i], ring[i + 1]) <= 0) return false;
  }
  return true;
}

bool holds_control_points(const Cell& cell, const std::vector<Point>& wall) {
  for (std::size_t i = 0; i + 1 < wall.size(); ++i) {
    for (int k = 0; k < cell.piece.size; ++k) {
      if (!not_right_of(wall[i], wall[i + 1], cell.piece.control[static_cast<std::size_t>(k)])) return false;
    }
  }
  return true;
}

/// Are all of them strictly to the left of the lines from a to p and from p to b?
bool beyond_second(const Point& a, const WidePoint& p, const Point& b, const std::vector<WidePoint>& points) {
  const WidePoint from = WidePoint::of(a), to = WidePoint::of(b);
  return std::all_of(points.begin(), points.end(),
                     [&](const WidePoint& q) { return turn(from, p, q) > 0 && turn(p, to, q) > 0; });
}

/// C3. Gates that are points need none of it: the piece begins in a corner of a convex polygon.
bool beyond_gates(const Cell& cell, const Gate& first, const Gate& last) {
  const Piece& piece = cell.piece;
  const auto begin = piece.control.begin(), end = begin + piece.size;
  if (!first.exact) {
    std::vector<WidePoint> ahead(begin + 1, end);
    ahead.push_back(WidePoint::of(last.left));
    ahead.push_back(WidePoint::of(last.right));
    if (!beyond_second(first.left, piece.first(), first.right, ahead)) return false;
  }
  if (!last.exact) {
    std::vector<WidePoint> behind(begin, end - 1);
    behind.push_back(WidePoint::of(first.left));
    behind.push_back(WidePoint::of(first.right));
    if (!beyond_second(last.right, piece.last(), last.left, behind)) return false;
  }
  return true;
}

/// C4, for the direction of the chord. Segments of Bezier curves shall turn by less than a quarter from each other,
/// which implies it, and which halves inherit: so whatever has a cell can be halved.
bool runs_ahead(const Piece& piece) {
  std::vector<WidePoint> segments;
  for (int k = 0; k + 1 < piece.size; ++k) {
    if ((k == 0 && piece.still[0]) || (k + 2 == piece.size && piece.still[1])) continue;
    segments.push_back(piece.control[static_cast<std::size_t>(k + 1)] - piece.control[static_cast<std::size_t>(k)]);
  }
  const WidePoint chord = piece.last() - piece.first();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (dot(segments[i], chord).sign() <= 0) return false;
    for (std::size_t j = 0; j < i && !piece.frame; ++j) {
      if (dot(segments[i], segments[j]).sign() <= 0) return false;
    }
  }
  return true;
}

std::vector<Point> wall_of(const Point& from, const std::vector<Point>& corners, const Point& to) {
  std::vector<Point> wall{from};
  wall.insert(wall.end(), corners.begin(), corners.end());
  wall.push_back(to);
  return wall;
}

}  // namespace

bool verified(const Cell& cell, const Gate& first, const Gate& last) {
  if (!runs_ahead(cell.piece) || !strictly_convex(corners_of(cell, first, last))) return false;
  const std::vector<Point> right = wall_of(first.right, cell.right, last.right);
  std::vector<Point> left = wall_of(first.left, cell.left, last.left);
  std::reverse(left.begin(), left.end());
  return holds_control_points(cell, right) && holds_control_points(cell, left) && beyond_gates(cell, first, last);
}

}  // namespace taut::internal::curve
