// Logs of separations: what prove() writes with the spacetime engine, and about worlds, is accepted and proves what
// check() says; damaged logs are rejected, or what they still prove is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>

#include "generators/generators.hpp"
#include "log_text.hpp"
#include "proof/bytes.hpp"
#include "proof/format.hpp"
#include "proof/verifier_world.hpp"
#include "prove/apart_writer.hpp"
#include "scene/validate_scene.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
using namespace internal;
namespace {

struct SeparationCounts {
  int free = 0, contact = 0, at_start = 0;
  std::uint64_t separations = 0, bytes = 0;
};

CheckOptions by_spacetime(Touch touch) {
  CheckOptions options;
  options.touch = touch;
  options.engine = EngineChoice::spacetime;
  return options;
}

Proved prove_by_spacetime(const Scene& scene, Touch touch) {
  std::ostringstream out;
  Proved proved;
  proved.answer = prove(scene, out, by_spacetime(touch));
  proved.log = out.str();
  return proved;
}

void expect_separations_prove(const Scene& scene, Touch touch, SeparationCounts& counts) {
  const Answer answer = check(scene, by_spacetime(touch));
  const Proved proved = prove_by_spacetime(scene, touch);
  ASSERT_STREQ(to_string(proved.answer.outcome), to_string(answer.outcome)) << proved.answer.reason;
  if (answer.outcome == Outcome::overlap_at_start || answer.outcome == Outcome::untested) {
    EXPECT_TRUE(proved.log.empty());
    return;
  }
  std::istringstream in(proved.log);
  const Verified v = verify(scene, in);
  ASSERT_STREQ(to_string(v.outcome), to_string(answer.outcome));
  ASSERT_EQ(v.touch, touch);
  ASSERT_EQ(v.fingerprint, scene_fingerprint(scene, touch));
  counts.separations += v.separations;
  counts.bytes += proved.log.size();
  if (v.outcome == Outcome::free) {
    ++counts.free;
    ASSERT_EQ(v.free_until, scene.end);
    return;
  }
  ++(v.contact->time.hi == scene.start ? counts.at_start : counts.contact);
  ASSERT_LE(v.contact->time.lo, answer.contact->time.hi);
  ASSERT_GE(v.contact->time.hi, answer.contact->time.lo);
  // What is printed is what is proved.
  ASSERT_EQ(v.contact->time.lo, proved.answer.contact->time.lo);
  ASSERT_EQ(v.contact->time.hi, proved.answer.contact->time.hi);
  ASSERT_EQ(v.free_until, proved.answer.free_until);
  // Before a joint of a world the windows end early, since the other pairs' jumps are there.
  ASSERT_LE(v.free_until, v.contact->time.lo);
  ASSERT_GE(v.free_until, !is_ring_pair(scene) ? std::nextafter(v.contact->time.lo, scene.start) : v.contact->time.lo);
  if (!is_ring_pair(scene) && v.contact->time.hi > scene.start) {
    ASSERT_EQ(v.contact->vertex, answer.contact->vertex);
    ASSERT_EQ(v.contact->edge, answer.contact->edge);
  }
}

void expect_all_proved(const std::filesystem::path& folder, SeparationCounts& counts) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json" || entry.path().stem().extension() == ".answer") continue;
    SCOPED_TRACE(entry.path().string());
    const Scene scene = read_scene(entry.path().string());
    for (const Touch touch : {Touch::open, Touch::closed})
      ASSERT_NO_FATAL_FAILURE(expect_separations_prove(scene, touch, counts));
  }
}

TEST(SeparationLogs, Examples) {
  SeparationCounts counts;
  expect_all_proved("examples", counts);
  expect_all_proved("examples/worlds", counts);
  EXPECT_GT(counts.free + counts.contact, 20);
}

TEST(SeparationLogs, Corpus) {
  SeparationCounts counts;
  expect_all_proved("tests/corpus", counts);
  expect_all_proved("tests/corpus/worlds", counts);
  expect_all_proved("tests/corpus/mechanisms", counts);
  EXPECT_GT(counts.free + counts.contact, 60);
}

