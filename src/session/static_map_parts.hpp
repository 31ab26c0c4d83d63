// The data of maps and movers, for the queries that use them.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "geometry/prepared_shape.hpp"
#include "solver/map_search.hpp"
#include "taut/map_query.hpp"
#include "taut/static_map.hpp"

namespace taut {

using namespace internal;

struct StaticMap::Impl {
  std::vector<Body> bodies;
  double largest = 0;  ///< the largest magnitude that a coordinate of a shape may have
  ShapeFacts range;    ///< of magnitudes
  MapBodies prepared;
};

struct StaticMap::Mover::Impl {
  std::string name;
  SharedRings rings;
  Layers z;
  AxisBox bounds;  ///< in the user's units
  double extent = 0;
  const void* map = nullptr;
};

}  // namespace taut

namespace taut::internal {

// Poses at which a robot was found to be free.

/// Poses of a robot of one body that were found free: planners query many paths from one place. Of the poses with the
/// same hash, the last one is kept.
class FreePoses {
 public:
  bool has(const PoseSE2& pose) const {
    if (poses_.empty()) return false;
    const PoseSE2& kept = poses_[slot(pose)];
    return kept.x == pose.x && kept.y == pose.y && kept.angle == pose.angle;
  }
  void add(const PoseSE2& pose) {
    if (poses_.empty()) poses_.assign(slots, {NAN, NAN, NAN});
    poses_[slot(pose)] = pose;
  }

 private:
  static constexpr std::size_t slots = 4096;
  static std::size_t slot(const PoseSE2& pose) {
    // Not every standard library that taut is compiled with has std::bit_cast.
    const auto bits = [](double x) {
      std::uint64_t b = 0;
      std::memcpy(&b, &x, sizeof b);
      return b;
    };
    std::uint64_t h = bits(pose.x) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 29) ^ bits(pose.y)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 32) ^ bits(pose.angle)) * 0x94d049bb133111ebu;
    return static_cast<std::size_t>(h >> 52);
  }
  std::vector<PoseSE2> poses_;
};

}  // namespace taut::internal
