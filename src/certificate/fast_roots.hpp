// Signs and roots in doubles with proved bounds: the stage that nearly always decides.
//
// Value, slope and second derivative at an instant, and a bound of the third derivative over a cell of the cache, give
// one of two results: a step that certainly contains no root, or an interval into which the function certainly falls.
// Nothing here throws for lack of precision. Uncertain cases are left to other stages (FailureSolver).
#pragma once

#include <cmath>
#include <optional>

#include "certificate/root.hpp"
#include "motion/taylor_model_cache.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {

struct FastLine;
struct Instant;

/// The expansion of a function at one instant, with bounds of its curvature within the cell around it.
struct LocalExpansion {
  double t;
  Bounded value, slope;
  Bounded second;  ///< the second derivative: at t if `local`, otherwise over the whole cell
  double third;    ///< a bound of the third derivative's magnitude if `local`, otherwise 0
  ModelPlace cell;
  bool local;

  /// A bound of the slope's change within the cell over this time.
  double slope_change(double time) const {
    return (std::fabs(second.value) + second.error + third * time) * time * (1 + 0x1p-40);
  }
};

/// An approximate extremum of a function, and the time until which the second derivative keeps its sign from there on.
struct PlaceOfTurn {
  double at, until;
};

class FastRoots {
 public:
  /// Answers are counted in `counts`. Both arguments must outlive this object.
  FastRoots(TaylorModelCache& clock, StageCounts& counts) : clock_(clock), counts_(counts) {}

  LocalExpansion expansion(const FastFunction& f, double t);
  /// The expansion at an instant shortly before t, or at t, that costs less.
  LocalExpansion expansion_near(const FastFunction& f, double t);
  /// The sign over [lo, hi], where `expansion` is taken at `at`; 0 if that is not certain.
  int sign_during(const FastFunction& f, const LocalExpansion& expansion, double lo, double hi, double at);
  /// The function as a line, on a straight segment.
  FastLine line_of(const FastFunction& f) const;

  static constexpr int all_cells = 1000;  ///< more than there are around any cell
  /// The root's sign is known to hold at now.t, and up to t, which is not before now.t. Examines at most `cells` cells
  /// beyond its own. Returns false if `now` shows little more than that.
  bool follow(Root& r, const LocalExpansion& now, double t, int cells = all_cells);
  /// Like follow(), on a straight segment. Returns false if it is not certain whether the root comes on the segment.
  bool follow_line(Root& r, const FastLine& line, double t);
  /// The root's sign was found in high precision at `instant`, where the function may be zero in doubles. Either it is
  /// new, and another function is zero at the same instant, or it was itself zero there (`own`). If it certainly rises
  /// or falls there, doubles suffice to continue.
  bool follow_from_zero(Root& r, const Instant& instant, bool own);
  /// The extremum of the function, if it is so near that doubles see little else of the function, and its cell is
  /// smooth.
  std::optional<PlaceOfTurn> turn_near(const FastFunction& f, double t);
  /// Encloses a bracketed root within a few ulps, if doubles can.
  void enclose(Root& r);
  /// The instant of the last evaluation when a root was last enclosed. The frame is known there.
  double enclosed_about() const { return enclosed_about_; }

 private:
  const MotionSegment& segment() const { return clock_.segment(); }
  LocalExpansion expansion_with(const FastFunction& f, const FrameSample& side, double t);
  void take_bounds(const FastFunction& f, LocalExpansion& expansion, const ModelCell& cell) const;
  bool widen(const FastFunction& f, LocalExpansion& expansion, double start, double end);
  /// The time for which the root's sign certainly lasts from now.t on within the cell, if its value is at least
  /// `least`.
  double lasts(const Root& r, const LocalExpansion& now, double least) const;
  double positive_beyond(const Root& r, const LocalExpansion& now, double value, int cells);
  bool holds_on(Root& r, const LocalExpansion& now, double t, double least, double lasting, int cells = all_cells);
  bool isolate(Root& r, const LocalExpansion& now, double from);
  bool isolate_across(Root& r, const LocalExpansion& now, double t);
  bool narrow(Root& r);
  void newton(Root& r);
  bool newton_step(Root& r, const LocalExpansion& here);

  TaylorModelCache& clock_;
  StageCounts& counts_;
  double enclosed_about_ = 0;
};

}  // namespace taut::internal
