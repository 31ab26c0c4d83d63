#include "support/audit.hpp"

#include <algorithm>

#include "base/errors.hpp"
#include "pair/placement.hpp"
#include "tiling/checks.hpp"
#include "tiling/prepared_tiling.hpp"

namespace taut::testing {
namespace {

std::string face_name(NodeId n) {
  if (n == node::root) return "PT";
  if (n == node::infinite_face) return "F";
  return node::in_p(n) ? "P" : "Q";
}

/// The static map, put together from the maps of the two bodies alone.
std::string compare_joined(const Placement& placement, const StaticTiling& fresh) {
  const PairGeometry& g = placement.geometry();
  const auto p = tile_shape(g.p(), node::p_tree), q = tile_shape(g.q(), node::q_tree);
  if (!p || !q) return "a body alone has no tiling";
  const auto joined = join_tilings(placement, *p, *q, true);
  if (!joined) return "the bodies' tilings cannot be joined";
  if (joined->root != fresh.root) return std::string("joined tilings have the root ") + to_string(joined->root);
  const std::string d = difference(joined->map, fresh.map);
  return d.empty() ? d : "joined (first) and static (second) differ:\n" + d;
}

}  // namespace

std::string compare_with_static(Session& session, AuditCounts& counts) {
  Engine& engine = session.engine();
  if (engine.state() != EngineState::running) return {};
  const double end = session.end();
  const auto next = engine.next_event(end);
  if (engine.leg().bridge) {
    ++counts.not_compared;
    return {};
  }
  const double lo = engine.parameter(), hi = next ? next->first : engine.leg().end;
  const double t = lo + (hi - lo) / 2;
  if (!(lo < t && t < hi)) {
    ++counts.not_compared;
    return {};
  }
  const Placement placement(engine.geometry(), engine.leg(), t);
  const StaticTiling fresh = build_tiling(placement);
  if (fresh.overlap) return "overlap at t = " + std::to_string(t);
  if (const std::string fault = find_fault(fresh.map, placement); !fault.empty()) return "static map: " + fault;
  ++counts.roots[to_string(fresh.root)];
  if (counts.compared++ % 4 == 0) {
    const std::string d = compare_joined(placement, fresh);
    if (!d.empty()) return "at t = " + std::to_string(t) + " (" + to_string(fresh.root) + "), " + d;
  }
  const std::string d = difference(engine.map(), fresh.map);
  if (!d.empty()) {
    return "after " + std::to_string(engine.events()) + " events, at t = " + std::to_string(t) + " (" +
           to_string(fresh.root) + "), kinetic (first) and static (second) differ:\n" + d;
  }
  return {};
}

namespace {

class RepairCounter : public Tracer {
 public:
  explicit RepairCounter(AuditCounts& counts) : counts_(counts) {}
  void on_event(const TraceEvent& e) override {
    ++counts_.events;
    ++counts_.repairs[to_string(e.repair)];
    counts_.pinch_rule += e.pinch_rule;
    counts_.three_corners += e.three_corners;
    counts_.largest_repair = std::max<std::uint64_t>(counts_.largest_repair, e.corners_touched);
  }

 private:
  AuditCounts& counts_;
};

/// What kind of corner is about to fail, at which kind of face.
void count_corner(const Engine& engine, AuditCounts& counts) {
  const PlanarMap& map = engine.map();
  const Certificate& c = engine.upcoming();
  ++counts.repairs[std::string(c.sign > 0 ? "convex" : "reflex") + " at face " + face_name(map.node(c.corner))];
}

}  // namespace

AuditResult audit(const Scene& scene, Touch touch, AuditCounts& counts, unsigned compare_every) {
  AuditResult result;
  RepairCounter tracer(counts);
  ++counts.scenes;
  try {
    Session session(scene, touch, &tracer);
    unsigned steps = 0;
    while (!session.finished()) {
      if (steps++ % compare_every == 0) {
        result.fault = compare_with_static(session, counts);
        if (!result.fault.empty()) return result;
      }
      const double end = session.end();
      if (session.engine().next_event(end)) count_corner(session.engine(), counts);
      session.step(end);
    }
    result.contact = session.contact();
    result.outcome = session.overlap_at_start() ? Outcome::overlap_at_start
                     : session.contact()        ? Outcome::contact
                                                : Outcome::free;
    counts.collisions += session.contact().has_value();
  } catch (const Undecidable& u) {
    result.fault = std::string("undecided: ") + u.what;
  } catch (const std::exception& e) {
    result.fault = e.what();
  }
  return result;
}

}  // namespace taut::testing
