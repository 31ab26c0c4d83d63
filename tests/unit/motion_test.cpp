// Frames, legs, displacement and the functions of mixed triples.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <utility>

#include "geometry/displaced_orientation.hpp"
#include "geometry/displacement.hpp"
#include "kinetic/failure_solver.hpp"
#include "motion/cosine_pieces.hpp"
#include "motion/pieces.hpp"
#include "motion/polynomial_search.hpp"
#include "pair/placement.hpp"
#include "relative/leg.hpp"
#include "sign/plan_range.hpp"
#include "sign/precise_function.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"
#include "taut/simulation.hpp"
#include "taut/validate.hpp"

namespace taut::testing {
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
  return piece;
}

/// World position by the definition, in long double.
void world(const MotionPiece& piece, long double t, const DisplacedPoint& v, long double& x, long double& y) {
  const auto value = [t](const Coefficients& c) {
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

TEST(Form, IsTheOrientationInTheWorldForEveryFormOfMotion) {
  Rng rng(5);
  for (int i = 0; i < 2000; ++i) {
    const PairGeometry g = random_pair(rng);
    const MotionPiece p = random_piece(rng), q = random_piece(rng);
    const Leg leg = Leg::motion(p, q, -1, 1);
    const double t = rng.real(-1, 1);
    VertexId v[3] = {VertexId(rng.below(4)), VertexId(4 + rng.below(4)), VertexId(rng.below(8))};
    if (v[2] == v[0] || v[2] == v[1]) continue;
    long double x[3], y[3];
    for (int k = 0; k < 3; ++k) world(g.in_p(v[k]) ? p : q, t, g.point(v[k]), x[k], y[k]);
    const long double want = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    const Form triple = Form::of(g, v[0], v[1], v[2]);
    const Jet<Real320> precise = PreciseFunction<Real320>(leg, g, triple)(Ball<Real320>::exact(t));
    EXPECT_NEAR(RealTraits<Real320>::to_double(precise.v.mid), static_cast<double>(want), 1e-13);
    EXPECT_LT(precise.v.rad, 1e-80);
    LegClock clock;
    clock.reset(leg);
    const FastFunction fast = FastFunction::level_zero(leg, g, triple);
    const Bounded value = fast.value(clock.at(t, fast.pp)), slope = fast.slope(clock.at(t, fast.pp));
    EXPECT_LE(std::fabs(value.value - RealTraits<Real320>::to_double(precise.v.mid)), value.error);
    EXPECT_LE(std::fabs(slope.value - RealTraits<Real320>::to_double(precise.d.mid)), slope.error);
    EXPECT_LT(value.error, 1e-11);
    const Bounded bend = fast.curvature(clock.cell(t).curvature(fast.pp));
    EXPECT_LE(std::fabs(bend.value - RealTraits<Real320>::to_double(precise.dd.mid)), bend.error);
    // The projection is the dot product.
    const Jet<Real320> dot = PreciseFunction<Real320>(leg, g, triple.along())(Ball<Real320>::exact(t));
    long double px[3], py[3];
    const VertexId w[3] = {triple.a, triple.b, triple.c};
    for (int k = 0; k < 3; ++k) world(g.in_p(w[k]) ? p : q, t, g.point(w[k]), px[k], py[k]);
    const long double product = (px[1] - px[0]) * (px[2] - px[0]) + (py[1] - py[0]) * (py[2] - py[0]);
    EXPECT_NEAR(RealTraits<Real320>::to_double(dot.v.mid), static_cast<double>(product), 1e-13);
  }
}

/// Both ways to the same function: g(s) = f(end + direction s^2), so g' = 2 direction s f'.
TEST(Form, IsSmoothInTheRootOfTheDistanceFromASingularEnd) {
  Rng rng(7);
  for (int i = 0; i < 400; ++i) {
    const PairGeometry g = random_pair(rng);
    MotionPiece p = random_piece(rng);
    const bool at_start = rng.chance(0.5), linear = rng.chance(0.5);
    const double e = rng.chance(0.5) ? 1 : -1, change = -e * rng.between(20, 100) * 0x1p-8;
    // |c| = 1 at the end.
    const double end = rng.chance(0.5) ? 0.75 : 0, direction = at_start ? 1 : -1;
    // The first power that is there: with the second one the body starts at a finite speed, and nothing is singular.
    const int order = linear ? 1 : rng.between(1, 3);
    Coefficients a{e, 0, 0, 0};
    a[static_cast<std::size_t>(order)] = order % 2 == 1 ? direction * change : change;
    for (int k = order + 1; k < 4 && !linear; ++k) a[static_cast<std::size_t>(k)] = rng.between(-12, 12) * 0x1p-8;
    // About 0 instead of about the end: exact with coefficients of few bits.
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t power = 3; power-- > k;) a[power] -= a[power + 1] * end;
    }
    p.rotation = CosineRotation{a};
    const Leg leg =
        at_start ? Leg::motion(p, random_piece(rng), end, end + 1) : Leg::motion(p, random_piece(rng), end - 1, end);
    ASSERT_TRUE(leg.singular_cosine(true, end));
    EXPECT_EQ(leg.singular_at(end), order % 2 == 1);
    const PreciseFunction<Real320> f(leg, g, Form::of(g, VertexId(0), VertexId(1), VertexId(6)));
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
    // The polynomial about the end holds the function everywhere up to there.
    const double near = direction * 0.05;
    const BallPolynomial<Real320> polynomial = f.from_end(end, direction, Ball<Real320>::exact(near));
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

TEST(PlanRange, SaysTheSignOverTheWholePlanOrNothing) {
  Rng rng(8);
  int kept = 0;
  for (int i = 0; i < 500; ++i) {
    const PairGeometry g = random_pair(rng);
    const MotionPiece p = random_piece(rng), q = random_piece(rng), next = random_piece(rng);
    const double length = rng.real(0.01, 0.3);
    const std::vector<Leg> legs{Leg::motion(p, q, 0, length), Leg::bridging(p, q, next, q, length),
                                Leg::motion(next, q, length, 2 * length)};
    PlanRange range = PlanRange::over(legs[0], legs[0].start, legs[0].end);
    for (const Leg& leg : legs) range.include(PlanRange::over(leg, leg.start, leg.end));
    range = range.widened();
    for (const Leg& leg : legs) EXPECT_EQ(range.left_at(leg, leg.start), INFINITY);
    const PlanRange half = PlanRange::over(legs[0], 0, length / 2).widened();
    const double left = half.left_at(legs[0], 0);
    EXPECT_TRUE(left >= length * 0.4 && half.contains(PlanRange::over(legs[0], left * 0.3, left * 0.7)));
    for (int k = 0; k < 10; ++k) {
      const Form triple = Form::of(g, VertexId(rng.below(4)), VertexId(4 + rng.below(2)), VertexId(6));
      for (const int sign : {1, -1}) {
        if (!range.keeps_sign(g, triple, sign)) continue;
        ++kept;
        for (const Leg& leg : legs) {
          const Ball<Real320> t = Ball<Real320>::exact(rng.real(leg.start, leg.end));
          EXPECT_EQ(PreciseFunction<Real320>(leg, g, triple)(t).v.sign(), sign);
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
    const Form triple = Form::of(g, VertexId(0), VertexId(1), VertexId(5));
    const auto sign = [&](const Leg& leg, double at) {
      return PreciseFunction<Real320>(leg, g, triple)(Ball<Real320>::exact(at)).v.sign();
    };
    const Leg bridge = Leg::bridging(p, q, p2, q2, t);
    EXPECT_EQ(sign(bridge, 0), sign(Leg::motion(p, q, -1, 1), t));
    EXPECT_EQ(sign(bridge, 1), sign(Leg::motion(p2, q2, -1, 1), t));
  }
}

/// Both edges of every vertex move by between delta and 2 delta, to the side asked for.
TEST(Displacement, MovesEdgesToOneSide) {
  Rng rng(7);
  const double delta = 0x1p-30;  // coarse, so that doubles can measure it
  for (int i = 0; i < 300; ++i) {
    const int n = 3 + rng.below(9);
    std::vector<Point> polygon;
    for (int k = 0; k < n; ++k) {
      const double a = 2 * 3.14159265358979 * k / n, r = rng.real(0.3, 1);
      polygon.push_back({r * std::cos(a), r * std::sin(a)});
    }
    for (const bool inwards : {true, false}) {
      const auto moved = displace(polygon, inwards, delta, static_cast<std::uint64_t>(i)).points;
      for (int k = 0; k < n; ++k) {
        const auto at = [&](int j) { return polygon[static_cast<std::size_t>((j + n) % n)]; };
        const DisplacedPoint& m = moved[static_cast<std::size_t>(k)];
        EXPECT_EQ(m.x, at(k).x);
        for (const auto& [a, b] : {std::pair{at(k - 1), at(k)}, std::pair{at(k), at(k + 1)}}) {
          const double length = std::hypot(b.x - a.x, b.y - a.y);
          const double side = ((b.x - a.x) * m.dy - (b.y - a.y) * m.dx) / length / delta;
          EXPECT_GE(inwards ? side : -side, 1.0) << n;
          EXPECT_LE(inwards ? side : -side, 2.0) << n;
        }
      }
    }
  }
}

TEST(DisplacedOrientation, TellsWhichStageAnswered) {
  Stage stage;
  const DisplacedPoint a{0, 0, 0, 0}, b{1, 0, 0, 0}, c{0.5, 1, 0, 0}, straight{2, 0, 0, 0};
  EXPECT_EQ(orientation(a, b, c, stage), 1);
  EXPECT_EQ(stage, Stage::filter);
  EXPECT_EQ(orientation(a, b, straight, stage), 0);
  EXPECT_EQ(stage, Stage::displacement);
  const DisplacedPoint up{2, 0, 0, 0x1p-200}, down{2, 0, 0x1p-190, -0x1p-201};
  EXPECT_EQ(orientation(a, b, up, stage), 1);
  EXPECT_EQ(stage, Stage::displacement);
  EXPECT_EQ(orientation(a, b, down, stage), -1);
  // Not collinear by one unit in the last place.
  const DisplacedPoint p{0.1, 0.1, 0, 0}, q{0.2, 0.2, 0, 0}, r{0.3, std::nextafter(0.3, 1.0), 0, -0x1p-180};
  EXPECT_EQ(orientation(p, q, r, stage), 1);
  EXPECT_EQ(stage, Stage::exact);
  EXPECT_EQ(orientation(q, p, r), -1);
  EXPECT_EQ(orientation(q, r, p), 1);
}

Scene sliding_square(double y) {
  Scene scene;
  scene.end = 10;
  scene.bodies = {{"a", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, {"b", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};
  scene.bodies[1].motion.pieces = {{{-3, 1}, {y}, NoRotation{}}};
  return scene;
}

/// Axis-aligned sliding is decided in doubles, by the part that is linear in the displacement.
TEST(Stages, SlidingNeedsNoMultiPrecisionForItsSigns) {
  const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const PairGeometry g(displace(square, true, displacement_unit, 1).points,
                       displace(square, true, displacement_unit, 2).points);
  const Scene scene = sliding_square(1);
  const Leg leg = Leg::motion({}, scene.bodies[1].motion.pieces[0], 0, 10);
  // P's upper edge (2 -> 3) and Q's lower left corner: on one line at all times.
  const Form triple{VertexId(2), VertexId(3), VertexId(4), true};
  FastFunction level1;
  ASSERT_TRUE(FastFunction::level_one(leg, g, triple, level1));
  LegClock clock;
  clock.reset(leg);
  const FastFunction level0 = FastFunction::level_zero(leg, g, triple);
  const Bounded zero = level0.value(clock.at(3.0, true)), one = level1.value(clock.at(3.0, true));
  EXPECT_LE(std::fabs(zero.value), zero.error);
  EXPECT_GT(std::fabs(one.value), one.error);
  const int precise = PreciseFunction<Real640>(leg, g, triple)(Ball<Real640>::exact(3.0)).v.sign();
  EXPECT_EQ(one.value > 0 ? 1 : -1, precise);
  // Not identically zero: there is no level one.
  const Leg oblique = Leg::motion({}, {{-3, 1}, {1, 0x1p-60}, NoRotation{}}, 0, 10);
  EXPECT_FALSE(FastFunction::level_one(oblique, g, triple, level1));
  EXPECT_EQ(check(scene).outcome, Outcome::free);
}

TEST(Placement, SignsAgreeWithMultiPrecisionAndCountIt) {
  Rng rng(8);
  PairGeometry g = random_pair(rng);
  const Leg leg = Leg::motion({}, {{0.25}, {0.5}, AngleRotation{{0, 1}}}, 0, 1);
  const Placement placement(g, leg, 0.5);
  for (std::uint32_t a = 0; a < 8; ++a) {
    for (std::uint32_t b = 0; b < 8; ++b) {
      for (std::uint32_t c = 0; c < 8; ++c) {
        if (a == b || b == c || c == a) continue;
        const VertexId u(a), v(b), w(c);
        EXPECT_EQ(placement.orientation(u, v, w), placement.orientation(v, w, u));
        EXPECT_EQ(placement.orientation(u, v, w), -placement.orientation(v, u, w));
        if (g.same_body(u, v) && g.same_body(v, w)) continue;
        const auto f = PreciseFunction<Real320>(leg, g, Form::of(g, u, v, w))(Ball<Real320>::exact(0.5));
        EXPECT_EQ(placement.orientation(u, v, w), f.v.sign());
      }
    }
  }
  EXPECT_EQ(placement.precise_calls(), 0u);
}

// ----- what is refused -----

std::string refusal(const Scene& scene) {
  try {
    validate(scene);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

Scene with_motion(std::vector<MotionPiece> pieces) {
  Scene scene = sliding_square(2);
  scene.bodies[1].motion.pieces = std::move(pieces);
  return scene;
}

void expect_refusal(const Scene& scene, const std::string& part) {
  EXPECT_NE(refusal(scene).find(part), std::string::npos) << "\"" << refusal(scene) << "\" lacks \"" << part << "\"";
}

TEST(MotionValidation, RefusesWhatIsNotAMotion) {
  EXPECT_EQ(refusal(sliding_square(2)), "");
  expect_refusal(with_motion({{{0, NAN}, {}, NoRotation{}}}), "b: motion: x[1] is not a finite number");
  expect_refusal(with_motion({{Coefficients(18, 1.0), {}, NoRotation{}}}), "x has degree 17\nhint: the highest degree");
  expect_refusal(with_motion({{{}, {}, DirectionRotation{{-1, 1}, {-2, 2}}}}),
                 "the direction (a, b) vanishes near t = ");
  expect_refusal(with_motion({{{}, {}, DirectionRotation{{}, {}}}}), "vanishes");
  expect_refusal(with_motion({{{}, {}, CosineRotation{{0, 0.5}}}}), "the cosine is beyond 1 in magnitude");
  expect_refusal(with_motion({{{}, {}, CosineRotation{{0, 0.5}}}}), "must stay within [-1, 1]");
  EXPECT_EQ(refusal(with_motion({{{3}, {}, CosineRotation{{0, 0.1}}}})), "");
  expect_refusal(with_motion({{{1e200}, {}, NoRotation{}}}), "outside the range of magnitudes");
  expect_refusal(with_motion({{{}, {}, NoRotation{}, INFINITY, {0, NAN}}}), "pivot[1] is not a finite number");
}

TEST(MotionValidation, RefusesPiecesThatDoNotFit) {
  expect_refusal(with_motion({{{3, -1}, {2}, NoRotation{}, 3}, {{1}, {2}, NoRotation{}}}),
                 "b: motion piece 0: the motion jumps by 1 at t = 3");
  expect_refusal(with_motion({{{3}, {2}, NoRotation{}, 3}, {{3}, {2}, NoRotation{}, 3}, {{3}, {2}, NoRotation{}}}),
                 "`until` 3 does not come after");
  expect_refusal(with_motion({{{3}, {2}, NoRotation{}, 3}}), "the motion ends at 3, before the scene does, at 10");
  EXPECT_EQ(refusal(with_motion({{{3, -1}, {2}, NoRotation{}, 3}, {{1e-9, 0}, {2}, NoRotation{}}})), "");
}

/// The Chebyshev polynomial of this degree: it reaches 1 and -1 in turn, all over [-1, 1].
Coefficients chebyshev(int degree) {
  Coefficients before{1}, last{0, 1};
  for (int k = 1; k < degree; ++k) {
    Coefficients next(last.size() + 1, 0.0);
    for (std::size_t i = 0; i < last.size(); ++i) next[i + 1] += 2 * last[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::exchange(last, std::move(next));
  }
  return last;
}

std::string refusal_of_rotation(const Rotation& rotation, double start, double end) {
  Scene scene = with_motion({{{3}, {}, rotation}});
  scene.start = start;
  scene.end = end;
  return refusal(scene);
}

/// What doubles cannot tell from a cosine beyond 1, and halving would look for in every interval there is.
TEST(MotionValidation, TellsCosinesThatReachOneFromOnesBeyondIt) {
  EXPECT_EQ(refusal_of_rotation(CosineRotation{{-9999, 200, -1}}, 100, 101), "");
  EXPECT_NE(refusal_of_rotation(CosineRotation{{-9999, 200, -1 - 0x1p-36}}, 101, 101.5), "");
  EXPECT_EQ(refusal_of_rotation(CosineRotation{{-99999999, 20000, -1}}, 9999.5, 10001), "");
  EXPECT_EQ(refusal_of_rotation(CosineRotation{{1 + 0x1p-41}}, 0, 1), "");
  EXPECT_NE(refusal_of_rotation(CosineRotation{{-1 - 0x1p-39}}, 0, 1), "");
  EXPECT_NE(refusal_of_rotation(CosineRotation{{1 + 0x1p-40, 0, -1}}, -1, 1), "") << "it just reaches the bound";
  for (const int degree : {2, 11, 12, 16}) {
    EXPECT_EQ(refusal_of_rotation(CosineRotation{chebyshev(degree)}, -1, 1), "") << degree;
    EXPECT_NE(refusal_of_rotation(CosineRotation{chebyshev(degree)}, -1, 1.0001), "") << degree;
    Coefficients beyond = chebyshev(degree);
    for (double& c : beyond) c *= 1 + 0x1p-38;
    EXPECT_NE(refusal_of_rotation(CosineRotation{beyond}, -0.5, 0.99), "") << degree;
  }
}

TEST(MotionValidation, RefusesDirectionsThatVanishAndNoOthers) {
  const Coefficients t{0, 1}, sqrt_two{-2, 0, 1}, multiple{0, -2, 0, 1};
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{t, {1e-15}}, -1, 1), "");
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{t, {1e-100}}, -1, 1), "");
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{t, {1e-100, 1}}, -1.0 / 3, 1), "");
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{sqrt_two, multiple}, 2, 3), "");
  EXPECT_NE(refusal_of_rotation(DirectionRotation{t, {0, 0, 1}}, 0, 1), "") << "at an end";
  EXPECT_NE(refusal_of_rotation(DirectionRotation{t, {0, 0, 1}}, -1.0 / 3, 1), "") << "where nothing is halved";
  EXPECT_NE(refusal_of_rotation(DirectionRotation{sqrt_two, multiple}, 0, 3).find("near t = 1.41421356"),
            std::string::npos);
  EXPECT_NE(refusal_of_rotation(DirectionRotation{{0}, {0}}, 0, 1), "");
  // One root of multiplicity 8, and the same moved by a little.
  Coefficients root{256, 0, -1024, 0, 1792, 0, -1792, 0, 1120, 0, -448, 0, 112, 0, -16, 0, 1};
  Coefficients moved = root;
  moved[1] = 1e-30;
  EXPECT_NE(refusal_of_rotation(DirectionRotation{root, root}, 0, 2), "");
  EXPECT_EQ(refusal_of_rotation(DirectionRotation{root, moved}, 0, 2), "");
}

TEST(MotionValidation, AcceptsNothingThatItCouldNotSearch) {
  EXPECT_EQ(beyond_one(chebyshev(16), -1, 1), std::nullopt);
  EXPECT_THROW(beyond_one(chebyshev(16), -1, 1, 100), SearchExhausted);
  const Coefficients sqrt_two{-2, 0, 1}, multiple{0, -2, 0, 1};
  EXPECT_NE(common_zero(sqrt_two, multiple, 0, 2), std::nullopt);
  EXPECT_THROW(common_zero(sqrt_two, multiple, 0, 2, 100), SearchExhausted);
}

TEST(MotionValidation, SmallBodiesFarAwayMayJumpByWhatDoublesRound) {
  Scene scene = sliding_square(2);
  for (Body& body : scene.bodies) {
    for (Point& v : body.polygon) v = {v.x * 0x1p-20, v.y * 0x1p-20};
  }
  const auto jump = [&scene](double by) {
    scene.bodies[1].motion.pieces = {{{1e6 + by}, {}, NoRotation{}, 3}, {{1e6}, {}, NoRotation{}}};
    return refusal(scene);
  };
  EXPECT_EQ(jump(0x1p-33), "");
  EXPECT_NE(jump(0x1p-20).find("the motion jumps by"), std::string::npos);
  // Terms that cancel are rounded, too.
  scene.bodies[1].motion.pieces = {{{1e6 - 3e6, 1e6}, {}, NoRotation{}, 3}, {{-2e6 + 0x1p-32, 1e6}, {}, NoRotation{}}};
  EXPECT_EQ(refusal(scene), "");
}

TEST(SceneValidation, RefusesBadTimesAndBodies) {
  Scene scene = sliding_square(2);
  scene.end = -1;
  expect_refusal(scene, "time: the time interval ends before it starts");
  scene = sliding_square(2);
  scene.start = INFINITY;
  expect_refusal(scene, "not finite");
  scene = sliding_square(2);
  scene.bodies.push_back(scene.bodies[0]);
  expect_refusal(scene, "the scene has 3 bodies\nhint: exactly two are supported now");
  scene = sliding_square(2);
  scene.bodies[0].polygon = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  expect_refusal(scene, "a: ");
  scene = sliding_square(2);
  scene.bodies[0].polygon[0].x = 1e-110;
  scene.bodies[1].polygon[1].x = 1e100;
  expect_refusal(scene, "differ in magnitude");
}

/// A notch far smaller than the displacement turns inside out: that must be seen, not computed with.
TEST(FineFeatures, SmallerThanTheDisplacementAreRefused) {
  Scene scene = sliding_square(2);
  scene.bodies[0].polygon = {{0, 0}, {1, 0}, {1, 1}, {0.5, 1e-75}, {0.25, 0.5e-75}, {0, 1}};
  try {
    check(scene);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("a: edges "), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("come closer than the displacement"), std::string::npos) << e.what();
  }
  // A hundred million times larger than the displacement is fine.
  scene.bodies[0].polygon = {{0, 0}, {1, 0}, {1, 1}, {0.5, 1e-52}, {0.25, 0.5e-52}, {0, 1}};
  EXPECT_EQ(check(scene).outcome, Outcome::free);
}

/// Every way to ask refuses it, and names the vertex of the input.
TEST(FineFeatures, CornersTooSharpAreRefused) {
  Scene scene = sliding_square(2);
  scene.bodies[0].polygon = {{0.5, 1e-15}, {0, 1}, {-0.25, 1}, {-0.5, 0.5}, {0, 0}, {1, 0}};
  for (const auto engine : {EngineChoice::kinetic, EngineChoice::spacetime}) {
    CheckOptions options;
    options.engine = engine;
    try {
      check(scene, options);
      FAIL() << "accepted";
    } catch (const InputError& e) {
      EXPECT_EQ(e.place(), "a");
      EXPECT_NE(e.problem().find("the corner at vertex 5"), std::string::npos) << e.what();
      EXPECT_EQ(e.culprits().vertices, std::vector<int>{5});
    }
  }
  std::ostringstream log;
  EXPECT_THROW(prove(scene, log), InputError);
  EXPECT_THROW(Simulation(scene, Touch::closed), InputError);
  scene.bodies[0].polygon[0].y = 1e-11;
  EXPECT_EQ(check(scene).outcome, Outcome::free);
}

/// The displacement of a short edge, times a long way, may exceed what the edge rounds.
TEST(FastFunction, BoundsCoverTheDisplacementOfShortEdges) {
  const std::vector<Point> shard{{0, 0}, {0x1p-170, 0}, {0, 0x1p-170}}, square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const PairGeometry g(displace(shard, true, displacement_unit, 1).points,
                       displace(square, true, displacement_unit, 2).points);
  MotionPiece way;
  way.x = {0, 0x1p100, 1};
  way.y = {0, 0x1p90, -1};
  const Leg leg = Leg::motion({}, way, 0, 1);
  LegClock clock;
  clock.reset(leg);
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
    for (int c = 3; c < 7; ++c) {
      const Form triple = Form::of(g, VertexId(a), VertexId(b), VertexId(c));
      const Ball<Real960> exact = PreciseFunction<Real960>(leg, g, triple).value(Ball<Real960>::exact(0.5));
      const Bounded fast = FastFunction::level_zero(leg, g, triple).value(clock.at(0.5, triple.pp));
      EXPECT_LE(std::fabs(static_cast<double>(exact.mid - Real960(fast.value))), fast.error);
    }
  }
}

