// Forms over segments, bridges and stretches of a plan, and the predicates of one instant.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "certificate/fast_function.hpp"
#include "certificate/frame_range.hpp"
#include "certificate/margin_function.hpp"
#include "certificate/precise_function.hpp"
#include "geometry/displacement.hpp"
#include "motion/taylor_model_cache.hpp"
#include "scene/placement.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"
#include "unit/sliding_square.hpp"

namespace taut::testing {
using namespace internal;
namespace {

MotionPiece random_piece(Rng& rng) {
  const auto some = [&rng](int n) {
    Coefficients c;
    for (int i = 0; i < n; ++i) c.push_back(rng.real(-1, 1));
    return c;
  };
  MotionPiece piece;
  piece.x = some(1 + rng.below(4));
  piece.y = some(1 + rng.below(4));
  switch (rng.below(5)) {
    case 0:
      break;
    case 1:
      piece.rotation = AngleRotation{some(3)};
      break;
    case 2:
      piece.rotation = DirectionRotation{{2, 0.3}, some(3)};
      break;
    case 3:
      piece.rotation = HalfAngleRotation{some(3)};
      break;
    default:
      piece.rotation = CosineRotation{{0.1, rng.real(-0.5, 0.5)}};
  }
  if (rng.below(2)) piece.pivot = {rng.real(-1, 1), rng.real(-1, 1)};
  if (rng.below(2)) piece.origin = rng.below(2) ? 0.25 : rng.real(0, 1);
  return piece;
}

/// World position by the definition, in long double.
void world(const MotionPiece& piece, long double time, const DisplacedPoint& v, long double& x, long double& y) {
  const auto value = [t = time - piece.origin](const Coefficients& c) {
    long double s = 0;
    for (std::size_t k = c.size(); k-- > 0;) s = s * t + c[k];
    return s;
  };
  long double c = 1, s = 0;
  if (const auto* r = std::get_if<AngleRotation>(&piece.rotation)) {
    c = std::cos(value(r->angle));
    s = std::sin(value(r->angle));
  } else if (const auto* d = std::get_if<DirectionRotation>(&piece.rotation)) {
    const long double a = value(d->a), b = value(d->b), n = std::sqrt(a * a + b * b);
    c = a / n;
    s = b / n;
  } else if (const auto* h = std::get_if<HalfAngleRotation>(&piece.rotation)) {
    const long double u = value(h->s);
    c = (1 - u * u) / (1 + u * u);
    s = 2 * u / (1 + u * u);
  } else if (const auto* k = std::get_if<CosineRotation>(&piece.rotation)) {
    c = value(k->a);
    s = std::sqrt(1 - c * c);
  }
  const long double px = turns(piece) ? piece.pivot.x : 0, py = turns(piece) ? piece.pivot.y : 0;
  x = value(piece.x) + px + c * (v.x - px) - s * (v.y - py);
  y = value(piece.y) + py + s * (v.x - px) + c * (v.y - py);
}

PairGeometry random_pair(Rng& rng) {
  std::vector<DisplacedPoint> polygons[2];
  for (int i = 0; i < 8; ++i) polygons[i / 4].push_back({rng.real(-1, 1), rng.real(-1, 1), 0, 0});
  return {polygons[0], polygons[1]};
}

TEST(CertificateFunction, IsTheOrientationInTheWorldForEveryFormOfMotion) {
  Rng rng(5);
  for (int i = 0; i < 2000; ++i) {
    const PairGeometry g = random_pair(rng);
    const MotionPiece p = random_piece(rng), q = random_piece(rng);
    const MotionSegment segment = MotionSegment::motion(p, q, -1, 1);
    const double t = rng.real(-1, 1);
    VertexId v[3] = {VertexId(rng.below(4)), VertexId(4 + rng.below(4)), VertexId(rng.below(8))};
    if (v[2] == v[0] || v[2] == v[1]) continue;
    long double x[3], y[3];
    for (int k = 0; k < 3; ++k) world(g.in_p(v[k]) ? p : q, t, g.point(v[k]), x[k], y[k]);
    const long double want = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const CertificateFunction triple = CertificateFunction::of(g, v[0], v[1], v[2]);
    const Jet<Real320> precise = PreciseFunction<Real320>(segment, g, triple)(Ball<Real320>::exact(t));
    EXPECT_NEAR(RealTraits<Real320>::to_double(precise.v.mid), static_cast<double>(want), 1e-13);
    EXPECT_LT(precise.v.rad, 1e-80);
    TaylorModelCache clock;
    clock.reset(segment);
    const FastFunction fast = FastFunction::undisplaced(segment, g, triple);
    const Bounded value = fast.value(clock.at(t, fast.pp)), slope = fast.slope(clock.at(t, fast.pp));
    EXPECT_LE(std::fabs(value.value - RealTraits<Real320>::to_double(precise.v.mid)), value.error);
    EXPECT_LE(std::fabs(slope.value - RealTraits<Real320>::to_double(precise.d.mid)), slope.error);
    EXPECT_LT(value.error, 1e-11);
    const Bounded second = fast.curvature(clock.cell(t).curvature(fast.pp));
    EXPECT_LE(std::fabs(second.value - RealTraits<Real320>::to_double(precise.dd.mid)), second.error);
    // The projection is the dot product.
    const Jet<Real320> dot = PreciseFunction<Real320>(segment, g, triple.along())(Ball<Real320>::exact(t));
    long double px[3], py[3];
    const VertexId w[3] = {triple.a, triple.b, triple.c};
    for (int k = 0; k < 3; ++k) world(g.in_p(w[k]) ? p : q, t, g.point(w[k]), px[k], py[k]);
    const long double product = (px[1] - px[0]) * (px[2] - px[0]) + (py[1] - py[0]) * (py[2] - py[0]);
    EXPECT_NEAR(RealTraits<Real320>::to_double(dot.v.mid), static_cast<double>(product), 1e-13);
  }
}

/// Not negative on [0, 2], and of a degree beyond that of a model, too.
Margin random_margin(Rng& rng) {
  Margin margin{{rng.real(0.1, 2)}, rng.chance(0.5) ? 0 : -0.5};
  for (int degree = rng.chance(0.2) ? max_degree : rng.between(1, 4); degree > 0; --degree)
    margin.coefficients.push_back(rng.real(0, 0.1));
  return margin;
}

long double value_of(const Margin& margin, double t) {
  long double sum = 0;
  for (std::size_t k = margin.coefficients.size(); k-- > 0;)
    sum = sum * (static_cast<long double>(t) - margin.origin) + margin.coefficients[k];
  return sum;
}

/// The polynomial about the end holds the function everywhere up to there.
template <class Function>
void expect_held_by_terms(const Function& f, double end, double direction) {
  for (const double near : {direction * 0.05, direction * 0.01}) {
    BallPolynomial<Real320> polynomial = f.terms_from_end(end, direction);
    polynomial.push_back(f.last_term_from_end(end, direction, near));
    for (const double share : {0.0, 0.01, 0.5, 1.0}) {
      const Ball<Real320> at = Ball<Real320>::exact(near * share);
      const Jet<Real320> expanded = polynomial_range(polynomial, at);
      const Jet<Real320> direct = f(TimeFromEnd<Real320>{end, direction, at});
      EXPECT_EQ((expanded.v - direct.v).sign(), 0);
      EXPECT_EQ((expanded.d - direct.d).sign(), 0);
      EXPECT_EQ((expanded.dd - direct.dd).sign(), 0);
      EXPECT_LT(expanded.v.rad, share < 0.1 ? 1e-20 : 1e-3);
    }
  }
}

/// Both ways to the same function: g(s) = f(end + direction s^2), so g' = 2 direction s f'.
TEST(CertificateFunction, IsSmoothInTheRootOfTheDistanceFromASingularEnd) {
  Rng rng(7);
  for (int i = 0; i < 400; ++i) {
    const PairGeometry g = random_pair(rng);
    MotionPiece p = random_piece(rng);
    p.origin = rng.chance(0.5) ? 0.25 : 0;
    const bool at_start = rng.chance(0.5), linear = rng.chance(0.5);
    const double e = rng.chance(0.5) ? 1 : -1, change = -e * rng.between(20, 100) * 0x1p-8;
    // |c| = 1 at the end.
    const double end = rng.chance(0.5) ? 0.75 : 0, direction = at_start ? 1 : -1;
    // The first power that is there: with the second one the body starts at a finite speed, and nothing is singular.
    const int order = linear ? 1 : rng.between(1, 3);
    Coefficients a{e, 0, 0, 0};
    a[static_cast<std::size_t>(order)] = order % 2 == 1 ? direction * change : change;
    for (int k = order + 1; k < 4 && !linear; ++k) a[static_cast<std::size_t>(k)] = rng.between(-12, 12) * 0x1p-8;
    // About the origin instead of about the end: exact with coefficients of few bits.
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t power = 3; power-- > k;) a[power] -= a[power + 1] * (end - p.origin);
    }
    p.rotation = CosineRotation{a};
    const MotionSegment segment = at_start ? MotionSegment::motion(p, random_piece(rng), end, end + 1)
                                           : MotionSegment::motion(p, random_piece(rng), end - 1, end);
    ASSERT_TRUE(segment.singular_cosine(true, 0, end));
    EXPECT_EQ(segment.singular_at(end), order % 2 == 1);
    const PreciseFunction<Real320> f(segment, g, CertificateFunction::of(g, VertexId(0), VertexId(1), VertexId(6)));
    const double s = direction * rng.real(0.01, 0.9);
    const Ball<Real320> exact = Ball<Real320>::exact(s), square = exact * exact;
    const Jet<Real320> in_t = f(square * direction + Ball<Real320>::exact(end));
    const Jet<Real320> in_s = f(TimeFromEnd<Real320>{end, direction, exact});
    EXPECT_EQ((in_t.v - in_s.v).sign(), 0);
    EXPECT_EQ((in_t.d * (2 * direction * s) - in_s.d).sign(), 0);
    EXPECT_EQ((in_t.dd * square * 4.0 + in_t.d * (2 * direction) - in_s.dd).sign(), 0);
    EXPECT_LT(in_s.v.rad + in_s.d.rad + in_s.dd.rad, 1e-80);
    // At the end itself everything is finite, where in t the slope is not.
    const Jet<Real320> there = f(TimeFromEnd<Real320>{end, direction, Ball<Real320>::exact(0)});
    EXPECT_LT(there.v.rad + there.d.rad + there.dd.rad, 1e-80);
    // Also of another form, for which the frame functions are known already, and of what is made of forms.
    TaylorFrames shared;
    const auto line = [&](unsigned c) { return CertificateFunction::of(g, VertexId(0), VertexId(1), VertexId(c)); };
    expect_held_by_terms(PreciseFunction<Real320>(segment, g, line(6), &shared), end, direction);
    expect_held_by_terms(PreciseFunction<Real320>(segment, g, line(4), &shared), end, direction);
    expect_held_by_terms(LineMargin<Real320>(segment, g, line(6), 0.25, &shared), end, direction);
    expect_held_by_terms(VertexMargin<Real320>(segment, g, VertexId(0), VertexId(6), 0.25, &shared), end, direction);
    expect_held_by_terms(VertexMargin<Real320>(segment, g, VertexId(6), VertexId(0), 0.25, &shared), end, direction);
    const MarginTerms<Real320> margin = SegmentMargin(random_margin(rng), segment).terms<Real320>();
    expect_held_by_terms(LineMargin<Real320>(segment, g, line(6), margin, &shared), end, direction);
    expect_held_by_terms(VertexMargin<Real320>(segment, g, VertexId(0), VertexId(6), margin, &shared), end, direction);
  }
}

