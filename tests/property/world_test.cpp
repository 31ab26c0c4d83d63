// Worlds of many bodies against their definition: bodies are posed and compared by arithmetic that shares nothing with
// the library, and the same world told in other words has the same answer.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <sstream>
#include <string>
#include <vector>

#include "support/effort.hpp"
#include "support/every_pair.hpp"
#include "support/exact_oracle.hpp"
#include "support/made_world.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "support/world_changes.hpp"
#include "taut/check.hpp"
#include "taut/motions.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

/// Asked about, as far as the list of ignored pairs goes.
bool not_ignored(const MadeWorld& world, int a, int b) {
  return std::none_of(world.ignore.begin(), world.ignore.end(), [&](const std::array<int, 2>& pair) {
    const auto names = [&](int i, int k) { return pair[0] == i && (pair[1] == k || pair[1] < 0); };
    const auto other_way = [&](int i, int k) { return pair[1] == i && pair[0] < 0 && i != k; };
    return names(a, b) || names(b, a) || other_way(a, b) || other_way(b, a);
  });
}

/// Do they never move against each other, however that is written?
bool move_alike(const MadeWorld& world, int a, int b) {
  for (const double t : {0.0, 0.31, 0.9, 1.3, 1.7, 2.1, 2.6, 2.9, 3.3, 4.0}) {
    const MadePose p = pose_of(world, a, t), q = pose_of(world, b, t);
    if (std::abs(p.o - q.o) > 1e-9 || std::abs(p.x - q.x) > 1e-9) return false;
  }
  return true;
}

bool all_move_alike(const MadeWorld& world) {
  bool all = true;
  for (int b = 1; b < static_cast<int>(world.bodies.size()); ++b) all = all && move_alike(world, 0, b);
  return all;
}

struct WorldCounts {
  int free = 0, contact = 0, overlap = 0, entered = 0;
};

Complex vertex_at(const BodyAtPose& body, int part, int ring, int index) {
  const RingAtPose& points = body[static_cast<std::size_t>(part)].rings[static_cast<std::size_t>(ring)];
  return points[static_cast<std::size_t>(index) % points.size()];
}

/// The vertex lies on the edge, and the two bodies are those of the pair.
void expect_witness(const MadeWorld& world, const std::array<BodyId, 2>& pair, const Contact& contact) {
  const int v = contact.vertex.body, e = contact.edge.body;
  EXPECT_TRUE((v == pair[0] && e == pair[1]) || (v == pair[1] && e == pair[0]));
  const double t = contact.time.lo + (contact.time.hi - contact.time.lo) / 2;
  const BodyAtPose vertex = posed(world, v, t), edge = posed(world, e, t);
  const VertexRef& at = contact.vertex;
  const EdgeRef& on = contact.edge;
  const double distance =
      to_segment(vertex_at(vertex, at.part, at.ring, at.index), vertex_at(edge, on.part, on.ring, on.index),
                 vertex_at(edge, on.part, on.ring, on.index + 1));
  EXPECT_LE(distance, 1e-8 + 1e3 * (contact.time.hi - contact.time.lo));
}

/// No clear overlap before the answer's time, at many instants and just before it.
void expect_apart_before(const MadeWorld& world, const PairAnswer& pair, WorldCounts& counts) {
  const int a = pair.bodies[0], b = pair.bodies[1];
  if (pair.outcome == Outcome::overlap_at_start) {
    ++counts.overlap;
    const BodyAtPose p = posed(world, a, 0), q = posed(world, b, 0);
    EXPECT_TRUE(overlap_clearly(p, q, 0) || between_rings(p, q) < 1e-9);
    return;
  }
  const bool meets = pair.outcome == Outcome::contact;
  ASSERT_TRUE(meets || pair.outcome == Outcome::free) << pair.reason;
  ++(meets ? counts.contact : counts.free);
  const double until = meets ? pair.contact->time.lo : world.end;
  std::vector<double> instants{until, until - 1e-9, until - 1e-6, until - 1e-3};
  for (int i = 0; i < 48; ++i) instants.push_back(until * i / 48);
  for (const double t : instants) {
    if (t < 0) continue;
    EXPECT_FALSE(overlap_clearly(posed(world, a, t), posed(world, b, t), 1e-7)) << "at " << t;
  }
  if (!meets) return;
  expect_witness(world, pair.bodies, *pair.contact);
  const double after = pair.contact->time.hi + 1e-4;
  if (overlap_clearly(posed(world, a, after), posed(world, b, after), 0)) ++counts.entered;
}

