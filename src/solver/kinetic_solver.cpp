#include "solver/kinetic_solver.hpp"

#include <algorithm>
#include <string>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"

namespace taut::internal {
namespace {

/// The number of events between two tests of the work done.
constexpr std::uint64_t events_of_slice = 16;
/// In units of checkpoint(): the work of a tiling per vertex.
constexpr std::uint64_t work_of_vertex = 16;

}  // namespace

KineticSolver::KineticSolver(const Instance& world, int a, int b, Offset offset, EventBudget& budget,
                             KineticObserver* observer)
    : world_(world),
      a_(a),
      b_(b),
      offset_(offset),
      budget_(budget),
      observer_(observer),
      bodies_(world.pair(a, b)),
      geometry_(displaced_pair(bodies_, offset)),
      segments_(segments_of(bodies_, start(), world.end())) {
  result_.a = std::min(a, b);
  result_.b = std::max(a, b);
  result_.free_until = world.end();
  result_.engine = EngineName::kinetic;
}

void KineticSolver::ask_start() {
  try {
    resolve_start();
  } catch (const Undecidable& limit) {
    give_up(not_decided(limit), start());
  }
  if (observer_) observer_->started(*this);
}

void KineticSolver::resolve_start() {
  const double from = start();
  const MotionSegment& segment = segments_.front();
  begin(from);
  if (!engines_->overlap()) return;
  const auto how = [&] { return overlap_of_outlines(geometry_, segment, from, engines_->inside()); };
  const auto overlap_of = [&](const PairGeometry& shapes) {
    return RingEngines(bodies_, shapes, Offset::inward, segments_).overlap();
  };
  take_start(contact_at_start(features(), segment, from, how, overlap_of), from, result_);
  engines_.reset();
}

void KineticSolver::begin(double from) {
  leave();
  engines_ = std::make_unique<RingEngines>(
      bodies_, geometry_, offset_,
      from == segments_.place(0).start ? segments_ : segments_of(bodies_, from, world_.end()), engine_observer());
  at_ = window_ = from;
}

void KineticSolver::leave() {
  before_ = counts();
  stages_ = stages();
  engines_.reset();
}

KineticCounts KineticSolver::counts() const {
  KineticCounts sum = before_;
  if (engines_) sum += {engines_->events(), engines_->initial_certificates(), engines_->max_certificates()};
  return sum;
}

StageCounts KineticSolver::stages() const {
  StageCounts sum = stages_;
  if (engines_) sum += engines_->stages();
  return sum;
}

/// Provides tilings at the beginning of a window.
void KineticSolver::enter(double from) {
  if (needs_tilings(from)) {
    begin(from);
    if (engines_->overlap()) throw StructureError("bodies that were apart overlap");
  }
  window_ = from;
}

/// Reports whether the work is done. A limit ends it.
template <class Work>
bool KineticSolver::guarded(double from, const Work& work) {
  if (!open() && result_.free_until <= from) return true;
  try {
    return work();
  } catch (const Undecidable& limit) {
    give_up(not_decided(limit), engines_ ? engines_->reached() : from);
  } catch (const Interrupted& limit) {
    // This may be in the middle of an event.
    give_up(limit.reason, engines_ ? engines_->reached() : from);
  }
  return true;
}

bool KineticSolver::work(double from, double to, std::uint64_t effort) {
  const Slice slice(effort);
  return guarded(from, [&] {
    if (needs_tilings(from) && effort < work_of_vertex * geometry_.size()) return false;
    enter(from);
    while (!advance(to, events_of_slice)) {
      if (slice.used_up()) return false;
    }
    return true;
  });
}

void KineticSolver::start_at(double from) {
  guarded(from, [&] {
    enter(from);
    return true;
  });
}

std::optional<TimeInterval> KineticSolver::next_event(double t) {
  std::optional<TimeInterval> next;
  guarded(at_, [&] {
    if (const auto found = engines_->next_event(t)) next = {found->first, found->second};
    return true;
  });
  return next;
}

void KineticSolver::step(double t) {
  if (!open()) return;
  guarded(at_, [&] { return advance(t, 1); });
}

void KineticSolver::stand_at(double t) {
  if (!open() || !engines_) return;
  guarded(at_, [&] {
    const RingEngines::Arrival arrival = engines_->advance(t);
    if (arrival == RingEngines::Arrival::contact) note_contact();
    at_ = t;
    return true;
  });
}

bool KineticSolver::replan(double now) {
  if (!engines_ || !(open() || result_.found) || !engines_->can_replan_at(now)) return false;
  at_ = window_ = now;
  result_.outcome = Outcome::free;
  result_.free_until = world_.end();
  result_.contact.reset();
  result_.found.reset();
  bodies_ = world_.pair(a_, b_);
  segments_ = segments_of(bodies_, start(), world_.end());
  // The world starts just before the present, with a joint at the present unless the relative motion stays as it was,
  // or ends now.
  MotionSegments rest = segments_;
  if (rest.size() > 1 && rest.place(0).end <= now) {
    rest.drop_first();
  } else {
    rest = segments_of(bodies_, now, world_.end());
  }
  engines_->replan(std::move(rest));
  return true;
}

bool KineticSolver::advance(double to, std::uint64_t events) {
  const std::uint64_t before = engines_->events(), most = std::min(events, budget_.left);
  const RingEngines::Arrival arrival = engines_->advance(to, most);
  budget_.left -= engines_->events() - before;
  report_parts("events", engines_->events());
  report_time(engines_->proved_until());
  if (arrival == RingEngines::Arrival::contact) {
    note_contact();
  } else if (arrival == RingEngines::Arrival::there) {
    at_ = to;
  } else if (budget_.left == 0) {
    give_up("the limit of " + std::to_string(budget_.most) + " events was reached", engines_->proved_until());
  } else {
    return false;
  }
  return true;
}

std::vector<NearTiling> KineticSolver::tilings() const {
  std::vector<NearTiling> all;
  for (std::size_t k = 0; engines_ && k < engines_->size(); ++k) {
    const PlanarMap& map = engines_->engine(k).map();
    NearTiling tiling{world_.scene_pair(result_.a, result_.b), engines_->is_contained(k), {}};
    for (std::uint32_t i = 0; i < map.halfedge_count(); i += 2) {
      const HalfedgeId h(i);
      if (!map.alive(h) || map.is_polygon_edge(h)) continue;
      const auto from = engines_->named_vertex(k, map.origin(h)), to = engines_->named_vertex(k, map.target(h));
      if (!from || !to) continue;
      tiling.edges.push_back({features().vertex(*from), features().vertex(*to), !geometry_.same_body(*from, *to)});
    }
    all.push_back(std::move(tiling));
  }
  return all;
}

void KineticSolver::note_contact() {
  const RingEngines::Found& found = *engines_->contact();
  // The segments from a later time on are the last of all segments.
  const std::size_t segment = segments_.size() - engines_->segments().size() + found.segment;
  result_ = contact_of(result_, features(), segments_[segment], segment, found.contact, start());
}

void KineticSolver::give_up(const std::string& reason, double until) {
  result_.outcome = Outcome::undecided;
  result_.reason = reason;
  result_.free_until = std::clamp(until, start(), world_.end());
  leave();
}

void TraceWriter::on_event(const KineticSolver& solver, const EngineEvent& event) {
  const FeatureMap features = solver.features();
  TraceEvent out;
  out.number = ++number_;
  out.lo = event.segment->time(event.lo);
  out.hi = event.segment->time(event.hi);
  out.bridging = event.segment->bridge;
  out.repair = event.report.repair;
  out.u = features.vertex(event.u);
  out.v = features.vertex(event.v);
  out.w = features.vertex(event.w);
  out.pinch_rule = event.report.pinch_rule;
  out.three_corners = event.three_corners;
  out.corners_touched = static_cast<int>(event.report.corner_count);
  out.certificates = solver.engines()->certificates();
  tracer_.on_event(out);
}

}  // namespace taut::internal