TEST(SeparationLogs, CertifiedWorlds) {
  if (!std::filesystem::exists("../shared/worlds"))
    GTEST_SKIP() << "the worlds with certified answers are not here (../shared/worlds)";
  SeparationCounts counts;
  expect_all_proved("../shared/worlds", counts);
  EXPECT_GE(counts.free + counts.contact + counts.at_start, 120);
}

TEST(SeparationLogs, CertifiedScenes) {
  if (!std::filesystem::exists("../shared/scenes"))
    GTEST_SKIP() << "the scenes with certified answers are not here (../shared/scenes)";
  SeparationCounts counts;
  expect_all_proved("../shared/scenes", counts);
  EXPECT_GE(counts.free + counts.contact + counts.at_start, 290);
}

TEST(SeparationLogs, RandomScenes) {
  SeparationCounts counts;
  for (std::uint64_t seed = 0; seed < effort(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    SceneOptions options;
    options.grid = seed % 2 == 0;
    const Scene scene = random_scene(7000 + seed, all_families[seed % std::size(all_families)], options);
    ASSERT_NO_FATAL_FAILURE(expect_separations_prove(scene, seed % 4 == 3 ? Touch::closed : Touch::open, counts));
  }
  EXPECT_GE(counts.free, static_cast<int>(enough(60)));
  EXPECT_GE(counts.contact, static_cast<int>(enough(40)));
  std::cout << counts.separations << " separations, " << counts.bytes << " bytes\n";
}

TEST(SeparationLogs, RandomWorlds) {
  SeparationCounts counts;
  for (std::uint64_t seed = 40000; seed < 40000 + effort(300); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = scene_of(random_world(seed));
    ASSERT_NO_FATAL_FAILURE(expect_separations_prove(scene, seed % 4 == 3 ? Touch::closed : Touch::open, counts));
  }
  EXPECT_GE(counts.free, static_cast<int>(enough(30)));
  EXPECT_GE(counts.contact, static_cast<int>(enough(60)));
  std::cout << counts.separations << " separations, " << counts.bytes << " bytes\n";
}

/// Parts at rest, each beside four others.
Scene layout(int side) {
  Scene scene;
  scene.end = 1;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      Polygon part = {{0, 0}, {0.9, 0}, {0.45, 0.3}, {0.9, 0.9}, {0, 0.9}};
      for (Point& p : part) p = {p.x + i, p.y + j};
      scene.bodies.push_back({std::to_string(i) + "," + std::to_string(j), part, {}});
    }
  }
  return scene;
}

/// Where nothing moves, every pair is shown to be apart, by its boxes or by separations.
TEST(SeparationLogs, OfLayouts) {
  SeparationCounts counts;
  Scene scene = layout(6);
  for (const Touch touch : {Touch::open, Touch::closed})
    ASSERT_NO_FATAL_FAILURE(expect_separations_prove(scene, touch, counts));
  std::ostringstream log;
  EXPECT_EQ(prove_clearance(scene, 0.0625, log).outcome, Outcome::free);
  std::istringstream in(log.str());
  const Verified kept = verify(scene, in);
  EXPECT_EQ(kept.outcome, Outcome::free);
  EXPECT_EQ(kept.clearance, 0.0625);
  EXPECT_EQ(kept.coverage.tested, 36u * 35 / 2);
  // They are still tested beside a body that moves if the scene says so, and that is part of what is proved about.
  scene.bodies.push_back({"bird", {{0, 9}, {1, 9}, {0, 10}}, from_velocity({1, 0})});
  const Fingerprint skipped = scene_fingerprint(scene, Touch::open);
  scene.at_rest = AtRest::test;
  EXPECT_NE(scene_fingerprint(scene, Touch::open), skipped);
  ASSERT_NO_FATAL_FAILURE(expect_separations_prove(scene, Touch::open, counts));
  EXPECT_EQ(counts.free, 3);
  // Two that touch are a contact at the start, with a proof.
  for (Point& p : scene.bodies[1].polygon) p.y -= 0.1;
  EXPECT_EQ(check(scene, by_spacetime(Touch::closed)).outcome, Outcome::contact);
  ASSERT_NO_FATAL_FAILURE(expect_separations_prove(scene, Touch::closed, counts));
}

