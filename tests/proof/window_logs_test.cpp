// Windows of logs of separations: boxes made smaller, taken away or exchanged, pairs and bodies and windows left out.
// Such logs are rejected, or what they still prove is true.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <map>
#include <sstream>

#include "log_text.hpp"
#include "numeric/budget.hpp"
#include "proof/format.hpp"
#include "proof/verifier_world.hpp"
#include "scene/meeting_boxes.hpp"
#include "support/effort.hpp"
#include "support/large_world.hpp"
#include "support/rng.hpp"
#include "taut/io.hpp"

namespace taut::testing {
using namespace internal;
namespace {

constexpr std::size_t before_windows = 42, box_bytes = 16;

struct BoxedLog {
  Scene scene;
  std::string log;                 ///< without its checksum
  std::size_t window = 0;          ///< the first window that states boxes
  std::vector<std::size_t> boxes;  ///< where the flags of its boxes are
  std::size_t pairs = 0;           ///< where its pairs begin
};

/// Where the first window with boxes has them, in a log of a claim that nothing is said about.
void find_boxes(BoxedLog& log) {
  const proof::VerifierScene scene(log.scene);
  std::size_t at = before_windows;
  while (log.log[at] == 0) ++at;
  log.window = at++;
  for (std::size_t k = moving_bodies(scene, {}).size(); k > 0; --k) {
    if (log.log[at] == 1) log.boxes.push_back(at);
    at += log.log[at] == 1 ? 1 + box_bytes : 1;
  }
  log.pairs = at;
}

float float_at(const std::string& bytes, std::size_t at) {
  float x;
  std::memcpy(&x, bytes.data() + at, sizeof x);
  return x;
}
void put_float(std::string& bytes, std::size_t at, float x) { std::memcpy(bytes.data() + at, &x, sizeof x); }

class DamagedWindows : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    for (std::uint64_t seed = 1; logs().size() < effort(40); ++seed) {
      BoxedLog made;
      made.scene = scene_of(large_world(seed).world);
      std::ostringstream out;
      const Answer answer = prove(made.scene, out);
      if (answer.outcome != Outcome::free || made.scene.bodies.size() < 13) continue;
      made.log = out.str().substr(0, out.str().size() - 8);
      find_boxes(made);
      if (made.boxes.size() >= 2) logs().push_back(std::move(made));
    }
  }
  static void TearDownTestSuite() {
    for (const auto& [name, count] : counts())
      std::cout << name << ": " << count[0] << " damaged logs, " << count[1] << " still proofs\n";
  }
  static std::vector<BoxedLog>& logs() {
    static std::vector<BoxedLog> all;
    return all;
  }
  static std::map<std::string, std::array<int, 2>>& counts() {
    static std::map<std::string, std::array<int, 2>> all;
    return all;
  }
  /// Is it refused? All scenes are free, so that what is proved of them is true.
  static bool refused(const std::string& name, const BoxedLog& log, const std::string& bytes) {
    ++counts()[name][0];
    std::istringstream in(sealed(bytes));
    try {
      const Verified v = verify(log.scene, in);
      EXPECT_EQ(v.outcome, Outcome::free);
      ++counts()[name][1];
      return false;
    } catch (const ProofError&) {
      return true;
    }
  }
};

TEST_F(DamagedWindows, NothingDamagedIsAccepted) {
  for (const BoxedLog& log : logs()) EXPECT_FALSE(refused("nothing", log, log.log));
}

/// A side goes in by more than the writer leaves room on purpose.
TEST_F(DamagedWindows, BoxesMadeSmaller) {
  Rng rng(3);
  int accepted = 0, tried = 0;
  for (const BoxedLog& log : logs()) {
    for (int i = 0; i < 20; ++i, ++tried) {
      std::string bytes = log.log;
      const std::size_t at = log.boxes[static_cast<std::size_t>(rng.below(static_cast<int>(log.boxes.size())))] + 1;
      const int side = rng.below(4);
      const float lo = float_at(bytes, at + (side % 2) * 4), hi = float_at(bytes, at + 8 + (side % 2) * 4);
      const float by = static_cast<float>(rng.real(0.3, 0.9)) * (hi - lo);
      put_float(bytes, at + static_cast<std::size_t>(side) * 4, side < 2 ? lo + by : hi - by);
      accepted += !refused("a smaller box", log, bytes);
    }
  }
  // The writer's boxes of long chains are wide, and the verifier sees that smaller ones hold as well.
  EXPECT_LT(5 * accepted, tried);
}

TEST_F(DamagedWindows, BoxesOfOtherBodies) {
  Rng rng(4);
  for (const BoxedLog& log : logs()) {
    for (int i = 0; i < 20; ++i) {
      std::string bytes = log.log;
      const auto any = [&] {
        return log.boxes[static_cast<std::size_t>(rng.below(static_cast<int>(log.boxes.size())))];
      };
      const std::size_t a = any() + 1, b = any() + 1;
      if (a == b) continue;
      std::swap_ranges(bytes.begin() + static_cast<std::ptrdiff_t>(a),
                       bytes.begin() + static_cast<std::ptrdiff_t>(a + box_bytes),
                       bytes.begin() + static_cast<std::ptrdiff_t>(b));
      refused("boxes exchanged", log, bytes);
      bytes = log.log;
      put_float(bytes, a, float_at(bytes, a) + 1000);
      put_float(bytes, a + 8, float_at(bytes, a + 8) + 1000);
      EXPECT_TRUE(refused("a box elsewhere", log, bytes));
      bytes = log.log;
      put_float(bytes, a, NAN);
      EXPECT_TRUE(refused("not a box", log, bytes));
    }
  }
}

