#include "taut/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/simulation_impl.hpp"

namespace taut {
using namespace internal;

namespace {

SimulationOptions without_limits(Touch touch, Tracer* tracer) {
  SimulationOptions options;
  options.touch = touch;
  options.tracer = tracer;
  return options;
}

}  // namespace

Simulation::Simulation(const Scene& scene, const SimulationOptions& options)
    : impl_(std::make_unique<Impl>(scene, options)) {}
Simulation::Simulation(const Scene& scene, Touch touch, Tracer* tracer)
    : Simulation(scene, without_limits(touch, tracer)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

Simulation::Impl& Simulation::usable() const {
  if (impl_->broken) throw UnusableError();
  return *impl_;
}

SimulationState Simulation::state() const {
  const Impl& impl = usable();
  if (impl.undecided()) return SimulationState::undecided;
  if (impl.world) {
    const Outcome outcome = impl.world->answer().outcome;
    if (outcome == Outcome::overlap_at_start) return SimulationState::overlap_at_start;
    if (outcome == Outcome::contact) return SimulationState::contact;
    if (!impl.ended()) return SimulationState::running;
    return impl.world->has_tested() ? SimulationState::finished : SimulationState::untested;
  }
  const Session& s = *impl.session;
  if (s.overlap_at_start()) return SimulationState::overlap_at_start;
  if (s.contact()) return SimulationState::contact;
  return s.finished() ? SimulationState::finished : SimulationState::running;
}

const std::string& Simulation::reason() const { return usable().why_undecided(); }

Coverage Simulation::coverage() const {
  const Impl& impl = usable();
  if (impl.world) return impl.world->coverage();
  Coverage two;
  two.pairs = two.tested = 1;
  return two;
}

double Simulation::time() const {
  const Impl& impl = usable();
  if (impl.world) return impl.world->time();
  return impl.undecided() ? impl.free_until : impl.session->engine().time();
}

std::optional<TimeInterval> Simulation::next_event() {
  Impl& impl = usable();
  if (impl.ended()) return std::nullopt;
  if (impl.world) {
    std::optional<TimeInterval> next;
    impl.changing([&] { next = impl.world->next_event(); });
    return impl.undecided() ? std::nullopt : next;
  }
  std::optional<std::pair<double, double>> found;
  impl.changing([&] { found = impl.session->engine().next_event(impl.session->end()); });
  if (!found || impl.undecided()) return std::nullopt;
  return TimeInterval{found->first, found->second};
}

bool Simulation::step() {
  Impl& impl = usable();
  if (impl.ended()) return false;
  const std::uint64_t before = events();
  impl.changing([&] {
    if (!impl.world) {
      impl.step(impl.session->end());
    } else if (const std::optional<TimeInterval> next = impl.world->next_event()) {
      impl.world->advance(next->hi);
    } else {
      impl.world->advance(impl.world->end());
    }
  });
  return events() > before;
}

SimulationState Simulation::advance_to(double t) {
  Impl& impl = usable();
  if (std::isnan(t))
    throw InputError("", "the time to advance to is not a number", "choose one within the scene's time");
  if (impl.ended()) return state();
  if (impl.world) {
    impl.changing([&impl, t] { impl.world->advance(std::min(t, impl.world->end())); });
    return state();
  }
  const double limit = std::min(t, impl.session->end());
  impl.changing([&impl, limit] {
    while (impl.step(limit)) {
    }
  });
  return state();
}

void Simulation::set_motion(BodyId body, const Motion& motion) {
  Impl& impl = usable();
  impl.expect_decided();
  impl.changing([&] {
    if (impl.world) return impl.world->set_motion(body, motion);
    impl.session->set_motion(body, motion);
  });
}

const std::optional<Contact>& Simulation::contact() const {
  static const std::optional<Contact> none;
  const Impl& impl = usable();
  if (impl.world) return impl.world->answer().contact;
  return impl.session ? impl.session->contact() : none;
}

std::optional<std::array<BodyId, 2>> Simulation::pair() const {
  const Impl& impl = usable();
  if (impl.world) return impl.world->answer().pair;
  if (!impl.session || !(impl.session->contact() || impl.session->overlap_at_start())) return std::nullopt;
  return std::array<BodyId, 2>{0, 1};
}

const std::vector<PairAnswer>& Simulation::also() const {
  static const std::vector<PairAnswer> none;
  const Impl& impl = usable();
  return impl.world ? impl.world->answer().also : none;
}

const std::optional<Point>& Simulation::overlap_point() const {
  static const std::optional<Point> none;
  const Impl& impl = usable();
  if (impl.world) return impl.world->answer().overlap_point;
  return impl.session ? impl.session->overlap_point() : none;
}

std::uint64_t Simulation::events() const {
  const Impl& impl = usable();
  if (impl.world) return impl.world->events();
  return impl.session ? impl.session->engine().events() : 0;
}

std::uint64_t Simulation::certificates() const {
  const Impl& impl = usable();
  if (impl.world) return impl.world->certificates();
  return impl.session ? impl.session->engine().active_certificates() : 0;
}

std::uint64_t Simulation::certificates_max() const {
  const Impl& impl = usable();
  if (impl.world) return impl.world->certificates_max();
  return impl.session ? impl.session->engine().max_certificates() : 0;
}

}  // namespace taut