/// "Free" of nothing is not proved by anything.
TEST(SeparationLogs, OfNothingAreRefused) {
  Scene scene = layout(2);
  scene.ignore = {{"*", "*"}};
  std::ostringstream out;
  proof::ByteWriter writer(out);
  proof::write_header(writer, {proof::of_separations, scene_fingerprint(scene, Touch::open), Touch::open,
                               static_cast<std::uint8_t>(proof::Claim::free)});
  writer.u8(1);
  writer.close();
  std::istringstream in(out.str());
  try {
    verify(scene, in);
    ADD_FAILURE();
  } catch (const ProofError& error) {
    EXPECT_NE(std::string(error.what()).find("nothing was tested"), std::string::npos) << error.what();
  }
}

/// A log is small: no more than a byte or two for each step, and the steps are few.
TEST(SeparationLogs, AreShort) {
  const Scene scene = read_scene("examples/worlds/room.json");
  const Proved proved = prove_by_spacetime(scene, Touch::open);
  std::istringstream in(proved.log);
  EXPECT_LE(proved.log.size(), 200 + 4 * verify(scene, in).separations);
}

/// Where the motion is known badly, windows are halved before ranges are: else this log is twice as long.
TEST(SeparationLogs, OfPathsOfHighDegreeAreShort) {
  gen::DipOptions options;
  options.sides = 300;
  options.dips = 5;
  const Scene scene = gen::make_dips(options);
  const Proved proved = prove_by_spacetime(scene, Touch::open);
  EXPECT_EQ(proved.answer.outcome, Outcome::free);
  EXPECT_LE(proved.log.size(), 700u);
}

/// Where a face falls onto a face, a vertex is beside its neighbours' edges by less and less, and then by the
/// displacement only: exact forms tell of that at once, and not by some forty windows for each, the last one as short
/// as doubles are.
TEST(SeparationLogs, OfTiesAreShort) {
  Scene scene = read_scene("examples/hello.json");
  EXPECT_LE(prove_by_spacetime(scene, Touch::open).log.size(), 130u);
  Body anvil = scene.bodies[0], hammer = scene.bodies[1];
  anvil.polygon = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  scene.bodies = {anvil};
  for (const auto& [x, y] : {std::pair(6, 0), {-6, 0}, {0, 6}, {0, -6}}) {
    hammer = anvil;
    hammer.name = "from " + std::to_string(x) + ", " + std::to_string(y);
    hammer.motion.pieces = {MotionPiece{}};
    hammer.motion.pieces[0].x = {double(x), -x / 6.0};
    hammer.motion.pieces[0].y = {double(y), -y / 6.0};
    scene.bodies.push_back(hammer);
  }
  const Proved proved = prove_by_spacetime(scene, Touch::open);
  EXPECT_EQ(proved.answer.outcome, Outcome::contact);
  EXPECT_LE(proved.log.size(), 600u);
}

// Damage.

struct DamagedSpecimen {
  Scene scene;
  Touch touch;
  std::string log;                ///< without its checksum
  std::array<Answer, 2> answers;  ///< of both touch modes
};

constexpr std::size_t checksum_bytes = 8, header_bytes = 42;

/// Empty if what a damaged log claims is so.
std::string refutation_of(const DamagedSpecimen& specimen, const Verified& v) {
  const Answer& a = specimen.answers[v.touch == Touch::closed ? 1 : 0];
  if (a.outcome == Outcome::overlap_at_start) return "bodies overlap at the start";
  if (a.contact && v.free_until > a.contact->time.hi) return "free beyond the contact";
  if (v.outcome == Outcome::undecided) return {};
  if (v.outcome != a.outcome) return "another outcome";
  if (v.outcome == Outcome::free) return {};
  if (a.contact->time.hi < v.contact->time.lo || v.contact->time.hi < a.contact->time.lo) return "another time";
  return {};
}

