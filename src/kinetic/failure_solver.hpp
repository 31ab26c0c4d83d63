// Determines when a certificate fails: lower bounds first, isolation only when needed.
#pragma once

#include <optional>
#include <vector>

#include "certificate/fast_roots.hpp"
#include "certificate/instant.hpp"
#include "kinetic/certificate.hpp"
#include "numeric/errors.hpp"

namespace taut::internal {

/// The current instant: a double, or the failure time of a certificate.
struct Now : Instant {
  double at = 0;              ///< in [lo, hi]; an instant where the motion is known already, if any
  double monotone_until = 0;  ///< for an event: its function is monotone until then
  /// The precise time found by the solver, copied because the solver discards it with the certificate; or filled on
  /// first use.
  std::optional<PreciseTime> precise;
};

/// Determines when certificates fail on one segment. It computes lower bounds first, advances them on demand, and
/// encloses a failure when it is near. Each query passes through the following stages. The first is doubles (FastRoots,
/// and FastLine where the certificate function is also a line in doubles). The second is the same on the part that is
/// linear in the displacement, where the rest is zero. The last is PreciseTriple, which has exact lines, certificate
/// functions expanded about an instant, and multi-precision.
class FailureSolver {
 public:
  explicit FailureSolver(const PairGeometry& geometry) : geometry_(geometry) {}
  FailureSolver(const FailureSolver&) = delete;
  FailureSolver& operator=(const FailureSolver&) = delete;

  /// Makes room for the failure times of this many certificates, so that events allocate nothing. The memory is touched
  /// only when events coincide within double precision.
  void reserve(std::size_t certificates) {
    pool_.reserve(certificates);
    pool_free_.reserve(certificates);
  }
  /// Required for a segment that is not straight.
  void reserve_cells() {
    clock_.reserve_cells();
    memory_.reserve_expansions();
  }
  /// Gives room that is not needed between two queries to others in this thread, and that for precise times back, if
  /// there are none: doubles decide nearly everything.
  void put_aside() {
    clock_.release();
    memory_.release();
    if (!pool_.empty()) return;
    pool_ = std::vector<PreciseTime>();
    pool_free_ = std::vector<std::int32_t>();
  }
  std::size_t bytes() const {
    return pool_.capacity() * sizeof(PreciseTime) + pool_free_.capacity() * sizeof(std::int32_t);
  }
  void enter(const MotionSegment& segment) {
    clock_.reset(segment);
    memory_.reset(segment);
    hopeless_near_end_ = false;
  }
  const MotionSegment& segment() const { return clock_.segment(); }
  const StageCounts& stages() const { return memory_.stages; }
  const std::vector<PreciseTime>& pool() const { return pool_; }

  /// Marks a certificate that cannot fail.
  void rest(Certificate& c) {
    release(c);
    c.kind = RootKind::not_before;
    c.lo = never;
  }
  /// Starts a certificate whose sign is known to hold at t.
  void start(Certificate& c, double t);
  /// Starts a new certificate just after `now` and determines its sign.
  void start_at(Certificate& c, Now& now);
  /// Advances the lower bound of a certificate, or encloses its failure: first as far as the bounds allow, then as
  /// tightly as doubles can. Not for isolated ones.
  void advance(Certificate& c);
  /// Frees the pool entry of the certificate.
  void release(Certificate& c);

  /// Is the isolated failure of `a` certainly before that of `b`, as far as is known now?
  bool known_before(const Certificate& a, const Certificate& b) const;
  /// Given two isolated failures whose enclosures overlap, refines the less precise one, or both. The caller must
  /// update the queue. Throws Undecidable if no stage is left.
  void separate(Certificate& a, Certificate& b);
  /// Does the isolated failure come no later than t, which is inside its enclosure?
  bool fails_by(Certificate& c, double t);
  /// The middle one of three vertices that are collinear at `now`.
  VertexId middle(VertexId u, VertexId v, VertexId w, Now& now);
  /// The failure of c as the current instant.
  Now event(const Certificate& c) const;
  /// The isolated failure of c, if a stage beyond doubles has refined it.
  std::optional<PreciseTime> known_precisely(const Certificate& c) const;
  /// Refines the failure time of c to within a few ulps.
  void tighten(Certificate& c);

 private:
  CertificateFunction function_of(const Certificate& c) const {
    return CertificateFunction::of(geometry_, c.u, c.v, c.w);
  }
  PreciseTriple precise_of(const Certificate& c) { return {segment(), geometry_, function_of(c), &memory_}; }
  void advance_from(Certificate& c, double t);
  void advance_hard(Certificate& c, double t);
  void advance_precise(Certificate& c, const PreciseTriple& function, const PreciseTime& from);
  void advance_to(Certificate& c, const PreciseTriple& function, const PreciseTime& from, double to);
  bool advance_near_end(Certificate& c, const PreciseTriple& function, const PreciseTime& from, double segment_end);
  bool pass_turn(Certificate& c, const PreciseTime& from);
  bool isolate_on_segment(Certificate& c, const PreciseTime& t);
  bool start_in_doubles(Certificate& c, const Now& now);
  bool start_on_line(Certificate& c, double t);
  bool start_on_line(Certificate& c, const Now& now);
  void set_isolated(Certificate& c, const PreciseTime& t);
  void holds_until(Certificate& c, double t);
  void sharpen(Certificate& c, Stage stage);
  PreciseTime& precise_slot(Certificate& c);
  static PreciseTime& precise_now(Now& now);
  /// The sign of a certificate function at `now`: in doubles if possible, else precisely.
  int sign_now(const CertificateFunction& function, Now& now);
  int precise_sign(const CertificateFunction& function, Now& now);

  const PairGeometry& geometry_;
  TaylorModelCache clock_;
  FrameMemory memory_;
  FastRoots fast_{clock_, memory_.stages};
  bool hopeless_near_end_ = false;  ///< on this segment
  std::vector<PreciseTime> pool_;
  std::vector<std::int32_t> pool_free_;
};

}  // namespace taut::internal