/// A body without its flag, a box without its bytes, a pair without its byte, a window without its end.
TEST_F(DamagedWindows, ThingsLeftOut) {
  Rng rng(5);
  for (const BoxedLog& log : logs()) {
    for (const std::size_t at : log.boxes) {
      refused("a body left out", log, log.log.substr(0, at) + log.log.substr(at + 1 + box_bytes));
      refused("a box left out", log, log.log.substr(0, at) + '\0' + log.log.substr(at + 1 + box_bytes));
    }
    for (std::size_t at = log.pairs; at < std::min(log.log.size(), log.pairs + 40); ++at)
      refused("a byte of the pairs left out", log, log.log.substr(0, at) + log.log.substr(at + 1));
    EXPECT_TRUE(refused("windows left out", log, log.log.substr(0, log.window)));
    EXPECT_TRUE(refused("windows left out", log, log.log.substr(0, log.pairs - 1)));
    if (log.pairs < log.log.size()) refused("the pairs left out", log, log.log.substr(0, log.pairs));
    refused("a window of the other kind", log, log.log.substr(0, log.window) + '\0' + log.log.substr(log.window + 1));
    EXPECT_TRUE(refused("a half left out", log, log.log.substr(0, log.window) + '\0' + log.log.substr(log.window)));
  }
}

/// All bodies in the boxes that they have at the start, no two of which meet: a short proof that nothing ever happens,
/// if nobody looked where the bodies go.
TEST(ForgedWindows, BodiesThatLeaveTheirBoxes) {
  int forged = 0;
  for (std::uint64_t seed = 500; forged < static_cast<int>(effort(20)); ++seed) {
    const Scene scene = scene_of(large_world(seed).world);
    if (check(scene).outcome != Outcome::contact) continue;
    const proof::VerifierScene proved(scene);
    const Instance instance(scene);
    std::ostringstream log;
    proof::ByteWriter out(log);
    proof::write_header(out, {proof::of_separations, scene_fingerprint(scene, Touch::open), Touch::open,
                              static_cast<std::uint8_t>(proof::Claim::free)});
    out.u8(1);
    for (const int body : moving_bodies(proved, {})) {
      const AxisBox b =
          grown(swept_box(instance.bodies()[static_cast<std::size_t>(body)], scene.start, scene.start), 1e-6);
      out.u8(1);
      for (const double side : {b.lo_x, b.lo_y, b.hi_x, b.hi_y}) {
        const auto single = static_cast<float>(side);
        std::uint32_t bits;
        std::memcpy(&bits, &single, sizeof bits);
        out.u32(bits);
      }
    }
    out.close();
    ++forged;
    std::istringstream in(log.str());
    try {
      verify(scene, in);
      ADD_FAILURE() << "accepted: seed " << seed;
    } catch (const ProofError& error) {
      EXPECT_NE(std::string(error.what()).find("within its box"), std::string::npos) << error.what();
    }
  }
}

/// One window without a box, of many bodies that move: all pairs meet, and the log has no bytes for them. What is done
/// is in proportion to the scene and the log, and a limit ends what is left of it, also where a log comes by a pipe.
TEST(ForgedWindows, OfMoreBodiesThanBytes) {
  Scene scene;
  scene.end = 1;
  const int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double x = 3.0 * i;
    Body body{"b" + std::to_string(i), {{x, 0}, {x + 1, 0}, {x, 1}}, {}};
    MotionPiece piece;
    piece.x = {0, 1e-3 * (i + 1)};
    body.motion.pieces = {piece};
    scene.bodies.push_back(body);
  }
  std::ostringstream log;
  proof::ByteWriter out(log);
  proof::write_header(out, {proof::of_separations, scene_fingerprint(scene, Touch::open), Touch::open,
                            static_cast<std::uint8_t>(proof::Claim::free)});
  out.u8(1);
  for (int i = 0; i < n; ++i) out.u8(0);
  out.close();
  const std::uint64_t before = work_spent();
  std::istringstream in(log.str());
  EXPECT_THROW(verify(scene, in), ProofError);
  // All pairs would be eight million.
  EXPECT_LT(work_spent() - before, 400000u);
  std::istringstream again(log.str());
  const Budget limit(std::uint64_t{1000});
  EXPECT_THROW(verify(scene, again), Interrupted);
}

/// A stream that cannot be asked for its length.
TEST(ForgedWindows, NoneFromAPipe) {
  class Pipe : public std::streambuf {
   public:
    explicit Pipe(std::string bytes) : bytes_(std::move(bytes)) {
      setg(bytes_.data(), bytes_.data(), bytes_.data() + bytes_.size());
    }

   private:
    std::string bytes_;
  };
  const Scene scene = scene_of(large_world(3).world);
  std::ostringstream out;
  CheckOptions options;
  options.engine = EngineChoice::spacetime;
  const Answer answer = prove(scene, out, options);
  ASSERT_NE(answer.outcome, Outcome::overlap_at_start);
  Pipe pipe(out.str());
  std::istream in(&pipe);
  EXPECT_EQ(verify(scene, in).outcome, answer.outcome);
}

/// Logs of version 3 are refused by that name.
TEST(ForgedWindows, OfVersionThree) {
  const Scene scene = scene_of(large_world(2).world);
  std::ostringstream out;
  prove(scene, out);
  std::string log = out.str();
  ASSERT_GT(log.size(), 50u);
  log[7] = '3';
  std::istringstream in(sealed(log.substr(0, log.size() - 8)));
  try {
    verify(scene, in);
    ADD_FAILURE();
  } catch (const ProofError& error) {
    EXPECT_NE(std::string(error.what()).find("version 3"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace taut::testing
