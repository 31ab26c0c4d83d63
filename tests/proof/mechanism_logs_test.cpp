// Logs about mechanisms: valid for their scene, and for no other one.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
namespace {

Scene example(const std::string& name) { return read_scene("examples/mechanisms/" + name + ".json"); }

TEST(MechanismLogs, ProveWhatChecksSay) {
  for (const std::string name : {"crank_rocker", "excavator", "jansen", "scissor_lift", "toggle_press"}) {
    SCOPED_TRACE(name);
    const Scene scene = example(name);
    for (const Touch touch : {Touch::open, Touch::closed}) {
      CheckOptions options;
      options.touch = touch;
      std::stringstream log;
      const Answer answer = prove(scene, log, options);
      EXPECT_EQ(answer.outcome, check(scene, options).outcome);
      const Verified proved = verify(scene, log);
      EXPECT_EQ(proved.outcome, answer.outcome);
      EXPECT_EQ(proved.free_until, answer.contact ? answer.contact->time.lo : scene.end);
    }
  }
}

TEST(MechanismLogs, ProveClearancesUpToALock) {
  const Scene scene = example("toggle_press");
  std::stringstream log;
  EXPECT_EQ(prove_clearance(scene, 0.1, log).outcome, Outcome::locked);
  const Verified proved = verify(scene, log);
  EXPECT_EQ(proved.outcome, Outcome::locked);
  EXPECT_EQ(proved.clearance, 0.1);
  std::stringstream closer;
  EXPECT_EQ(prove_clearance(scene, 1, closer).outcome, Outcome::contact);
  EXPECT_EQ(verify(scene, closer).outcome, Outcome::contact);
}

/// Anything that changes the motion changes the fingerprint.
TEST(MechanismLogs, BelongToOneMechanism) {
  Scene scene = example("jansen");
  const auto changed = [&](const auto& change) {
    Scene other = scene;
    for (Body& body : other.bodies) {
      body.motion = {};
      body.relative_to.clear();
    }
    other.assembly = nullptr;
    change(*other.mechanism);
    return scene_fingerprint(assembled(other), Touch::open);
  };
  const Fingerprint own = scene_fingerprint(scene, Touch::open);
  EXPECT_EQ(changed([](Mechanism&) {}), own);
  EXPECT_EQ(changed([](Mechanism& m) {
              for (MechanismJoint& joint : m.joints) joint.name += "'";
              for (taut::Drive& drive : m.drives) drive.joint += "'";
            }),
            own);
  EXPECT_NE(changed([](Mechanism& m) { m.joints[1].at.x += 1e-9; }), own);
  EXPECT_NE(changed([](Mechanism& m) { std::swap(m.joints[0].first, m.joints[0].second); }), own);
  EXPECT_NE(changed([](Mechanism& m) { (*m.drives[0].pieces[0].line)[3] = 350; }), own);
  EXPECT_NE(changed([](Mechanism& m) { m.drives[0].pieces[0] = {INFINITY, {}, {0, 1}}; }), own);
}

}  // namespace
}  // namespace taut::testing