CosineRotation cosine(const Coefficients& a) { return {a}; }

std::vector<MotionPiece> cut(const Coefficients& a, double from, double to) {
  MotionPiece piece;
  piece.rotation = cosine(a);
  return cut_at_extremes(piece, from, to);
}

TEST(CosinePieces, EndWhereTheCosineIsOne) {
  // 1 - (t - 1)^2 / 2, and 1 - (t - 1.5)^4 / 128, whose guesses are best in the third derivative.
  for (const auto& [a, at] :
       {std::pair(Coefficients{0.5, 1, -0.5}, 1.0),
        std::pair(Coefficients{0.96044921875, 0.10546875, -0.10546875, 0.046875, -0.0078125}, 1.5)}) {
    const std::vector<MotionPiece> pieces = cut(a, 0, 2);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[0].until, at);
    EXPECT_TRUE(same_motion(pieces[0], pieces[1]));
  }
  EXPECT_EQ(cut({1, -1}, 0, 1).size(), 1U);
  EXPECT_EQ(cut({1, 0, -1}, 0, 1).size(), 1U);
}

TEST(CosinePieces, RestWhereTheCosineIsBeyondOne) {
  EXPECT_TRUE(std::holds_alternative<DirectionRotation>(cut({1}, 0, 1)[0].rotation));
  EXPECT_TRUE(std::holds_alternative<DirectionRotation>(cut({-1}, 0, 1)[0].rotation));
  EXPECT_TRUE(std::holds_alternative<CosineRotation>(cut({0.5}, 0, 1)[0].rotation));
  const std::vector<MotionPiece> pieces = cut({1 + 0x1p-52, -1}, 0, 1);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].until, 0x1p-52);
  EXPECT_TRUE(std::holds_alternative<DirectionRotation>(pieces[0].rotation));
  EXPECT_TRUE(std::holds_alternative<CosineRotation>(pieces[1].rotation));
}

/// The Chebyshev polynomial of degree 4 is -1 at sqrt(1/2), which is no double.
TEST(CosinePieces, RestBesideATouchBetweenDoubles) {
  const std::vector<MotionPiece> pieces = cut({1, 0, -8, 0, 8}, 0, 1);
  ASSERT_EQ(pieces.size(), 3U);
  EXPECT_LT(pieces[0].until, std::sqrt(0.5));
  EXPECT_GT(pieces[1].until, std::sqrt(0.5));
  EXPECT_LT(pieces[1].until - pieces[0].until, 0x1p-51);
  EXPECT_TRUE(std::holds_alternative<DirectionRotation>(pieces[1].rotation));
  Scene scene = sliding_square(2);
  scene.end = 1;
  for (Point& v : scene.bodies[0].polygon) v.x -= 30;
  scene.bodies[1].motion.pieces.resize(1);
  scene.bodies[1].motion.pieces[0] = {};
  scene.bodies[1].motion.pieces[0].rotation = cosine({1, 0, -8, 0, 8});
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  EXPECT_EQ(check(scene, options).outcome, Outcome::free);
}

}  // namespace
}  // namespace taut::testing
