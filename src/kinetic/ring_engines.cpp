#include "kinetic/ring_engines.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "certificate/instant.hpp"
#include "geometry/predicates.hpp"
#include "numeric/errors.hpp"
#include "scene/placement.hpp"
#include "tiling/prepared_tiling.hpp"

namespace taut::internal {

RingEngines::RingEngines(const BodyPair& bodies, const PairGeometry& geometry, Offset offset, MotionSegments segments,
                         EngineObserver* observer)
    : bodies_(bodies), geometry_(geometry), offset_(offset), segments_(std::move(segments)) {
  const RingMeetings meetings = meetings_at_start();
  inside_ = meetings.inside;
  overlap_ = inside_.has_value();
  keeps_tilings_ = meetings.pairs.size() > bodies.rings[0]->rings().size() + bodies.rings[1]->rings().size() ||
                   (bodies.rings[0]->is_prepared() && bodies.rings[1]->is_prepared());
  for (const RingMeeting& rings : meetings.pairs) {
    begin(rings, observer);
    if (overlap_) return;
  }
}

/// The tiling of two single rings also shows whether one lies inside the other.
RingMeetings RingEngines::meetings_at_start() {
  if (bodies_.has_single_rings()) return {{{0, 0}}, {}};
  const MotionSegment& first = segments_.front();
  const Placement placement(geometry_, first, first.start, Positions::on_demand);
  RingMeetings meetings = ring_meetings(bodies_, placement);
  at_start_ = placement.stages();
  return meetings;
}

const MotionSegments& RingEngines::segments_in_roles(bool exchanged) {
  if (!exchanged) return segments_;
  if (!exchanged_segments_) exchanged_segments_ = segments_.exchanged();
  return *exchanged_segments_;
}

/// The ring that plays this role.
const SingleRing& RingEngines::ring_of(const Run& run, Role role) const {
  return set_of(run, role).single_ring(ring_number(run, role), offset_);
}

const ShapeTiling* RingEngines::tiling_of(const Run& run, Role role) const {
  const SingleRing& ring = ring_of(run, role);
  return set_of(run, role).kept_of<ShapeTiling>(ring_number(run, role), offset_, role, [&] {
    return tile_shape(ring.polygon, role == Role::p ? node::p_tree : node::q_tree);
  });
}

double RingEngines::diameter_of(Role role, std::size_t ring) {
  const RingSet& rings = *bodies_.rings[index_of(role)];
  if (rings.rings().size() == 1) return rings.diameter_squared();
  std::vector<double>& known = diameters_[index_of(role)];
  if (known.empty()) known.assign(rings.rings().size(), -1);
  if (known[ring] < 0) known[ring] = rings.diameter_squared(ring);
  return known[ring];
}

void RingEngines::begin(const RingMeeting& rings, EngineObserver* observer) {
  const RingSet &p = *bodies_.rings[0], &q = *bodies_.rings[1];
  Run run;
  run.rings = rings;
  // The rules at the root require the polygon with the larger diameter as P. The box of a container is larger than its
  // contents.
  if (q.rings()[rings.q].ring > 0) {
    run.exchanged = true;
  } else if (p.rings()[rings.p].ring == 0) {
    run.exchanged = diameter_of(Role::q, rings.q) > diameter_of(Role::p, rings.p);
  }
  // A container surrounds its contents, so no faces far from it are worth keeping.
  const bool contained = p.rings()[rings.p].ring > 0 || q.rings()[rings.q].ring > 0;
  KnownTilings known;
  if (keeps_tilings_ && !contained) known = {tiling_of(run, Role::p), tiling_of(run, Role::q)};
  run.engine = std::make_unique<Engine>(PairGeometry(ring_of(run, Role::p).polygon, ring_of(run, Role::q).polygon),
                                        segments_in_roles(run.exchanged), observer, known);
  overlap_ = run.engine->state() == EngineState::overlap;
  runs_.push_back(std::move(run));
}

bool RingEngines::is_contained(std::size_t k) const {
  const RingMeeting& rings = runs_[k].rings;
  return bodies_.rings[0]->rings()[rings.p].ring > 0 || bodies_.rings[1]->rings()[rings.q].ring > 0;
}

RingEngines::Arrival RingEngines::advance(double t, std::uint64_t events) {
  std::uint64_t left = events;
  bool arrived = true;
  for (Run& run : runs_) {
    Engine& engine = *run.engine;
    while (engine.state() == EngineState::running) {
      if (left == 0) {
        arrived = false;
        break;
      }
      // Events after a known contact do not matter.
      const double limit = contact_ ? std::min(t, segments_[contact_->segment].time(contact_->contact.hi)) : t;
      const std::uint64_t before = engine.events();
      if (!engine.step(limit) && engine.events() == before) break;
      left -= engine.events() - before;
    }
    if (engine.state() == EngineState::contact) note_contact(run);
  }
  if (!arrived) return Arrival::on_the_way;
  return contact_ ? Arrival::contact : Arrival::there;
}

double RingEngines::time() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Run& run : runs_) least = std::min(least, run.engine->time());
  return least;
}

