// Worlds whose bodies change their plans: what is kept through a change is what would be found from scratch.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <set>

#include "motion/pieces.hpp"
#include "numeric/budget.hpp"
#include "scene/validate_scene.hpp"
#include "session/near_bodies.hpp"
#include "support/effort.hpp"
#include "support/large_world.hpp"
#include "support/simulated_worlds.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// What the body did up to t, and that motion from then on.
Motion joined(const Motion& before, const Motion& after, double start, double t) {
  Motion motion;
  if (t > start) motion.pieces = given_pieces_between(before, start, t);
  if (!motion.pieces.empty()) motion.pieces.back().until = t;
  motion.pieces.insert(motion.pieces.end(), after.pieces.begin(), after.pieces.end());
  return motion;
}

bool is_world_of_many(const Scene& scene) {
  return scene.bodies.size() > 2 || !scene.bodies[0].parts.empty() || !scene.bodies[1].parts.empty();
}

/// Changes plans until something happens, and notes all that was done in `whole`.
void wander(Simulation& simulation, Scene& whole, Rng& rng, SimulationCounts& counts) {
  for (int k = 0; k < 12; ++k) {
    const double now = simulation.time() + (whole.end - simulation.time()) * rng.real(0, 0.2);
    if (k > 0 && simulation.advance_to(now) != SimulationState::running) return;
    if (rng.chance(0.2)) simulation.next_event();
    if (simulation.state() != SimulationState::running) return;
    const double t = simulation.time();
    const int body = rng.below(static_cast<int>(whole.bodies.size()));
    Body& changed = whole.bodies[static_cast<std::size_t>(body)];
    const Motion after = going_on(changed, t, rng);
    simulation.set_motion(body, after);
    changed.motion = joined(changed.motion, after, whole.start, t);
    ++counts.changes;
  }
}

TEST(ChangedWorlds, ComeToWhatOneWithAllChangesInItComesTo) {
  SimulationCounts counts, from_scratch;
  for (std::uint64_t seed = 0; seed < effort(600); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed + 31);
    Scene scene = scene_of(seed % 6 == 0 ? large_world(seed).world : random_world(seed + 9000));
    if (!is_world_of_many(scene)) continue;
    const Touch touch = seed % 3 == 2 ? Touch::closed : Touch::open;
    if (fresh_answer(scene, touch).outcome == Outcome::overlap_at_start) continue;
    Simulation simulation(scene, touch);
    wander(simulation, scene, rng, counts);
    simulation.advance_to(scene.end);
    const Answer answer = fresh_answer(scene, touch);
    // Bodies that moved alike and overlapped were no pair then, and are one from the start of all that they did.
    if (answer.outcome == Outcome::overlap_at_start) continue;
    if (simulation.state() == SimulationState::overlap_at_start) continue;
    ASSERT_NO_FATAL_FAILURE(expect_ended(simulation, answer, counts));
    Simulation again(scene, touch);
    again.advance_to(scene.end);
    ASSERT_NO_FATAL_FAILURE(expect_ended(again, answer, from_scratch));
  }
  std::cout << counts.changes << " changes, " << counts.contacts << " contacts, " << counts.finished << " free\n";
  EXPECT_GE(counts.changes, static_cast<int>(enough(1000)));
  EXPECT_GE(counts.contacts, static_cast<int>(enough(150)));
  EXPECT_GE(counts.finished, static_cast<int>(enough(20)));
}

/// Which pairs are near now, by the boxes of all bodies at some instants until the next box ends.
void expect_all_near(const Instance& instance, const NearBodies& near, double from, double until, int& met) {
  const int bodies = static_cast<int>(instance.bodies().size());
  for (int k = 0; k <= 4; ++k) {
    const double t = from + (until - from) * k / 4;
    std::vector<AxisBox> boxes;
    for (const InstanceBody& body : instance.bodies()) boxes.push_back(swept_box(body, t, t));
    for (int a = 0; a < bodies; ++a) {
      for (int b = a + 1; b < bodies; ++b) {
        const bool alike = instance.bodies()[static_cast<std::size_t>(a)].group ==
                           instance.bodies()[static_cast<std::size_t>(b)].group;
        if (!instance.asked(a, b) || alike) {
          ASSERT_FALSE(near.has(a, b)) << a << " and " << b << " are not asked about";
        } else if (boxes[static_cast<std::size_t>(a)].meets(boxes[static_cast<std::size_t>(b)])) {
          ASSERT_TRUE(near.has(a, b) && near.has(b, a)) << a << " and " << b << " at " << t;
          ++met;
        }
      }
    }
  }
}