/// Closeness by its definition: of points in the world, where the segment's own functions play no part.
TEST(Closeness, IsThatOfDistances) {
  Rng rng(9);
  for (int i = 0; i < 400; ++i) {
    const PairGeometry g = random_pair(rng);
    const MotionPiece p = random_piece(rng), q = random_piece(rng);
    const MotionSegment segment = MotionSegment::motion(p, q, 0, 1);
    const double t = rng.real(0, 1), margin = rng.real(0.1, 2);
    const auto at = [&](unsigned v) {
      long double x, y;
      world(g.in_p(VertexId(v)) ? p : q, t, g.point(VertexId(v)), x, y);
      return std::pair(x, y);
    };
    const auto [ax, ay] = at(0);
    const auto [bx, by] = at(1);
    const auto [cx, cy] = at(6);
    const Ball<Real320> now = Ball<Real320>::exact(t);
    const long double square = (cx - ax) * (cx - ax) + (cy - ay) * (cy - ay);
    const VertexMargin<Real320> vertices(segment, g, VertexId(0), VertexId(6), margin);
    EXPECT_NEAR(RealTraits<Real320>::to_double(vertices(now).v.mid), static_cast<double>(margin * margin - square),
                1e-13);
    const long double turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    const long double length = std::sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
    const LineMargin<Real320> line(segment, g, CertificateFunction::of(g, VertexId(0), VertexId(1), VertexId(6)),
                                   margin);
    EXPECT_NEAR(RealTraits<Real320>::to_double(line(now).v.mid), static_cast<double>(turn + margin * length), 1e-13);
    EXPECT_NEAR(RealTraits<Real320>::to_double(line.value(now).mid), static_cast<double>(turn + margin * length),
                1e-13);
    EXPECT_EQ(line.not_behind(now), turn < margin * length);
  }
}