bool RingEngines::can_replan_at(double t) const {
  return std::all_of(runs_.begin(), runs_.end(), [t](const Run& run) { return run.engine->can_replan_at(t); });
}

void RingEngines::replan(MotionSegments segments) {
  segments_ = std::move(segments);
  exchanged_segments_.reset();
  contact_.reset();
  for (Run& run : runs_) run.engine->replan(segments_in_roles(run.exchanged));
}

double RingEngines::reached() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Run& run : runs_) least = std::min(least, run.engine->reached());
  return least;
}

double RingEngines::proved_until() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Run& run : runs_) least = std::min(least, run.engine->proved_until());
  return least;
}

std::optional<std::pair<double, double>> RingEngines::next_event(double t) {
  std::optional<std::pair<double, double>> first;
  for (Run& run : runs_) {
    const auto next = run.engine->next_event(first ? std::min(t, first->second) : t);
    if (next && (!first || next->first < first->first)) first = next;
  }
  return first;
}

/// Maps a vertex of the two rings, or the edge that starts there, to that of the two bodies.
std::optional<VertexId> RingEngines::named(const Run& run, VertexId v, bool edge) const {
  const PairGeometry& two = run.engine->geometry();
  const Role role = two.role_of(v);
  const SingleRing& ring = ring_of(run, role);
  const VertexId own(v.value - two.first(role));
  const std::optional<std::uint32_t> k = edge ? ring.edge(own) : ring.vertex(own);
  if (!k) return std::nullopt;
  return VertexId(geometry_.first(run.in_pair(role)) + *k);
}

/// The walls of the slit are not features. They can be met only where a vertex was displaced into the mouth.
VertexId RingEngines::in_pair(const Run& run, VertexId v, bool edge) const {
  const std::optional<VertexId> k = named(run, v, edge);
  if (!k) throw Undecidable{"what a vertex in the slit of a hole meets"};
  return *k;
}

void RingEngines::note_contact(const Run& run) {
  Found here{*run.engine->contact(), run.engine->segment_index()};
  here.contact.vertex = in_pair(run, here.contact.vertex, false);
  here.contact.edge = in_pair(run, here.contact.edge, true);
  if (!contact_ || comes_before(here, *contact_)) contact_ = here;
}

bool RingEngines::comes_before(const Found& a, const Found& b) const {
  if (a.segment != b.segment) return a.segment < b.segment;
  if (a.contact.vertex == b.contact.vertex && a.contact.edge == b.contact.edge) return a.contact.lo < b.contact.lo;
  const std::shared_ptr<const MotionSegment> segment = segments_.hold(a.segment);
  const int order = order_of({segment, &geometry_, a.contact}, {segment, &geometry_, b.contact});
  if (order == 0) throw Undecidable{"the order of two contacts"};
  return order < 0;
}

StageCounts RingEngines::stages() const {
  StageCounts sum = at_start_;
  for (const Run& run : runs_) sum += run.engine->stages();
  return sum;
}

}  // namespace taut::internal
