// Checks a tree of separations: that two bodies' boundaries do not meet over a stretch of a segment.
#pragma once

#include <unordered_map>

#include "proof/bytes.hpp"
#include "proof/separation.hpp"

namespace taut::internal::proof {

/// A stretch of a segment's parameter that came of halving a longer one; the number identifies it.
struct HalvedTime {
  double from, to;
  std::uint64_t number = 1;

  static constexpr std::uint64_t deepest = std::uint64_t{1} << 62;
  double middle() const { return from + (to - from) / 2; }
  bool divisible() const { return number < deepest && from < middle() && middle() < to; }
  HalvedTime first() const { return {from, middle(), 2 * number}; }
  HalvedTime second() const { return {middle(), to, 2 * number + 1}; }
};

/// The windows of one stretch and its halves, each made once. Where a model of the motion leaves out no more than
/// rounding does, all halves of its window are seen by it: to make one costs as much as to see a hundred. Which model
/// that is, and so the window, depends on the stretch alone, and not on what was asked for before: who writes a log
/// evaluates more windows than its checker.
class HalvedWindows {
 public:
  explicit HalvedWindows(const MotionSegment& segment) : segment_(segment) {}
  void begin(double from, double to) { whole_ = {from, to}; }
  /// Valid until the next call.
  const MotionWindow& at(const HalvedTime& time);
  /// Does that window come of the model of a longer one?
  bool has_model_above(const HalvedTime& time) { return !segment_.bridge && sharp_model_above(time) != nullptr; }

 private:
  MotionWindow made(const HalvedTime& time);
  const FrameModel* sharp_model_above(const HalvedTime& time);
  const FrameModel* sharp_model_over(const HalvedTime& time);

  /// So many are kept.
  static constexpr std::size_t most = 1 << 14, most_models = 1 << 9;
  const MotionSegment& segment_;
  HalvedTime whole_{0, 0};
  std::unordered_map<std::uint64_t, MotionWindow> windows_;
  std::unordered_map<std::uint64_t, std::optional<FrameModel>> models_;  ///< nothing where it was not sharp
};

/// Does the vertex stay off the edge all over that stretch, for one of the first four reasons? As far as the
/// motion's second order shows, over the stretch or over parts of it, which are halved a few times at most: not where
/// a contact is in the stretch, which is between two doubles.
SeparationInWindow stays_separated_in_windows(const PairGeometry& geometry, const Incidence& incidence,
                                              SeparationReason why, HalvedWindows& windows, const HalvedTime& time,
                                              const Instant& end);

/// One pair on one stretch of one segment. The log has a tree of steps, in preorder: time is halved, or one of the
/// ranges, until what is left is apart; with a margin that is not 0, farther apart than that, and `until` is none then.
/// Throws ProofError where it is not as the log says.
class ApartChecker {
 public:
  /// `lifetimes` is on that segment. What comes after `until` does not matter.
  ApartChecker(const RangedPair& pair, Lifetimes& lifetimes, const std::optional<Instant>& until, ByteReader& in,
               double margin = 0)
      : pair_(pair), lifetimes_(lifetimes), until_(until), in_(in), margin_(margin), windows_(lifetimes.segment()) {}

  void check(double from, double to) {
    windows_.begin(from, to);
    visit({}, {from, to});
  }
  /// How many pairs of ranges, or of edges, were shown to be apart.
  std::uint64_t separations() const { return separations_; }

 private:
  void visit(const RangePair& ranges, const HalvedTime& time);
  void check_ends(const RangePair& ranges, const HalvedTime& time);
  void check_margin(const RangePair& ranges, std::uint8_t why, const HalvedTime& time);
  void check_incidence(const Incidence& incidence, int why, const HalvedTime& time);

  const RangedPair& pair_;
  Lifetimes& lifetimes_;
  const std::optional<Instant>& until_;
  ByteReader& in_;
  double margin_;
  HalvedWindows windows_;
  std::uint64_t separations_ = 0;
};

/// The end of the stretch, or `until` if that is before.
Instant end_of(const HalvedTime& time, const std::optional<Instant>& until);

}  // namespace taut::internal::proof
