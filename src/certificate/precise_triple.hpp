// The multi-precision stages of failure times: for degenerate input, tangencies, and events that doubles cannot order.
#pragma once

#include <optional>

#include "certificate/exact_line.hpp"
#include "certificate/fixed_point_expansion.hpp"
#include "certificate/precise_function.hpp"
#include "certificate/precise_time.hpp"
#include "certificate/taylor_frames.hpp"
#include "numeric/errors.hpp"
#include "numeric/root_isolation.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {

// Data shared by the signs and roots of one segment.

/// Cached data of one segment's frame functions, and counts of the stages that decided, also on earlier segments.
struct FrameMemory {
  FrameExpansionCache expansions;
  ExpansionCache functions;
  TaylorFrames models;
  StageCounts stages;

  /// Makes room for the needs of events at one instant.
  void reserve_expansions() {
    expansions.reserve();
    functions.reserve();
  }
  /// Gives the room back, for others in this thread to use.
  void release() {
    expansions.release();
    functions.release();
    models.clear();
  }
  void reset(const MotionSegment& segment) {
    expansions.reset(segment);
    functions.clear();
    models.clear();
  }
};

/// A certificate function on a segment, at any precision.
class PreciseTriple {
 public:
  /// `memory`, if any, belongs to the same segment and must outlive this object.
  PreciseTriple(const MotionSegment& segment, const PairGeometry& geometry, const CertificateFunction& function,
                FrameMemory* memory = nullptr)
      : segment_(segment), geometry_(geometry), function_(function), memory_(memory) {}

  /// The sign at an instant, at one stage; 0 if undecided there.
  int sign_at(const PreciseTime& t, Stage stage) const;
  /// The first change of sign in (from.hi, to], where `sign` holds just after `from`, by the first stage that decides.
  /// Throws Undecidable.
  std::optional<PreciseTime> first_failure(int sign, const PreciseTime& from, double to) const;
  /// The consequence of an extremum near zero for the time in which the second derivative keeps its sign.
  struct NearExtremum {
    std::optional<PreciseTime> failure;  ///< none if the function keeps its sign
  };
  /// The first change of sign as in first_failure(), where the function has an extremum within double precision of an
  /// instant: the sign of its extreme value decides. Nothing if there is no such extremum, or if it is not known. The
  /// failure is known relative to the extremum, and more precisely from Stage::precise on.
  std::optional<NearExtremum> near_extremum(int sign, const PreciseTime& from, double about) const;
  /// Shrinks an isolating enclosure at the given stage, but not below the width `enough`. `sign` is the sign before the
  /// root. Returns false if the stage cannot.
  bool refine(int sign, PreciseTime& t, Stage stage, double enough = 0) const;

 private:
  struct LineFailure {
    bool known = false;
    std::optional<PreciseTime> time;
  };
  LineFailure line_failure(int sign, const PreciseTime& from, double to) const;
  std::optional<NearExtremum> extremum_ahead(int sign, const PreciseTime& from, double to) const;
  const ExactLine* line() const;
  /// Returns the answer, and counts it if there is one.
  template <class Decided>
  Decided decided_by(Stage stage, Decided answer) const {
    if (answer && memory_) memory_->stages.add(stage);
    return answer;
  }
  const FrameExpansion* frame_near(const PreciseTime& t) const;
  const RootOfExpansion* root_near(const PreciseTime& t, Stage stage) const;
  std::optional<PreciseTime> root_of_expansion(int sign, const PreciseTime& t, Stage stage, double enough) const;
  PreciseTime sharpened(int sign, PreciseTime t) const;
  int sign_near_root(const PreciseTime& t, Stage stage) const;
  template <class Real>
  PreciseFunction<Real> function() const {
    return {segment_, geometry_, function_, memory_ ? &memory_->models : nullptr};
  }
  /// The sign change in (from.hi, to] as a function of time, as tight as this precision allows; stored if there is
  /// memory.
  template <class Real>
  std::optional<RootEnclosure<Real>> sign_change(const PreciseFunction<Real>& f, int sign, const PreciseTime& from,
                                                 double to) const;
  template <class Real>
  void refine_root(const PreciseFunction<Real>& f, int sign, RootEnclosure<Real>& root, double enough) const;

  const MotionSegment& segment_;
  const PairGeometry& geometry_;
  CertificateFunction function_;
  FrameMemory* memory_;
  mutable std::optional<ExactLine> line_;  ///< constructed on first use
};

}  // namespace taut::internal