/// Neither ignored pairs, nor of those that are written alike, are asked about; all that move against each other are.
/// Where nothing moves against anything else, all but the ignored ones are.
void expect_all_asked(const MadeWorld& world, const std::vector<PairAnswer>& pairs) {
  const int n = static_cast<int>(world.bodies.size());
  const bool all_alike = all_move_alike(world);
  auto next = pairs.begin();
  for (int a = 0; a < n; ++a) {
    for (int b = a + 1; b < n; ++b) {
      const bool asked = next != pairs.end() && next->bodies == std::array<BodyId, 2>{a, b};
      if (asked) ++next;
      const MadeBody &p = world.bodies[static_cast<std::size_t>(a)], &q = world.bodies[static_cast<std::size_t>(b)];
      const bool rest = p.keyframes.empty() && q.keyframes.empty() && p.parent == q.parent;
      if (!not_ignored(world, a, b) || (!all_alike && rest)) {
        EXPECT_FALSE(asked) << a << " and " << b;
      } else if (all_alike || !move_alike(world, a, b)) {
        EXPECT_TRUE(asked) << a << " and " << b;
      }
    }
  }
  EXPECT_EQ(next, pairs.end());
}

/// The world's answer is that of its first pair.
void expect_earliest(const Answer& headline, const std::vector<PairAnswer>& pairs) {
  double first = INFINITY;
  bool overlap = false;
  for (const PairAnswer& pair : pairs) {
    overlap = overlap || pair.outcome == Outcome::overlap_at_start;
    if (pair.contact) first = std::min(first, pair.contact->time.lo);
  }
  if (overlap) {
    EXPECT_EQ(headline.outcome, Outcome::overlap_at_start);
  } else if (first < INFINITY) {
    ASSERT_EQ(headline.outcome, Outcome::contact);
    EXPECT_NEAR(headline.contact->time.lo, first, 1e-11);
  } else {
    EXPECT_EQ(headline.outcome, pairs.empty() ? Outcome::untested : Outcome::free);
  }
}

Answer answer_to(const Scene& scene, Touch touch = Touch::open, bool all = false) {
  CheckOptions options;
  options.touch = touch;
  options.engine = EngineChoice::spacetime;
  options.all_pairs = all;
  options.tell_touching = false;
  Answer answer = check(scene, options);
  if (all) answer.pairs = every_pair(scene, answer);
  return answer;
}

