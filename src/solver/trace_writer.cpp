#include "solver/trace_writer.hpp"

namespace taut::internal {

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
