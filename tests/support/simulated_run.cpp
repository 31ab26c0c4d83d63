#include "support/simulated_run.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "support/responses.hpp"
#include "support/simulated_worlds.hpp"
#include "taut/error.hpp"
#include "taut/pose.hpp"

namespace taut::testing {
namespace {

class SimulatedRun {
 public:
  SimulatedRun(std::uint64_t number, const Scene& scene, Touch touch, RunTally& tally)
      : rng_(number),
        touch_(touch),
        tally_(tally),
        simulation_(scene, options(touch)),
        there_(scene.bodies.size(), true) {
    names_ = static_cast<int>(scene.bodies.size());
  }

  std::string wrong(int calls) {
    for (int k = 0; k < calls && goes_on(); ++k) {
      ++tally_.calls;
      std::string found;
      try {
        found = call();
      } catch (const InputError&) {
        ++tally_.refused;
      }
      if (!found.empty())
        return "call " + std::to_string(k) + ", at " + std::to_string(simulation_.time()) + ": " + found;
    }
    tally_.ends += simulation_.state() == SimulationState::finished;
    return wrong_in_record();
  }

 private:
  static SimulationOptions options(Touch touch) {
    SimulationOptions options;
    options.touch = touch;
    options.record = true;
    return options;
  }

  bool goes_on() const {
    return simulation_.state() == SimulationState::running || simulation_.state() == SimulationState::contact;
  }

  /// One that is still there.
  BodyId any_body() {
    for (;;) {
      const int k = rng_.below(static_cast<int>(there_.size()));
      if (there_[static_cast<std::size_t>(k)]) return k;
    }
  }

  std::string call() {
    if (simulation_.state() == SimulationState::contact) return answer_contact();
    const double now = simulation_.time(), end = simulation_.scene().end;
    switch (rng_.below(10)) {
      case 0:
      case 1:
        return compare_next_contact(end);
      case 2:
        return compare_next_contact(now + (end - now) * rng_.real(0, 0.3));
      case 3:
        simulation_.step();
        return "";
      case 4:
        simulation_.next_event();
        return "";
      case 5:
        return change_motion();
      case 6:
        return add_body();
      case 7:
        return remove_body();
      case 8:
        return attach();
      default:
        simulation_.ignore(any_body(), any_body());
        return "";
    }
  }

  std::string change_motion() {
    const BodyId body = any_body();
    simulation_.set_motion(
        body, going_on(simulation_.scene().bodies[static_cast<std::size_t>(body)], simulation_.time(), rng_));
    return "";
  }

  /// Some are attached to others, some have layers, and some are larger than all others.
  std::string add_body() {
    if (!rng_.chance(0.5)) return "";
    const bool large = rng_.chance(0.05);
    const double x = large ? 300 : rng_.real(-4, 4), y = rng_.real(-4, 4), size = large ? 20 : rng_.real(0.05, 0.4);
    Body body{"new " + std::to_string(names_++), {{x, y}, {x + size, y}, {x, y + size}}, {}};
    body.motion = Motion{{{{0, rng_.real(-1, 1)}, {0, rng_.real(-1, 1)}, NoRotation{}}}};
    body.motion.pieces[0].origin = simulation_.time();
    if (rng_.chance(0.2)) body.motion = {};
    if (rng_.chance(0.2)) body.relative_to = simulation_.scene().bodies[static_cast<std::size_t>(any_body())].name;
    if (rng_.chance(0.1)) body.z = {0, rng_.real(0.5, 2)};
    simulation_.add_body(body);
    there_.push_back(true);
    return "";
  }

  std::string remove_body() {
    if (!rng_.chance(0.4) || std::count(there_.begin(), there_.end(), true) < 4) return "";
    const BodyId body = any_body();
    simulation_.remove_body(body);
    there_[static_cast<std::size_t>(body)] = false;
    return "";
  }

  /// A body rests on another one from now on, which moves on a straight line, or leaves it.
  std::string attach() {
    const BodyId body = any_body(), parent = any_body();
    if (body == parent) return "";
    const std::vector<BodyPose> poses = poses_at(simulation_.scene(), simulation_.time());
    const BodyPose &at = poses[static_cast<std::size_t>(body)], &from = poses[static_cast<std::size_t>(parent)];
    const bool leaves = rng_.chance(0.5);
    const Point d{at.origin.x - from.origin.x, at.origin.y - from.origin.y};
    const Point seen{from.axis.x * d.x + from.axis.y * d.y, from.axis.x * d.y - from.axis.y * d.x};
    const double angle = std::atan2(at.axis.y, at.axis.x) - (leaves ? 0 : std::atan2(from.axis.y, from.axis.x));
    MotionPiece piece;
    piece.x = {leaves ? at.origin.x : seen.x};
    piece.y = {leaves ? at.origin.y : seen.y};
    piece.rotation = AngleRotation{{angle}};
    simulation_.set_parent(body, leaves ? std::nullopt : std::optional(parent), Motion{{piece}});
    return "";
  }