/// Of a margin that changes, by the same definition, also over stretches of time.
TEST(Closeness, IsThatOfDistancesAndAMarginThatChanges) {
  Rng rng(19);
  for (int i = 0; i < 400; ++i) {
    const PairGeometry g = random_pair(rng);
    MotionPiece p = random_piece(rng), q = random_piece(rng);
    if (rng.chance(0.3)) p.rotation = q.rotation = NoRotation{};
    const MotionSegment segment = MotionSegment::motion(p, q, 0, 1);
    const Margin margin = random_margin(rng);
    const SegmentMargin on_segment(margin, segment);
    const double t = rng.real(0, 1);
    const auto at = [&](unsigned v) {
      long double x, y;
      world(g.in_p(VertexId(v)) ? p : q, t, g.point(VertexId(v)), x, y);
      return std::pair(x, y);
    };
    const auto [ax, ay] = at(0);
    const auto [bx, by] = at(1);
    const auto [cx, cy] = at(6);
    const long double m = value_of(margin, t), square = (cx - ax) * (cx - ax) + (cy - ay) * (cy - ay);
    const long double turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    const long double length = std::sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
    const VertexMargin<Real320> vertices(segment, g, VertexId(0), VertexId(6), on_segment.terms<Real320>());
    const LineMargin<Real320> line(segment, g, CertificateFunction::of(g, VertexId(0), VertexId(1), VertexId(6)),
                                   on_segment.terms<Real320>());
    const Ball<Real320> now = Ball<Real320>::exact(t), around(Real320(t), 0x1p-8);
    const auto near = [](const Ball<Real320>& x, long double wanted) {
      EXPECT_NEAR(RealTraits<Real320>::to_double(x.mid), static_cast<double>(wanted), 1e-12);
    };
    near(vertices(now).v, m * m - square);
    near(vertices.value(now), m * m - square);
    near(line(now).v, turn + m * length);
    near(line.value(now), turn + m * length);
    near(line.telling_value(now), turn + m * length);
    EXPECT_EQ(line.not_behind(now), turn < m * length);
    // What holds over a stretch holds at its middle: values, slopes and second derivatives, by expansions or not.
    for (const Jet<Real320>& range : {line(around), line.decisive_range(around), line(around)}) {
      const Jet<Real320> exact = line(now);
      EXPECT_EQ((range.v - exact.v).sign(), 0);
      EXPECT_EQ((range.d - exact.d).sign(), 0);
      EXPECT_EQ((range.dd - exact.dd).sign(), 0);
    }
    const SegmentMargin::Bounds bounds = on_segment.over(std::max(0.0, t - 0.25), t);
    EXPECT_GE(bounds.most, static_cast<double>(m) * (1 - 1e-12));
    EXPECT_LE(bounds.most - bounds.change, static_cast<double>(m) * (1 + 1e-12));
  }
}

