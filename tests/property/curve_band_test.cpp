// Curves lie between their walls: held against points at random parameters in 200 bits, by MPFR and formulas of its
// own.
#include <gtest/gtest.h>

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "geometry/band.hpp"
#include "geometry/predicates.hpp"
#include "support/effort.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut {
using namespace internal;
namespace {

using curve::BandedPart;
using curve::Cell;
using taut::testing::effort;
using Long =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<61>, boost::multiprecision::et_off>;

struct LongPoint {
  Long x, y;
};

LongPoint mixed(const std::vector<std::pair<Long, Point>>& terms) {
  LongPoint sum{0, 0};
  for (const auto& [weight, p] : terms) {
    sum.x += weight * p.x;
    sum.y += weight * p.y;
  }
  return sum;
}

/// A curve by its parameter, from 0 to 1.
using Formula = std::function<LongPoint(const Long&)>;

/// The ellipse's arc through its centre and angles: the formulas of SVG 2, with its own sine and arc tangent.
Formula arc_formula(const Point& from, const ArcTo& arc) {
  const Long pi = boost::multiprecision::acos(Long(-1)), phi = Long(arc.rotation_deg) * pi / 180;
  const Long c = cos(phi), s = sin(phi), hx = (Long(from.x) - arc.to.x) / 2, hy = (Long(from.y) - arc.to.y) / 2;
  const Long x = c * hx + s * hy, y = c * hy - s * hx;
  Long rx = arc.rx, ry = arc.ry;
  const Long reach = x * x / (rx * rx) + y * y / (ry * ry);
  if (reach > 1) {
    rx *= sqrt(reach);
    ry *= sqrt(reach);
  }
  Long left = reach > 1 ? Long(0) : 1 / reach - 1;
  if (left < 0) left = 0;
  const Long factor = sqrt(left) * (arc.large == arc.sweep ? -1 : 1);
  const Long cx = factor * rx * y / ry, cy = -factor * ry * x / rx;
  const Long begin = atan2((y - cy) / ry, (x - cx) / rx);
  Long angle = atan2((-y - cy) / ry, (-x - cx) / rx) - begin;
  if (arc.sweep && angle < 0) angle += 2 * pi;
  if (!arc.sweep && angle > 0) angle -= 2 * pi;
  const LongPoint middle{(Long(from.x) + arc.to.x) / 2, (Long(from.y) + arc.to.y) / 2};
  return [=](const Long& u) {
    const Long t = begin + u * angle, px = cx + rx * cos(t), py = cy + ry * sin(t);
    return LongPoint{c * px - s * py + middle.x, s * px + c * py + middle.y};
  };
}

Formula formula_of(const Point& from, const CurveSegment& segment) {
  if (const auto* arc = std::get_if<ArcTo>(&segment)) return arc_formula(from, *arc);
  return [=](const Long& u) {
    const Long v = 1 - u;
    if (const auto* q = std::get_if<QuadraticTo>(&segment))
      return mixed({{v * v, from}, {2 * v * u, q->control}, {u * u, q->to}});
    if (const auto* c = std::get_if<CubicTo>(&segment))
      return mixed({{v * v * v, from}, {3 * v * v * u, c->first}, {3 * v * u * u, c->second}, {u * u * u, c->to}});
    return mixed({{v, from}, {u, end_of(segment)}});
  };
}

std::vector<Formula> formulas_of(const Outline& outline) {
  std::vector<Formula> formulas;
  Point from = outline.start;
  for (const auto& segment : curve::closed_segments(outline)) {
    formulas.push_back(formula_of(from, segment));
    from = end_of(segment);
  }
  return formulas;
}

/// Positive to the left of the line from a to b.
Long side_of(const Point& a, const Point& b, const LongPoint& p) {
  return (Long(b.x) - a.x) * (p.y - a.y) - (Long(b.y) - a.y) * (p.x - a.x);
}

/// True only if the point is well to the left of the line from a to b, or to the right for a sign of -1. In doubles,
/// whose errors, the point's own included, are below 2^-50 of the same products without signs: most points are that
/// clear.
bool clearly_beside(const Point& a, const Point& b, const LongPoint& p, int sign) {
  const Point q{p.x.convert_to<double>(), p.y.convert_to<double>()};
  const double reach = std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(q.x), std::fabs(q.y)});
  const double dx = b.x - a.x, dy = b.y - a.y;
  return sign * (dx * (q.y - a.y) - dy * (q.x - a.x)) > 0x1p-48 * (std::fabs(dx) + std::fabs(dy)) * reach;
}