  /// Mostly the bodies part; now and then they go on as they were, or some other way.
  std::string answer_contact() {
    const double before = simulation_.time();
    const Contact contact = *simulation_.contact();
    const bool stays = rng_.chance(0.1);
    // At the start there is no time before, in which they could part.
    if (before == simulation_.record().front().start && !stays) {
      simulation_.ignore(simulation_.contact()->vertex.body, simulation_.contact()->edge.body);
    } else if (rng_.chance(0.1)) {
      change_motion();
    } else if (!stays) {
      part_all(simulation_, rng_);
      note_removed();
    }
    simulation_.resume();
    if (simulation_.state() != SimulationState::contact) return "";
    ++tally_.again;
    // Another pair may come so close after it that doubles do not tell the times apart.
    const Contact& now = *simulation_.contact();
    const bool same = now.vertex == contact.vertex && now.edge == contact.edge;
    if (!simulation_.contact_again() && same) return "a contact at once is not said to be one again";
    return simulation_.time() < before ? "time goes back" : "";
  }

  void note_removed() {
    for (std::size_t k = 0; k < there_.size(); ++k)
      there_[k] = simulation_.scene().bodies[k].name.find(", removed)") == std::string::npos;
  }

  std::string compare_next_contact(double until) {
    const double from = simulation_.time();
    if (!(until > from)) return "";
    const Answer answer = asked_afresh(simulation_, touch_);
    if (answer.outcome == Outcome::free || answer.outcome == Outcome::contact) {
      const Coverage here = simulation_.coverage();
      if (here.pairs != answer.coverage.pairs || here.ignored != answer.coverage.ignored)
        return "it does not ignore what the rest of its scene ignores";
    }
    simulation_.advance_to(until);
    const SimulationState state = simulation_.state();
    if (state == SimulationState::undecided) return tiling_decides() ? simulation_.reason() : "";
    if (answer.outcome == Outcome::undecided) return "";
    const bool met = state == SimulationState::contact;
    if (met) ++tally_.contacts;
    if (met && !simulation_.also().empty()) ++tally_.several;
    // By the rounding of new motions, which the simulation follows from the old ones.
    if (answer.outcome == Outcome::overlap_at_start && state != SimulationState::overlap_at_start)
      return met && simulation_.time() == from ? "" : std::string("bodies overlap, and it is ") + to_string(state);
    if (answer.outcome == Outcome::overlap_at_start) return "";
    if (!answer.contact) return met && simulation_.time() > from ? "a contact where there is none" : "";
    const TimeInterval& expected = answer.contact->time;
    // So, too, where they overlap on the way from one to the other.
    if (met && simulation_.time() == from && expected.lo > from) return "";
    if (!met) return expected.hi < until ? "no contact where there is one at " + std::to_string(expected.lo) : "";
    const TimeInterval& found = simulation_.contact()->time;
    const bool same = std::fabs(found.lo - expected.lo) < 1e-9 && std::fabs(found.hi - expected.hi) < 1e-9;
    if (!same) return "a contact at " + std::to_string(found.lo) + " instead of " + std::to_string(expected.lo);
    if (simulation_.time() > found.hi) return "the present is after the contact";
    return simulation_.relative_velocity(*simulation_.contact()).along_normal.lo > 1e-9 ? "bodies that part meet" : "";
  }

  /// Whether the same engine decides about all that was recorded.
  bool tiling_decides() const {
    CheckOptions options;
    options.touch = touch_;
    options.engine = EngineChoice::kinetic;
    for (Scene scene : simulation_.record()) {
      scene.end = simulation_.scene().end;
      if (check(scene, options).outcome == Outcome::undecided) return false;
    }
    return true;
  }

  std::string wrong_in_record() {
    double until = 0;
    for (Scene scene : simulation_.record()) {
      ++tally_.scenes;
      until = scene.end;
      // Bodies at rest were no pairs of the simulation, also where nothing else moved for a while.
      scene.at_rest = AtRest::never;
      const Answer answer = fresh_answer(scene, touch_);
      if (answer.outcome == Outcome::contact) {
        // A contact at the start of everything, or at the end.
        if (answer.contact->time.lo == simulation_.record().front().start) return "";
        return "the record has a contact at " + std::to_string(answer.contact->time.lo);
      }
      // Bodies that moved alike and overlapped were no pair, until one of them moved in another way.
      const bool parted = simulation_.state() == SimulationState::overlap_at_start;
      // New motions are rounded. An overlap below 2^-150 of all bodies' size counts as touching, and scenes of the
      // record differ in size.
      const bool rounded = answer.outcome == Outcome::overlap_at_start && !answer.overlap_point;
      if (answer.outcome == Outcome::overlap_at_start && !parted && !rounded)
        return "the record has an overlap at its start";
    }
    return until == simulation_.time() ? "" : "the record ends before the present";
  }

  Rng rng_;
  Touch touch_;
  RunTally& tally_;
  Simulation simulation_;
  std::vector<bool> there_;
  int names_ = 0;
};

}  // namespace

std::string wrong_with_run(std::uint64_t number, const Scene& scene, Touch touch, int calls, RunTally& tally) {
  return SimulatedRun(number, scene, touch, tally).wrong(calls);
}

}  // namespace taut::testing
