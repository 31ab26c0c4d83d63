// A body is the union of its parts: cut into touching parts, or given by overlapping ones, it has the same answers to
// every question, and is shrunk as a whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "geometry/predicates.hpp"
#include "geometry/region_union.hpp"
#include "scene/fitted_scene.hpp"
#include "support/effort.hpp"
#include "support/small_world.hpp"
#include "support/world_changes.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/motions.hpp"
#include "taut/outline.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// How often a ring winds around a point, by angles.
int winding_of(const Polygon& ring, const Point& p) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const Complex from(a.x - p.x, a.y - p.y), to(b.x - p.x, b.y - p.y);
    sum += std::arg(to / from);
  }
  return static_cast<int>(std::lround(sum / 6.283185307179586));
}

TEST(Union, IsWhatIsWoundAround) {
  int points = 0, changed = 0;
  for (std::uint64_t seed = 0; seed < effort(2000); ++seed) {
    Rng rng(seed);
    std::vector<Polygon> rings;
    for (int n = rng.between(1, 4); n-- > 0;) {
      Polygon& ring = rings.emplace_back();
      for (int k = rng.between(3, 8); k-- > 0;) ring.push_back({rng.real(-4, 4), rng.real(-4, 4)});
    }
    const std::optional<RingUnion> joined = union_of(rings);
    ASSERT_TRUE(joined);
    changed += joined->changed;
    std::vector<Polygon> boundary;
    for (const auto& ring : joined->rings) {
      Polygon& polygon = boundary.emplace_back();
      for (const UnionVertex& v : ring) polygon.push_back(v.at);
    }
    for (int i = 0; i < 20; ++i) {
      const Point p{rng.real(-4, 4), rng.real(-4, 4)};
      int given = 0, found = 0;
      for (const Polygon& ring : rings) given += winding_of(ring, p);
      for (const Polygon& ring : boundary) found += winding_of(ring, p);
      ASSERT_EQ(found, given > 0 ? 1 : 0) << "seed " << seed;
      ++points;
    }
  }
  EXPECT_GT(changed, static_cast<int>(enough(1000)));
  EXPECT_GT(points, static_cast<int>(enough(10000)));
}

bool is_in(const Body& body, const Point& p) {
  const std::vector<Part> parts = body.parts.empty() ? std::vector<Part>{{body.polygon, {}}} : body.parts;
  return std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
    return side_of_ring(part.outline, p) > 0 &&
           std::none_of(part.holes.begin(), part.holes.end(), [&](const Polygon& h) { return side_of_ring(h, p) > 0; });
  });
}

double distance_to_boundary(const Body& whole, const Point& p) {
  double least = INFINITY;
  for (const Part& part : whole.parts) {
    for (std::size_t r = 0; r <= part.holes.size(); ++r) {
      const Polygon& ring = r == 0 ? part.outline : part.holes[r - 1];
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        least = std::min(least, to_segment({p.x, p.y}, {a.x, a.y}, {b.x, b.y}));
      }
    }
  }
  return least;
}

/// Cut bodies, and then, of some, the whole besides one of its pieces.
MadeWorld in_parts(Rng& rng, const MadeWorld& world, bool overlapping, int& count) {
  MadeWorld pieces = cut_at_seams(rng, world, count);
  for (std::size_t i = 0; overlapping && i < pieces.bodies.size(); ++i) {
    if (pieces.bodies[i].parts.size() != world.bodies[i].parts.size())
      pieces.bodies[i].parts[0] = world.bodies[i].parts[0];
  }
  return pieces;
}

