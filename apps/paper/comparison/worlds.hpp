// Worlds in motion: gases of polygons, as simulations recorded them.
#pragma once

#include <cstdint>

#include "taut/scene.hpp"

namespace taut::paper {

/// A gas of elastic bodies, and what taut counted while it was simulated.
struct RecordedGas {
  Scene scene;  ///< free of contacts: every motion gives way to the next one right before it
  std::uint64_t contacts = 0, events = 0, certificates_start = 0, certificates_max = 0;
  double seconds = 0;  ///< from the start to the last contact, without what the bodies answer
};

/// The shape of the bodies: "hexagons", "stars" of 16 vertices, or "gears" of 20 teeth, of radius 1.
Polygon gas_shape(const std::string& family);

/// A gas of so many bodies of this shape that fill `fraction` of their box, until there were `contacts` contacts.
RecordedGas recorded_gas(const Polygon& shape, int bodies, double fraction, std::uint64_t contacts);

}  // namespace taut::paper
