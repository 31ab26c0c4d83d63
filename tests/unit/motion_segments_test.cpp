// Segments are made when they are asked for: the same as if all were there; and pieces are kept in little memory.
#include <gtest/gtest.h>

#include <vector>

#include "motion/far_pieces.hpp"
#include "motion/local_time.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "support/effort.hpp"
#include "support/rng.hpp"

namespace taut::testing {
using namespace internal;
namespace {

Coefficients coefficients(Rng& rng) {
  Coefficients c;
  for (int k = rng.below(4); k > 0; --k) c.push_back(rng.chance(0.2) ? 0 : rng.real(-3, 3));
  if (!c.empty() && c.back() == 0) c.back() = 1;
  return c;
}

MotionPiece piece_of_any_form(Rng& rng) {
  MotionPiece piece;
  piece.x = coefficients(rng);
  piece.y = coefficients(rng);
  switch (rng.below(5)) {
    case 0:
      piece.rotation = AngleRotation{coefficients(rng)};
      break;
    case 1:
      piece.rotation = DirectionRotation{{4, rng.real(-1, 1)}, coefficients(rng)};
      break;
    case 2:
      piece.rotation = HalfAngleRotation{coefficients(rng)};
      break;
    case 3:
      piece.rotation = CosineRotation{{rng.real(-0.9, 0.9)}};
      break;
    default:
      break;
  }
  if (rng.chance(0.3)) piece.pivot = {rng.real(-2, 2), 0};
  if (rng.chance(0.3)) piece.origin = rng.chance(0.5) ? 1 : rng.real(-1, 1);
  if (rng.chance(0.2)) piece.orbit = {{rng.real(-2, 2), rng.real(-2, 2)}, {0, rng.real(0.5, 1)}};
  return piece;
}

Motion motion_of_any_forms(Rng& rng, int most) {
  Motion motion;
  double t = rng.real(-1, 1);
  for (int k = rng.between(1, most); k > 0; --k) {
    motion.pieces.push_back(!motion.pieces.empty() && rng.chance(0.1) ? motion.pieces.back() : piece_of_any_form(rng));
    motion.pieces.back().until = t += rng.chance(0.3) ? 1 : rng.real(0.1, 1);
  }
  motion.pieces.back().until = INFINITY;
  return motion;
}

void expect_same(const MotionPiece& a, const MotionPiece& b) {
  EXPECT_TRUE(same_motion(a, b));
  EXPECT_EQ(a.until, b.until);
  EXPECT_EQ(a.pivot, b.pivot);
  EXPECT_EQ(a.rotation.index(), b.rotation.index());
}

TEST(PieceList, GivesBackWhatItWasMadeOf) {
  Rng rng(81);
  for (std::uint64_t i = 0; i < effort(300); ++i) {
    const Motion motion = motion_of_any_forms(rng, 8);
    const double start = rng.real(-2, 3), end = start + rng.real(0, 4);
    std::vector<MotionPiece> pieces = pieces_between(motion, start, end);
    const PieceList list = PieceList::between(motion, start, end, 3);
    ASSERT_EQ(list.size(), pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      expect_same(list[k], scaled(pieces[k], 3));
      EXPECT_EQ(list.until(k), pieces[k].until);
    }
    for (int k = 0; k < 5; ++k) {
      const double t = rng.chance(0.3) ? pieces[0].until : rng.real(start, end);
      expect_same(list.at(t), scaled(piece_at(pieces, t), 3));
    }
    EXPECT_TRUE(same_pieces(list, PieceList::between(motion, start, end, 3)));
  }
}

TEST(PieceList, SeesRestAndDifferences) {
  EXPECT_TRUE(PieceList::between({}, 0, 1).rests());
  MotionPiece moved;
  moved.x = {1};
  const PieceList list({moved});
  EXPECT_FALSE(list.rests());
  EXPECT_FALSE(same_pieces(list, PieceList({MotionPiece{}})));
  const PieceList both = list.after(MotionPiece{}, 2);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both.until(0), 2);
  EXPECT_TRUE(same_motion(both.at(1), MotionPiece{}));
  EXPECT_TRUE(same_motion(both.at(2), moved));
}

/// All of them at once, in the plain way.
std::vector<MotionSegment> all_segments(const std::vector<MotionPiece>& p, const std::vector<MotionPiece>& q,
                                        double start, double end) {
  std::vector<MotionSegment> segments;
  std::size_t i = 0, j = 0;
  while (p[i].until <= start) ++i;
  while (q[j].until <= start) ++j;
  for (double t = start;;) {
    const double until = std::min({p[i].until, q[j].until, end});
    segments.push_back(MotionSegment::motion(p[i], q[j], t, until));
    if (until >= end) return segments;
    t = until;
    const std::size_t old_i = i, old_j = j;
    while (p[i].until <= t) ++i;
    while (q[j].until <= t) ++j;
    if (same_motion(p[old_i], p[i]) && same_motion(q[old_j], q[j])) continue;
    const double before = segments.back().start, after = std::min({p[i].until, q[j].until, end});
    const bool far = is_far_for(p[old_i], before, t) || is_far_for(q[old_j], before, t) || is_far_for(p[i], t, after) ||
                     is_far_for(q[j], t, after);
    segments.push_back(MotionSegment::bridging(p[old_i], q[old_j], p[i], q[j], t, far));
  }
}

void expect_same(const MotionSegment& a, const MotionSegment& b) {
  EXPECT_EQ(a.bridge, b.bridge);
  EXPECT_EQ(a.joint, b.joint);
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.far(), b.far());
  EXPECT_EQ(a.composed, b.composed);
  const double t = a.start + (a.end - a.start) / 3;
  const Frame<double> f = frame(a, Ball<double>::exact(t)), g = frame(b, Ball<double>::exact(t));
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(f.for_pp[k].v.mid, g.for_pp[k].v.mid);
    EXPECT_EQ(f.for_qq[k].d.mid, g.for_qq[k].d.mid);
    EXPECT_EQ(f.for_qq[k].v.rad, g.for_qq[k].v.rad);
  }
}

