// Every scene under examples/ is decided as examples/README.md says.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/io.hpp"
#include "taut/path.hpp"

namespace taut {
namespace {

struct Verdict {
  Outcome outcome;
  double time = 0;  ///< of a contact
};

struct Example {
  std::string file;  ///< within examples/
  Verdict open, closed;
};

void PrintTo(const Example& example, std::ostream* out) { *out << example.file; }

constexpr Verdict is_free{Outcome::free};
constexpr Verdict touches_at(double time) { return {Outcome::contact, time}; }
Example always(const std::string& file, Verdict verdict) { return {file, verdict, verdict}; }

/// The heel, 14 behind the hinge, reaches the wall 4 in front of it.
const double lid_angle = std::acos(-4.0 / 14.0) * 180 / std::numbers::pi;

const std::vector<Example> examples = {
    always("combs.json", is_free),
    always("continents/continents.json", touches_at(0.9623363728206296)),
    always("curves/cam.json", touches_at(81.70361049775896)),
    always("curves/geneva.json", is_free),
    always("curves/hinge.json", touches_at(20)),
    always("curves/slot.json", touches_at(60.28647919598177)),
    always("dips.json", is_free),
    always("gears.json", is_free),
    always("gears_thick_tooth.json", touches_at(0.4422683326461688)),
    always("hello.json", touches_at(8)),
    always("jigsaw.json", is_free),
    always("jigsaw_caught.json", touches_at(0.0684219926100698)),
    // Closed, the lid rests on the rim: touching counts only if asked for.
    {"lid.json", touches_at(lid_angle), touches_at(0)},
    always("lock.json", is_free),
    always("lock_wrong_key.json", touches_at(0.8477171978348304)),
    always("maze.json", is_free),
    always("maze_long_ship.json", touches_at(11.7498423627584215)),
    always("paper/fig1.json", is_free),
    always("paper/fig16.json", is_free),
    always("paper/fig17.json", is_free),
    always("mechanisms/crank_rocker.json", touches_at(236.02480977572432)),
    always("mechanisms/excavator.json", touches_at(0.3236790277704488)),
    always("mechanisms/jansen.json", is_free),
    always("mechanisms/scissor_lift.json", touches_at(7.197676896566034)),
    always("mechanisms/toggle_press.json", {Outcome::locked}),
    always("paper/fig2.json", is_free),
    always("paper/fig3.json", is_free),
    always("paper/fig5.json", is_free),
    always("paper/fig7.json", is_free),
    always("paper/fig8a.json", is_free),
    always("paper/fig8b.json", is_free),
    always("parking.json", is_free),
    always("parking_clips.json", touches_at(6.2544562952190725)),
    always("rotor.json", is_free),
    always("rotor_long_tooth.json", touches_at(0.6663450654749891)),
    always("spiral.json", is_free),
    always("worlds/arm.json", touches_at(0.2472470685612692)),
    {"worlds/bent_bar.json", is_free, touches_at(0)},
    always("worlds/billiards.json", is_free),
    always("worlds/conveyor.json", touches_at(7)),
    always("worlds/drawer.json", touches_at(36)),
    always("worlds/geneva.json", is_free),
    always("worlds/layers.json", is_free),
    always("worlds/planetary.json", is_free),
    always("worlds/puzzle.json", is_free),
    always("worlds/room.json", touches_at(2.283653104061214)),
    always("worlds/shuttle.json", is_free),
};

const std::filesystem::path examples_folder = "examples";

class Examples : public ::testing::TestWithParam<Example> {};

TEST_P(Examples, AreDecidedAsStated) {
  const Scene scene = read_scene((examples_folder / GetParam().file).string());
  for (const Touch touch : {Touch::open, Touch::closed}) {
    const Verdict& expected = touch == Touch::open ? GetParam().open : GetParam().closed;
    CheckOptions options;
    options.touch = touch;
    const Answer answer = check(scene, options);
    SCOPED_TRACE(GetParam().file + ", touch " + to_string(touch));
    EXPECT_STREQ(to_string(answer.outcome), to_string(expected.outcome)) << answer.reason;
    ASSERT_EQ(answer.contact.has_value(), expected.outcome == Outcome::contact);
    if (!answer.contact) continue;
    // Of curves, as wide as CheckOptions::time_tolerance says.
    const double width = answer.geometry ? 1e-9 * (scene.end - scene.start) : 1e-9;
    EXPECT_NEAR(answer.contact->time.lo, expected.time, width);
    EXPECT_NEAR(answer.contact->time.hi, expected.time, width);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Examples, ::testing::ValuesIn(examples));

/// Bodies that never touch keep a distance, and it is that of the play that they were drawn with.
TEST(ExampleWorlds, KeepTheirPlay) {
  const auto least = [](const std::string& file) {
    return clearance(read_scene((examples_folder / "worlds" / file).string())).nearest.value();
  };
  const auto geneva = least("geneva.json"), planetary = least("planetary.json"), puzzle = least("puzzle.json");
  // The pin of radius 1 in a slot that is 2.16 wide.
  EXPECT_GT(geneva.lo, 0.05);
  EXPECT_LT(geneva.hi, 0.08);
  EXPECT_GT(planetary.lo, 0.03);
  EXPECT_LT(planetary.hi, 0.05);
  // Two flanks of slope 2, one of them moved to the side by 0.1.
  EXPECT_NEAR(puzzle.lo, 0.1 * 2 / std::sqrt(5.0), 1e-8);
  EXPECT_NEAR(puzzle.hi, 0.1 * 2 / std::sqrt(5.0), 1e-8);
}

/// A drift of 0.0075 in each unit of time makes up for the 0.2 that there are to spare.
TEST(ExampleWorlds, KeepMarginsOfTheirOwn) {
  const Scene scene = read_scene((examples_folder / "worlds/shuttle.json").string());
  const MarginAnswer answer = check_clearance(scene, 0.25);
  ASSERT_EQ(answer.outcome, Outcome::contact);
  EXPECT_EQ(answer.first->bodies, (std::array{0, 2}));
  EXPECT_NEAR(answer.first->time.lo, 0.2 / 0.0075, 1e-9);
  EXPECT_NEAR(answer.first->margin_at, 0.3, 1e-12);
}

/// Curves that run along each other for long: what margins prove is the lower end.
TEST(ExampleCurves, KeepTheirPlay) {
  const Clearance found = clearance(read_scene((examples_folder / "curves/geneva.json").string()));
  EXPECT_GE(found.nearest.value().lo, 0.07);
  EXPECT_LT(found.nearest->hi, 0.08);
  EXPECT_FALSE(found.wide.empty());
}

TEST(ExampleWorlds, NameThePairThatMeets) {
  const auto pair = [](const std::string& file) {
    const Scene scene = read_scene((examples_folder / "worlds" / file).string());
    const auto [a, b] = check(scene).pair.value();
    return scene.bodies[static_cast<std::size_t>(a)].name + " x " + scene.bodies[static_cast<std::size_t>(b)].name;
  };
  EXPECT_EQ(pair("arm.json"), "shelf x hand");
  EXPECT_EQ(pair("conveyor.json"), "box 3 x gate");
  EXPECT_EQ(pair("drawer.json"), "handle x radiator");
  EXPECT_EQ(pair("room.json"), "pillars x robot");
}

/// Of each linkage, a combination that is free and one that is not, by how it looks.
struct LinkageExample {
  const char* file;
  std::array<double, max_joints> apart, meeting;
};
const LinkageExample linkage_examples[] = {
    // Opened beyond a right angle, the door meets the shelf; the handle can be anywhere.
    {"linkages/door.json", {45, 0}, {110, 0}},
    // The crate goes up to the beam if the platform is raised all the way.
    {"linkages/lift.json", {30, 1}, {60, 1}},
    // Lowered all the way, the arm is in the ground.
    {"linkages/loader.json", {30, 0}, {-35, 0}},
};

TEST(ExampleLinkages, AreFreeAndNot) {
  for (const LinkageExample& example : linkage_examples) {
    SCOPED_TRACE(example.file);
    const Linkage linkage = read_linkage((examples_folder / example.file).string());
    EXPECT_EQ(check(posed(linkage, example.apart)).outcome, Outcome::free);
    EXPECT_EQ(check(posed(linkage, example.meeting)).outcome, Outcome::overlap_at_start);
    const Envelope answer = envelope(linkage);
    EXPECT_EQ(answer.outcome, Outcome::contact);
    EXPECT_LT(answer.undecided, 2e-3);
    for (const EnvelopeCell& cell : answer.cells) {
      const auto holds = [&](const std::array<double, max_joints>& values) {
        return cell.lo[0] < values[0] && values[0] < cell.hi[0] && cell.lo[1] < values[1] && values[1] < cell.hi[1];
      };
      if (holds(example.apart)) {
        EXPECT_EQ(cell.state, CellState::free);
      }
      if (holds(example.meeting)) {
        EXPECT_EQ(cell.state, CellState::colliding);
      }
    }
  }
}

/// Of each path problem, what is the answer, in both touch modes.
struct PathExample {
  const char* file;
  PathOutcome outcome;
};
const PathExample path_examples[] = {
    {"paths/arm.json", PathOutcome::path},      {"paths/bracket.json", PathOutcome::path},
    {"paths/piano.json", PathOutcome::path},    {"paths/piano_long.json", PathOutcome::none},
    {"paths/reach.json", PathOutcome::none},    {"paths/excavator.json", PathOutcome::path},
    {"paths/five_bar.json", PathOutcome::path},
};

TEST(ExamplePaths, HaveTheStatedOutcomes) {
  for (const PathExample& example : path_examples) {
    SCOPED_TRACE(example.file);
    const PathProblem problem = read_path_problem((examples_folder / example.file).string());
    for (const Touch touch : {Touch::open, Touch::closed}) {
      PathOptions options;
      options.touch = touch;
      const PathAnswer answer = find_path(problem, options);
      EXPECT_EQ(answer.outcome, example.outcome) << answer.reason;
      if (answer.outcome == PathOutcome::path) {
        CheckOptions check_options;
        check_options.touch = touch;
        EXPECT_EQ(check(path_scene(problem, answer.waypoints), check_options).outcome, Outcome::free);
      }
    }
  }
  // Without a turn the bracket stays in its case.
  PathProblem bracket = read_path_problem((examples_folder / "paths/bracket.json").string());
  bracket.linkage.joints[2] = {"turn", 0, 0};
  bracket.periodic = {};
  EXPECT_EQ(find_path(bracket).outcome, PathOutcome::none);
}

TEST(ExamplesFolder, HoldsNoSceneThatIsNotStated) {
  std::vector<std::string> stated, found;
  for (const PathExample& example : path_examples) stated.push_back(example.file);
  for (const LinkageExample& example : linkage_examples) stated.push_back(example.file);
  for (const Example& example : examples) stated.push_back(example.file);
  for (const auto& entry : std::filesystem::recursive_directory_iterator(examples_folder)) {
    if (entry.path().extension() == ".json")
      found.push_back(entry.path().lexically_relative(examples_folder).generic_string());
  }
  std::sort(found.begin(), found.end());
  std::sort(stated.begin(), stated.end());
  EXPECT_EQ(found, stated);
}

}  // namespace
}  // namespace taut
