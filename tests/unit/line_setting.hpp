// Triples of vertices on straight ways.
#pragma once

#include "certificate/precise_function.hpp"
#include "motion/motion_segment.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "scene/body_pair.hpp"
#include "support/random_scenes.hpp"

namespace taut::testing {
using namespace internal;

/// A pair on a straight way, and a triple of its vertices.
struct LineSetting {
  PairGeometry geometry;
  MotionSegment segment;

  static LineSetting of(std::uint64_t seed, bool grid) {
    SceneOptions options;
    options.grid = grid;
    options.kinds = {MotionKind::rest, MotionKind::linear};
    const Scene scene = random_scene(seed, all_families[seed % std::size(all_families)], options);
    const BodyPair bodies = pair_of(scene);
    LineSetting s;
    s.geometry = displaced_pair(bodies, seed % 2 == 0 ? Offset::inward : Offset::outward);
    for (const MotionSegment& segment : segments_of(bodies, scene.start, scene.end)) {
      if (!segment.bridge) s.segment = segment;
    }
    return s;
  }
  CertificateFunction triple(Rng& rng) const {
    for (;;) {
      const auto any = [&] { return VertexId(static_cast<std::uint32_t>(rng.below(geometry.size()))); };
      const VertexId u = any(), v = any(), w = any();
      const bool mixed = !(geometry.same_body(u, v) && geometry.same_body(v, w));
      if (mixed && u != v && v != w && u != w) return CertificateFunction::of(geometry, u, v, w);
    }
  }
};

inline Measure any_measure(Rng& rng) { return rng.below(2) ? Measure::orientation : Measure::projection; }

}  // namespace taut::testing
