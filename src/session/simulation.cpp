#include "taut/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "session/simulation_impl.hpp"

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

/// The repair changes records of the corners it names, of the half-edges after them, and of the edge it removes
/// (src/kinetic/repair_*.cpp). An event whose tracer throws has changed the map and is not finished.
void Simulation::Impl::on_event(const KineticSolver& solver, const EngineEvent& event) {
  last = event.report;
  if (!options.tracer) return;
  const Engine& engine = solver.engines()->engine(0);
  TraceEvent out;
  out.number = engine.events();
  out.lo = event.segment->time(event.lo);
  out.hi = event.segment->time(event.hi);
  out.bridging = event.segment->bridge;
  out.repair = event.report.repair;
  out.u = solver.features().vertex(event.u);
  out.v = solver.features().vertex(event.v);
  out.w = solver.features().vertex(event.w);
  out.pinch_rule = event.report.pinch_rule;
  out.three_corners = event.three_corners;
  out.corners_touched = static_cast<int>(event.report.corner_count);
  out.certificates = engine.active_certificates();
  try {
    options.tracer->on_event(out);
  } catch (...) {
    broken = true;
    throw;
  }
}

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
  const Outcome outcome = impl.world->answer().outcome;
  if (outcome == Outcome::overlap_at_start) return SimulationState::overlap_at_start;
  if (outcome == Outcome::contact) return SimulationState::contact;
  if (!impl.ended()) return SimulationState::running;
  return impl.world->has_tested() ? SimulationState::finished : SimulationState::untested;
}

const std::string& Simulation::reason() const { return usable().why_undecided(); }

Coverage Simulation::coverage() const {
  const Impl& impl = usable();
  return impl.world ? impl.world->coverage() : impl.unreached;
}

double Simulation::time() const {
  const Impl& impl = usable();
  return impl.world ? impl.world->time() : impl.start;
}

std::optional<TimeInterval> Simulation::next_event() {
  Impl& impl = usable();
  if (impl.ended()) return std::nullopt;
  std::optional<TimeInterval> next;
  impl.changing([&] { next = impl.world->next_event(impl.world->end()); });
  return impl.undecided() ? std::nullopt : next;
}

bool Simulation::step() {
  Impl& impl = usable();
  if (impl.ended()) return false;
  const std::uint64_t before = events();
  impl.changing([&] { impl.world->step(impl.world->end()); });
  return events() > before;
}

SimulationState Simulation::advance_to(double t) {
  Impl& impl = usable();
  if (std::isnan(t))
    throw InputError("", "the time to advance to is not a number", "choose one within the scene's time");
  if (!impl.ended()) impl.changing([&impl, t] { impl.world->advance(std::min(t, impl.world->end())); });
  return state();
}

void Simulation::set_motion(BodyId body, const Motion& motion) {
  Impl& impl = usable();
  impl.expect_decided();
  impl.changing([&] { impl.world->set_motion(body, motion); });
}

const std::optional<Contact>& Simulation::contact() const {
  static const std::optional<Contact> none;
  const Impl& impl = usable();
  return impl.world ? impl.world->answer().contact : none;
}

std::optional<std::array<BodyId, 2>> Simulation::pair() const {
  const Impl& impl = usable();
  return impl.world ? impl.world->answer().pair : std::nullopt;
}

const std::vector<PairAnswer>& Simulation::also() const {
  static const std::vector<PairAnswer> none;
  const Impl& impl = usable();
  return impl.world ? impl.world->answer().also : none;
}

const std::optional<Point>& Simulation::overlap_point() const {
  static const std::optional<Point> none;
  const Impl& impl = usable();
  return impl.world ? impl.world->answer().overlap_point : none;
}

std::uint64_t Simulation::events() const {
  const Impl& impl = usable();
  return impl.world ? impl.world->events() : 0;
}

std::uint64_t Simulation::certificates() const {
  const Impl& impl = usable();
  return impl.world ? impl.world->certificates() : 0;
}

std::uint64_t Simulation::certificates_max() const {
  const Impl& impl = usable();
  return impl.world ? impl.world->certificates_max() : 0;
}

}  // namespace taut
