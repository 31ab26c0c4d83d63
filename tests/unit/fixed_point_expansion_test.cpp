// Forms about an instant, in numbers of a fixed length: against the same functions in 960 bits.
#include "certificate/fixed_point_expansion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "certificate/precise_triple.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "scene/body_pair.hpp"
#include "support/effort.hpp"
#include "support/random_scenes.hpp"
#include "support/tiling_run.hpp"
#include "taut/io.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// A pair on a curved way or turning, on a grid by turns, so that much coincides.
struct CurvedSetting {
  PairGeometry geometry;
  std::vector<MotionSegment> segments;

  static CurvedSetting of(std::uint64_t seed) {
    SceneOptions options;
    options.grid = seed % 3 != 0;
    const Scene scene = random_scene(seed, all_families[seed % std::size(all_families)], options);
    const BodyPair bodies = pair_of(scene);
    CurvedSetting s;
    s.geometry = displaced_pair(bodies, seed % 2 == 0 ? Offset::inward : Offset::outward);
    for (const MotionSegment& segment : segments_of(bodies, scene.start, scene.end)) {
      if (!segment.bridge && !(segment.translation && segment.degree <= 1)) s.segments.push_back(segment);
    }
    return s;
  }
  CertificateFunction function(Rng& rng) const {
    for (;;) {
      const auto any = [&] { return VertexId(static_cast<std::uint32_t>(rng.below(geometry.size()))); };
      const VertexId u = any(), v = any(), w = any();
      const bool mixed = !(geometry.same_body(u, v) && geometry.same_body(v, w));
      if (mixed && u != v && v != w && u != w) return CertificateFunction::of(geometry, u, v, w);
    }
  }
};

TEST(FixedPointExpansion, SignsAndRootsAreThoseOf960Bits) {
  Rng rng(21);
  std::uint64_t signs = 0, roots = 0, unknown = 0;
  for (std::uint64_t seed = 0; seed < effort(500); ++seed) {
    const CurvedSetting s = CurvedSetting::of(seed);
    for (const MotionSegment& segment : s.segments) {
      FrameExpansionCache frames;
      frames.reset(segment);
      for (int k = 0; k < 6; ++k) {
        const CertificateFunction function = s.function(rng);
        const PreciseTriple precise(segment, s.geometry, function);
        const PreciseFunction<Real960> f(segment, s.geometry, function);
        const int sign = f.value(Ball<Real960>::exact(segment.start)).sign();
        std::optional<PreciseTime> failure;
        try {
          if (sign != 0)
            failure = precise.first_failure(sign, PreciseTime::between(segment.start, segment.start), segment.end);
        } catch (const Undecidable&) {
        }
        if (!failure || !(failure->ceiling() < segment.end)) continue;
        const FrameExpansion* const frame = frames.around(failure->floor(), failure->ceiling());
        if (!frame) continue;
        const FixedPointExpansion tie(*frame, segment, s.geometry, function);
        // An instant of some doubles nearby.
        const ShortSum at(Fixed(frame->about) + Fixed(rng.real(-1, 1) * frame->reach * 0.4) +
                          Fixed(rng.unit() * 0x1p-150));
        const int found = tie.sign_over(PreciseTime(at, at, Stage::precise));
        if (found != 0) {
          ++signs;
          EXPECT_EQ(found, f.value(Ball<Real960>(Real960(at.real()), 0.0)).sign()) << "seed " << seed;
        }
        const auto root = tie.root(sign, Stage::precise, 0);
        if (!root) {
          ++unknown;
          continue;
        }
        ++roots;
        PreciseTime deep = *failure;
        if (!precise.refine(sign, deep, last_stage)) continue;
        EXPECT_FALSE(root->certainly_before(deep)) << "seed " << seed;
        EXPECT_FALSE(deep.certainly_before(*root)) << "seed " << seed;
        EXPECT_LE(root->width_of_sums(), 0x1p-180);
      }
    }
  }
  EXPECT_GT(signs, effort(300));
  EXPECT_GT(roots, effort(300));
  EXPECT_LT(unknown, roots / 4);
}

/// A square with its lower corners on y = height rides on a parabola whose lowest point is at the time 1/4, over one
/// with its upper edge on y = 0.
Scene riding(double height) {
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"floor", {{-4, -1}, {4, -1}, {4, 0}, {-4, 0}}, {}}, {"rider", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};
  MotionPiece piece;
  piece.x = {0.25};
  piece.y = {height + 0.0625, -0.5, 1};
  scene.bodies[1].motion = Motion{{piece}};
  return scene;
}

