// The directions in which bodies with curves can leave each other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "query/bracket.hpp"
#include "query/separate_straight.hpp"

namespace taut::internal {
namespace {

/// The tolerance, in degrees, for the directions that end a free arc.
constexpr double direction_tolerance = 1e-7;

const std::string finer_than_doubles =
    "whether bodies can leave in some directions, or overlap already, is finer than doubles resolve curves: taut "
    "flatten "
    "--inner, or --outer, makes polygons, about which it is decided";

/// The difference of two directions, also across 360 degrees.
double between_degrees(double a, double b) {
  const double d = std::fabs(a - b);
  return std::min(d, 360 - d);
}

/// Brackets the free directions between those of polygons around the bodies, which are certainly free, and those of
/// polygons within.
class CurvedSeparation {
 public:
  CurvedSeparation(const Scene& scene, const SeparateOptions& options)
      : options_(options), run_(scene, options.limits) {}

  Separation ask(CurveSide side) const {
    SeparateOptions options = options_;
    options.limits = run_.limits_left();
    Separation answer = separate_straight(run_.world().polygons(side), options);
    answer.geometry = run_.geometry();
    return answer;
  }

  std::optional<Separation> decided_by(const Separation& outer) const {
    if (!outer.reason.empty()) return outer;
    return std::nullopt;
  }

  std::optional<Separation> decided_by(const Separation& outer, const Separation& inner) const {
    if (!inner.reason.empty() || inner.overlap) return inner;
    if (alike(outer, inner) && widest(outer, inner) <= direction_tolerance) return concluded(outer, inner);
    return std::nullopt;
  }

  bool refine(const Separation& outer, const Separation& inner) {
    Marks marks(run_.world());
    if (outer.overlap) marks.near(*outer.overlap, run_.world().scene().start);
    mark(CurveSide::outer, outer, marks);
    mark(CurveSide::inner, inner, marks);
    return run_.refine(std::move(marks));
  }

  Separation too_fine(Separation outer, const Separation& inner) const {
    if (alike(outer, inner)) {
      outer.wide = fmt::format(
          "ends of free directions are found to {:.2g} degrees: more needs more edges along the curves than "
          "is reasonable",
          widest(outer, inner));
      return concluded(std::move(outer), inner);
    }
    outer.outcome = SeparationOutcome::undecided;
    outer.reason = finer_than_doubles;
    return outer;
  }

 private:
  static bool alike(const Separation& outer, const Separation& inner) {
    return !outer.overlap && same_arcs(outer, inner);
  }

  static bool same_arcs(const Separation& outer, const Separation& inner) {
    for (std::size_t i = 0; i < outer.bodies.size(); ++i) {
      if (outer.bodies[i].free.size() != inner.bodies[i].free.size()) return false;
      if (outer.bodies[i].all != inner.bodies[i].all) return false;
    }
    return true;
  }

  static double widest(const Separation& outer, const Separation& inner) {
    double most = 0;
    for (std::size_t i = 0; i < outer.bodies.size(); ++i) {
      for (std::size_t k = 0; k < outer.bodies[i].free.size(); ++k) {
        const DirectionArc &a = outer.bodies[i].free[k], &b = inner.bodies[i].free[k];
        most = std::max({most, between_degrees(a.from.hi, b.from.lo), between_degrees(a.to.lo, b.to.hi)});
      }
    }
    return most;
  }

  static void mark(CurveSide side, const Separation& answer, Marks& marks) {
    for (const BodyDirections& body : answer.bodies) {
      for (const DirectionArc& arc : body.free) {
        for (const auto& ends : {arc.from_vertices, arc.to_vertices}) {
          if (!ends) continue;
          for (const VertexRef& vertex : *ends) marks.vertex(side, vertex);
        }
        for (const auto& end : {arc.from_reach, arc.to_reach}) {
          if (!end) continue;
          const EdgeRef& e = end->edge;
          marks.vertex(side, end->vertex);
          marks.vertex(side, {e.body, e.index, e.part, e.ring});
        }
      }
    }
  }

  /// The result: the arcs of polygons around the bodies, which are certainly free, and enclosures of the true ends.
  Separation concluded(Separation outer, const Separation& inner) const {
    const auto name = [&](std::optional<std::array<VertexRef, 2>>& ends) {
      if (!ends) return;
      for (VertexRef& vertex : *ends) run_.world().name_curve(CurveSide::outer, vertex);
    };
    const auto name_reach = [&](std::optional<VertexAtEdge>& end) {
      if (!end) return;
      run_.world().name_curve(CurveSide::outer, end->vertex);
      run_.world().name_curve(CurveSide::outer, end->edge);
    };
    const auto name_ends = [&](DirectionArc& arc) {
      name(arc.from_vertices);
      name(arc.to_vertices);
      name_reach(arc.from_reach);
      name_reach(arc.to_reach);
    };
    for (std::size_t i = 0; i < outer.bodies.size(); ++i) {
      for (std::size_t k = 0; k < outer.bodies[i].free.size(); ++k) {
        DirectionArc& arc = outer.bodies[i].free[k];
        const DirectionArc& wider = inner.bodies[i].free[k];
        if (!outer.bodies[i].all) {
          // Not across 0: there an end is as exact as that of the polygons.
          if (wider.from.lo <= arc.from.lo && arc.from.lo - wider.from.lo < 1) arc.from.lo = wider.from.lo;
          if (wider.to.hi >= arc.to.hi && wider.to.hi - arc.to.hi < 1) arc.to.hi = wider.to.hi;
        }
        name_ends(arc);
      }
    }
    for (RemovalStep& step : outer.order) name_ends(step.free);
    return outer;
  }

  const SeparateOptions& options_;
  CurvedRun run_;
};

}  // namespace

Separation separate_curves(const Scene& scene, const SeparateOptions& options) {
  CurvedSeparation query(scene, options);
  return bracketed(query);
}

}  // namespace taut::internal
