#include "support/audit.hpp"

#include <algorithm>

#include "numeric/errors.hpp"
#include "scene/placement.hpp"
#include "tiling/planar_map.hpp"
#include "tiling/prepared_tiling.hpp"

namespace taut::testing {
using namespace internal;
namespace {

std::string face_name(ChainNode n) {
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

std::string compare_with_static(TilingRun& run, AuditCounts& counts) {
  return compare_with_static(run.engine(), run.end(), counts);
}

std::string compare_with_static(Engine& engine, double end, AuditCounts& counts) {
  if (engine.state() != EngineState::running) return {};
  const auto next = engine.next_event(end);
  if (engine.segment().bridge) {
    ++counts.not_compared;
    return {};
  }
  const double lo = engine.parameter(), hi = next ? next->first : engine.segment().end;
  const double t = lo + (hi - lo) / 2;
  if (!(lo < t && t < hi)) {
    ++counts.not_compared;
    return {};
  }
  const Placement placement(engine.geometry(), engine.segment(), t);
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

class RepairCounter : public EngineObserver, public KineticObserver {
 public:
  explicit RepairCounter(AuditCounts& counts) : counts_(counts) {}
  void on_event(const KineticSolver&, const EngineEvent& e) override { on_event(e); }
  void on_event(const EngineEvent& e) override {
    ++counts_.events;
    ++counts_.repairs[to_string(e.report.repair)];
    counts_.pinch_rule += e.report.pinch_rule;
    counts_.three_corners += e.three_corners;
    counts_.largest_repair = std::max<std::uint64_t>(counts_.largest_repair, e.report.corner_count);
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

/// To the end, or a contact; says what differs, or nothing.
template <class Step>
std::string follow(Engine& engine, double end, AuditCounts& counts, unsigned compare_every, const Step& step) {
  unsigned steps = 0;
  while (engine.state() == EngineState::running) {
    if (steps++ % compare_every == 0) {
      if (const std::string fault = compare_with_static(engine, end, counts); !fault.empty()) return fault;
    }
    if (engine.next_event(end)) count_corner(engine, counts);
    step();
  }
  return {};
}

/// What stops a run is a fault.
template <class Run>
void guarded(AuditResult& result, const Run& run) {
  try {
    run();
  } catch (const Undecidable& u) {
    result.fault = std::string("undecided: ") + u.what;
  } catch (const std::exception& e) {
    result.fault = e.what();
  }
}

}  // namespace

AuditResult audit(const Scene& scene, Touch touch, AuditCounts& counts, unsigned compare_every) {
  AuditResult result;
  RepairCounter observer(counts);
  ++counts.scenes;
  guarded(result, [&] {
    TilingRun simulation(scene, touch, &observer);
    if (!simulation.finished()) {
      result.fault = follow(simulation.engine(), simulation.end(), counts, compare_every,
                            [&] { simulation.step(simulation.end()); });
    }
    if (!result.fault.empty()) return;
    result.contact = simulation.answer().contact;
    result.outcome = simulation.answer().outcome;
    if (result.outcome == Outcome::undecided) result.fault = simulation.answer().reason;
    counts.collisions += result.contact.has_value();
  });
  return result;
}

RingAudit audit_rings(const Instance& world, int a, int b, Offset offset, AuditCounts& counts, unsigned compare_every) {
  RingAudit result;
  RepairCounter observer(counts);
  ++counts.scenes;
  guarded(result, [&] {
    const BodyPair plan = world.pair(a, b);
    const PairGeometry geometry = displaced_pair(plan, offset);
    RingEngines engines(plan, geometry, offset, world.segments(plan), &observer);
    if (engines.overlap()) {
      result.outcome = Outcome::overlap_at_start;
      return;
    }
    for (std::size_t k = 0; k < engines.size() && result.fault.empty(); ++k) {
      result.contained += engines.is_contained(k);
      Engine& engine = engines.engine(k);
      result.fault = follow(engine, world.end(), counts, compare_every, [&] { engine.step(world.end()); });
    }
    if (!result.fault.empty()) return;
    engines.advance(world.end());
    result.found = engines.contact();
    result.outcome = result.found ? Outcome::contact : Outcome::free;
    counts.collisions += result.found.has_value();
  });
  return result;
}

}  // namespace taut::testing
