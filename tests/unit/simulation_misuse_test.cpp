// What a simulation says to times that are none, and after an exception in the middle of an event.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random_scenes.hpp"
#include "taut/error.hpp"
#include "taut/simulation.hpp"

namespace taut {
namespace {

Body square(const char* name, Coefficients x) {
  Body body{name, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}};
  body.motion.pieces.push_back({std::move(x), {}, NoRotation{}});
  return body;
}

/// The right square reaches the left one at t = 2.
Scene meeting() {
  Scene scene;
  scene.bodies = {square("a", {0}), square("b", {3, -1})};
  scene.start = 0;
  scene.end = 10;
  return scene;
}

struct Stop {};

class ThrowsAt : public Tracer {
 public:
  explicit ThrowsAt(std::uint64_t event, bool input_error = false) : event_(event), input_error_(input_error) {}
  void on_event(const TraceEvent& event) override {
    if (event.number != event_) return;
    if (input_error_) throw InputError("tracer", "enough");
    throw Stop{};
  }

 private:
  std::uint64_t event_;
  bool input_error_;
};

void expect_unusable(Simulation& simulation) {
  EXPECT_THROW(simulation.state(), UnusableError);
  EXPECT_THROW(simulation.time(), UnusableError);
  EXPECT_THROW(simulation.next_event(), UnusableError);
  EXPECT_THROW(simulation.step(), UnusableError);
  EXPECT_THROW(simulation.advance_to(10), UnusableError);
  EXPECT_THROW(simulation.set_motion(0, {}), UnusableError);
  EXPECT_THROW(simulation.contact(), UnusableError);
  EXPECT_THROW(simulation.events(), UnusableError);
  EXPECT_THROW(simulation.certificates(), UnusableError);
  EXPECT_THROW(simulation.tiling(), UnusableError);
  EXPECT_THROW(simulation.halfedges(), UnusableError);
  EXPECT_THROW(simulation.changed_halfedges(), UnusableError);
  EXPECT_THROW(simulation.active_set(), UnusableError);
  EXPECT_THROW(simulation.levels(0), UnusableError);
  EXPECT_THROW(simulation.geodesic_cycle(0, 0), UnusableError);
}

TEST(SimulationMisuse, ATimeThatIsNotANumberIsAnError) {
  Simulation simulation(meeting());
  try {
    simulation.advance_to(std::nan(""));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problem(), "the time to advance to is not a number");
    EXPECT_NE(error.hint(), "");
  }
  EXPECT_EQ(simulation.time(), 0);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(simulation.advance_to(-infinity), SimulationState::running);
  EXPECT_EQ(simulation.time(), 0);
  EXPECT_EQ(simulation.advance_to(infinity), SimulationState::contact);
}

TEST(SimulationMisuse, AnExceptionInAnEventIsTheEndOfTheSimulation) {
  Simulation whole(meeting());
  whole.advance_to(10);
  ASSERT_GT(whole.events(), 0u);
  // The last one is the collision.
  for (std::uint64_t event = 1; event <= whole.events(); ++event) {
    for (const bool input_error : {false, true}) {
      ThrowsAt tracer(event, input_error);
      Simulation simulation(meeting(), Touch::open, &tracer);
      if (input_error) {
        EXPECT_THROW(simulation.advance_to(10), InputError);
      } else {
        EXPECT_THROW(simulation.advance_to(10), Stop);
      }
      expect_unusable(simulation);
      simulation = Simulation(meeting());
      EXPECT_EQ(simulation.advance_to(10), SimulationState::contact);
    }
  }
}

TEST(SimulationMisuse, RefusedMotionsChangeNothing) {
  Simulation simulation(meeting());
  simulation.advance_to(1);
  EXPECT_THROW(simulation.set_motion(1, square("b", {30}).motion), InputError);
  EXPECT_THROW(simulation.set_motion(2, {}), InputError);
  EXPECT_EQ(simulation.advance_to(10), SimulationState::contact);
}

/// A cosine that would be beyond 1 by now, had its piece not ended.
TEST(SimulationMisuse, PiecesThatArePastNeedNotBeDefinedNow) {
  Scene scene = meeting();
  Body& b = scene.bodies[1];
  b.motion.pieces = {{{30}, {}, CosineRotation{{1, -1}}}, {{30}, {}, CosineRotation{{0}}}};
  b.motion.pieces[0].until = 1;
  Simulation simulation(scene);
  simulation.advance_to(5);
  EXPECT_NO_THROW(simulation.set_motion(1, b.motion));
  EXPECT_EQ(simulation.advance_to(10), SimulationState::finished);
}

}  // namespace
}  // namespace taut