/// A closed curve around a point, of segments of all kinds; it may meet itself, and is no outline then.
Outline random_outline(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const int n = 2 + static_cast<int>(unit(random) * 9);
  const double size = std::ldexp(1.0, static_cast<int>(unit(random) * 12) - 4);
  const Point centre{unit(random) < 0.5 ? 0 : 40 * size * unit(random), unit(random) < 0.5 ? 0 : 7 * size};
  const auto at = [&](double turn, double radius) {
    Point p{centre.x + radius * size * std::cos(6.283185307 * turn),
            centre.y + radius * size * std::sin(6.283185307 * turn)};
    if (unit(random) < 0.3) p = {std::round(p.x * 16) / 16, std::round(p.y * 16) / 16};
    return p;
  };
  Outline outline{at(0, 0.5 + unit(random)), {}};
  Point from = outline.start;
  for (int k = 1; k <= n; ++k) {
    const Point to = k == n ? outline.start : at(double(k) / n, 0.5 + unit(random));
    const Point a = at((k - 0.66) / n, 0.5 + unit(random)), b = at((k - 0.33) / n, 0.5 + unit(random));
    const double chord = std::hypot(to.x - from.x, to.y - from.y);
    const int kind = static_cast<int>(unit(random) * 6);
    if (kind == 0) outline.segments.emplace_back(LineTo{to});
    if (kind == 1) outline.segments.emplace_back(QuadraticTo{a, to});
    if (kind == 2 || kind == 3) outline.segments.emplace_back(CubicTo{unit(random) < 0.1 ? from : a, b, to});
    if (kind >= 4) {
      const double rx = chord * (0.5 + unit(random) * unit(random) * 2);
      const double ry = unit(random) < 0.5 ? rx : rx * (0.3 + 1.5 * unit(random));
      const double turned = unit(random) < 0.3 ? 90 * std::floor(unit(random) * 4) : 360 * unit(random);
      outline.segments.emplace_back(ArcTo{rx, ry, turned, unit(random) < 0.1, unit(random) < 0.6, to});
    }
    from = to;
  }
  return outline;
}

std::optional<BandedPart> banded(const Outline& outline) {
  try {
    return BandedPart({outline, {}}, "random");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

/// The least product by which the point lies on its side of the cell's walls.
void expect_between_walls(const curve::Band& band, std::size_t k, const LongPoint& p) {
  const Cell& cell = band.cells()[k];
  const double size = band.resolution().size;
  const auto expect = [&](Point from, const std::vector<Point>& corners, const Point& to, int sign) {
    std::vector<Point> wall{from};
    wall.insert(wall.end(), corners.begin(), corners.end());
    wall.push_back(to);
    for (std::size_t i = 0; i + 1 < wall.size(); ++i) {
      if (clearly_beside(wall[i], wall[i + 1], p, sign)) continue;
      ASSERT_GE(sign * side_of(wall[i], wall[i + 1], p), -Long(std::ldexp(size * size, -190)));
    }
  };
  expect(band.gate(k).right, cell.right, band.gate(k + 1).right, 1);
  expect(band.gate(k).left, cell.left, band.gate(k + 1).left, -1);
}

TEST(CurveBand, WallsHaveTheCurveBetweenThem) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> unit(0, 1);
  const std::uint64_t wanted = effort(1000000);
  std::uint64_t points = 0, outlines = 0, refused = 0;
  while (points < wanted) {
    const Outline outline = random_outline(random);
    auto part = banded(outline);
    if (!part) {
      ++refused;
      continue;
    }
    ++outlines;
    curve::Band& band = part->band(0);
    const std::vector<Formula> formulas = formulas_of(outline);
    for (int level = 0; level < 8; ++level) {
      for (int i = 0; i < 150; ++i) {
        const auto k = static_cast<std::size_t>(unit(random) * static_cast<double>(band.cells().size()));
        const curve::Piece& piece = band.cells()[k].piece;
        // Of arcs, a parameter is an angle's share, known in doubles.
        const double u = piece.from + (0.001 + 0.998 * unit(random)) * (piece.to - piece.from);
        expect_between_walls(band, k, formulas[static_cast<std::size_t>(piece.segment)](u));
        ++points;
      }
      if (HasFatalFailure()) FAIL() << write_path({{outline, {}}}) << " at level " << level;
      std::vector<int> halvings;
      for (std::size_t k = 0; k < band.cells().size(); ++k)
        halvings.push_back(level < 4 || unit(random) < 6.0 / static_cast<double>(band.cells().size()) ? 1 + level / 2
                                                                                                      : 0);
      band.refine(halvings);
    }
  }
  EXPECT_GT(outlines, 20u);
  EXPECT_GT(outlines, refused / 8) << "nearly all random outlines are refused";
}

/// 1 inside, -1 outside, 0 on the ring.
int where(const Polygon& ring, const Point& p) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const int side = orientation(a, b, p);
    if (side == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
        p.y <= std::max(a.y, b.y))
      return 0;
    if ((a.y > p.y) != (b.y > p.y) && (a.y < b.y) == (side > 0)) odd = !odd;
  }
  return odd ? 1 : -1;
}

