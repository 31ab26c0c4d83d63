#include "prove/proof_writer.hpp"

#include <algorithm>
#include <cmath>

#include "certificate/precise_triple.hpp"
#include "numeric/errors.hpp"
#include "proof/format.hpp"
#include "proof/lifetime.hpp"
#include "proof/motion_window.hpp"
#include "proof/verify_separations.hpp"
#include "scene/placement.hpp"
#include "taut/proof.hpp"
#include "tiling/root_faces.hpp"

namespace taut::internal {

using proof::Record;
using proof::Shapes;

void ProofWriter::started(const KineticSolver& solver) {
  segments_ = solver.segments();
  const PairResult& known = solver.result();
  if (known.touching) return contact_at_start(solver);
  if (known.outcome != Outcome::free) return;
  header(touch_ == Touch::open ? Shapes::inwards : Shapes::outwards);
  tiling(solver.engines()->engine(0).map());
}

/// All operations that may be interrupted come first, so that nothing is written partially.
void ProofWriter::on_event(const KineticSolver& solver, const EngineEvent& event) {
  const double at = about(solver.geometry(), event);
  const bool hit = event.report.repair == Repair::collision;
  if (hit) note_contact(solver, event, at);
  to_segment(event.segment_index);
  switch (event.report.gone) {
    case Gone::none:
      kind(Record::event);
      break;
    case Gone::first:
      kind(hit ? Record::contact_first : Record::event_first);
      break;
    case Gone::second:
      kind(hit ? Record::contact_second : Record::event_second);
      break;
  }
  out_.f64(at);
  out_.u32(event.corner.value);
  last_event_ = at;
  if (trace_) trace_->on_event(solver, event);
}

/// An instant so close to the event that the verifier finds it there. Where a function is flat, the engine's enclosure
/// in doubles may be wide.
double ProofWriter::about(const PairGeometry& geometry, const EngineEvent& event) {
  const MotionSegment& segment = *event.segment;
  PreciseTime t = PreciseTime::between(event.lo, event.hi);
  if (event.hi - event.lo > proof::nearness(segment.start, segment.end)) {
    const PreciseTriple f(segment, geometry, CertificateFunction::of(geometry, event.u, event.v, event.w));
    if (const int before = f.sign_at(PreciseTime::between(event.lo, event.lo), Stage::precise))
      f.refine(before, t, Stage::precise);
  }
  const double lo = t.floor(), hi = t.ceiling();
  return lo + (hi - lo) / 2;
}

/// Of the corner that determined the repair, which may be another one than the certificate's. The instant does not
/// depend on when the corner came to be, which is known to have its sign since then.
void ProofWriter::note_contact(const KineticSolver& solver, const EngineEvent& event, double about) {
  const PlanarMap& map = solver.engines()->engine(0).map();
  const HalfedgeId h = event.corner;
  proof::Lifetimes lifetimes(solver.geometry());
  lifetimes.enter(*event.segment);
  const proof::FineInstant since{std::max(event.segment->start, event.lo - (event.hi - event.lo)), 0, 0};
  try {
    const Instant now =
        lifetimes.failure({map.origin(h), map.target(h), map.target(map.next(h)), 1, proof::instant_at(since)}, about);
    contact_ = proof::proved_contact(solver.features(), {event.report.hitting, map.origin(event.report.hit)},
                                     *event.segment, lifetimes.tightened(now), scene_.start, INFINITY)
                   .contact;
  } catch (const ProofError&) {
    // Too close to its beginning for a sign in between: the engine's own enclosure stays.
  } catch (const Undecidable&) {
  }
}

void ProofWriter::end(Answer& answer) {
  if (!started_) {
    if (answer.outcome == Outcome::undecided) answer.free_until = scene_.start;
    return;
  }
  if (answer.outcome == Outcome::free) kind(Record::free);
  if (answer.outcome == Outcome::undecided) answer.free_until = free_until(answer.free_until);
  if (answer.contact && contact_) {
    answer.contact = contact_;
    answer.free_until = contact_->time.lo;
  }
  out_.close();
}

/// On the first segment that reaches this time, unless events have gone further. A verifier encloses the last event by
/// itself. Where the time is too near to it, the log claims an earlier one, before both enclosures.
double ProofWriter::free_until(double t) {
  to_segment(std::max(segment_, std::min(segments_.first_until(t), segments_.size() - 1)));
  const SegmentPlace place = segments_.place(segment_);
  double until = place.bridge ? 0.0 : std::max(t, place.start);
  const double near = 2 * proof::nearness(place.start, place.end);
  if (last_event_ && until <= *last_event_ + near) until = std::max(place.start, std::min(until, *last_event_ - near));
  kind(Record::free_until);
  out_.f64(until);
  return place.bridge ? t : until;
}

void ProofWriter::to_segment(std::size_t segment) {
  for (; segment_ < segment; ++segment_) {
    kind(Record::next_segment);
    last_event_.reset();
  }
}

void ProofWriter::header(Shapes shapes) {
  started_ = true;
  proof::write_header(
      out_, {proof::of_tilings, scene_fingerprint(scene_, touch_), touch_, static_cast<std::uint8_t>(shapes)});
}

void ProofWriter::tiling(const PlanarMap& map) {
  const std::uint32_t count = map.halfedge_count();
  out_.u32(count);
  for (std::uint32_t i = 2 * map.vertices(); i < count; ++i) out_.u32(map.origin(HalfedgeId(i)).value);
  for (std::uint32_t i = 0; i < count; ++i) out_.u32(map.next(HalfedgeId(i)).value);
  out_.u32(static_cast<std::uint32_t>(map.unused().size()));
  for (const HalfedgeId h : map.unused()) out_.u32(h.value);
}

/// The outward shapes overlap already, but the inward ones do not: a tiling of the inward shapes proves it.
void ProofWriter::contact_at_start(const KineticSolver& solver) {
  const PairGeometry inner = displaced_pair(solver.bodies(), Offset::inward);
  header(Shapes::inwards);
  tiling(build_tiling(Placement(inner, segments_.front(), scene_.start)).map);
  kind(Record::touching);
  out_.u32(solver.result().touching->edge_p.value);
  out_.u32(solver.result().touching->edge_q.value);
}

Answer prove_by_tiling(const Scene& scene, std::ostream& log, const CheckOptions& given) {
  CheckOptions options = given;
  options.engine = EngineChoice::kinetic;
  ProofWriter writer(scene, options.touch, log, options.tracer);
  Run run(scene, options, &writer);
  run.run();
  Answer answer = run.answer_with_touching();
  writer.end(answer);
  return answer;
}

}  // namespace taut::internal