class DamagedSeparations : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (std::uint64_t seed = 90000; specimens().size() < effort(40); ++seed) {
      const Scene scene = seed % 3 == 0 ? random_scene(seed, all_families[seed % std::size(all_families)], {})
                                        : scene_of(random_world(seed));
      const Touch touch = seed % 4 == 3 ? Touch::closed : Touch::open;
      const Proved proved = prove_by_spacetime(scene, touch);
      if (proved.log.size() < header_bytes + 20 || proved.log.size() > 3000) continue;
      specimens().push_back({scene, touch, proved.log.substr(0, proved.log.size() - checksum_bytes), {}});
      for (const Touch mode : {Touch::open, Touch::closed})
        specimens().back().answers[mode == Touch::closed ? 1 : 0] = check(scene, by_spacetime(mode));
    }
  }
  static void TearDownTestSuite() {
    int tried = 0;
    for (const auto& [name, count] : counts()) {
      std::cout << name << ": " << count[0] << " damaged logs, " << count[1] << " still proofs\n";
      tried += count[0];
    }
    EXPECT_GE(static_cast<std::uint64_t>(tried), enough(10000));
  }
  static std::vector<DamagedSpecimen>& specimens() {
    static std::vector<DamagedSpecimen> all;
    return all;
  }
  static std::map<std::string, std::array<int, 2>>& counts() {
    static std::map<std::string, std::array<int, 2>> all;
    return all;
  }

  static bool judge(const std::string& name, const DamagedSpecimen& specimen, const std::string& bytes) {
    ++counts()[name][0];
    std::istringstream in(sealed(bytes));
    try {
      const Verified v = verify(specimen.scene, in);
      ++counts()[name][1];
      EXPECT_EQ(refutation_of(specimen, v), "") << name;
      return true;
    } catch (const ProofError&) {
      return false;
    }
  }
};

TEST_F(DamagedSeparations, NothingDamagedIsAccepted) {
  for (const DamagedSpecimen& specimen : specimens()) EXPECT_TRUE(judge("nothing", specimen, specimen.log));
  counts().erase("nothing");
}

/// Every step becomes every other kind of step.
TEST_F(DamagedSeparations, Steps) {
  for (const DamagedSpecimen& specimen : specimens()) {
    for (std::size_t i = header_bytes; i < specimen.log.size(); ++i) {
      for (const int other : {0, 1, 2, 3, 4, 9, 15, 70}) {
        if (specimen.log[i] == static_cast<char>(other) || (i * 7 + static_cast<std::size_t>(other)) % 5 != 0) continue;
        std::string bytes = specimen.log;
        bytes[i] = static_cast<char>(other);
        judge("a step", specimen, bytes);
      }
    }
  }
}

TEST_F(DamagedSeparations, BytesMissingOrTwice) {
  for (const DamagedSpecimen& specimen : specimens()) {
    for (std::size_t i = header_bytes; i < specimen.log.size(); i += 3) {
      judge("a byte less", specimen, specimen.log.substr(0, i) + specimen.log.substr(i + 1));
      judge("a byte more", specimen, specimen.log.substr(0, i) + specimen.log[i] + specimen.log.substr(i));
      judge("cut off", specimen, specimen.log.substr(0, i));
    }
  }
}

/// Other numbers in what the log claims: a pair, a segment, a vertex, an edge, times.
TEST_F(DamagedSeparations, Claims) {
  Rng rng(5);
  for (const DamagedSpecimen& specimen : specimens()) {
    for (int claim = 0; claim < 4; ++claim) {
      std::string bytes = specimen.log;
      bytes[header_bytes - 1] = static_cast<char>(claim);
      if (bytes != specimen.log) judge("another claim", specimen, bytes);
    }
    for (int i = 0; i < 60; ++i) {
      std::string bytes = specimen.log;
      const std::size_t at = header_bytes + static_cast<std::size_t>(rng.below(52));
      if (at >= bytes.size()) continue;
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << rng.below(8)));
      judge("a number of the claim", specimen, bytes);
    }
  }
}