TEST(Worlds, AnswersFitTheDefinition) {
  WorldCounts counts;
  for (std::uint64_t seed = 0; seed < effort(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MadeWorld world = random_world(seed);
    const Scene scene = scene_of(world);
    const Answer all = answer_to(scene, Touch::open, true);
    ASSERT_TRUE(all.pairs);
    expect_all_asked(world, *all.pairs);
    for (const PairAnswer& pair : *all.pairs) {
      SCOPED_TRACE(scene.bodies[static_cast<std::size_t>(pair.bodies[0])].name + " and " +
                   scene.bodies[static_cast<std::size_t>(pair.bodies[1])].name);
      expect_apart_before(world, pair, counts);
    }
    expect_earliest(all, *all.pairs);
    const Answer alone = answer_to(scene);
    expect_earliest(alone, *all.pairs);
    const Answer closed = answer_to(scene, Touch::closed, true);
    expect_earliest(closed, *closed.pairs);
    ASSERT_EQ(closed.pairs->size(), all.pairs->size());
    for (std::size_t i = 0; i < all.pairs->size(); ++i) {
      const PairAnswer &loose = (*all.pairs)[i], &strict = (*closed.pairs)[i];
      if (!loose.contact) continue;
      ASSERT_TRUE(strict.contact || strict.outcome == Outcome::overlap_at_start);
      if (strict.contact) {
        EXPECT_LE(strict.contact->time.lo, loose.contact->time.hi);
      }
    }
  }
  EXPECT_GE(counts.contact, static_cast<int>(enough(800)));
  EXPECT_GE(counts.free, static_cast<int>(enough(800)));
  EXPECT_GE(counts.overlap, static_cast<int>(enough(10)));
  // Nearly all enter, a few graze.
  EXPECT_GE(counts.entered, counts.contact * 9 / 10);
  RecordProperty("contacts", counts.contact);
}

// The same in other words.

/// Same outcome, times that enclose one instant, and the same bodies.
void expect_same_answer(const Scene& first, const Scene& second, const char* what, Touch touch = Touch::open) {
  SCOPED_TRACE(what);
  const Answer a = answer_to(first, touch), b = answer_to(second, touch);
  if (a.outcome == Outcome::untested) return;  // a far body may be tested
  ASSERT_STREQ(to_string(a.outcome), to_string(b.outcome));
  if (a.outcome == Outcome::free) return;
  if (a.contact) {
    EXPECT_LE(a.contact->time.lo, b.contact->time.hi + 1e-9);
    EXPECT_GE(a.contact->time.hi, b.contact->time.lo - 1e-9);
  }
  // The pair, unless several come together.
  if (a.also.empty() && b.also.empty() && a.pair && b.pair && a.contact) {
    const auto name = [](const Scene& scene, BodyId id) { return scene.bodies[static_cast<std::size_t>(id)].name; };
    std::array<std::string, 2> p{name(first, (*a.pair)[0]), name(first, (*a.pair)[1])},
        q{name(second, (*b.pair)[0]), name(second, (*b.pair)[1])};
    std::sort(p.begin(), p.end());
    std::sort(q.begin(), q.end());
    EXPECT_EQ(p, q);
  }
}

TEST(Worlds, OrderOfBodiesDoesNotMatter) {
  for (std::uint64_t seed = 1000; seed < 1000 + effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = scene_of(random_world(seed));
    Rng rng(seed);
    Scene shuffled = scene;
    for (std::size_t i = shuffled.bodies.size(); i > 1; --i)
      std::swap(shuffled.bodies[i - 1], shuffled.bodies[static_cast<std::size_t>(rng.below(static_cast<int>(i)))]);
    expect_same_answer(scene, shuffled, "shuffled");
  }
}

TEST(Worlds, FarBodiesChangeNothing) {
  for (std::uint64_t seed = 2000; seed < 2000 + effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MadeWorld world = random_world(seed);
    const MadeWorld larger = with_far_bodies(seed, world);
    const Scene scene = scene_of(world);
    // Where nothing moves against anything else all pairs are tested; beside a far body that moves they are not.
    if (!all_move_alike(world)) expect_same_answer(scene, scene_of(larger), "with far bodies");
  }
}

/// All that stands in the world's frame is put on something that moves.
TEST(Worlds, CarriedAsAWhole) {
  for (std::uint64_t seed = 3000; seed < 3000 + effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MadeWorld world = random_world(seed);
    if (all_move_alike(world)) continue;
    Rng rng(seed);
    const MadeWorld carried = carried_as_a_whole(rng, world);
    expect_same_answer(scene_of(world), scene_of(carried), "carried");
  }
}

/// Seen from one of the bodies, whose velocity is taken from all others.
TEST(Worlds, SeenFromAMovingBody) {
  for (std::uint64_t seed = 4000; seed < 4000 + effort(150); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    MadeWorld world = random_world(seed);
    if (world.bodies.size() == 2) continue;
    for (MadeBody& body : world.bodies) body.keyframes.clear();
    Rng rng(seed);
    Scene scene = scene_of(world), seen = scene;
    std::vector<Point> velocities;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      velocities.push_back({sixteenths(rng, -2, 2), sixteenths(rng, -2, 2)});
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const Point v = velocities[i];
      const double spin = rng.chance(0.5) ? 0 : rng.between(-60, 60);
      scene.bodies[i].motion = from_velocity(v, spin, world.bodies[i].pivot);
      const bool root = world.bodies[i].parent < 0;
      seen.bodies[i].motion =
          from_velocity(root ? Point{v.x - velocities[0].x, v.y - velocities[0].y} : v, spin, world.bodies[i].pivot);
    }
    expect_same_answer(scene, seen, "from the first body");
  }
}