/// Two cams that extremum past each other within such a time.
StageCounts stages_of_cams(double time) {
  Scene scene = taut::read_scene(std::string("tests/corpus/symmetric_cams.json"));
  scene.end *= time;
  for (Body& body : scene.bodies) {
    for (MotionPiece& piece : body.motion.pieces) {
      piece.until *= time;
      if (auto* turns = std::get_if<AngleRotation>(&piece.rotation)) turns->angle[1] /= time;
    }
  }
  TilingRun run(scene);
  while (!run.finished()) run.step(scene.end);
  return run.engine().stages();
}

/// Frames about ties count time in units of their own.
TEST(FixedPointExpansion, FastMotionsAndSlowOnesAreToldByTheSameStages) {
  const StageCounts once = stages_of_cams(1);
  EXPECT_GT(once[Stage::fixed], 0u);
  for (const double time : {0x1p-30, 0x1p-10, 0x1p10, 0x1p25}) {
    EXPECT_EQ(stages_of_cams(time)[Stage::fixed], once[Stage::fixed]) << time;
    EXPECT_EQ(stages_of_cams(time)[Stage::precise], once[Stage::precise]) << time;
  }
}

TEST(FixedPointExpansion, TurnsTellWhetherZeroIsReached) {
  int reached = 0, missed = 0;
  for (const double height : {0.0, 0x1p-56, -0x1p-56, 0x1p-50, -0x1p-50}) {
    for (const Offset offset : {Offset::inward, Offset::outward}) {
      const Scene scene = riding(height);
      const BodyPair bodies = pair_of(scene);
      const PairGeometry geometry = displaced_pair(bodies, opposite(offset));
      const MotionSegment segment = segments_of(bodies, scene.start, scene.end).front();
      FrameExpansionCache frames;
      frames.reset(segment);
      const FrameExpansion* const frame = frames.around(0.25 + 1e-12, 0.25 + 1e-12);
      ASSERT_TRUE(frame);
      for (std::uint32_t u = 0; u < geometry.size(); ++u) {
        for (std::uint32_t v = 0; v < geometry.size(); ++v) {
          const VertexId a(u), b = geometry.next(a), c(v);
          if (geometry.same_body(a, c)) continue;
          const CertificateFunction function{a, b, c, geometry.in_p(a)};
          const FixedPointExpansion tie(*frame, segment, geometry, function);
          const auto extremum = tie.extremum();
          if (!extremum) continue;
          const PreciseFunction<Real960> f(segment, geometry, function);
          const RealMax at = RealMax(frame->about) + RealMax(frame->reach) * ShortSum(extremum->at).real();
          EXPECT_EQ(f.value(Ball<Real960>(at, 0.0)).sign(), extremum->value_sign);
          if (extremum->value_sign == extremum->second_sign) {
            ++missed;
            continue;
          }
          if (!(extremum->half_gap < 0.25)) continue;
          ++reached;
          for (const int side : {-1, 1}) {
            const auto root = tie.root_near(*extremum, side, Stage::precise);
            ASSERT_TRUE(root);
            const int before = f.value(Ball<Real960>(root->lo(), 0.0)).sign();
            const int after = f.value(Ball<Real960>(root->hi(), 0.0)).sign();
            EXPECT_EQ(before, side < 0 ? extremum->second_sign : extremum->value_sign);
            EXPECT_EQ(after, side < 0 ? extremum->value_sign : extremum->second_sign);
            // The same to all digits there are: Newton's steps go on from where the extremum has it.
            const auto sharp = tie.root(before, Stage::precise, 0);
            ASSERT_TRUE(sharp);
            EXPECT_TRUE(root->lo() < sharp->lo() && sharp->hi() < root->hi());
            EXPECT_EQ(f.value(Ball<Real960>(sharp->lo(), 0.0)).sign(), before);
            EXPECT_EQ(f.value(Ball<Real960>(sharp->hi(), 0.0)).sign(), after);
            EXPECT_LT(sharp->width_of_sums(), 0x1p-80 * root->width_of_sums());
          }
        }
      }
    }
  }
  EXPECT_GT(reached, 0);
  EXPECT_GT(missed, 0);
}

}  // namespace
}  // namespace taut::testing