/// In it are all points that lie deeper than twice the fit, and none that lie less deep than the fit.
TEST(Union, IsShrunkAsAWhole) {
  int cut = 0, deep = 0, shallow = 0, refused = 0;
  for (std::uint64_t number = 0; number < effort(400); ++number) {
    SCOPED_TRACE("world " + std::to_string(number));
    Rng rng(number);
    const MadeWorld world = small_world(number).world;
    const Scene whole = scene_of(world), pieces = scene_of(in_parts(rng, world, rng.chance(0.5), cut));
    const double fit = std::ldexp(1.0, -rng.between(5, 25));
    Scene shrunk;
    try {
      FittedScene(whole, fit);
    } catch (const InputError&) {
      continue;
    }
    try {
      shrunk = FittedScene(pieces, fit).scene();
    } catch (const InputError&) {
      ++refused;
      continue;
    }
    for (std::size_t i = 0; i < whole.bodies.size(); ++i) {
      const Body& given = whole.bodies[i];
      if (given.parts.size() != 1 || pieces.bodies[i].parts.size() < 2) continue;
      // Beside the edges of the pieces, seams among them.
      for (const Part& part : pieces.bodies[i].parts) {
        for (std::size_t k = 0; k < part.outline.size(); ++k) {
          const Point &a = part.outline[k], &b = part.outline[(k + 1) % part.outline.size()];
          const double share = rng.real(0, 1);
          const Point p{a.x + share * (b.x - a.x) + fit * rng.real(-4, 4),
                        a.y + share * (b.y - a.y) + fit * rng.real(-4, 4)};
          const bool inside = is_in(given, p), found = is_in(shrunk.bodies[i], p);
          const double depth = distance_to_boundary(given, p);
          // A sharp corner recedes by more than its edges.
          if (inside && depth > 40 * fit) {
            EXPECT_TRUE(found);
            ++deep;
          }
          if (!inside || depth < fit) {
            EXPECT_FALSE(found);
            ++shallow;
          }
        }
      }
    }
  }
  EXPECT_GT(deep, static_cast<int>(enough(100)));
  EXPECT_GT(shallow, static_cast<int>(enough(500)));
  EXPECT_LT(refused, static_cast<int>(effort(400)) / 20);
}

bool at_one_time(const TimeInterval& a, const TimeInterval& b) { return a.lo <= b.hi + 1e-9 && b.lo <= a.hi + 1e-9; }

void expect_same_answer(const Answer& whole, const Answer& parts) {
  ASSERT_EQ(whole.outcome, parts.outcome) << parts.reason;
  if (whole.contact) {
    EXPECT_TRUE(at_one_time(whole.contact->time, parts.contact->time));
  }
}

void expect_same_questions(const Scene& whole, const Scene& parts, const CheckOptions& options) {
  expect_same_answer(check(whole, options), check(parts, options));
  const Intervals a = intervals(whole, options), b = intervals(parts, options);
  ASSERT_EQ(a.intervals.size(), b.intervals.size());
  for (std::size_t i = 0; i < a.intervals.size(); ++i) {
    EXPECT_TRUE(at_one_time(a.intervals[i].from, b.intervals[i].from));
    EXPECT_TRUE(at_one_time(a.intervals[i].to, b.intervals[i].to));
  }
  const MarginAnswer close = check_clearance(whole, 0.25, options), other = check_clearance(parts, 0.25, options);
  ASSERT_EQ(close.outcome, other.outcome);
  if (close.outcome == Outcome::contact) {
    EXPECT_TRUE(at_one_time(close.first->time, other.first->time));
  }
  std::stringstream log;
  const Answer proved = prove(parts, log, options);
  expect_same_answer(check(whole, options), proved);
  if (proved.outcome == Outcome::free || proved.outcome == Outcome::contact) {
    EXPECT_EQ(verify(parts, log).outcome, proved.outcome);
  }
}