TEST(FrameRange, SaysTheSignOverTheWholePlanOrNothing) {
  Rng rng(8);
  int kept = 0;
  for (int i = 0; i < 500; ++i) {
    const PairGeometry g = random_pair(rng);
    const MotionPiece p = random_piece(rng), q = random_piece(rng), next = random_piece(rng);
    const double length = rng.real(0.01, 0.3);
    const std::vector<MotionSegment> segments{MotionSegment::motion(p, q, 0, length),
                                              MotionSegment::bridging(p, q, next, q, length),
                                              MotionSegment::motion(next, q, length, 2 * length)};
    FrameRange range = FrameRange::over(segments[0], segments[0].start, segments[0].end);
    for (const MotionSegment& segment : segments) range.include(FrameRange::over(segment, segment.start, segment.end));
    range = range.widened();
    for (const MotionSegment& segment : segments) EXPECT_EQ(range.left_at(segment, segment.start), INFINITY);
    const FrameRange half = FrameRange::over(segments[0], 0, length / 2).widened();
    const double left = half.left_at(segments[0], 0);
    EXPECT_TRUE(left >= length * 0.4 && half.contains(FrameRange::over(segments[0], left * 0.3, left * 0.7)));
    for (int k = 0; k < 10; ++k) {
      const CertificateFunction triple =
          CertificateFunction::of(g, VertexId(rng.below(4)), VertexId(4 + rng.below(2)), VertexId(6));
      for (const int sign : {1, -1}) {
        if (!range.keeps_sign(g, triple, sign)) continue;
        ++kept;
        for (const MotionSegment& segment : segments) {
          const Ball<Real320> t = Ball<Real320>::exact(rng.real(segment.start, segment.end));
          EXPECT_EQ(PreciseFunction<Real320>(segment, g, triple)(t).v.sign(), sign);
        }
      }
    }
  }
  EXPECT_GT(kept, 1000);
}