TEST(CurveBand, PolygonsAreSimpleAndFinerOnesLieBetween) {
  std::mt19937_64 random(4);
  for (std::uint64_t done = 0; done < effort(150);) {
    const Outline outline = random_outline(random);
    auto part = banded(outline);
    if (!part) continue;
    ++done;
    Polygon inner = part->polygons(CurveSide::inner).outline, outer = part->polygons(CurveSide::outer).outline;
    for (int level = 0; level < 5; ++level) {
      ASSERT_NO_THROW(validate_polygon(inner, "inner"));
      ASSERT_NO_THROW(validate_polygon(outer, "outer"));
      part->band(0).refine(std::vector<int>(part->bands()[0].cells().size(), 1));
      const Polygon more = part->polygons(CurveSide::inner).outline, less = part->polygons(CurveSide::outer).outline;
      for (const Point& p : less) ASSERT_GE(where(outer, p), 0) << write_path({{outline, {}}});
      for (const Point& p : more) ASSERT_GE(where(less, p), 0) << write_path({{outline, {}}});
      for (const Point& p : inner) ASSERT_GE(where(more, p), 0) << write_path({{outline, {}}});
      inner = more;
      outer = less;
    }
  }
}

TEST(CurveBand, ToleranceIsReachedAndTold) {
  std::mt19937_64 random(99);
  for (std::uint64_t done = 0; done < effort(60);) {
    const Outline outline = random_outline(random);
    if (!banded(outline)) continue;
    ++done;
    const double size = banded(outline)->bands()[0].resolution().size;
    const Polygon inner = flatten({{outline, {}}}, CurveSide::inner, size * 1e-4)[0].outline;
    const Polygon outer = flatten({{outline, {}}}, CurveSide::outer, size * 1e-4)[0].outline;
    for (const Point& p : outer) {
      double nearest = INFINITY;
      for (std::size_t i = 0; i < inner.size(); ++i) {
        const Point a = inner[i], b = inner[(i + 1) % inner.size()];
        const double x = b.x - a.x, y = b.y - a.y;
        const double t = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
        nearest = std::min(nearest, std::hypot(p.x - a.x - t * x, p.y - a.y - t * y));
      }
      ASSERT_LE(nearest, size * 1e-4 * (1 + 1e-9)) << write_path({{outline, {}}});
    }
  }
}

/// Polygons at a tolerance of their own are on the side of the bracket that they must be on.
TEST(CurveBand, FirstContactsLieBetweenThoseOfFinePolygons) {
  std::mt19937_64 random(2026);
  std::uniform_real_distribution<double> unit(0, 1);
  std::uint64_t contacts = 0, frees = 0;
  for (std::uint64_t done = 0; done < effort(100);) {
    const Outline a = random_outline(random), b = random_outline(random);
    const auto part_a = banded(a), part_b = banded(b);
    if (!part_a || !part_b) continue;
    ++done;
    Scene scene;
    scene.end = 1;
    scene.bodies.resize(2);
    scene.bodies[0].name = "a";
    scene.bodies[0].curves = {{a, {}}};
    scene.bodies[1].name = "b";
    scene.bodies[1].curves = {{b, {}}};
    // From well away to beyond a's start, turning on the way.
    const double size = part_a->bands()[0].resolution().size + part_b->bands()[0].resolution().size;
    MotionPiece piece;
    piece.x = {a.start.x - b.start.x + 4 * size, -5 * size};
    piece.y = {a.start.y - b.start.y + size * (unit(random) - 0.5)};
    piece.pivot = b.start;
    piece.rotation = AngleRotation{{6 * unit(random), 2 * unit(random)}};
    scene.bodies[1].motion.pieces = {piece};
    const Answer answer = check(scene);
    const auto flat = [&](CurveSide side) {
      Scene polygons = scene;
      for (Body& body : polygons.bodies) {
        body.polygon = flatten(body.curves, side, size * 1e-6)[0].outline;
        body.curves.clear();
      }
      return check(polygons);
    };
    const Answer outer = flat(CurveSide::outer), inner = flat(CurveSide::inner);
    SCOPED_TRACE(write_path({{a, {}}}) + "   " + write_path({{b, {}}}));
    if (answer.outcome == Outcome::contact) {
      ++contacts;
      ASSERT_EQ(outer.outcome, Outcome::contact);
      EXPECT_LE(outer.contact->time.lo, answer.contact->time.hi);
      if (inner.contact) {
        EXPECT_GE(inner.contact->time.hi, answer.contact->time.lo);
      }
      EXPECT_LE(answer.contact->time.hi - answer.contact->time.lo, 1.1e-9);
    }
    if (answer.outcome == Outcome::free) {
      ++frees;
      EXPECT_EQ(inner.outcome, Outcome::free);
    }
    if (answer.outcome == Outcome::overlap_at_start) {
      EXPECT_EQ(outer.outcome, Outcome::overlap_at_start);
    }
  }
  EXPECT_GT(contacts, frees / 20);
  EXPECT_GT(frees, 5u);
}

}  // namespace
}  // namespace taut
