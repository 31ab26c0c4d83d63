// Other units of time and of length, by powers of two, change nothing but the numbers: each question has the same
// outcome, and takes the same work.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "numeric/budget.hpp"
#include "soak/soak_scene.hpp"
#include "support/effort.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"

namespace taut::testing {
using namespace internal;
namespace {

void rescale(Coefficients& c, int lengths, int times) {
  for (std::size_t k = 0; k < c.size(); ++k) c[k] = std::ldexp(c[k], lengths - static_cast<int>(k) * times);
}
void rescale(Point& p, int lengths) { p = {std::ldexp(p.x, lengths), std::ldexp(p.y, lengths)}; }

/// Lengths times 2^lengths, times times 2^times.
Scene in_other_units(Scene scene, int lengths, int times) {
  scene.start = std::ldexp(scene.start, times);
  scene.end = std::ldexp(scene.end, times);
  for (Body& body : scene.bodies) {
    for (Point& p : body.polygon) rescale(p, lengths);
    for (MotionPiece& piece : body.motion.pieces) {
      piece.until = std::ldexp(piece.until, times);
      piece.origin = std::ldexp(piece.origin, times);
      rescale(piece.x, lengths, times);
      rescale(piece.y, lengths, times);
      rescale(piece.pivot, lengths);
      rescale(piece.orbit.angle, 0, times);
      rescale(piece.orbit.centre, lengths);
      if (auto* r = std::get_if<AngleRotation>(&piece.rotation)) rescale(r->angle, 0, times);
      if (auto* r = std::get_if<HalfAngleRotation>(&piece.rotation)) rescale(r->s, 0, times);
      if (auto* r = std::get_if<CosineRotation>(&piece.rotation)) rescale(r->a, 0, times);
      if (auto* r = std::get_if<DirectionRotation>(&piece.rotation)) {
        rescale(r->a, 0, times);
        rescale(r->b, 0, times);
      }
    }
  }
  return scene;
}

struct Effort {
  std::string outcome;
  std::uint64_t work = 0;
};

Effort effort_of(const Scene& scene, int question, Touch touch, double clearance) {
  CheckOptions options;
  options.touch = touch;
  options.tell_touching = false;
  options.limits.max_seconds = 1;
  const std::uint64_t before = work_spent();
  Effort spent;
  if (question < 2) {
    options.engine = question == 0 ? EngineChoice::kinetic : EngineChoice::spacetime;
    spent.outcome = to_string(check(scene, options).outcome);
  } else if (question == 2) {
    const Intervals found = intervals(scene, options);
    spent.outcome = std::to_string(found.intervals.size()) + (found.undecided.empty() ? "" : " undecided");
  } else if (question == 3) {
    ClearanceOptions how;
    how.limits.max_seconds = 1;
    spent.outcome = taut::clearance(scene, how).wide;
  } else if (question == 4) {
    spent.outcome = to_string(check_clearance(scene, clearance, options).outcome);
  } else {
    ProfileOptions how;
    how.instants = 5;
    how.limits.max_seconds = 1;
    spent.outcome = distance_profile(scene, how).reason;
  }
  spent.work = work_spent() - before;
  return spent;
}

const char* const names_of_questions[] = {"kinetic", "spacetime", "intervals", "clearance", "margin", "profile"};

/// What was asked, and how often it took more than a tenth more in one of the units.
struct UnitCounts {
  int all = 0, other_work = 0;
};

void expect_same_in_other_units(const Scene& scene, int lengths, int times, bool profile, UnitCounts& counts) {
  const Scene other = in_other_units(scene, lengths, times);
  const Polygon& first = scene.bodies[0].polygon;
  const double margin = 0.25 * std::fabs(first[0].x - first[1].x) + 0.01;
  for (const Touch touch : {Touch::open, Touch::closed}) {
    for (int question = 0; question < (profile ? 6 : 5); ++question) {
      const Effort a = effort_of(scene, question, touch, margin);
      const Effort b = effort_of(other, question, touch, std::ldexp(margin, lengths));
      EXPECT_EQ(a.outcome, b.outcome) << names_of_questions[question] << ", " << to_string(touch);
      const double less = static_cast<double>(std::min(a.work, b.work)),
                   more = static_cast<double>(std::max(a.work, b.work));
      EXPECT_LE(more, 4 * less + 1000) << names_of_questions[question] << ", " << to_string(touch);
      ++counts.all;
      counts.other_work += more > 1.1 * less + 100;
    }
  }
}

TEST(Units, OfTimeAndLengthChangeNoOutcomeAndNoWork) {
  UnitCounts counts;
  for (std::uint64_t number = 0; number < effort(400); ++number) {
    for (const bool contacts : {false, true}) {
      const Scene scene = contacts ? soak_contact_scene(number).scene : soak_scene(number).scene;
      for (const auto& [lengths, times] : {std::pair{0, 28}, std::pair{0, -28}, std::pair{20, 0}, std::pair{-20, 0}}) {
        SCOPED_TRACE((contacts ? "contact scene " : "scene ") + std::to_string(number) + ", lengths times 2^" +
                     std::to_string(lengths) + ", times 2^" + std::to_string(times));
        try {
          expect_same_in_other_units(scene, lengths, times, number % 8 == 0, counts);
        } catch (const InputError&) {
          // Some scenes of the soak are not valid.
        }
      }
    }
  }
  EXPECT_LE(counts.other_work, counts.all / 500);
}

/// Slivers about pivots that are far away: a motion that is exactly zero but for a turn, over many units of time.
TEST(Units, OfSliversThatTurn) {
  const double far = 0x1p34, thin = 0x1p-21;
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"P", {{0, 0}, {0.5, 0}, {1, 0}, {1, thin}, {1, 2 * thin}, {0.5, 2 * thin}}, {}},
                  {"Q", {{far - 1, -3 * thin}, {far - 0.5, -2 * thin}, {far, -thin}, {far - 1, -thin}}, {}}};
  MotionPiece turn;
  turn.x = {3.5 - far};
  turn.y = {4 * thin};
  turn.rotation = DirectionRotation{{1}, {0, 1}};
  turn.pivot = {far, 0};
  scene.bodies[1].motion.pieces = {turn};
  UnitCounts counts;
  for (const int times : {28, -28}) expect_same_in_other_units(scene, 0, times, false, counts);
  for (const int lengths : {-30}) expect_same_in_other_units(scene, lengths, 0, false, counts);
  EXPECT_EQ(counts.other_work, 0);
}

}  // namespace
}  // namespace taut::testing
