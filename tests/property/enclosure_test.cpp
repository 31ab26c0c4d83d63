// The time of a contact is between the two bounds that the answer gives: the vertex is on one side of the edge's line
// at the first and on the other side at the second, by the definition of the motions in 2,000 bits. Shared with the
// library are the pieces of the motions and the displaced vertices, as numbers.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "scene/body_pair.hpp"
#include "support/effort.hpp"
#include "support/exact_motion.hpp"
#include "support/exact_roots.hpp"
#include "support/rng.hpp"
#include "taut/check.hpp"

namespace taut::testing {
using namespace internal;
namespace {

using exact::BodyMotion;
using exact::Precision;
using exact::Wide;

/// Convex, counterclockwise, about the origin.
Polygon any_polygon(Rng& rng) {
  const int n = rng.between(3, 6);
  const bool round = rng.chance(0.5);
  Polygon polygon;
  for (int k = 0; k < n; ++k) {
    const double angle = 2 * std::numbers::pi * (k + rng.real(-0.3, 0.3)) / n;
    const Point v{std::cos(angle), std::sin(angle)};
    polygon.push_back(round ? Point{std::round(v.x * 64) / 64, std::round(v.y * 64) / 64} : v);
  }
  return polygon;
}

Coefficients random_coefficients(Rng& rng, int degree, double size) {
  Coefficients c;
  for (int k = 0; k <= degree; ++k) c.push_back(rng.chance(0.2) ? rng.between(-2, 2) : rng.real(-size, size));
  return c;
}

/// Sines and cosines of 2,000 bits take their time: fewer of those.
Rotation any_rotation(Rng& rng) {
  const int choice = rng.below(16);
  if (choice < 10) return NoRotation{};
  if (choice < 12) return HalfAngleRotation{random_coefficients(rng, rng.below(3), 2)};
  if (choice < 14) return CosineRotation{{rng.real(-0.3, 0.3), rng.real(-0.3, 0.3), rng.real(-0.3, 0.3)}};
  if (choice < 15) return AngleRotation{random_coefficients(rng, rng.below(3), 3)};
  DirectionRotation r{random_coefficients(rng, rng.below(3), 1), random_coefficients(rng, rng.below(3), 1)};
  r.a[0] = rng.sign() * 4;
  return r;
}

/// On [0, 1], from `from` to about `to`.
Motion any_motion(Rng& rng, const Point& from, const Point& to) {
  const int degree = rng.chance(0.6) ? 1 : rng.between(2, 4);
  MotionPiece piece{random_coefficients(rng, degree, 0.5), random_coefficients(rng, degree, 0.5), any_rotation(rng)};
  piece.x[0] = from.x;
  piece.y[0] = from.y;
  piece.x[1] = to.x - from.x;
  piece.y[1] = to.y - from.y;
  if (rng.chance(0.2)) piece.pivot = {rng.real(-1, 1), double(rng.between(-1, 1))};
  Motion motion;
  motion.pieces.push_back(piece);
  return motion;
}

Scene any_scene(Rng& rng) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].polygon = any_polygon(rng);
  scene.bodies[1].polygon = any_polygon(rng);
  if (rng.chance(0.5)) scene.bodies[0].motion = any_motion(rng, {0, 0}, {rng.real(-1, 1), rng.real(-1, 1)});
  const double angle = rng.real(-4, 4);
  scene.bodies[1].motion = any_motion(rng, {4 * std::cos(angle), 4 * std::sin(angle)}, {rng.real(-1, 1), 0});
  scene.start = 0;
  scene.end = 1;
  return scene;
}

struct Place {
  Wide x, y;
};

/// Where the motion puts a vertex of the displaced polygon.
Place place(const MotionPiece& piece, const DisplacedPoint& v, const Wide& t) {
  const auto body = BodyMotion::of(piece, {0, 1}, 0, 1);
  const exact::Pose<Wide, 2> pose = body->pose<Wide, 2>(t);
  const Wide one(1.0), below = one / pose.below.c[0];
  const Wide c = pose.x.c[0] * below, s = pose.y.c[0] * below;
  const Wide x = Wide(v.x) + Wide(v.dx) - Wide(body->pivot_point().x);
  const Wide y = Wide(v.y) + Wide(v.dy) - Wide(body->pivot_point().y);
  return {pose.ox.c[0] + (x * c - y * s), pose.oy.c[0] + (x * s + y * c)};
}

/// The vertex of a feature in the pair's own numbers.
VertexId vertex_of(const BodyPair& bodies, int body, int index, bool edge) {
  const std::size_t side = bodies.body(Role::p) == body ? 0 : 1;
  const RingMap& map = bodies.rings[side]->rings()[0];
  const auto before = static_cast<std::uint32_t>(side == 0 ? 0 : bodies.rings[0]->size());
  for (std::uint32_t k = 0; k < map.size; ++k) {
    if ((edge ? map.edge(k) : map.vertex(k)) == index) return VertexId(before + k);
  }
  return VertexId();
}

/// The side of the edge's line on which the vertex is at t: positive inside.
int side_at(const BodyPair& bodies, const PairGeometry& g, const Contact& contact, double t) {
  const Precision precision(2000);
  const VertexId a = vertex_of(bodies, contact.edge.body, contact.edge.index, true), b = g.next(a);
  const VertexId c = vertex_of(bodies, contact.vertex.body, contact.vertex.index, false);
  const auto at = [&](VertexId v) { return place(bodies.motions[g.in_p(v) ? 0 : 1][0][0], g.point(v), Wide(t)); };
  const Place pa = at(a), pb = at(b), pc = at(c);
  return ((pb.x - pa.x) * (pc.y - pa.y) - (pb.y - pa.y) * (pc.x - pa.x)).sign();
}

TEST(Enclosure, OfAContactContainsItsRoot) {
  std::uint64_t contacts = 0, sharp = 0;
  for (std::uint64_t seed = 0; contacts < effort(40000); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    const Scene scene = any_scene(rng);
    CheckOptions options;
    options.touch = rng.chance(0.5) ? Touch::closed : Touch::open;
    options.engine = rng.chance(0.5) ? EngineChoice::kinetic : EngineChoice::spacetime;
    const Answer answer = check(scene, options);
    ASSERT_NE(answer.outcome, Outcome::undecided);
    if (answer.outcome != Outcome::contact) continue;
    const TimeInterval& time = answer.contact->time;
    const BodyPair bodies = pair_of(scene);
    const PairGeometry geometry = displaced_pair(bodies, offset_for(options.touch));
    ASSERT_EQ(bodies.motions[0][0].size() * bodies.motions[1][0].size(), 1u);
    ++contacts;
    ASSERT_LE(time.lo, time.hi);
    ASSERT_LE(side_at(bodies, geometry, *answer.contact, time.lo), 0);
    ASSERT_GE(side_at(bodies, geometry, *answer.contact, time.hi), 0);
    sharp += time.hi - time.lo <= 0x1p-46;
  }
  EXPECT_GT(sharp, contacts - contacts / 16);
}

}  // namespace
}  // namespace taut::testing
