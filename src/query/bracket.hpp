// The loop of all queries about curves: each is asked about polygons around the bodies and about polygons within them.
// The true answer lies between. Where the two differ too much, the polygons are refined near the cause, and the query
// is repeated.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <utility>

#include "scene/curved_world.hpp"
#include "scene/pair_margins.hpp"
#include "solver/run.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/intervals.hpp"
#include "taut/separate.hpp"

namespace taut::internal {

/// Marks the cells of both bodies whose distance from the other body at time t is at most their thickness plus `reach`.
/// Of two cells that differ much, only the thicker one is marked. The marks are estimates in doubles: they determine
/// where to refine, and prove nothing. Returns the number of marked cells that can be refined.
std::size_t mark_near(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, double reach,
                      CurvedWorld::Halvings& marks);

/// Do the curves of two bodies run along each other at that time, so closely that more than `most` cells would be
/// needed to separate them? This is an estimate in doubles, from the majority of the near cells. It serves only to stop
/// early.
bool run_along(const CurvedWorld& world, const std::array<BodyId, 2>& pair, double t, std::uint64_t most);

/// Cells to refine.
class Marks {
 public:
  explicit Marks(const CurvedWorld& world) : world_(world), halvings_(world.no_halvings()) {}

  /// The cells of both bodies that are near each other at that time: see mark_near().
  void near(const std::array<BodyId, 2>& pair, double t, double reach = 0) {
    count_ += mark_near(world_, pair, t, reach, halvings_);
  }
  /// Of both bodies, all cells at least half as thick as the thickest one that is marked.
  void as_thick(const std::array<BodyId, 2>& pair);
  /// The cell of a vertex of the polygons on that side, and its neighbours.
  void vertex(CurveSide side, const VertexRef& vertex) { count_ += world_.mark_vertex(side, vertex, halvings_); }

  /// How many of the marked cells can be refined.
  std::size_t count() const { return count_; }
  /// Each marked cell is to be halved so many times.
  CurvedWorld::Halvings times(int halvings) &&;

 private:
  const CurvedWorld& world_;
  CurvedWorld::Halvings halvings_;
  std::size_t count_ = 0;
};

/// What one query about curves works with: its bands, the time it has left, and a limit of the number of cells, beyond
/// which it is abandoned: curves that run along each other for a while would never end.
class CurvedRun {
 public:
  /// `limits` must outlive this.
  CurvedRun(const Scene& scene, const Limits& limits)
      : world_(scene),
        limits_(limits),
        began_(std::chrono::steady_clock::now()),
        most_segments_(4 * world_.segments() + 30000) {}

  const CurvedWorld& world() const { return world_; }
  CurvedWorld take_world() { return std::move(world_); }
  CurveGeometry geometry() const { return {world_.tolerance(), world_.segments()}; }

  double seconds() const { return seconds_since(began_); }
  /// The limits of the query, with the time that is left.
  Limits limits_left() const { return {time_left(limits_.max_seconds, began_), limits_.stop}; }

  std::uint64_t most_segments() const { return most_segments_; }
  bool at_limit() const { return world_.segments() > most_segments_; }
  /// Refines the marked cells: a little if there are many, further if there are few. False if none became finer, or the
  /// limit was reached before.
  bool refine(Marks marks) { return !at_limit() && refine_beyond_limit(std::move(marks)); }
  bool refine_beyond_limit(Marks marks);
  /// The same, each by so many halvings.
  bool refine(Marks marks, int halvings);

 private:
  CurvedWorld world_;
  const Limits& limits_;
  std::chrono::steady_clock::time_point began_;
  std::uint64_t most_segments_;
};

/// Answers a query that has
///   Answer ask(CurveSide)                                  for polygons on that side
///   std::optional<Answer> decided_by(outer)                if the polygons around the bodies suffice
///   std::optional<Answer> decided_by(outer, inner)         if the two answers are near enough to each other
///   bool refine(outer, inner)                              where they differ; false if nothing became finer
///   Answer too_fine(outer, inner)                          what is known then
template <class Query>
auto bracketed(Query& query) {
  for (;;) {
    auto outer = query.ask(CurveSide::outer);
    if (auto answer = query.decided_by(outer)) return std::move(*answer);
    auto inner = query.ask(CurveSide::inner);
    if (auto answer = query.decided_by(outer, inner)) return std::move(*answer);
    if (!query.refine(outer, inner)) return query.too_fine(std::move(outer), std::move(inner));
  }
}

// Queries about bodies with curves: bracket.hpp has the loop that they share.

Answer check_curved(const Scene& scene, const CheckOptions& options);

/// A first contact, and the bands between whose walls it was found, for use in pictures.
struct CurvedContact {
  Answer answer;
  CurvedWorld world;
};
/// Like check_curved(), without `fit` and `all_pairs`.
CurvedContact first_contact_of_curves(const Scene& scene, const CheckOptions& options);

/// Of an answer about a clearance: are bodies closer, or do they even overlap, already at the start?
inline bool at_start(Outcome outcome) {
  return outcome == Outcome::overlap_at_start || outcome == Outcome::closer_at_start;
}

/// Whether bodies keep a clearance, and the bands between whose walls this was found.
struct CurvedMargin {
  MarginAnswer answer;
  CurvedWorld world;
};
/// Like check_margins_of_curves(), without `all_pairs`.
CurvedMargin margin_of_curves(const Scene& scene, const PairMargins& margins, const CheckOptions& options);

Clearance clearance_of_curves(const Scene& scene, const ClearanceOptions& options);
DistanceProfile distance_profile_of_curves(const Scene& scene, const ProfileOptions& options);
MarginAnswer check_margins_of_curves(const Scene& scene, const PairMargins& margins, const CheckOptions& options);
Intervals intervals_of_curves(const Scene& scene, const CheckOptions& options);
/// `precisely` as overlap_intervals() takes it.
Intervals intervals_of_polygons(const Scene& scene, const CheckOptions& options, bool precisely);
/// Sets the outcome of an answer that has its intervals and its undecided pairs.
void conclude(Intervals& answer);
Separation separate_curves(const Scene& scene, const SeparateOptions& options);

/// The curves of distance_profile() with only their instants. Requires polygons and valid options.
DistanceProfile distances_at_instants(const Scene& scene, const ProfileOptions& options);

/// The largest coordinate of any curve.
double largest_size(const CurvedWorld& world);

/// The scene of two bodies, including all their parents, with all other pairs ignored. `ids` receives the bodies'
/// numbers in the whole scene.
Scene scene_of_pair(const Scene& scene, const std::array<BodyId, 2>& pair, std::vector<BodyId>& ids);

}  // namespace taut::internal
