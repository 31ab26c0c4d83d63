// In which directions bodies come apart if they are moved straight.
#include "query/separate_straight.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "query/bracket.hpp"
#include "scene/untested.hpp"
#include "scene/validate_scene.hpp"
#include "solver/free_directions.hpp"
#include "solver/pair_solver.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

class SeparationSearch {
 public:
  SeparationSearch(const Scene& scene, double travel) : instance_(scene), travel_(travel) {
    for (const InstanceBody& body : instance_.bodies()) {
      standing_.push_back(std::make_unique<const StandingBody>(
          StandingBody{VerticesAtPose(body, instance_.start(), Offset::inward), tree_of(*body.rings, Offset::inward)}));
    }
    left_.resize(scene.bodies.size());
    std::iota(left_.begin(), left_.end(), 0);
  }

  /// The bodies stand still, so it does not matter which of them move alike later.
  Coverage coverage() const { return instance_.coverage_of_all_groups(); }

  /// The coverage if the search stops here.
  Coverage when_stopped() const { return coverage_when_stopped(coverage(), held_.size()); }

  Separation run() {
    Separation answer;
    answer.coverage = coverage();
    if (answer.coverage.is_empty()) {
      answer.outcome = SeparationOutcome::untested;
      answer.reason = why_untested(answer.coverage);
      return answer;
    }
    answer.overlap = overlap();
    const int n = static_cast<int>(left_.size());
    if (!answer.overlap) {
      for (int body = n == 2 ? 1 : 0; body < n; ++body) {
        report_parts("bodies", answer.bodies.size(), left_.size());
        answer.bodies.push_back(directions(body));
      }
      if (n > 2) take_apart(answer);
    }
    answer.outcome = answer.overlap      ? SeparationOutcome::overlap_at_start
                     : is_locked(answer) ? SeparationOutcome::locked
                                         : SeparationOutcome::free;
    return answer;
  }

 private:
  static bool is_locked(const Separation& answer) {
    return answer.bodies.size() == 1 ? answer.bodies[0].free.empty() : !answer.stuck.empty();
  }

  std::optional<std::array<BodyId, 2>> overlap() {
    const int n = static_cast<int>(standing_.size());
    for (int a = 0; a < n; ++a) {
      report_parts("bodies held against the others", static_cast<std::uint64_t>(a), standing_.size());
      for (int b = a + 1; b < n; ++b) {
        checkpoint();
        if (instance_.excluded(a, b)) continue;
        held_.insert(instance_.scene_pair(a, b));
        const PairInstance pair(instance_, a, b, Offset::inward);
        if (spacetime::overlapping(pair.geometry, pair.trees(), pair.segments()[0], instance_.start()))
          return instance_.scene_pair(a, b);
      }
    }
    return std::nullopt;
  }

  /// The directions of a body relative to all that are left.
  BodyDirections directions(int body) const {
    FreeDirections search(std::ldexp(travel_, instance_.exponent()));
    std::vector<std::array<int, 2>> pairs;
    for (const int other : left_) {
      for (const int own : instance_.sections(body)) {
        for (const int theirs : instance_.sections(other)) {
          if (instance_.excluded(own, theirs)) continue;
          pairs.push_back({own, theirs});
          search.add(*standing_[static_cast<std::size_t>(own)], *standing_[static_cast<std::size_t>(theirs)]);
        }
      }
    }
    BodyDirections found;
    found.body = body;
    found.all = search.all_free();
    if (found.all) {
      found.free.emplace_back();
      return found;
    }
    for (const VertexArc& arc : search.free()) found.free.push_back(arc_of(pairs, search, arc));
    return found;
  }

  DirectionArc arc_of(const std::vector<std::array<int, 2>>& pairs, const FreeDirections& search,
                      const VertexArc& arc) const {
    const auto rings = [&](const VertexDirection& d, std::size_t side) -> const RingSet& {
      return *instance_.bodies()[static_cast<std::size_t>(pairs[static_cast<std::size_t>(d.other)][side])].rings;
    };
    const auto vertices = [&](const VertexDirection& d) -> std::optional<std::array<VertexRef, 2>> {
      if (d.kind != VertexDirection::Kind::vertices) return std::nullopt;
      return std::array<VertexRef, 2>{rings(d, 0).vertex(d.from), rings(d, 1).vertex(d.to)};
    };
    const auto reach = [&](const VertexDirection& d) -> std::optional<VertexAtEdge> {
      if (d.kind == VertexDirection::Kind::vertices) return std::nullopt;
      const RingSet &own = rings(d, 0), &other = rings(d, 1);
      if (d.kind == VertexDirection::Kind::to_edge) return VertexAtEdge{own.vertex(d.from), other.edge(d.to)};
      return VertexAtEdge{other.vertex(d.to), own.edge(d.from)};
    };
    const auto [from_lo, from_hi] = search.degrees(arc.from);
    const auto [to_lo, to_hi] = search.degrees(arc.to);
    return {{from_lo, from_hi}, {to_lo, to_hi},  search.is_point(arc), vertices(arc.from),
            vertices(arc.to),   reach(arc.from), reach(arc.to)};
  }

  /// A body that can leave can also leave later, because fewer bodies block it. So the first one that can leave is as
  /// good as any other.
  void take_apart(Separation& answer) {
    const std::size_t all = left_.size();
    while (left_.size() > 1) {
      report_parts("bodies taken away", all - left_.size(), all);
      bool taken = false;
      for (std::size_t i = 0; i < left_.size() && !taken; ++i) {
        const BodyDirections can = directions(left_[i]);
        if (can.free.empty()) continue;
        answer.order.push_back(widest_removal(can));
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
        taken = true;
      }
      if (taken) continue;
      answer.stuck.assign(left_.begin(), left_.end());
      return;
    }
  }

  Instance instance_;
  double travel_;
  std::vector<std::unique_ptr<const StandingBody>> standing_;
  std::vector<int> left_;                 ///< bodies that have not been removed
  std::set<std::array<BodyId, 2>> held_;  ///< pairs that were held against each other
};

}  // namespace
}  // namespace taut

namespace taut::internal {

RemovalStep widest_removal(const BodyDirections& can) {
  const auto width = [](const DirectionArc& arc) {
    if (arc.point) return 0.0;
    const double w = arc.to.lo - arc.from.hi;
    return w > 0 ? w : w + 360;
  };
  const DirectionArc& widest =
      *std::max_element(can.free.begin(), can.free.end(),
                        [&](const DirectionArc& a, const DirectionArc& b) { return width(a) < width(b); });
  const double middle = can.all ? 0 : widest.from.hi + width(widest) / 2;
  return {can.body, widest, middle >= 360 ? middle - 360 : middle};
}

Separation separate_straight(const Scene& scene, const SeparateOptions& options) {
  if (!(options.travel > 0))
    throw InputError("travel", "bodies move farther than nothing", "give a length > 0, or none for any distance");
  if (has_curves(scene)) return separate_curves(scene, options);
  const Budget scope(options.limits);
  std::optional<SeparationSearch> search;
  Separation answer;
  const std::string stopped = what_stops([&] {
    validate_polygons(scene);
    answer = search.emplace(scene, options.travel).run();
  });
  if (stopped.empty()) return answer;
  answer.coverage = search ? search->when_stopped() : coverage_before_search(scene);
  answer.reason = stopped;
  return answer;
}

}  // namespace taut::internal