/// A pair less, or a stretch of time: whole runs of steps are taken out, or exchanged.
TEST_F(DamagedSeparations, RunsOfSteps) {
  Rng rng(6);
  for (const DamagedSpecimen& specimen : specimens()) {
    const int size = static_cast<int>(specimen.log.size() - header_bytes);
    for (int i = 0; i < 60; ++i) {
      const auto at = static_cast<std::size_t>(rng.below(size)), length = static_cast<std::size_t>(rng.between(2, 40));
      const std::size_t from = header_bytes + at, to = std::min(specimen.log.size(), from + length);
      judge("steps missing", specimen, specimen.log.substr(0, from) + specimen.log.substr(to));
      std::string turned = specimen.log;
      std::reverse(turned.begin() + static_cast<std::ptrdiff_t>(from),
                   turned.begin() + static_cast<std::ptrdiff_t>(to));
      if (turned != specimen.log) judge("steps turned around", specimen, turned);
    }
  }
}

/// A log is about one scene.
TEST_F(DamagedSeparations, OtherScenes) {
  for (const DamagedSpecimen& specimen : specimens()) {
    Scene other = specimen.scene;
    std::swap(other.bodies[0].motion, other.bodies[1].motion);
    if (scene_fingerprint(other, specimen.touch) == scene_fingerprint(specimen.scene, specimen.touch)) continue;
    std::istringstream in(sealed(specimen.log));
    EXPECT_THROW(verify(other, in), ProofError);
  }
}

/// A corner that crosses an edge's line twice, as its body turns about it: at t = 1/4 and 3/4.
TEST(SeparationLogs, BehindAnEndWheneverOnTheLine) {
  Rng rng(78);
  std::array<int, 2> seen{};
  for (std::uint64_t n = effort(300); n > 0; --n) {
    const double from = rng.real(-1.5, 2.5), along = rng.real(-2, 2);
    Scene scene;
    scene.end = 1;
    scene.bodies = {{"edge", {{0, 0}, {0, -1}, {1, -1}, {1, 0}}, {}}, {"corner", {{0, 0}, {3, 4}, {-3, 4}}, {}}};
    MotionPiece piece;
    piece.x = {from, along};
    piece.y = {0.75, -4, 4};
    piece.rotation = AngleRotation{{rng.real(-0.2, 0.2), rng.real(-0.3, 0.3)}};
    scene.bodies[1].motion.pieces = {piece};
    const proof::VerifierScene plan(scene);
    proof::VerifierWorld world(plan, rng.chance(0.5) ? Offset::inward : Offset::outward);
    const proof::VerifierPair& pair = world.pair(0, 1);
    const PairGeometry& g = pair.geometry;
    proof::Lifetimes lifetimes(g);
    lifetimes.enter(pair.segments[0]);
    // Which of the two bodies is P depends on their size, and rings begin at their smallest vertices.
    const double scale = std::ldexp(1.0, -3);
    const auto vertex_at = [&](double x, double y, bool of_p) {
      for (std::uint32_t v = of_p ? 0 : g.np; v < (of_p ? g.np : g.np + g.nq); ++v) {
        if (g.point(VertexId(v)).x == x * scale && g.point(VertexId(v)).y == y * scale) return VertexId(v);
      }
      throw std::logic_error("no such vertex");
    };
    const proof::Incidence incidence{vertex_at(0, 0, true), vertex_at(1, 0, false)};
    const auto behind = [&](double t) { return from + along * t < 0 || from + along * t > 1; };
    const bool expected = behind(0.25) && behind(0.75);
    EXPECT_EQ(proof::stays_separated(g, lifetimes, incidence, proof::SeparationReason::behind_when_on_line, 0,
                                     Instant::exactly(1)),
              expected)
        << from << ' ' << along;
    ++seen[expected];
  }
  EXPECT_GT(std::min(seen[0], seen[1]), static_cast<int>(effort(300) / 10));
}

/// Corners at whole numbers pass each other between two doubles.
TEST(SeparationLogs, OfCornersThatPassWhileTurning) {
  const Scene scene = read_scene("tests/corpus/worlds/corners_pass_while_turning.json");
  std::stringstream log;
  ASSERT_EQ(prove(scene, log, by_spacetime(Touch::open)).outcome, Outcome::free);
  EXPECT_EQ(verify(scene, log).outcome, Outcome::free);
}

