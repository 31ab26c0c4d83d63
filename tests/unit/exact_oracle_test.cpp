// The oracle by definition against answers found by hand, and its laws.
#include "support/exact_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/contact_scene.hpp"
#include "support/effort.hpp"
#include "taut/validate.hpp"

namespace taut::testing::exact {
namespace {

const Polygon square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

Scene scene(Polygon p, Polygon q, MotionPiece piece, double end) {
  Scene s;
  s.end = end;
  s.bodies = {Body{"P", std::move(p), {}}, Body{"Q", std::move(q), {{std::move(piece)}}}};
  return s;
}

MotionPiece way(Coefficients x, Coefficients y = {}) { return {std::move(x), std::move(y), NoRotation{}}; }

/// Multiplicity 0: any.
void expect_contact(const Scene& s, Touch touch, double t, int multiplicity = 1) {
  const ExactAnswer a = first_contact(s, touch);
  ASSERT_EQ(a.verdict, Verdict::contact) << a.why;
  EXPECT_NEAR(a.time.lo(), t, 4e-16 * std::max(1.0, std::fabs(t)));
  EXPECT_LE(a.time.log_width(), -200);
  if (multiplicity > 0) {
    EXPECT_EQ(a.multiplicity, multiplicity);
  }
  EXPECT_FALSE(a.meetings.empty());
}

void expect(const Scene& s, Touch touch, Verdict verdict) {
  const ExactAnswer a = first_contact(s, touch);
  EXPECT_EQ(a.verdict, verdict) << to_string(a.verdict) << " at " << a.time.lo() << ' ' << a.why;
}

bool meets(const ExactAnswer& a, int body, int vertex, int edge) {
  return std::any_of(a.meetings.begin(), a.meetings.end(),
                     [&](const Meeting& m) { return m.vertex_body == body && m.vertex == vertex && m.edge == edge; });
}

TEST(ExactOracle, SquareOnSquare) {
  const Scene s = scene(square, square, way({5, -1}), 10);
  expect_contact(s, Touch::open, 3);
  expect_contact(s, Touch::closed, 3);
  const ExactAnswer a = first_contact(s, Touch::open);
  EXPECT_FALSE(a.assumed);
  // Corners on corners: each meets two edges.
  EXPECT_EQ(a.meetings.size(), 8u);
  EXPECT_TRUE(meets(a, 1, 0, 1) && meets(a, 0, 2, 3));
}

TEST(ExactOracle, FacesSlide) {
  const Scene s = scene(square, square, way({5, -1}, {2}), 10);
  expect(s, Touch::open, Verdict::free);
  expect_contact(s, Touch::closed, 3);
  // Then down.
  const Scene down = scene(square, square, way({5, -1}, {3, -0.25, 0, 0}), 10);
  expect_contact(down, Touch::open, 4);
}

TEST(ExactOracle, CornerOnCorner) {
  const Scene s = scene(square, square, way({5, -1}, {-1, 1}), 10);  // past the corner (1, 1), at t = 3
  expect_contact(s, Touch::closed, 3);
  expect(s, Touch::open, Verdict::free);
  expect_contact(scene(square, square, way({5, -1}, {5, -1}), 10), Touch::open, 3);
}

TEST(ExactOracle, GrazesOfEachMultiplicity) {
  const Polygon tip{{0, 0}, {1, 2}, {-1, 2}};
  for (int m = 1; m <= 6; ++m) {
    Coefficients y{1};  // 1 + (1 - t)^m above the origin
    for (int k = 0; k < m; ++k) {
      y.push_back(0);
      for (std::size_t i = y.size(); i-- > 0;) y[i] = y[i] - (i > 0 ? y[i - 1] : 0);
    }
    y[0] += 1;
    const Scene s = scene(square, tip, way({}, y), 2);
    expect_contact(s, Touch::closed, 1, m);
    if (m % 2 == 0) {
      expect(s, Touch::open, Verdict::free);
    } else {
      expect_contact(s, Touch::open, 1, m);
    }
  }
}

TEST(ExactOracle, Starts) {
  expect(scene(square, square, way({0.5}), 1), Touch::open, Verdict::overlap_at_start);
  expect(scene(square, square, way({}), 1), Touch::open, Verdict::overlap_at_start);
  expect(scene(square, {{-0.5, -0.5}, {0.5, -0.5}, {0, 0.5}}, way({}), 1), Touch::closed, Verdict::overlap_at_start);
  expect(scene({{-0.5, -0.5}, {0.5, -0.5}, {0, 0.5}}, square, way({}), 1), Touch::open, Verdict::overlap_at_start);
  expect(scene(square, square, way({2, 1}), 1), Touch::open, Verdict::free);
  expect_contact(scene(square, square, way({2, 1}), 1), Touch::closed, 0, 0);
  expect_contact(scene(square, square, way({2, -1}), 1), Touch::open, 0, 0);
  // At an instant alone.
  expect_contact(scene(square, square, way({2, -1}), 0), Touch::closed, 0, 0);
  expect(scene(square, square, way({2, -1}), 0), Touch::open, Verdict::free);
}

/// A square that turns about its middle, beside a wall at x = 1.25, which its corner reaches when cos + sin = 1.25.
TEST(ExactOracle, SpinsAgainstAWall) {
  const Polygon wall{{1.25, -9}, {3, -9}, {3, 9}, {1.25, 9}};
  const auto spin = [&](Rotation rotation) { return scene(wall, square, {{}, {}, std::move(rotation)}, 1); };
  const double angle = std::asin(1.25 / std::sqrt(2.0)) - std::acos(-1.0) / 4;
  for (const Touch touch : {Touch::open, Touch::closed}) {
    expect_contact(spin(HalfAngleRotation{{0, 1}}), touch, (2 - std::sqrt(1.75)) / 4.5);
    expect_contact(spin(DirectionRotation{{1}, {0, 1}}), touch, (2 - std::sqrt(4 - 4 * 0.5625 * 0.5625)) / 1.125);
    expect_contact(spin(CosineRotation{{1, -1}}), touch, 1 - (2.5 + std::sqrt(1.75)) / 4);
    expect_contact(spin(AngleRotation{{0, 1}}), touch, angle);
  }
  EXPECT_FALSE(first_contact(spin(CosineRotation{{1, -1}}), Touch::open).assumed);
}

/// The same square turns back and forth, and its cosine nearly reaches 1 on the way.
TEST(ExactOracle, TurnsWithNearlyInfiniteSpeed) {
  const Polygon wall{{1.25, -9}, {3, -9}, {3, 9}, {1.25, 9}};
  Scene s = scene(wall, square, {{}, {}, CosineRotation{{0.75 - 0x1p-50, 1, -1}}}, 1);
  s.start = 0.375;
  const long double cosine = (2.5L + std::sqrt(1.75L)) / 4;
  const auto t = static_cast<double>(0.5L + std::sqrt(1 - 0x1p-50L - cosine));
  expect_contact(s, Touch::open, t);
  expect_contact(s, Touch::closed, t);
}

/// What the oracle gave up as long as it looked for functions' own signs in ever shorter intervals.
TEST(ExactOracle, NearlyInfiniteSpeedIsNotBeyondIt) {
  const Polygon notched{{-0.25, -3}, {-0.25, 0}, {0, 0}, {0, -9}, {-0.25, -9}, {-0.25, -6}, {-0.125, -6}, {-0.125, -3}};
  const Polygon stairs{{-3, 1}, {-1, -1}, {0, 0}, {2, -2}, {1, -3}, {3, -5}, {5, -3}, {-1, 3}};
  const CosineRotation turn{{-0.749999999996362, -1, 1}};
  const Scene s = scene(notched, stairs, {{-2.25, 0}, {2, -6}, turn, INFINITY, {-3, 1}}, 1);
  expect(s, Touch::open, Verdict::free);
  expect(s, Touch::closed, Verdict::free);
}

TEST(ExactOracle, HingeAtASharedCorner) {
  const Polygon p{{0, 0}, {-2, 0}, {-2, -2}, {0, -2}}, q{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  // A quarter turn lays Q's side on P's: s = 1. Then on into it.
  const Scene s = scene(p, q, {{}, {}, HalfAngleRotation{{0, 1}}}, 3);
  expect_contact(s, Touch::closed, 0, 0);
  // The corner (0, 2) comes down on the line x = -2 as on a tangent.
  expect_contact(s, Touch::open, 1, 2);
  const Scene back = scene(p, q, {{}, {}, HalfAngleRotation{{0, -1}}}, 1);
  expect(back, Touch::open, Verdict::free);
}

/// Both turn alike, and so do not turn against one another.
TEST(ExactOracle, TurnsTogether) {
  for (const Rotation& r : {Rotation{AngleRotation{{0, 3}}}, Rotation{HalfAngleRotation{{0, 1}}},
                            Rotation{DirectionRotation{{1, 1}, {0, 2}}}, Rotation{CosineRotation{{1, -1}}}}) {
    Scene s = scene(square, square, {{2}, {}, r, INFINITY, {-2, 0}}, 1);
    s.bodies[0].motion = {{MotionPiece{{}, {}, r}}};
    // In P's frame, Q is at (2, 0) at the start, and then somewhere on a circle about P.
    const ExactAnswer a = first_contact(s, Touch::closed);
    ASSERT_EQ(a.verdict, Verdict::contact);
    EXPECT_FALSE(a.assumed);
    s.bodies[1].motion.pieces[0] = {{}, {}, r};
    for (Point& v : s.bodies[1].polygon) v.x += 2;
    expect(s, Touch::open, Verdict::free);
    EXPECT_FALSE(first_contact(s, Touch::open).assumed);
  }
}

/// The tip of a needle turns down along the wall of a notch and is, by a term of fifth order, 5e-57 inside of the
/// wall's corner for a moment. The tip of the displaced needle is farther back than that: not for the oracle to say.
TEST(ExactOracle, OverlapsByLessThanTheDisplacementAreBeyondIt) {
  const double e = 5.7220458984375e-06;
  const Polygon p{{3, -3}, {6, -6},  {6 - 2 * e, -6 - 2 * e}, {-3 - 2 * e, 3 - 2 * e}, {-3, 3},
                  {0, 0},  {-e, -e}, {3 - e, -3 - e}};
  const Polygon needle{{-6, 6}, {0, 0}, {-3 + e, 3 + e}};
  const Coefficients right{3, 0, 0, 0, 0, 6 + 2 * e}, down{-3, 0, 0, 0, 0, -6 + 2 * e};
  const CosineRotation turn{{-1, 2}};
  const Point pivot{-3 + e, 3 + e};
  expect(scene(p, needle, {right, down, turn, INFINITY, pivot}, 1), Touch::open, Verdict::beyond);
  // By a term of first order it is seen.
  expect_contact(scene(p, needle, {{3, 1}, {-3, -1}, turn, INFINITY, pivot}, 1), Touch::open, 3.637978807078478e-12);
}

/// Corner on corner, but for a term of fifth order: they miss each other by 1e-62 of a unit. Larger bodies by the
/// displacement touch there, those as they are touch later.
TEST(ExactOracle, MissesByLessThanTheDisplacementAreBeyondIt) {
  const double e = 1.430511474609375e-06;
  const Polygon p{{e, 0}, {0, 0}, {0, 7}, {2 * e, 7}, {2 * e, -14}, {0, -14}, {0, -7}, {e, -7}};
  const Polygon q{{e, -7}, {0, -14}, {0, 0}, {e, 7}, {2 * e, 0}, {2 * e, -14}};
  const Coefficients right{-3 * e, 13 * e, -22 * e, 18 * e, -7 * e, e}, up{-14, 35, -70, 70, -35, 7};
  Scene s = scene(p, q, {right, up, CosineRotation{{0, -1}}, INFINITY, Point{0, -14}}, 1);
  s.bodies[0].motion.pieces = {{{}, {}, CosineRotation{{1, 0, -2}}, INFINITY, Point{2 * e, -14}}};
  expect(s, Touch::closed, Verdict::beyond);
}

/// A needle's tip comes to a corner that turns away with nearly infinite speed, and meets the face beside it 9e-48 from
/// the corner. Displaced, by far less, it meets the other face, 2e-55 earlier.
TEST(ExactOracle, NamesWhatMayMeetWhenDisplaced) {
  const double e = 1.430511474609375e-06;
  Scene s = scene({{-7, 7},
                   {-7 + e, 7 + e},
                   {-14 + e, 14 + e},
                   {-14 - e, 14 - e},
                   {7 - e, -7 - e},
                   {7 + e, -7 + e},
                   {e, e},
                   {0, 0}},
                  {{9, 0x1p-14}, {0, 0}, {18, 0}}, {{}, {}, CosineRotation{{0, 2, -1}}, INFINITY, {18, 0}}, 1);
  s.bodies[0].motion = {
      {MotionPiece{{18, 7, 0, 0, -7}, {0, -7, 0, 0, 7}, CosineRotation{{-1, 1}}, INFINITY, {-7 + e, 7 + e}}}};
  const ExactAnswer a = first_contact(s, Touch::closed);
  ASSERT_EQ(a.verdict, Verdict::contact);
  EXPECT_TRUE(meets(a, 1, 2, 1));
  EXPECT_TRUE(meets(a, 1, 2, 2));
  EXPECT_FALSE(meets(a, 1, 2, 4));
}

/// Wedges of half a degree that slide face along face.
TEST(ExactOracle, Blades) {
  const Polygon q{{10, 0}, {0, 0}, {10, -0.2}};
  const Scene chain = scene({{0, 0}, {0.25, 0}, {0.5, 0}, {0.75, 0}, {10, 0}, {0, 0.2}}, q, way({12, -1}), 20);
  expect(chain, Touch::open, Verdict::free);
  const Polygon p{{0, 0}, {10, 0}, {0, 0.2}};
  expect_contact(scene(p, q, way({10.25, -1, 0.5}), 2), Touch::closed, 1 - std::sqrt(0.5));
  expect_contact(scene(p, q, way({12, -1}), 20), Touch::closed, 2);
}

TEST(ExactOracle, JumpsAtJointsAreBridged) {
  const double gap = 0x1p-30;
  // Q rests beside P, jumps through its face by a hair, and rests there.
  Scene s = scene(square, square, way({2}), 2);
  s.bodies[1].motion.pieces[0].until = 1;
  s.bodies[1].motion.pieces.push_back(way({2 - gap}));
  expect_contact(s, Touch::open, 1, 0);
  s.bodies[1].motion.pieces[1] = way({2 + gap});
  expect(s, Touch::open, Verdict::free);
}

void mirror(Scene& s) {
  for (Body& body : s.bodies) {
    for (Point& v : body.polygon) v.y = -v.y;
    for (MotionPiece& piece : body.motion.pieces) {
      piece.pivot.y = -piece.pivot.y;
      const auto negate = [](Coefficients& c) {
        for (double& x : c) x = -x;
      };
      negate(piece.y);
      if (auto* r = std::get_if<AngleRotation>(&piece.rotation)) negate(r->angle);
      if (auto* r = std::get_if<HalfAngleRotation>(&piece.rotation)) negate(r->s);
      if (auto* r = std::get_if<DirectionRotation>(&piece.rotation)) negate(r->b);
    }
  }
}

bool has_cosine(const Scene& s) {
  for (const Body& body : s.bodies) {
    for (const MotionPiece& piece : body.motion.pieces) {
      if (std::holds_alternative<CosineRotation>(piece.rotation)) return true;
    }
  }
  return false;
}

void expect_same(const ExactAnswer& a, const ExactAnswer& b) {
  ASSERT_EQ(a.verdict, b.verdict) << a.why << b.why;
  if (a.verdict != Verdict::contact) return;
  EXPECT_FALSE(a.time.before(b.time) || b.time.before(a.time));
  EXPECT_EQ(a.multiplicity, b.multiplicity);
  EXPECT_EQ(a.meetings.size(), b.meetings.size());
}

TEST(ExactOracle, ExchangedAndMirrored) {
  for (std::uint64_t k = 0; k < effort(150); ++k) {
    SCOPED_TRACE(k);
    const ContactScene c = contact_scene(k);
    try {
      validate(c.scene);
    } catch (const std::exception&) {
      continue;
    }
    const ExactAnswer a = first_contact(c.scene, c.touch);
    Scene other = c.scene;
    std::swap(other.bodies[0], other.bodies[1]);
    expect_same(a, first_contact(other, c.touch));
    if (has_cosine(c.scene)) continue;
    mirror(other);
    expect_same(a, first_contact(other, c.touch));
  }
}

/// Backwards from just before the first contact there is none.
TEST(ExactOracle, Reversed) {
  const auto flip = [](Coefficients& c) {
    for (std::size_t k = 1; k < c.size(); k += 2) c[k] = -c[k];
  };
  int reversed = 0;
  for (std::uint64_t k = 0; k < effort(150); ++k) {
    SCOPED_TRACE(k);
    ContactScene c = contact_scene(k);
    if (c.family != "slides" && c.family != "blades") continue;
    const ExactAnswer a = first_contact(c.scene, c.touch);
    if (a.verdict == Verdict::contact) {
      if (!(a.time.lo() - 1e-9 > c.scene.start)) continue;
      c.scene.end = a.time.lo() - 1e-9;
    } else if (a.verdict != Verdict::free) {
      continue;
    }
    for (Body& body : c.scene.bodies) {
      for (MotionPiece& piece : body.motion.pieces) {
        flip(piece.x);
        flip(piece.y);
      }
    }
    std::swap(c.scene.start, c.scene.end);
    c.scene.start = -c.scene.start;
    c.scene.end = -c.scene.end;
    ++reversed;
    EXPECT_EQ(first_contact(c.scene, c.touch).verdict, Verdict::free);
  }
  EXPECT_GT(reversed, static_cast<int>(enough(15)));
}

}  // namespace
}  // namespace taut::testing::exact
