#include "compare/engines.hpp"

#include <fmt/format.h>

#include <cmath>

#include "taut/check.hpp"
#include "taut/shape.hpp"
#include "taut/simulation.hpp"

namespace taut::bench {
namespace {

/// taut's engines, with or without prepared shapes.
class Taut : public Engine {
 public:
  Taut(EngineChoice engine, bool prepared) : prepared_(prepared) { options_.engine = engine; }

  void set_up(const Contest& contest) override {
    contest_ = &contest;
    scene_ = contest.scene;
    if (!prepared_) return;
    for (Body& body : scene_.bodies) {
      body.prepared = prepare(body.polygon, body.name);
      body.polygon.clear();
    }
    check(scene_, options_);  // what the shapes keep for their roles is made when first needed
  }

  std::vector<Answer> run() override {
    if (contest_->plans.empty()) return {check(scene_, options_)};
    return options_.engine == EngineChoice::kinetic ? follow_plans() : check_plans();
  }

 private:
  /// One simulation, whose plan changes.
  std::vector<Answer> follow_plans() {
    Simulation simulation(scene_);
    std::vector<Answer> answers(contest_->plans.size());
    for (std::size_t k = 0; k < contest_->plans.size(); ++k) {
      if (k > 0) simulation.set_motion(1, contest_->plans[k]);
      simulation.advance_to(static_cast<double>(k + 1));
      answers[k].outcome = simulation.contact() ? Outcome::contact : Outcome::free;
      answers[k].contact = simulation.contact();
    }
    return answers;
  }
  /// A question for each plan.
  std::vector<Answer> check_plans() {
    std::vector<Answer> answers;
    for (std::size_t k = 0; k < contest_->plans.size(); ++k) {
      scene_.bodies[1].motion = contest_->plans[k];
      scene_.start = static_cast<double>(k);
      scene_.end = static_cast<double>(k + 1);
      answers.push_back(check(scene_, options_));
    }
    return answers;
  }

  bool prepared_;
  CheckOptions options_;
  const Contest* contest_ = nullptr;
  Scene scene_;
};

template <EngineChoice engine, bool prepared>
std::unique_ptr<Engine> make() {
  return std::make_unique<Taut>(engine, prepared);
}

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> all{
      {"kinetic, cold", make<EngineChoice::kinetic, false>},
      {"kinetic", make<EngineChoice::kinetic, true>},
      {"spacetime, cold", make<EngineChoice::spacetime, false>},
      {"spacetime", make<EngineChoice::spacetime, true>},
      {"either", make<EngineChoice::either, true>},
  };
  return all;
}

std::string fault(const Contest& contest, const std::vector<Answer>& answers) {
  for (const Answer& answer : answers) {
    if (answer.outcome != contest.outcome)
      return fmt::format("{} instead of {}", to_string(answer.outcome), to_string(contest.outcome));
    if (!contest.contact_time) continue;
    const double t = *contest.contact_time, slack = 1e-12 * std::fabs(t);
    if (!(answer.contact->time.lo - slack <= t && t <= answer.contact->time.hi + slack))
      return fmt::format("contact at {} instead of {}", answer.contact->time.lo, t);
  }
  return {};
}

std::string disagreement(const std::vector<Answer>& first, const std::vector<Answer>& second) {
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (!first[k].contact || !second[k].contact) continue;
    const TimeInterval a = first[k].contact->time, b = second[k].contact->time;
    if (a.lo > b.hi || b.lo > a.hi) return fmt::format("contact at {} and at {}", a.lo, b.lo);
  }
  return {};
}

}  // namespace taut::bench