TEST(MotionSegments, AreThoseThatAreMadeAtOnce) {
  Rng rng(82);
  for (std::uint64_t i = 0; i < effort(200); ++i) {
    const Motion p = motion_of_any_forms(rng, 12), q = motion_of_any_forms(rng, 12);
    const double start = rng.real(-1, 1), end = start + rng.real(0, 8);
    const std::vector<MotionSegment> all =
        all_segments(pieces_between(p, start, end), pieces_between(q, start, end), start, end);
    const MotionSegments segments =
        make_segments(PieceList::between(p, start, end), PieceList::between(q, start, end), start, end);
    ASSERT_EQ(segments.size(), all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      expect_same(segments[k], all[k]);
      EXPECT_EQ(segments.place(k).bridge, all[k].bridge);
      EXPECT_EQ(segments.place(k).start, all[k].time(all[k].start));
      EXPECT_EQ(segments.place(k).end, all[k].time(all[k].end));
    }
    for (int k = 0; k < 20; ++k) {
      const auto any = static_cast<std::size_t>(rng.below(static_cast<int>(all.size())));
      expect_same(segments[any], all[any]);
    }
    for (const double t : {start, end, rng.real(start, end), start - 1, end + 1}) {
      std::size_t first = 0;
      while (first < all.size() && all[first].time(all[first].end) < t) ++first;
      EXPECT_EQ(segments.first_until(t), first);
    }
  }
}

MotionSegments keyframes(int count) {
  Motion motion;
  for (int k = 0; k < count; ++k) {
    MotionPiece piece;
    piece.x = {static_cast<double>(k % 2)};
    piece.until = k + 1;
    motion.pieces.push_back(piece);
  }
  return make_segments(PieceList::between({}, 0, count), PieceList::between(motion, 0, count), 0, count);
}

/// Whoever holds a segment has the one that others are given, however many there have been between.
TEST(MotionSegments, AreTheSameWhileHeld) {
  const MotionSegments segments = keyframes(1000);
  ASSERT_EQ(segments.size(), 1999u);
  const std::shared_ptr<const MotionSegment> held = segments.hold(7);
  std::weak_ptr<const MotionSegment> dropped = segments.hold(8);
  for (std::size_t k = 0; k < segments.size(); ++k) segments[k];
  EXPECT_EQ(held->joint, 4);
  EXPECT_EQ(segments.hold(7), held);
  EXPECT_TRUE(dropped.expired());
  const MotionSegments copy = segments;
  EXPECT_EQ(copy.hold(7), held);
}

TEST(MotionSegments, CanLoseTheFirstOne) {
  MotionSegments segments = keyframes(30);
  const double end = segments[20].end;
  segments.drop_first();
  EXPECT_EQ(segments.size(), 58u);
  EXPECT_TRUE(segments.front().bridge);
  EXPECT_EQ(segments[19].end, end);
  EXPECT_EQ(segments.place(0).end, 1);
  EXPECT_EQ(segments.first_until(1), 0u);
}

TEST(MotionSegments, ExchangedHaveTheOtherRoles) {
  MotionSegments segments = keyframes(3);
  segments.drop_first();
  const MotionSegments exchanged = segments.exchanged();
  ASSERT_EQ(exchanged.size(), segments.size());
  for (std::size_t k = 0; k < segments.size(); ++k) {
    EXPECT_EQ(exchanged[k].bridge, segments[k].bridge);
    EXPECT_EQ(exchanged.place(k).end, segments.place(k).end);
    EXPECT_TRUE(same_motion(exchanged[k].p, segments[k].q));
    EXPECT_TRUE(same_motion(exchanged[k].q, segments[k].p));
  }
}

}  // namespace
}  // namespace taut::testing
