// Logs of separations about a clearance: what prove_clearance() writes is accepted, and damaged ones are rejected, or
// what they still prove is true.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "log_text.hpp"
#include "proof/format.hpp"
#include "proof/verifier_world.hpp"
#include "prove/apart_writer.hpp"
#include "support/effort.hpp"
#include "support/made_world.hpp"
#include "support/rng.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"

namespace taut::testing {
using namespace internal;
namespace {

struct ClearanceCounts {
  int free = 0, closer = 0;
};

void expect_clearance_proved(const Scene& scene, double clearance, Touch touch, ClearanceCounts& counts) {
  std::ostringstream out;
  CheckOptions options;
  options.touch = touch;
  const MarginAnswer answer = prove_clearance(scene, clearance, out, options);
  const MarginAnswer asked = check_clearance(scene, clearance, options);
  ASSERT_STREQ(to_string(answer.outcome), to_string(asked.outcome)) << answer.reason;
  if (answer.outcome == Outcome::overlap_at_start || answer.outcome == Outcome::closer_at_start) {
    EXPECT_TRUE(out.str().empty());
    return;
  }
  std::istringstream in(out.str());
  const Verified v = verify(scene, in);
  ASSERT_STREQ(to_string(v.outcome), to_string(answer.outcome));
  EXPECT_EQ(v.clearance, clearance);
  EXPECT_FALSE(v.contact);
  if (v.outcome == Outcome::free) {
    ++counts.free;
    EXPECT_EQ(v.free_until, scene.end);
    return;
  }
  ++counts.closer;
  ASSERT_TRUE(v.closer);
  EXPECT_EQ(v.closer->features.vertex, answer.first->features->vertex);
  EXPECT_EQ(v.closer->time.lo, answer.first->time.lo);
  EXPECT_EQ(v.closer->time.hi, answer.first->time.hi);
  EXPECT_LE(v.closer->time.hi - v.closer->time.lo, 1e-6 * (scene.end - scene.start));
}

TEST(ClearanceLogs, CertifiedWorlds) {
  if (!std::filesystem::exists("../shared/worlds")) GTEST_SKIP() << "the worlds with certified answers are not here";
  ClearanceCounts counts;
  for (const auto& entry : std::filesystem::directory_iterator("../shared/worlds")) {
    const std::string file = entry.path().string(), suffix = ".answer.json";
    if (file.size() < suffix.size() || file.substr(file.size() - suffix.size()) != suffix) continue;
    std::ifstream stream(entry.path());
    const nlohmann::json answer = nlohmann::json::parse(stream);
    if (!answer.contains("margin")) continue;
    SCOPED_TRACE(file);
    const Scene scene = read_scene(file.substr(0, file.size() - suffix.size()) + ".json");
    for (const Touch touch : {Touch::open, Touch::closed})
      expect_clearance_proved(scene, answer["margin"]["clearance"], touch, counts);
  }
  std::cout << counts.free << " clearances that are kept, " << counts.closer << " that are not\n";
  EXPECT_GE(counts.free + counts.closer, 100);
}

TEST(ClearanceLogs, RandomWorlds) {
  ClearanceCounts counts;
  for (std::uint64_t seed = 8100; seed < 8100 + effort(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Scene scene = scene_of(random_world(seed));
    const Clearance least = clearance(scene);
    if (!least.nearest || least.nearest->hi <= 0) continue;
    const double share = seed % 3 == 0 ? 0.9999 : seed % 3 == 1 ? 0.7 : 1.01;
    expect_clearance_proved(scene, least.nearest->hi * share, seed % 2 ? Touch::open : Touch::closed, counts);
  }
  EXPECT_GE(counts.free, static_cast<int>(enough(5)));
  EXPECT_GE(counts.closer, static_cast<int>(enough(2)));
}

/// Bodies whose distance at the start is the clearance, to the last bit: a contact there with touching counted,
/// whatever they do then.
TEST(ClearanceLogs, AsCloseAtTheStart) {
  for (const double speed : {1.0, 0.0, -1.0}) {
    Scene scene;
    scene.end = 1;
    scene.bodies = {{"a", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}},
                    {"b", {{2, -0.5}, {4, -0.5}, {4, 0.5}, {2, 0.5}}, from_velocity({speed, 0})}};
    for (const double clearance : {1 - 0x1p-50, 1.0, 1 + 0x1p-50}) {
      SCOPED_TRACE("speed " + std::to_string(speed) + ", clearance 1 + " + std::to_string((clearance - 1) * 0x1p50));
      CheckOptions closed;
      closed.touch = Touch::closed;
      const MarginAnswer answer = check_clearance(scene, clearance, closed);
      if (clearance > 1) {
        EXPECT_EQ(answer.outcome, Outcome::closer_at_start);
        continue;
      }
      ClearanceCounts counts;
      expect_clearance_proved(scene, clearance, Touch::closed, counts);
      expect_clearance_proved(scene, clearance, Touch::open, counts);
      if (clearance < 1) {
        EXPECT_EQ(answer.outcome, speed < 0 ? Outcome::contact : Outcome::free);
        continue;
      }
      ASSERT_EQ(answer.outcome, Outcome::contact);
      EXPECT_EQ(answer.free_until, 0);
      EXPECT_EQ(answer.first->time.lo, 0);
      EXPECT_EQ(answer.first->time.hi, 0);
      ASSERT_TRUE(answer.first->features);
      EXPECT_EQ(check_clearance(scene, clearance).outcome, speed < 0 ? Outcome::contact : Outcome::free);
    }
  }
}

/// Such a log with other features, or with the clearance or the motion of others, proves nothing.
TEST(ClearanceLogs, AsCloseAtTheStartOnly) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"a", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}},
                  {"b", {{2, -0.5}, {4, -0.5}, {4, 0.5}, {2, 0.5}}, from_velocity({1, 0})}};
  std::ostringstream out;
  CheckOptions closed;
  closed.touch = Touch::closed;
  prove_clearance(scene, 1, out, closed);
  const std::string bytes = out.str().substr(0, out.str().size() - 8);
  for (const std::size_t at : {41u, 48u, 58u, 62u, 66u}) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string other = bytes;
      other[at] = static_cast<char>(other[at] ^ (1 << bit));
      std::istringstream in(sealed(other));
      try {
        const Verified v = verify(scene, in);
        EXPECT_EQ(v.outcome, Outcome::contact);
        EXPECT_GE(v.clearance, 1);
      } catch (const ProofError&) {
      }
    }
  }
}

