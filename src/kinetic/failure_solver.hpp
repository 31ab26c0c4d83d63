// When does a certificate fail? Lower bounds first, isolation only when it matters.
#pragma once

#include <optional>
#include <vector>

#include "base/errors.hpp"
#include "kinetic/certificate.hpp"
#include "relative/leg_clock.hpp"
#include "sign/instant.hpp"

namespace taut {

struct FastLine;

/// The present: a double, or the failure time of a certificate.
struct Now : Instant {
  double at = 0;              ///< in [lo, hi], where the motion is known already, if there is such an instant
  double monotone_until = 0;  ///< of an event: its function is monotone until then
  /// Filled when first needed; `pool` is where the solver keeps the enclosure it has found, or -1.
  std::optional<PreciseTime> precise;
  std::int32_t pool = -1;
};

/// How often each stage of the arithmetic answered.
struct StageCounts {
  std::uint64_t fast = 0;      ///< doubles with an error bound
  std::uint64_t level1 = 0;    ///< doubles, on the part that is linear in the displacement
  std::uint64_t precise = 0;   ///< multi-precision failure times
  std::uint64_t compared = 0;  ///< multi-precision comparisons of two failure times

  StageCounts& operator+=(const StageCounts& o) {
    fast += o.fast;
    level1 += o.level1;
    precise += o.precise;
    compared += o.compared;
    return *this;
  }
};

/// Schedules certificates on one leg.
class FailureSolver {
 public:
  explicit FailureSolver(const PairGeometry& geometry) : geometry_(geometry) {}

  /// Makes room for the failure times of this many certificates, so that events allocate nothing. The memory is touched
  /// only when events coincide within double precision.
  void reserve(std::size_t certificates) {
    pool_.reserve(64 + certificates);
    pool_free_.reserve(64 + certificates);
  }
  /// For a leg that is not straight.
  void reserve_cells() { clock_.reserve_cells(); }
  std::size_t bytes() const {
    return pool_.capacity() * sizeof(PreciseTime) + pool_free_.capacity() * sizeof(std::int32_t);
  }
  void enter(const Leg& leg) { clock_.reset(leg); }
  const Leg& leg() const { return clock_.leg(); }
  const StageCounts& counts() const { return counts_; }
  const std::vector<PreciseTime>& pool() const { return pool_; }

  /// A certificate that cannot fail.
  void rest(Certificate& c) {
    release(c);
    c.kind = FailureKind::not_before;
    c.lo = never;
  }
  /// Starts a certificate whose sign is known to hold at t.
  void start(Certificate& c, double t);
  /// Starts a new certificate just after `now`; finds its sign.
  void start_at(Certificate& c, Now& now);
  /// Pushes the lower bound of a certificate forward, or encloses its failure: first as the bounds tell, then as well
  /// as doubles can. Not for isolated ones.
  void advance(Certificate& c);
  /// Drops what the pool holds for it.
  void release(Certificate& c);

  /// Is the isolated failure of `a` certainly before that of `b`, as far as is known now?
  bool known_before(const Certificate& a, const Certificate& b) const;
  /// Of two isolated failures whose enclosures overlap, encloses the less precise one better (or both): the queue must
  /// be told. Throws Undecidable if no stage is left.
  void separate(Certificate& a, Certificate& b);
  /// Does the isolated failure come no later than t (inside its enclosure)?
  bool fails_by(Certificate& c, double t);
  /// Of three vertices that are collinear now, the middle one.
  VertexId middle(VertexId u, VertexId v, VertexId w, Now& now);
  /// The present as the failure of c.
  Now event(const Certificate& c) const;
  /// The failure time of c within a few ulps.
  void tighten(Certificate& c);

 private:
  Form form_of(const Certificate& c) const { return Form::of(geometry_, c.u, c.v, c.w); }
  PreciseTriple precise_of(const Certificate& c) const { return {leg(), geometry_, form_of(c)}; }
  /// A function at one instant, and how it may bend within the cell around it.
  struct Course {
    double t;
    Bounded value, slope;
    Bounded bend;  ///< the second derivative: at t if `local`, otherwise all over the cell
    double third;  ///< a bound of the third one's magnitude if `local`, otherwise 0
    ClockPlace cell;
    bool local;

    /// The most that the slope changes within the cell in so short a time.
    double slope_change(double time) const {
      return (std::fabs(bend.value) + bend.error + third * time) * time * (1 + 0x1p-40);
    }
  };
  Course course(const FastFunction& f, double t);
  /// At an instant shortly before t, or at t, that costs less.
  Course course_near(const FastFunction& f, double t);
  Course course_with(const FastFunction& f, const FrameSample& side, double t);
  void advance_from(Certificate& c, double t);
  static constexpr int all_cells = 1000;  ///< more than there are around one
  bool advance_along(Certificate& c, const Course& now, double t, int cells = all_cells);
  bool advance_from_zero(Certificate& c, const Now& instant);
  /// How long the certificate's sign certainly lasts from now.t on within the cell, if its value is `least` at least.
  double lasts(const Certificate& c, const Course& now, double least) const;
  void take_bounds(const FastFunction& f, Course& course, const ClockCell& cell) const;
  bool holds_on(Certificate& c, const Course& now, double t, double least, double lasting, int cells = all_cells);
  bool isolate(Certificate& c, const Course& now, double from);
  bool start_in_doubles(Certificate& c, const Now& now);
  FastLine line_of(const FastFunction& f) const;
  bool start_on_line(Certificate& c, double t);
  bool start_on_line(Certificate& c, const Now& now);
  bool follow_line(Certificate& c, const FastLine& line, double t);
  double positive_beyond(const Certificate& c, const Course& now, double value, int cells);
  void refine_fast(Certificate& c);
  bool narrow(Certificate& c);
  void newton(Certificate& c);
  bool newton_step(Certificate& c, const Course& here);
  void advance_hard(Certificate& c, double t);
  void advance_precise(Certificate& c, const PreciseTriple& function, const PreciseTime& from);
  void set_isolated(Certificate& c, const PreciseTime& t);
  void sharpen(Certificate& c, int stage);
  void set_not_before(Certificate& c, double t);
  PreciseTime& precise_slot(Certificate& c);
  PreciseTime& precise_now(Now& now) const;
  /// The sign of a function at `now`: fast if possible, else precise.
  int sign_now(const Form& form, Now& now);
  int precise_sign(const Form& form, Now& now);
  bool widen(const FastFunction& f, Course& course, double start, double end);
  int sign_during(const FastFunction& f, const Course& course, const Now& now);

  const PairGeometry& geometry_;
  LegClock clock_;
  double enclosed_about_ = 0;  ///< where the function was evaluated when a failure was last enclosed
  StageCounts counts_;
  std::vector<PreciseTime> pool_;
  std::vector<std::int32_t> pool_free_;
};

}  // namespace taut
