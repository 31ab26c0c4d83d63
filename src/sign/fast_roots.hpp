// Signs and roots in doubles with proved bounds: the stage that answers nearly always.
//
// From value, slope and second derivative at an instant, and a bound of the third over a cell of the clock, comes a
// step that certainly holds no root, or an interval into which the function certainly falls. Nothing here throws for
// want of precision: what is not certain is left to other stages (FailureSolver).
#pragma once

#include <cmath>
#include <optional>

#include "numeric/stages.hpp"
#include "relative/taylor_model_cache.hpp"
#include "sign/root.hpp"

namespace taut::internal {

struct FastLine;
struct Instant;

/// A function at one instant, and how it may bend within the cell around it.
struct LocalExpansion {
  double t;
  Bounded value, slope;
  Bounded second;  ///< the second derivative: at t if `local`, otherwise all over the cell
  double third;    ///< a bound of the third one's magnitude if `local`, otherwise 0
  ModelPlace cell;
  bool local;

  /// The most that the slope changes within the cell in so short a time.
  double slope_change(double time) const {
    return (std::fabs(second.value) + second.error + third * time) * time * (1 + 0x1p-40);
  }
};

/// About where a function turns, and until when it bends to one side from there on.
struct PlaceOfTurn {
  double at, until;
};

class FastRoots {
 public:
  /// Answers are counted in `counts`. Both must outlive it.
  FastRoots(TaylorModelCache& clock, StageCounts& counts) : clock_(clock), counts_(counts) {}

  LocalExpansion expansion(const FastFunction& f, double t);
  /// At an instant shortly before t, or at t, that costs less.
  LocalExpansion expansion_near(const FastFunction& f, double t);
  /// The sign over [lo, hi], where `course` is taken at `at`; 0 if that is not certain.
  int sign_during(const FastFunction& f, const LocalExpansion& expansion, double lo, double hi, double at);
  /// The function as a line, on a straight segment.
  FastLine line_of(const FastFunction& f) const;

  static constexpr int all_cells = 1000;  ///< more than there are around one
  /// The root's sign is known to hold at now.t, and up to t, which is not before that. Looks at so many cells beyond
  /// its own. False if that is about all that can be said with `now`.
  bool follow(Root& r, const LocalExpansion& now, double t, int cells = all_cells);
  /// The same on a straight segment. False if it is not certain whether the root comes on the segment.
  bool follow_line(Root& r, const FastLine& line, double t);
  /// The root's sign was found in high precision at `instant`, where in doubles the function may be zero: it was just
  /// born, and another one is zero at the same instant, or it was so itself (`own`). If it certainly rises or falls
  /// there, doubles are good enough to go on.
  bool follow_from_zero(Root& r, const Instant& instant, bool own);
  /// Where the function turns, if that is so near that doubles see little else of it, and its cell is smooth.
  std::optional<PlaceOfTurn> turn_near(const FastFunction& f, double t);
  /// Encloses a bracketed root within a few ulps, if doubles can.
  void enclose(Root& r);
  /// Where the function was evaluated when a root was last enclosed: the frame is known there.
  double enclosed_about() const { return enclosed_about_; }

 private:
  const MotionSegment& segment() const { return clock_.segment(); }
  LocalExpansion expansion_with(const FastFunction& f, const FrameSample& side, double t);
  void take_bounds(const FastFunction& f, LocalExpansion& expansion, const ModelCell& cell) const;
  bool widen(const FastFunction& f, LocalExpansion& expansion, double start, double end);
  /// How long the root's sign certainly lasts from now.t on within the cell, if its value is `least` at least.
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
