// When a corner fails, and that it keeps its sign until then.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "certificate/fast_function.hpp"
#include "certificate/frame_range.hpp"
#include "certificate/instant.hpp"
#include "motion/motion_segments.hpp"
#include "motion/taylor_model_cache.hpp"
#include "numeric/budget.hpp"
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

// Corners that need no test on every segment: those that keep their sign wherever the motion goes for many segments.

/// Half-edges, any of which can be taken away at once. Their order is that of the log.
class HalfedgeList {
 public:
  void resize(std::size_t halfedges) { place_.resize(halfedges, nowhere); }
  std::size_t size() const { return list_.size(); }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }
  bool has(HalfedgeId h) const { return place_[h.value] != nowhere; }
  void add(HalfedgeId h) {
    if (has(h)) return;
    place_[h.value] = static_cast<std::uint32_t>(list_.size());
    list_.push_back(h);
  }
  void remove(HalfedgeId h) {
    if (!has(h)) return;
    const std::uint32_t place = place_[h.value];
    const HalfedgeId last = list_.back();
    list_[place] = last;
    place_[last.value] = place;
    list_.pop_back();
    place_[h.value] = nowhere;
  }
  void clear() {
    for (const HalfedgeId h : list_) place_[h.value] = nowhere;
    list_.clear();
  }

 private:
  static constexpr std::uint32_t nowhere = 0xffffffffu;
  std::vector<HalfedgeId> list_;
  std::vector<std::uint32_t> place_;  ///< by half-edge
};

/// Some segments, and where the motion is on them. Many segments and many corners are then not tested in all pairs.
class StretchOfSegments {
 public:
  explicit StretchOfSegments(const PairGeometry& geometry) : geometry_(geometry) {}

  /// True if a new stretch begins with this segment: then all corners are to be asked about anew.
  bool enter(const MotionSegments& segments, std::size_t segment, std::size_t corners) {
    if (segment < end_) return false;
    range_.reset();
    end_ = segment + 1;
    if (corners < few_corners) return true;
    // So many that the new test of all corners costs each segment a few of them.
    length_ = std::clamp<std::size_t>(length_, 1, corners / 8);
    end_ = std::min(segment + length_, segments.size());
    range_ = range_of(segments[segment]);
    for (std::size_t k = segment + 1; k < end_; ++k) {
      checkpoint();
      range_->include(range_of(segments[k]));
    }
    return true;
  }

  /// Does the corner certainly have this sign at all times of the stretch?
  bool decides(VertexId u, VertexId v, VertexId w, int sign) const {
    checkpoint();
    return range_ && range_->keeps_sign(geometry_, CertificateFunction::of(geometry_, u, v, w), sign);
  }

  /// What came of it: a motion that goes far is better divided into short stretches.
  void judge(std::size_t open, std::size_t corners) { length_ = 2 * open > corners ? length_ / 4 : 2 * length_; }

 private:
  static constexpr std::size_t few_corners = 64, first_length = 16;
  static FrameRange range_of(const MotionSegment& segment) {
    return FrameRange::over(segment, segment.start, segment.end);
  }

  const PairGeometry& geometry_;
  std::size_t end_ = 0;  ///< the first segment that is not part of it
  std::size_t length_ = first_length;
  std::optional<FrameRange> range_;
};

}  // namespace taut::internal::proof