/// Beside an infinite speed no window is so short that doubles tell of signs in it: what is plain there is said of long
/// windows, not of each one between two doubles (74,350 bytes).
TEST(SeparationLogs, AreShortBesideAnInfiniteSpeed) {
  const Scene scene = read_scene("tests/corpus/infinite_speed_in_a_contact_of_order_six.json");
  std::stringstream log;
  ASSERT_EQ(prove(scene, log, by_spacetime(Touch::open)).outcome, Outcome::free);
  EXPECT_LT(log.str().size(), 1000);
  EXPECT_EQ(verify(scene, log).outcome, Outcome::free);
}

/// Two bars in the shape of a plus: no vertex is on an edge, or inside the other body, and still they overlap. A log of
/// all that separations can say of them is not a proof.
std::string log_without_incidences(const Scene& scene, Touch touch) {
  const proof::VerifierScene plan(scene);
  proof::VerifierWorld world(plan, offset_for(touch));
  const proof::VerifierPair& pair = world.pair(0, 1);
  std::string steps("\1\0\1", 3);
  proof::Lifetimes lifetimes(pair.geometry);
  for (const proof::SegmentStretch& stretch : proof::stretches(pair.segments, {scene.start, scene.end, true})) {
    lifetimes.enter(pair.segments[stretch.segment]);
    ApartWriter(pair.ranges, lifetimes, std::nullopt, steps).write(stretch.from, stretch.to);
  }
  std::ostringstream log;
  proof::ByteWriter out(log);
  proof::write_header(out, {proof::of_separations, scene_fingerprint(scene, touch), touch,
                            static_cast<std::uint8_t>(proof::Claim::free)});
  for (const char c : steps) out.u8(static_cast<std::uint8_t>(c));
  out.close();
  return log.str();
}

TEST(SeparationLogs, OfBodiesThatCrossAtTheStart) {
  Rng rng(77);
  for (std::uint64_t n = effort(60); n > 0; --n) {
    const double long_side = rng.real(3, 5), thin = rng.real(0.2, 1);
    Scene scene;
    scene.end = 1;
    scene.bodies = {{"lies", {{-long_side, -thin}, {long_side, -thin}, {long_side, thin}, {-long_side, thin}}, {}},
                    {"stands", {{-thin, -long_side}, {thin, -long_side}, {thin, long_side}, {-thin, long_side}}, {}}};
    MotionPiece piece;
    piece.x = {0, rng.real(-1, 1)};
    piece.y = {0, rng.real(-1, 1)};
    if (rng.chance(0.5)) piece.rotation = AngleRotation{{rng.real(-0.2, 0.2), rng.real(-0.1, 0.1)}};
    scene.bodies[1].motion.pieces = {piece};
    const Touch touch = rng.chance(0.5) ? Touch::open : Touch::closed;
    ASSERT_EQ(check(scene, by_spacetime(touch)).outcome, Outcome::overlap_at_start);
    std::istringstream in(log_without_incidences(scene, touch));
    try {
      verify(scene, in);
      ADD_FAILURE() << "accepted: " << write_scene(scene);
    } catch (const ProofError& error) {
      EXPECT_NE(std::string(error.what()).find("overlap at the start"), std::string::npos) << error.what();
    }
  }
}

/// The list of ignored pairs is part of what is proved.
TEST(SeparationLogs, IgnoredPairsArePartOfTheScene) {
  Scene scene = scene_of(random_world(40003));
  const Fingerprint all = scene_fingerprint(scene, Touch::open);
  scene.ignore.push_back({scene.bodies[0].name, scene.bodies[1].name});
  EXPECT_NE(scene_fingerprint(scene, Touch::open), all);
  std::swap(scene.ignore.back()[0], scene.ignore.back()[1]);
  const Fingerprint turned = scene_fingerprint(scene, Touch::open);
  std::swap(scene.ignore.back()[0], scene.ignore.back()[1]);
  EXPECT_EQ(scene_fingerprint(scene, Touch::open), turned);
}

}  // namespace
}  // namespace taut::testing
