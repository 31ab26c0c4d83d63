// What must not change the answer: running time backwards, swapping the bodies, scaling by powers of two, moving.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "numeric/exact_sum.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "taut/check.hpp"

namespace taut::testing {
using namespace internal;
namespace {

constexpr Family moving_families[] = {Family::apart, Family::intertwined, Family::nested, Family::corridor,
                                      Family::combs, Family::stars,       Family::convex};

void flip_time(Coefficients& c) {
  for (std::size_t k = 1; k < c.size(); k += 2) c[k] = -c[k];
}

/// The motion at time -t: exact, for coefficients only change sign.
MotionPiece reversed(MotionPiece piece) {
  flip_time(piece.x);
  flip_time(piece.y);
  if (auto* r = std::get_if<AngleRotation>(&piece.rotation)) flip_time(r->angle);
  if (auto* r = std::get_if<HalfAngleRotation>(&piece.rotation)) flip_time(r->s);
  if (auto* r = std::get_if<CosineRotation>(&piece.rotation)) flip_time(r->a);
  if (auto* r = std::get_if<DirectionRotation>(&piece.rotation)) {
    flip_time(r->a);
    flip_time(r->b);
  }
  return piece;
}

Scene reversed(const Scene& scene) {
  Scene out = scene;
  out.start = -scene.end;
  out.end = -scene.start;
  for (Body& body : out.bodies) {
    std::vector<MotionPiece> pieces;
    for (std::size_t k = body.motion.pieces.size(); k-- > 0;) {
      pieces.push_back(reversed(body.motion.pieces[k]));
      pieces.back().origin = -body.motion.pieces[k].origin;
      pieces.back().until = k == 0 ? INFINITY : -body.motion.pieces[k - 1].until;
    }
    body.motion.pieces = pieces;
  }
  return out;
}

Scene scaled(const Scene& scene, int exponent) {
  Scene out = scene;
  for (Body& body : out.bodies) {
    for (Point& v : body.polygon) v = {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent)};
    for (MotionPiece& piece : body.motion.pieces) {
      for (double& c : piece.x) c = std::ldexp(c, exponent);
      for (double& c : piece.y) c = std::ldexp(c, exponent);
    }
  }
  return out;
}

/// Both bodies moved by (dx, dy); nothing if that is not exact.
std::optional<Scene> moved(const Scene& scene, double dx, double dy) {
  Scene out = scene;
  for (Body& body : out.bodies) {
    if (body.motion.pieces.empty()) body.motion.pieces.emplace_back();
    for (MotionPiece& piece : body.motion.pieces) {
      for (auto [c, d] : {std::pair{&piece.x, dx}, std::pair{&piece.y, dy}}) {
        if (c->empty()) c->push_back(0);
        const TwoDoubles sum = two_sum((*c)[0], d);
        if (sum.lo != 0) return std::nullopt;
        (*c)[0] = sum.hi;
      }
    }
  }
  return out;
}

template <class Run>
void for_scenes(std::uint64_t seeds, const Run& run) {
  for (std::uint64_t seed = 0; seed < effort(seeds); ++seed) {
    for (const Family family : moving_families) {
      SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed));
      run(random_scene(1000 + seed, family));
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

/// By the engine whose events have symmetries, too.
Answer by_tiling(const Scene& scene) {
  CheckOptions options;
  options.engine = EngineChoice::kinetic;
  return check(scene, options);
}

TEST(Symmetry, ScalingByPowersOfTwoChangesNothing) {
  for_scenes(25, [](const Scene& scene) {
    const Answer a = by_tiling(scene);
    for (const int exponent : {-80, 3, 120}) {
      const Answer b = by_tiling(scaled(scene, exponent));
      ASSERT_EQ(a.outcome, b.outcome);
      ASSERT_EQ(a.events, b.events);
      if (!a.contact) continue;
      EXPECT_EQ(a.contact->time.lo, b.contact->time.lo);
      EXPECT_EQ(a.contact->time.hi, b.contact->time.hi);
      EXPECT_EQ(a.contact->vertex.index, b.contact->vertex.index);
      EXPECT_EQ(std::ldexp(a.contact->point.x, exponent), b.contact->point.x);
    }
  });
}

TEST(Symmetry, SwappingTheBodiesSwapsTheFeatures) {
  int contacts = 0;
  for_scenes(40, [&](const Scene& scene) {
    Scene other = scene;
    std::swap(other.bodies[0], other.bodies[1]);
    const Answer a = by_tiling(scene), b = by_tiling(other);
    ASSERT_EQ(a.outcome, b.outcome);
    if (!a.contact) return;
    ++contacts;
    EXPECT_NEAR(a.contact->time.lo, b.contact->time.lo, 1e-12);
    EXPECT_EQ(a.contact->vertex.body, 1 - b.contact->vertex.body);
    EXPECT_EQ(a.contact->vertex.index, b.contact->vertex.index);
    EXPECT_EQ(a.contact->edge.index, b.contact->edge.index);
  });
  EXPECT_GT(contacts, static_cast<int>(enough(50)));
}

TEST(Symmetry, MovingTheWholeScene) {
  int compared = 0;
  for_scenes(40, [&](const Scene& scene) {
    const auto other = moved(scene, 1048576.0, -3145728.0);
    if (!other) return;
    const Answer a = by_tiling(scene), b = by_tiling(*other);
    ASSERT_EQ(a.outcome, b.outcome);
    ++compared;
    if (!a.contact) return;
    EXPECT_NEAR(a.contact->time.lo, b.contact->time.lo, 1e-12);
    EXPECT_EQ(a.contact->vertex.index, b.contact->vertex.index);
    EXPECT_EQ(a.contact->edge.index, b.contact->edge.index);
  });
  EXPECT_GT(compared, static_cast<int>(enough(30)));
}

TEST(Symmetry, TimeReversal) {
  int free = 0, contacts = 0;
  for_scenes(40, [&](const Scene& scene) {
    const Answer a = by_tiling(scene);
    if (a.outcome == Outcome::free) {
      ++free;
      const Answer b = by_tiling(reversed(scene));
      ASSERT_EQ(b.outcome, Outcome::free);
      // Every failure is undone in reverse: reflex events become convex ones and vice versa.
      EXPECT_EQ(a.events, b.events);
    } else if (a.contact && a.contact->time.lo > 1e-3) {
      ++contacts;
      Scene before = scene;
      before.end = a.contact->time.lo * (1 - 1e-9);
      ASSERT_EQ(by_tiling(reversed(before)).outcome, Outcome::free);
    }
  });
  EXPECT_GT(free, static_cast<int>(enough(50)));
  EXPECT_GT(contacts, static_cast<int>(enough(50)));
}

/// Smaller sets touch later: outwards no later than inwards.
TEST(Symmetry, ClosedTouchesNoLaterThanOpen) {
  for_scenes(40, [](const Scene& scene) {
    const Answer open = by_tiling(scene);
    CheckOptions options;
    options.touch = Touch::closed;
    const Answer closed = check(scene, options);
    if (open.contact) {
      ASSERT_TRUE(closed.contact);
      EXPECT_LE(closed.contact->time.lo, open.contact->time.hi);
    }
    if (closed.outcome == Outcome::free) {
      ASSERT_EQ(open.outcome, Outcome::free);
    }
  });
}

}  // namespace
}  // namespace taut::testing
