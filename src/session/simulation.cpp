#include "taut/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/mechanism_lock.hpp"
#include "session/simulation_impl.hpp"

namespace taut {
using namespace internal;

const char* to_string(SimulationState state) {
  switch (state) {
    case SimulationState::running:
      return "running";
    case SimulationState::finished:
      return "finished";
    case SimulationState::contact:
      return "contact";
    case SimulationState::overlap_at_start:
      return "overlap_at_start";
    case SimulationState::undecided:
      return "undecided";
    case SimulationState::untested:
      return "untested";
    case SimulationState::locked:
      return "locked";
  }
  return "";
}

namespace {

SimulationOptions without_limits(Touch touch, Tracer* tracer) {
  SimulationOptions options;
  options.touch = touch;
  options.tracer = tracer;
  return options;
}

/// About a millionth of the time, unless it is given.
double contact_time(const SimulationOptions& options, const Scene& scene) {
  if (!(options.contact_time >= 0))
    throw InputError("contact_time", "it is negative, or not a number", "choose a time, or 0");
  return options.contact_time > 0 ? options.contact_time : std::ldexp(scene.end - scene.start, -20);
}

}  // namespace

Simulation::Impl::Impl(const Scene& given_scene, const SimulationOptions& given)
    : options(given),
      scene(given_scene),
      removed(given_scene.bodies.size(), false),
      at_end(Outcome::free),
      contacts(given.max_contacts_per_time, contact_time(given, given_scene)),
      start(given_scene.start) {
  changing([&] {
    world = make_world(scene);
    if (options.tracer) only_pair();
  });
  if (!world) unreached = coverage_before_search(scene);
  if (!world) return;
  note_lock(scene, at_end, reason_at_end);
  if (options.record) record.begin(scene, removed);
  note_contact();
}

std::unique_ptr<WorldSimulation> Simulation::Impl::make_world(const Scene& from_now) {
  const std::uint64_t spent = std::min(options.max_events, events());
  return std::make_unique<WorldSimulation>(from_now, options.touch, options.max_events - spent, this);
}

/// Every pair in contact counts.
void Simulation::Impl::note_contact() {
  if (!world || !in_contact()) return;
  changed_since_contact = false;
  const Answer& answer = world->answer();
  std::vector<std::array<BodyId, 2>> pairs{*answer.pair};
  for (const PairAnswer& other : answer.also) pairs.push_back(other.bodies);
  if (!is_again()) contacts.total += pairs.size();
  for (const std::array<BodyId, 2>& pair : pairs) {
    if (!contacts.add(pair, world->time())) continue;
    reason = fmt::format(
        "bodies \"{}\" and \"{}\" came into contact more than {} times within {:.6g} of time, up to t = {}: "
        "contacts may be infinitely many in a finite time, unless the bodies come to rest, or part faster",
        scene.bodies[static_cast<std::size_t>(pair[0])].name, scene.bodies[static_cast<std::size_t>(pair[1])].name,
        contacts.most(), contacts.stretch(), world->time());
  }
}

bool Simulation::Impl::is_again() const {
  const Contact& now = *world->answer().contact;
  return std::any_of(resumed.begin(), resumed.end(), [&](const PairAnswer& before) {
    const Contact& then = *before.contact;
    return then.vertex == now.vertex && then.edge == now.edge && now.time.lo <= then.time.hi;
  });
}

/// The repair changes records of the corners it names, of the half-edges after them, and of the edge it removes
/// (src/kinetic/repair_*.cpp). An event whose tracer throws has changed the map and is not finished.
void Simulation::Impl::on_event(const KineticSolver& solver, const EngineEvent& event) {
  last = event.report;
  if (!options.tracer) return;
  const Engine& engine = solver.engines()->engine(0);
  TraceEvent out;
  out.number = ++traced;
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
  if (!impl.world->has_tested()) return SimulationState::untested;
  return impl.at_end == Outcome::locked ? SimulationState::locked : SimulationState::finished;
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
  impl.changing([&] {
    next = impl.world->next_event(impl.world->end());
    impl.note_contact();
  });
  return impl.undecided() ? std::nullopt : next;
}

bool Simulation::step() {
  Impl& impl = usable();
  if (impl.ended()) return false;
  const std::uint64_t before = events();
  impl.changing([&] {
    impl.world->step(impl.world->end());
    impl.note_contact();
  });
  return events() > before;
}

SimulationState Simulation::advance_to(double t) {
  Impl& impl = usable();
  if (std::isnan(t))
    throw InputError("", "the time to advance to is not a number", "choose one within the scene's time");
  if (impl.ended()) return state();
  impl.changing([&impl, t] {
    impl.world->advance(std::min(t, impl.world->end()));
    impl.note_contact();
  });
  return state();
}

SimulationState Simulation::resume() {
  Impl& impl = usable();
  impl.expect_decided();
  if (!impl.in_contact())
    throw InputError("", "there is no contact to go on from", "call resume() while state() is `contact`");
  const Answer& answer = impl.world->answer();
  impl.resumed = answer.also;
  impl.resumed.push_back({*answer.pair, answer.outcome, answer.contact, answer.free_until, {}});
  impl.changing([&] {
    impl.world->resume();
    impl.note_contact();
  });
  return state();
}

bool Simulation::contact_again() const {
  const Impl& impl = usable();
  return impl.world && impl.in_contact() && impl.is_again();
}

std::uint64_t Simulation::contacts() const { return usable().contacts.total; }

void Simulation::set_motion(BodyId body, const Motion& motion) {
  Impl& impl = usable();
  impl.expect_decided();
  impl.changing([&] {
    const bool was_in_contact = impl.in_contact();
    impl.set_motion(body, motion);
    if (!was_in_contact) impl.note_contact();
  });
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

std::uint64_t Simulation::events() const { return usable().events(); }

std::uint64_t Simulation::certificates() const {
  const Impl& impl = usable();
  return impl.world ? impl.world->certificates() : 0;
}

std::uint64_t Simulation::certificates_max() const {
  const Impl& impl = usable();
  return std::max(impl.certificates_max_before, impl.world ? impl.world->certificates_max() : 0);
}

}  // namespace taut