/// The same bodies, in touching pieces.
TEST(Worlds, SeamsDoNotMatter) {
  int cut = 0;
  for (std::uint64_t seed = 5000; seed < 5000 + effort(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MadeWorld world = random_world(seed);
    Rng rng(seed);
    const MadeWorld pieces = cut_at_seams(rng, world, cut);
    const Scene whole = scene_of(world), pieced = scene_of(pieces);
    expect_same_answer(whole, pieced, "open");
    expect_same_answer(whole, pieced, "closed", Touch::closed);
  }
  EXPECT_GE(cut, static_cast<int>(enough(300)));
}

// Two plain bodies.

TEST(Worlds, TwoBodiesAsBothEnginesSay) {
  CheckOptions ordinary;
  ordinary.engine = EngineChoice::both;
  for (const bool grid : {false, true}) {
    for (const Family family : all_families) {
      for (std::uint64_t seed = 0; seed < effort(10); ++seed) {
        SCOPED_TRACE(std::string(to_string(family)) + " seed " + std::to_string(seed) + (grid ? " grid" : ""));
        SceneOptions options;
        options.grid = grid;
        const Scene scene = random_scene(7000 + seed, family, options);
        for (const Touch touch : {Touch::open, Touch::closed}) {
          ordinary.touch = touch;
          const Answer two = check(scene, ordinary), world = answer_to(scene, touch, true);
          ASSERT_STREQ(to_string(two.outcome), to_string(world.outcome));
          if (!two.contact) continue;
          EXPECT_LE(two.contact->time.lo, world.contact->time.hi + 1e-12);
          EXPECT_GE(two.contact->time.hi, world.contact->time.lo - 1e-12);
        }
      }
    }
  }
}

/// Segments around a centre, of two plain bodies: both engines, the definition, and a proof.
TEST(Worlds, ArcsOfTwoBodies) {
  WorldCounts counts;
  CheckOptions options;
  options.engine = EngineChoice::both;
  for (std::uint64_t seed = 8000; seed < 8000 + effort(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    MadeWorld world;
    for (int i = 0; i < 2; ++i) {
      const Point at{3.0 * i, 0};
      MadeBody body;
      body.name = i == 0 ? "first" : "second";
      body.parts = {star_part(rng, at, 1.4, 0)};
      body.pivot = rng.chance(0.7) ? at : Point{};
      if (i == 0 || rng.chance(0.7)) body.keyframes = random_keyframes(rng, world.end, 4, at);
      world.bodies.push_back(body);
    }
    const Scene scene = scene_of(world);
    const Answer answer = check(scene, options);
    expect_apart_before(world, {{0, 1}, answer.outcome, answer.contact, answer.free_until, answer.reason}, counts);
    std::ostringstream log;
    const Answer proved = prove(scene, log);
    EXPECT_STREQ(to_string(proved.outcome), to_string(answer.outcome));
    if (answer.outcome == Outcome::overlap_at_start) continue;
    std::istringstream in(log.str());
    EXPECT_STREQ(to_string(verify(scene, in).outcome), to_string(answer.outcome));
  }
  EXPECT_GE(counts.contact, static_cast<int>(enough(60)));
  EXPECT_GE(counts.free, static_cast<int>(enough(40)));
}

/// Each pair of a world of plain bodies that do not turn, by the oracle that decides exactly.
TEST(Worlds, PairsAsTheExactOracleSays) {
  int compared = 0;
  for (std::uint64_t seed = 6000; seed < 6000 + effort(40); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed);
    Scene scene;
    scene.end = 4;
    for (int i = 0; i < 4; ++i) {
      const Part star = star_part(rng, {4.0 * (i % 2), 4.0 * (i / 2)}, 1.5, 0);
      Body body;
      body.name = "b" + std::to_string(i);
      for (const Point& p : star.outline)
        body.polygon.push_back({std::round(p.x * 64) / 64, std::round(p.y * 64) / 64});
      body.motion = from_velocity({sixteenths(rng, -2, 2), sixteenths(rng, -2, 2)});
      scene.bodies.push_back(body);
    }
    for (const Touch touch : {Touch::open, Touch::closed}) {
      const Answer world = answer_to(scene, touch, true);
      for (const PairAnswer& pair : *world.pairs) {
        Scene two = scene;
        two.bodies = {scene.bodies[static_cast<std::size_t>(pair.bodies[0])],
                      scene.bodies[static_cast<std::size_t>(pair.bodies[1])]};
        const exact::ExactAnswer truth = exact::first_contact(two, touch);
        if (truth.verdict == exact::Verdict::beyond) continue;
        ++compared;
        EXPECT_STREQ(to_string(pair.outcome), exact::to_string(truth.verdict));
        if (truth.verdict != exact::Verdict::contact || !pair.contact) continue;
        EXPECT_GE(truth.time.hi(), pair.contact->time.lo - 1e-12);
        EXPECT_LE(truth.time.lo(), pair.contact->time.hi + 1e-12);
      }
    }
  }
  EXPECT_GE(compared, static_cast<int>(enough(200)));
}

}  // namespace
}  // namespace taut::testing
