// When a corner fails, and that it keeps its sign until then.
#pragma once

#include "certificate/fast_function.hpp"
#include "certificate/instant.hpp"
#include "motion/taylor_model_cache.hpp"
#include "numeric/errors.hpp"

namespace taut::internal::proof {

/// A corner of vertices of both bodies, with the sign that it has from `birth` on.
struct Corner {
  VertexId u, v, w;
  int sign = 0;
  Instant birth;
};

/// A form with the sign that it has from `birth` on. Where that is a root of the form itself, the sign is the one
/// after it.
struct SignedFunction {
  CertificateFunction function;
  int sign = 0;
  Instant birth;
  bool from_root = false;
};

/// Answers about one segment at a time. Every sign is certified: in doubles with bounds, else at high precision. Where
/// that does not suffice, it throws Undecidable.
class Lifetimes {
 public:
  explicit Lifetimes(const PairGeometry& geometry) : geometry_(geometry) {}

  void enter(const MotionSegment& segment) { clock_.reset(segment); }
  const MotionSegment& segment() const { return clock_.segment(); }

  /// The instant close to `about` at which the corner fails: for the first time since its birth if holds() says so.
  /// Throws ProofError if there is none.
  Instant failure(const Corner& corner, double about);
  /// Does the corner keep its sign from its birth up to `until`, that included? Where its own three vertices are those
  /// of `until`: up to then, not included.
  bool holds(const Corner& corner, const Instant& until);
  /// The same for any form. `own`: `until` is a root of this form.
  bool holds(const SignedFunction& function, const Instant& until, bool own);
  /// The same, as far as doubles can show: nothing is known where they cannot.
  bool holds_in_doubles(const SignedFunction& function, const Instant& until, bool own);
  /// Whenever a vertex is on an edge's line, which is what the form says, from `from` on and before `until`, or then if
  /// that is no event: is it behind one of the edge's ends? Throws Undecidable.
  bool behind_at_roots(const CertificateFunction& line, double from, const Instant& until) const;
  /// Is a failure as near to the time that a log gives for it as it has to be? An enclosure in doubles can be wide:
  /// where it does not decide, a finer one does.
  bool is_near(const Instant& event, double about) const;
  /// Is `a` certainly before `b`, or are they one?
  bool in_order(const Instant& a, const Instant& b);
  /// A failure enclosed within a few units in the last place, if that can be done.
  Instant tightened(Instant event) const;
  /// Of the three vertices that are on one line at `now`: which one is between?
  VertexId middle(const Instant& now);

 private:
  CertificateFunction function(VertexId u, VertexId v, VertexId w) const {
    return CertificateFunction::of(geometry_, u, v, w);
  }
  PreciseTriple precise(const CertificateFunction& f) const { return {segment(), geometry_, f}; }
  /// The instant at a stage; false if that cannot enclose it.
  bool at_stage(const Instant& i, Stage stage, PreciseTime& t) const;
  bool enclose(const FastFunction& f, int sign, Instant& root);
  bool falls_to_root(const FastFunction& f, int sign, const Instant& root, double& since);
  bool holds_back(const FastFunction& f, const SignedFunction& function, double& t);
  bool holds_in_doubles(const SignedFunction& function, const Instant& until, bool own, Instant& rest);
  bool holds_precisely(const SignedFunction& function, const Instant& until, bool own);
  int sign_at(const CertificateFunction& function, const Instant& now);

  const PairGeometry& geometry_;
  TaylorModelCache clock_;
};

}  // namespace taut::internal::proof
