// Worlds as they were made up, with poses and overlaps by definition: arithmetic that shares nothing with the library.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <string>
#include <vector>

#include "support/rng.hpp"
#include "taut/motions.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

using Complex = std::complex<double>;

/// A body as it was made up: what the scene is written from, and what poses are computed from.
struct MadeBody {
  std::string name;
  std::vector<Part> parts;
  std::vector<Keyframe> keyframes;  ///< empty: at rest
  Point pivot;
  int parent = -1;
  Layers z = {};  ///< of the parts that have none of their own
};

using Transform = Point (*)(const Point&);
/// What is done to points and to ways alike, and moved; `mirrors` turns angles round.
MadeBody transformed(MadeBody body, Transform change, bool mirrors, const Point& by = {});

struct MadeWorld {
  double end = 4;
  std::vector<MadeBody> bodies;
  std::vector<std::array<int, 2>> ignore;  ///< -1 is every other body
};

/// As the library takes it.
Scene scene_of(const MadeWorld& world);

/// z is at o + x z.
struct MadePose {
  Complex o = 0, x = 1;
  Complex at(const Point& p) const { return o + x * Complex(p.x, p.y); }
};
MadePose pose_of(const MadeWorld& world, int body, double t);

using RingAtPose = std::vector<Complex>;
struct PartAtPose {
  std::vector<RingAtPose> rings;  ///< outline, then holes
  Layers z;
};
using BodyAtPose = std::vector<PartAtPose>;
BodyAtPose posed(const MadeWorld& world, int body, double t);

/// How far a point is from a segment.
double to_segment(const Complex& p, const Complex& a, const Complex& b);
/// By more than rounding, in parts that share a layer.
bool overlap_clearly(const BodyAtPose& p, const BodyAtPose& q, double margin);
/// Of the boundaries of parts that share a layer; not 0 where they cross.
double between_rings(const BodyAtPose& p, const BodyAtPose& q);

/// A random multiple of 1/16.
double sixteenths(Rng& rng, double lo, double hi);
/// A star around the centre, of at most that radius; with a hole where `hole` is its share of the radius.
Part star_part(Rng& rng, const Point& centre, double radius, double hole);
std::vector<Keyframe> random_keyframes(Rng& rng, double end, double reach, const Point& at);
/// A body that turns, or one that turns on another one; the last one is meant.
MadeWorld random_way(Rng& rng);
/// 2 to 12 bodies in cells of 4 by 4; some have another one in a hole.
MadeWorld random_world(std::uint64_t seed);

}  // namespace taut::testing
