// Random scenes for property tests: two disjoint simple polygons, random motions of every form, time [0, 1].
#pragma once

#include <cstdint>
#include <vector>

#include "support/random_polygons.hpp"
#include "support/rng.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

enum class MotionKind : std::uint8_t {
  rest,
  linear,      ///< translation with constant velocity
  polynomial,  ///< translation of degree 2 to 5
  angle,       ///< from here on: a rotation of this form, with a translation
  direction,
  half_angle,
  cosine,
  orbit,   ///< a rotation of any form around a distant pivot
  pieces,  ///< 2 to 4 pieces that join exactly
};

inline constexpr MotionKind all_motions[] = {MotionKind::rest,   MotionKind::linear,    MotionKind::polynomial,
                                             MotionKind::angle,  MotionKind::direction, MotionKind::half_angle,
                                             MotionKind::cosine, MotionKind::orbit,     MotionKind::pieces};

const char* to_string(MotionKind kind);

/// What a random motion is to be like. At time 0 it turns a body by `quarter_turns` and moves its origin to `pivot`.
struct Drive {
  MotionKind kind = MotionKind::linear;
  double reach = 1;       ///< length of the way
  double turn = 1;        ///< radians turned in [0, 1], about
  Point heading;          ///< unit vector of the way; (0, 0): anywhere
  Point pivot;            ///< integers
  int quarter_turns = 0;  ///< 0 to 3; not every form can begin with every one, see start_turns()
};

/// The quarter turns with which a motion of this kind can begin exactly.
std::vector<int> start_turns(MotionKind kind);

/// A random motion over [0, 1]. Every coefficient is a double; where pieces join, the two poses are exactly equal.
Motion random_motion(Rng& rng, const Drive& drive);
/// The same from the identity, with a way of about `scale`.
Motion random_motion(Rng& rng, double scale, MotionKind kind);

/// A body that is at `polygon` at time 0, exactly: its own coordinates are the polygon turned back, around the pivot.
Body animate(Rng& rng, const char* name, const Polygon& polygon, const Drive& drive);

struct SceneOptions {
  bool grid = false;              ///< vertices on a coarse grid, often moving along it: degeneracies abound
  std::vector<MotionKind> kinds;  ///< the motions to choose from; empty: all
};

/// The scene of a seed. Some collide, some do not; the bodies are disjoint at the start.
Scene random_scene(std::uint64_t seed, Family family, const SceneOptions& options = {});

}  // namespace taut::testing