/// The changes are the difference between the pairs before and after them.
void expect_changes(std::set<std::pair<int, int>>& pairs, const NearBodies& near, const NearBodies::Changes& changes) {
  for (const auto& pair : changes.gone) ASSERT_EQ(pairs.erase(pair), 1u);
  for (const auto& pair : changes.come) ASSERT_TRUE(pairs.insert(pair).second);
  const std::vector<std::pair<int, int>> now = near.pairs();
  ASSERT_EQ(pairs, (std::set<std::pair<int, int>>(now.begin(), now.end())));
}

/// A world whose bodies change their motions, come, go, and are attached to others, and which of them are near.
class ChangingWorld {
 public:
  explicit ChangingWorld(const Scene& scene) : scene_(scene), instance_(scene_), near_(instance_) {
    for (const auto& pair : near_.pairs()) pairs_.insert(pair);
    for (std::size_t k = 0; k < scene_.bodies.size(); ++k) there_.push_back(static_cast<int>(k));
  }

  const Instance& instance() const { return instance_; }
  const NearBodies& near() const { return near_; }
  void renew() { expect_changes(pairs_, near_, near_.renew()); }

  void change(double from, Rng& rng) {
    // Boxes may have begun a little later.
    const double back = rng.chance(0.2) ? std::nextafter(from, scene_.start) : from;
    const int body = there_[static_cast<std::size_t>(rng.below(static_cast<int>(there_.size())))];
    switch (rng.below(8)) {
      case 0:
        return add(body, from, back, rng);
      case 1:
        return remove(body);
      case 2:
        return attach(body, from, back, rng);
      case 3:
        return ignore(body, rng);
      default:
        return set_motion(body, from, back, rng);
    }
  }

 private:
  bool has_sections() const { return instance_.bodies().size() != scene_.bodies.size(); }

  void set_motion(int body, double from, double back, Rng& rng) {
    Body& changed = scene_.bodies[static_cast<std::size_t>(body)];
    const Motion after = going_on(changed, from, rng);
    changed.motion = joined(changed.motion, after, scene_.start, from);
    instance_.replan(body, after, from, from);
    expect_changes(pairs_, near_, near_.change(instance_.followers(body), back));
  }

  void add(int parent, double from, double back, Rng& rng) {
    Body body = scene_.bodies[static_cast<std::size_t>(rng.below(static_cast<int>(scene_.bodies.size())))];
    body.name = "new " + std::to_string(scene_.bodies.size());
    body.motion = going_on(body, from, rng);
    if (!instance_.can_add(body)) return;
    instance_.add(instance_.to_add(body, rng.chance(0.3) ? parent : -1, from), back);
    expect_changes(pairs_, near_, near_.add(back));
    if (rng.chance(0.2)) {
      // It was refused.
      const int last = static_cast<int>(scene_.bodies.size());
      std::erase_if(pairs_, [last](const auto& pair) { return pair.second == last; });
      near_.remove_last();
      instance_.remove_last();
      expect_changes(pairs_, near_, {});
      return;
    }
    there_.push_back(static_cast<int>(scene_.bodies.size()));
    scene_.bodies.push_back(body);
  }

  void remove(int body) {
    const std::vector<int> sections = instance_.sections(body);
    if (there_.size() < 4 || instance_.followers(body).size() > sections.size()) return;
    for (const int k : sections) {
      const NearBodies::Changes changes = near_.remove(k);
      expect_changes(pairs_, near_, changes);
    }
    instance_.retire(body);
    std::erase(there_, body);
  }

  void attach(int body, double from, double back, Rng& rng) {
    const int parent = there_[static_cast<std::size_t>(rng.below(static_cast<int>(there_.size())))];
    const std::vector<int> followers = instance_.followers(body);
    if (std::binary_search(followers.begin(), followers.end(), parent)) return;
    const Motion motion = going_on(scene_.bodies[static_cast<std::size_t>(body)], from, rng);
    scene_.bodies[static_cast<std::size_t>(body)].motion = motion;
    instance_.attach(body, rng.chance(0.5) ? parent : -1, instance_.pieces_of(motion, from), from, back);
    expect_changes(pairs_, near_, near_.change(instance_.followers(body), back));
  }

  void ignore(int body, Rng& rng) {
    const int other = there_[static_cast<std::size_t>(rng.below(static_cast<int>(there_.size())))];
    if (body == other || has_sections()) return;
    instance_.ignore(body, other);
    near_.part(body, other);
    pairs_.erase({std::min(body, other), std::max(body, other)});
    expect_changes(pairs_, near_, {});
  }

  Scene scene_;
  Instance instance_;
  NearBodies near_;
  std::set<std::pair<int, int>> pairs_;
  std::vector<int> there_;
};