TEST(Bridge, RunsFromTheOldPoseToTheNew) {
  Rng rng(6);
  for (int i = 0; i < 200; ++i) {
    const PairGeometry g = random_pair(rng);
    const MotionPiece p = random_piece(rng), q = random_piece(rng), p2 = random_piece(rng), q2 = random_piece(rng);
    const double t = rng.real(-1, 1);
    const CertificateFunction triple = CertificateFunction::of(g, VertexId(0), VertexId(1), VertexId(5));
    const auto sign = [&](const MotionSegment& segment, double at) {
      return PreciseFunction<Real320>(segment, g, triple)(Ball<Real320>::exact(at)).v.sign();
    };
    const MotionSegment bridge = MotionSegment::bridging(p, q, p2, q2, t);
    EXPECT_EQ(sign(bridge, 0), sign(MotionSegment::motion(p, q, -1, 1), t));
    EXPECT_EQ(sign(bridge, 1), sign(MotionSegment::motion(p2, q2, -1, 1), t));
  }
}

/// Both edges of every vertex move by between delta and 2 delta, to the side asked for.
/// Axis-aligned sliding is decided in doubles, by the part that is linear in the displacement.
TEST(Stages, SlidingNeedsNoMultiPrecisionForItsSigns) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const PairGeometry g(displace(square, Offset::inward, displacement_unit, 1).points,
                       displace(square, Offset::inward, displacement_unit, 2).points);
  const Scene scene = sliding_square(1);
  const MotionSegment segment = MotionSegment::motion({}, scene.bodies[1].motion.pieces[0], 0, 10);
  // P's upper edge (2 -> 3) and Q's lower left corner: on one line at all times.
  const CertificateFunction triple{VertexId(2), VertexId(3), VertexId(4), true};
  FastFunction level1;
  ASSERT_TRUE(FastFunction::displacement_gradient(segment, g, triple, level1));
  TaylorModelCache clock;
  clock.reset(segment);
  const FastFunction level0 = FastFunction::undisplaced(segment, g, triple);
  const Bounded zero = level0.value(clock.at(3.0, true)), one = level1.value(clock.at(3.0, true));
  EXPECT_LE(std::fabs(zero.value), zero.error);
  EXPECT_GT(std::fabs(one.value), one.error);
  const int precise = PreciseFunction<Real960>(segment, g, triple)(Ball<Real960>::exact(3.0)).v.sign();
  EXPECT_EQ(one.value > 0 ? 1 : -1, precise);
  // Not identically zero: there is no level one.
  const MotionSegment oblique = MotionSegment::motion({}, {{-3, 1}, {1, 0x1p-60}, NoRotation{}}, 0, 10);
  EXPECT_FALSE(FastFunction::displacement_gradient(oblique, g, triple, level1));
  EXPECT_EQ(check(scene).outcome, Outcome::free);
}

