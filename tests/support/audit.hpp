// Runs a scene through the kinetic engine and compares the tiling with the one built from scratch between all events.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>

#include "kinetic/ring_engines.hpp"
#include "scene/instance.hpp"
#include "support/tiling_run.hpp"
#include "taut/scene.hpp"

namespace taut::testing {
using namespace internal;

/// What was seen over many runs.
struct AuditCounts {
  std::uint64_t scenes = 0, events = 0, compared = 0, not_compared = 0, collisions = 0;
  std::map<std::string, std::uint64_t> roots;    ///< states of the root in the maps compared
  std::map<std::string, std::uint64_t> repairs;  ///< restructuring cases by kind of face
  std::uint64_t pinch_rule = 0, three_corners = 0;
  std::uint64_t largest_repair = 0;  ///< corners touched by one repair
};

struct AuditResult {
  std::string fault;  ///< empty if every map agreed
  Outcome outcome = Outcome::undecided;
  std::optional<Contact> contact;
};

/// Runs the scene to its end. `compare_every`: 1 compares after every event.
AuditResult audit(const Scene& scene, Touch touch, AuditCounts& counts, unsigned compare_every = 1);

/// The same of two bodies of rings.
struct RingAudit : AuditResult {
  std::optional<RingEngines::Found> found;
  unsigned contained = 0;  ///< pairs of rings of which one is in a hole
};
RingAudit audit_rings(const Instance& world, int a, int b, Offset offset, AuditCounts& counts,
                      unsigned compare_every = 1);

/// Compares the run's map with the static one at the middle between the present and the next event; says what
/// differs, or nothing.
std::string compare_with_static(TilingRun& run, AuditCounts& counts);
std::string compare_with_static(Engine& engine, double end, AuditCounts& counts);

}  // namespace taut::testing
