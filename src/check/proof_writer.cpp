#include "check/proof_writer.hpp"

#include "base/errors.hpp"
#include "pair/placement.hpp"
#include "proof/header.hpp"
#include "sign/precise_triple.hpp"
#include "taut/proof.hpp"
#include "tiling/static_tiling.hpp"

namespace taut::internal {

using proof::Record;
using proof::Shapes;

void ProofWriter::started(const Session& session) {
  geometry_ = &session.engine().geometry();
  if (session.overlap_at_start()) return;
  if (session.touching()) return contact_at_start(session);
  header(touch_ == Touch::open ? Shapes::inwards : Shapes::outwards);
  tiling(session.engine().map());
}

/// All operations that may be interrupted come first, so that nothing is written partially.
void ProofWriter::on_event(const EngineEvent& event) {
  const double at = about(event);
  to_segment(event.segment_index);
  const bool hit = event.report.repair == Repair::collision;
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
}

/// An instant so close to the event that the verifier finds it there. Where a function is flat, the engine's enclosure
/// in doubles may be wide.
double ProofWriter::about(const EngineEvent& event) const {
  const MotionSegment& segment = *event.segment;
  PreciseTime t = PreciseTime::between(event.lo, event.hi);
  if (event.hi - event.lo > proof::nearness(segment.start, segment.end)) {
    const PreciseTriple f(segment, *geometry_, CertificateFunction::of(*geometry_, event.u, event.v, event.w));
    if (const int before = f.sign_at(PreciseTime::between(event.lo, event.lo), Stage::precise))
      f.refine(before, t, Stage::precise);
  }
  const double lo = t.floor(), hi = t.ceiling();
  return lo + (hi - lo) / 2;
}

void ProofWriter::ended(const Session& session, const Answer& answer) {
  const Engine& engine = session.engine();
  if (answer.outcome == Outcome::free) kind(Record::free);
  if (answer.outcome == Outcome::undecided) {
    to_segment(engine.segment_index());
    kind(Record::free_until);
    out_.f64(engine.segment().bridge ? 0.0 : answer.free_until);
  }
  out_.close();
}

void ProofWriter::to_segment(std::size_t segment) {
  for (; segment_ < segment; ++segment_) kind(Record::next_segment);
}

void ProofWriter::header(Shapes shapes) {
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
void ProofWriter::contact_at_start(const Session& session) {
  const PairGeometry inner = displaced_pair(session.plan(), true);
  header(Shapes::inwards);
  tiling(build_tiling(Placement(inner, session.engine().segment(), scene_.start)).map);
  kind(Record::touching);
  out_.u32(session.touching()->edge_p.value);
  out_.u32(session.touching()->edge_q.value);
}

Answer prove_by_tiling(const Scene& scene, std::ostream& log, const CheckOptions& options) {
  ProofWriter writer(scene, options.touch, log);
  return run_kinetic(scene, options, writer);
}

}  // namespace taut::internal