/// A child jumps with its parent's plan, if need be: boxes do not mind.
TEST(ChangedWorlds, WhoeverMeetsIsNear) {
  int met = 0, changes = 0, windows = 0;
  for (std::uint64_t seed = 0; seed < effort(400); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Rng rng(seed + 5);
    const Scene scene = scene_of(large_world(seed).world);
    validate_polygons(scene);
    if (Instance(scene).is_single_pair()) continue;
    ChangingWorld world(scene);
    double from = scene.start;
    for (int step = 0; step < 40 && world.near().until() < scene.end; ++step) {
      const double until = world.near().until();
      ASSERT_NO_FATAL_FAILURE(expect_all_near(world.instance(), world.near(), from, until, met));
      ++windows;
      if (!rng.chance(0.3)) {
        from = until;
        ASSERT_NO_FATAL_FAILURE(world.renew());
        continue;
      }
      from = from + (until - from) * (rng.chance(0.1) ? 0 : rng.real(0, 0.99));
      ASSERT_NO_FATAL_FAILURE(world.change(from, rng));
      ++changes;
    }
  }
  std::cout << changes << " changes, " << windows << " windows, " << met << " pairs met\n";
  EXPECT_GE(changes, static_cast<int>(enough(1000)));
  EXPECT_GE(met, static_cast<int>(enough(10000)));
}

/// Squares in a row, 10 apart, that go their ways; the first two are close.
Scene row(int bodies) {
  Scene scene;
  scene.end = 100;
  for (int k = 0; k < bodies; ++k) {
    Body body;
    body.name = std::to_string(k);
    const double x = k == 1 ? 1.5 : 10.0 * k;
    body.polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    body.motion.pieces = {{{x}, {0, k < 2 ? 0.01 : 0.5 + 0.001 * k}, NoRotation{}}};
    scene.bodies.push_back(body);
  }
  return scene;
}

/// Of changes at 20 instants, but for the first one, which makes what the others look things up in.
template <class Change>
std::uint64_t work_of(int bodies, const Change& change) {
  const Scene scene = row(bodies);
  Simulation simulation(scene, Touch::open);
  std::uint64_t before = 0;
  for (int k = 1; k <= 20; ++k) {
    simulation.advance_to(k);
    change(simulation, k);
    if (k == 1) before = work_spent();
  }
  EXPECT_EQ(simulation.state(), SimulationState::running);
  return work_spent() - before;
}

std::uint64_t work_of_motions(int bodies) {
  double y = 0, speed = 0.01;
  return work_of(bodies, [&](Simulation& simulation, int k) {
    y += speed;
    speed = k % 2 ? 0.02 : 0.005;
    simulation.set_motion(0, Motion{{{{0}, {y - speed * k, speed}, NoRotation{}}}});
  });
}

/// Of a body that comes, is attached to another one, and goes.
std::uint64_t work_of_comings(int bodies) {
  return work_of(bodies, [](Simulation& simulation, int k) {
    const BodyId added = simulation.add_body({"new " + std::to_string(k), {{0, 2}, {1, 2}, {0.5, 3}}, {}});
    simulation.set_parent(added, 0, Motion{{{{0}, {-0.01 * k}, NoRotation{}}}});
    simulation.ignore(0, added);
    simulation.remove_body(added);
  });
}

TEST(ChangedWorlds, AChangeCostsNothingForBodiesThatAreFar) {
  for (const auto& work : {work_of_motions, work_of_comings}) {
    const std::uint64_t few = work(30), many = work(3000);
    EXPECT_GT(few, 0u);
    EXPECT_LE(many, few + few / 10);
  }
}

/// A body comes flush with a wall, and in the same instant its motion jumps into that by a rounding. The pair has no
/// past over which the jump could be bridged: a body that went on through the wall was the answer.
TEST(ChangedWorlds, AMotionMayJumpInTheInstantInWhichABodyComes) {
  const auto straight = [](double t, double x, double v) {
    MotionPiece piece;
    piece.origin = t;
    piece.x = {x, v};
    return Motion{{piece}};
  };
  const auto square = [](double x) { return Polygon{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}; };
  for (const double jump : {-0x1p-36, -0x1p-46, -0x1p-52, 0.0, 0x1p-46}) {
    Scene scene;
    scene.end = 4;
    scene.bodies = {{"wall", square(0), straight(0, 0, 0.5)}, {"far", square(20), {}}, {"farther", square(30), {}}};
    Simulation simulation(scene, Touch::open);
    simulation.advance_to(1);
    const BodyId added = simulation.add_body({"b", square(1), straight(1, 0.5, 0)});
    try {
      simulation.set_motion(added, straight(1, 0.5 + jump, -0.3));
    } catch (const InputError&) {
      // It would overlap at the present: nothing has changed, and the wall moves on into it.
      EXPECT_LT(jump, 0);
    }
    EXPECT_EQ(simulation.advance_to(4), SimulationState::contact) << jump;
    EXPECT_NEAR(simulation.time(), 1, 1e-9) << jump;
  }
}

}  // namespace
}  // namespace taut::testing