/// A log with its margin, one of its bytes, or its claim changed: what it still proves is true.
TEST(ClearanceLogs, DamagedOnes) {
  Scene scene;
  scene.end = 4;
  scene.bodies = {{"rests", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}},
                  {"passes", {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, {}}};
  MotionPiece piece;
  piece.x = {-4, 2};
  piece.y = {3};
  piece.rotation = AngleRotation{{0, 0.3}};
  scene.bodies[1].motion.pieces = {piece};
  const double least = clearance(scene).nearest->lo;
  Rng rng(9);
  int accepted = 0, refused = 0;
  for (const double share : {0.9, 1.1}) {
    std::ostringstream out;
    const MarginAnswer answer = prove_clearance(scene, least * share, out);
    ASSERT_STREQ(to_string(answer.outcome), share < 1 ? "free" : "contact");
    const std::string log = out.str();
    for (std::uint64_t n = effort(1500); n > 0; --n) {
      std::string bytes = log.substr(0, log.size() - 8);
      char& byte = bytes[41 + static_cast<std::size_t>(rng.below(static_cast<int>(bytes.size()) - 41))];
      byte = static_cast<char>(byte ^ (1 << rng.below(8)));
      std::istringstream in(sealed(bytes));
      try {
        const Verified v = verify(scene, in);
        ++accepted;
        // Less is proved, or the same.
        if (v.outcome == Outcome::free) {
          EXPECT_LE(v.clearance, least * (1 + 1e-9));
        } else if (v.closer) {
          EXPECT_GE(v.clearance, least * (1 - 1e-9));
          CheckOptions options;
          const MarginAnswer truth = check_clearance(scene, v.clearance, options);
          ASSERT_NE(truth.outcome, Outcome::free);
          if (truth.outcome == Outcome::contact) {
            EXPECT_LE(v.closer->time.lo, truth.first->time.hi);
            EXPECT_GE(v.closer->time.hi, truth.first->time.lo);
          }
        }
      } catch (const ProofError&) {
        ++refused;
      }
    }
  }
  std::cout << accepted << " damaged logs still prove something, " << refused << " are refused\n";
  EXPECT_GT(refused, accepted / 2);
}

/// Bodies that cross at the start keep any distance between vertices and edges.
TEST(ClearanceLogs, OfBodiesThatCrossAtTheStart) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"lies", {{-5, -1}, {5, -1}, {5, 1}, {-5, 1}}, {}},
                  {"stands", {{-1, -5}, {1, -5}, {1, 5}, {-1, 5}}, {}}};
  const proof::VerifierScene plan(scene);
  const double clearance = 0.125, margin = std::ldexp(clearance, plan.exponent());
  proof::VerifierWorld world(plan, Offset::inward, margin);
  const proof::VerifierPair& pair = world.pair(0, 1);
  std::string steps("\1\0\1", 3);
  proof::Lifetimes lifetimes(pair.geometry);
  lifetimes.enter(pair.segments[0]);
  ApartWriter(pair.ranges, lifetimes, std::nullopt, steps, margin).write(0, 1);
  std::ostringstream log;
  proof::ByteWriter out(log);
  proof::write_header(out, {proof::of_separations, scene_fingerprint(scene, Touch::open), Touch::open,
                            static_cast<std::uint8_t>(proof::Claim::free) | proof::with_clearance});
  out.f64(clearance);
  for (const char c : steps) out.u8(static_cast<std::uint8_t>(c));
  out.close();
  std::istringstream in(log.str());
  EXPECT_THROW(verify(scene, in), ProofError);
}

}  // namespace
}  // namespace taut::testing
