// Logs about mechanisms: valid for their scene, and for no other one.
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "proof/mechanism_cells.hpp"
#include "scene/mechanism.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"

namespace taut::testing {
using namespace internal;
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

/// The part of a log about cells, as it is written for a scene.
std::string cells_of(const Scene& scene) {
  std::ostringstream out;
  proof::ByteWriter bytes(out);
  proof::write_cells(bytes, *scene.assembly);
  bytes.close();
  return out.str();
}

Scene moved_by(const Scene& scene, const std::string& cells) {
  std::istringstream in(cells);
  proof::ByteReader bytes(in);
  return proof::with_stated_cells(scene, bytes);
}

/// Engines, writers and verifiers see the same functions, to the last bit.
TEST(MechanismLogs, StateTheCellsThatMoveTheScene) {
  for (const std::string name : {"crank_rocker", "excavator", "jansen", "scissor_lift", "toggle_press"}) {
    SCOPED_TRACE(name);
    const Scene scene = example(name), read = moved_by(scene, cells_of(scene));
    const JointFunctions &own = *scene.assembly->functions, &stated = *read.assembly->functions;
    ASSERT_NE(&own, &stated);
    ASSERT_EQ(own.pieces(), stated.pieces());
    for (std::size_t piece = 0; piece < own.pieces(); ++piece) {
      ASSERT_EQ(own.cells(piece).size(), stated.cells(piece).size());
      for (std::size_t k = 0; k < own.cells(piece).size(); ++k) {
        const LoopCell &a = own.cells(piece)[k], &b = stated.cells(piece)[k];
        EXPECT_EQ(a.c, b.c);
        EXPECT_EQ(a.error, b.error);
        EXPECT_EQ(a.tube, b.tube);
        EXPECT_EQ(a.radius, b.radius);
      }
    }
    for (const Body& body : read.bodies) {
      for (const MotionPiece& piece : body.motion.pieces) {
        const auto* const follower = std::get_if<JointFollower>(&piece.rotation);
        EXPECT_TRUE(!follower || follower->functions.get() == &stated);
      }
    }
  }
}

/// A byte is the sign, exponent or leading bits of a coefficient, a time, a kind or a number of these.
TEST(MechanismLogs, RefuseCellsThatAreNotRight) {
  const Scene scene = example("crank_rocker");
  const std::string cells = cells_of(scene);
  int refused = 0;
  for (std::size_t at = 0; at + 8 < cells.size(); ++at) {
    std::string bytes = cells;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x08);
    try {
      const Scene moved = moved_by(scene, bytes);
      // Low bits of a coefficient: the functions are the same ones, if less well known.
      const JointFunctions &own = *scene.assembly->functions, &stated = *moved.assembly->functions;
      const LoopCell &a = own.cells(0).back(), &b = stated.cells(0).back();
      for (std::size_t i = 0; i < a.c.size(); ++i)
        EXPECT_NEAR(a.approximate(i, a.to), b.approximate(i, b.to), 1e-6) << at;
    } catch (const ProofError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, static_cast<int>(cells.size()) / 8);
  EXPECT_THROW(moved_by(scene, cells.substr(0, cells.size() / 2)), ProofError);
  EXPECT_THROW(moved_by(scene, std::string(4, '\0')), ProofError);
}

/// The same bars can be assembled in another way, in which the loop closes as well. Cells of that are right solutions
/// of the equations, and not the mechanism that was drawn.
TEST(MechanismLogs, RefuseTheOtherBranch) {
  const Scene scene = example("crank_rocker");
  const LoopEquations& equations = scene.assembly->functions->equations();
  const LoopCurve curve{equations, 0, equations.unknowns};
  std::optional<Balls<double>> other;
  for (double a = -180; a < 180 && !other; a += 15) {
    for (double b = -180; b < 180 && !other; b += 15) {
      std::vector<double> y{a, b};
      const auto inverse = newton(curve, y, scene.start);
      if (!inverse || std::fabs(std::remainder(y[0], 360)) < 1 || std::fabs(y[0]) + std::fabs(y[1]) > 360) continue;
      other = solve_at<double>(curve, y, scene.start, *inverse, weights_of(equations));
    }
  }
  ASSERT_TRUE(other);
  LoopPath path = follow(equations, 0, scene.start, scene.end, *other);
  ASSERT_FALSE(path.singular);
  Scene assembled_otherwise = scene;
  AssembledMechanism mechanism = *scene.assembly;
  mechanism.functions = std::make_shared<const JointFunctions>(
      equations, std::vector<std::vector<LoopCell>>{std::move(path.cells)}, std::nullopt);
  assembled_otherwise.assembly = std::make_shared<const AssembledMechanism>(mechanism);
  EXPECT_THROW(moved_by(scene, cells_of(assembled_otherwise)), ProofError);
}

/// A drive that does not begin in the drawn pose: the way there has cells as well.
TEST(MechanismLogs, StateTheWayToTheBeginning) {
  Scene given = example("crank_rocker");
  for (Body& body : given.bodies) {
    body.motion = {};
    body.relative_to.clear();
  }
  given.assembly = nullptr;
  given.mechanism->drives[0].pieces[0].line = {given.start, 40, given.end, 200};
  const Scene scene = assembled(given);
  ASSERT_FALSE(scene.assembly->approach.empty());
  EXPECT_EQ(moved_by(scene, cells_of(scene)).assembly->functions->cells(0).back().error,
            scene.assembly->functions->cells(0).back().error);
  for (const Touch touch : {Touch::open, Touch::closed}) {
    CheckOptions options;
    options.touch = touch;
    std::stringstream log;
    const Answer answer = prove(scene, log, options);
    EXPECT_EQ(verify(scene, log).outcome, answer.outcome);
  }
}

/// Discs at the pins, and one in the way: the logs of the polygons around and within them state cells each.
TEST(MechanismLogs, OfCurves) {
  Scene given = example("crank_rocker");
  const auto disc = [](const Point& at, double r) {
    return CurvedPart{{{at.x - r, at.y},
                       {ArcTo{r, r, 0, false, true, {at.x + r, at.y}}, ArcTo{r, r, 0, false, true, {at.x - r, at.y}}}},
                      {}};
  };
  ASSERT_EQ(given.bodies[2].name, "coupler");
  for (const bool meets : {true, false}) {
    Scene scene = given;
    const Point tip = scene.bodies[2].polygon[0];
    scene.end = 200;  // the bars meet later
    scene.bodies.push_back({"disc", {}, {}});
    Body& added = scene.bodies.back();
    added.curves.push_back(disc({tip.x, tip.y}, 0.5));
    added.relative_to = "coupler";
    scene.bodies.push_back({"post", {}, {}});
    scene.bodies.back().curves.push_back(disc({meets ? -21.0 : -210.0, 0}, 3));
    for (const Body& body : given.bodies) {
      scene.ignore.push_back({body.name, "disc"});
      scene.ignore.push_back({body.name, "post"});
    }
    SCOPED_TRACE(meets);
    std::stringstream log;
    const Answer answer = prove(scene, log, {});
    const Verified proved = verify(scene, log);
    EXPECT_EQ(answer.outcome, meets ? Outcome::contact : Outcome::free);
    EXPECT_EQ(proved.kind, ProofKind::curves);
    EXPECT_EQ(proved.outcome, answer.outcome);
    EXPECT_EQ(proved.free_until, answer.outcome == Outcome::free ? scene.end : answer.free_until);
  }
}

}  // namespace
}  // namespace taut::testing
