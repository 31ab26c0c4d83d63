// Polygons as rough as coastlines, by midpoint displacement.
#pragma once

#include <cstddef>
#include <cstdint>

#include "taut/scene.hpp"

namespace taut::bench {

/// `outline` (counterclockwise, no interior angle and no gap so narrow that triangles of 40 degrees on either side of
/// its edges meet) roughened to `vertices` vertices. Simple by construction; the same for the same arguments.
Polygon coastline(const Polygon& outline, std::size_t vertices, std::uint64_t seed);

/// An island of diameter about 2 around the origin.
Polygon island(std::size_t vertices, std::uint64_t seed);

/// A bay and a headland that reaches far into it, `vertices` in all. The headland moves out slowly.
Scene bay(std::size_t vertices);

}  // namespace taut::bench