TEST(Placement, SignsAgreeWithMultiPrecisionAndCountIt) {
  Rng rng(8);
  PairGeometry g = random_pair(rng);
  const MotionSegment segment = MotionSegment::motion({}, {{0.25}, {0.5}, AngleRotation{{0, 1}}}, 0, 1);
  const Placement placement(g, segment, 0.5);
  for (std::uint32_t a = 0; a < 8; ++a) {
    for (std::uint32_t b = 0; b < 8; ++b) {
      for (std::uint32_t c = 0; c < 8; ++c) {
        if (a == b || b == c || c == a) continue;
        const VertexId u(a), v(b), w(c);
        EXPECT_EQ(placement.orientation(u, v, w), placement.orientation(v, w, u));
        EXPECT_EQ(placement.orientation(u, v, w), -placement.orientation(v, u, w));
        if (g.same_body(u, v) && g.same_body(v, w)) continue;
        const auto f =
            PreciseFunction<Real320>(segment, g, CertificateFunction::of(g, u, v, w))(Ball<Real320>::exact(0.5));
        EXPECT_EQ(placement.orientation(u, v, w), f.v.sign());
      }
    }
  }
  EXPECT_EQ(placement.stages().beyond_doubles(), 0u);
}

/// The displacement of a short edge, times a long way, may exceed what the edge rounds.
TEST(FastFunction, BoundsCoverTheDisplacementOfShortEdges) {
  const std::vector<Point> shard{{0, 0}, {0x1p-170, 0}, {0, 0x1p-170}}, square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const PairGeometry g(displace(shard, Offset::inward, displacement_unit, 1).points,
                       displace(square, Offset::inward, displacement_unit, 2).points);
  MotionPiece way;
  way.x = {0, 0x1p100, 1};
  way.y = {0, 0x1p90, -1};
  const MotionSegment segment = MotionSegment::motion({}, way, 0, 1);
  TaylorModelCache clock;
  clock.reset(segment);
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
    for (int c = 3; c < 7; ++c) {
      const CertificateFunction triple = CertificateFunction::of(g, VertexId(a), VertexId(b), VertexId(c));
      const Ball<Real960> exact = PreciseFunction<Real960>(segment, g, triple).value(Ball<Real960>::exact(0.5));
      const Bounded fast = FastFunction::undisplaced(segment, g, triple).value(clock.at(0.5, triple.pp));
      EXPECT_LE(std::fabs(static_cast<double>(exact.mid - Real960(fast.value))), fast.error);
    }
  }
}

}  // namespace
}  // namespace taut::testing