TEST(Union, HasTheSameAnswersInPartsAndAsAWhole) {
  int cut = 0;
  for (std::uint64_t number = 0; number < effort(300); ++number) {
    SCOPED_TRACE("world " + std::to_string(number));
    Rng rng(number);
    const MadeWorld world = small_world(number).world;
    const Scene whole = scene_of(world), parts = scene_of(in_parts(rng, world, rng.chance(0.5), cut));
    CheckOptions options;
    options.touch = rng.chance(0.5) ? Touch::open : Touch::closed;
    options.engine = rng.chance(0.5) ? EngineChoice::kinetic : EngineChoice::spacetime;
    expect_same_questions(whole, parts, options);
    const Clearance a = clearance(whole), b = clearance(parts);
    if (a.nearest && b.nearest) {
      EXPECT_LE(a.nearest->lo, b.nearest->hi + 1e-9);
      EXPECT_LE(b.nearest->lo, a.nearest->hi + 1e-9);
    }
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GT(cut, static_cast<int>(enough(200)));
}

/// Smaller bodies meet later: with half the fit no later than with it, and with twice the fit no earlier.
TEST(Union, ShrunkMeetsWhenTheWholeDoes) {
  int cut = 0, compared = 0;
  for (std::uint64_t number = 0; number < effort(400); ++number) {
    SCOPED_TRACE("world " + std::to_string(number));
    Rng rng(number);
    const MadeWorld world = small_world(number).world;
    const Scene whole = scene_of(world), parts = scene_of(in_parts(rng, world, rng.chance(0.5), cut));
    const auto first = [](const Scene& scene, double fit) {
      CheckOptions options;
      options.fit = fit;
      const Answer answer = check(scene, options);
      return answer.outcome == Outcome::free || answer.outcome == Outcome::untested ? TimeInterval{INFINITY, INFINITY}
             : answer.outcome == Outcome::overlap_at_start                          ? TimeInterval{-INFINITY, -INFINITY}
                                                                                    : answer.contact.value().time;
    };
    const double fit = std::ldexp(1.0, -rng.between(6, 25));
    try {
      const TimeInterval less = first(whole, fit / 2), same = first(parts, fit), more = first(whole, 2 * fit);
      EXPECT_LE(less.lo, same.hi);
      EXPECT_LE(same.lo, more.hi);
      ++compared;
    } catch (const InputError&) {
      // Finer than the fit.
    }
  }
  EXPECT_GT(compared, static_cast<int>(enough(200)));
}

/// A bar comes through the middle of a wall of two parts: where they touch, where they overlap, and where a third one
/// fills a hole.
TEST(Union, NoSeamOpens) {
  const auto block = [](double x, double y, double w, double h) {
    return Polygon{{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
  };
  const std::vector<std::vector<Part>> walls{
      {{block(-5, 0, 10, 2), {}}, {block(-5, -2, 10, 2), {}}},
      {{block(-5, -0.01, 10, 2), {}}, {block(-5, -2, 10, 2), {}}},
      {{block(-5, -2, 10, 4), {block(-4, -1, 8, 2)}}, {block(-4, -1, 8, 2), {}}},
      {{block(-5, -2, 10, 4), {}}, {block(-5, -2, 10, 4), {}}},
      {{block(-5, 0, 10, 2), {}}, {block(-5, -2, 4, 2), {}}, {block(-1, -2, 6, 2), {}}}};
  for (const std::vector<Part>& parts : walls) {
    Scene scene;
    scene.end = 20;
    scene.bodies = {{"wall", {}, {}}, {"bar", block(7, -0.25, 2, 0.5), from_velocity({-1, 0})}};
    scene.bodies[0].parts = parts;
    CheckOptions options;
    options.fit = 0.1;
    const Answer answer = check(scene, options);
    ASSERT_EQ(answer.outcome, Outcome::contact);
    EXPECT_GE(answer.contact->time.lo, 2.2);
    EXPECT_LE(answer.contact->time.hi, 2.4);
  }
}

/// Halves of a disc, and a plate whose hole a disc fills: the seam is a line, and a curve.
TEST(Union, NoSeamOfCurvesOpens) {
  const std::vector<std::vector<std::string>> shapes{
      {"M -5 0 A 5 5 0 0 1 5 0 Z", "M 5 0 A 5 5 0 0 1 -5 0 Z"},
      {"M -5 -2 H 5 V 2 H -5 Z M -1 0 A 1 1 0 0 1 1 0 A 1 1 0 0 1 -1 0 Z",
       "M -1 0 A 1 1 0 0 1 1 0 A 1 1 0 0 1 -1 0 Z"}};
  for (const std::vector<std::string>& paths : shapes) {
    Scene scene;
    scene.end = 20;
    scene.bodies = {{"solid", {}, {}}, {"bar", {{7, -0.25}, {9, -0.25}, {9, 0.25}, {7, 0.25}}, from_velocity({-1, 0})}};
    for (const std::string& path : paths) scene.bodies[0].curves.push_back(parse_path(path).at(0));
    for (const double fit : {0.03, 1e-3}) {
      CheckOptions options;
      options.fit = fit;
      const Answer answer = check(scene, options);
      ASSERT_EQ(answer.outcome, Outcome::contact);
      EXPECT_GE(answer.contact->time.lo, 2 + 2 * fit);
      EXPECT_LE(answer.contact->time.hi, 2 + 4.5 * fit);
    }
    // Nothing is in the hole that is filled.
    scene.bodies[1].polygon = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
    CheckOptions small;
    small.fit = 0.03;
    EXPECT_EQ(check(scene, small).outcome, Outcome::overlap_at_start);
  }
}

}  // namespace
}  // namespace taut::testing
