// Worlds in motion: gases of polygons, simulated and recorded.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "taut/scene.hpp"

namespace taut::paper {

/// What taut counted while a gas was simulated.
struct SimulatedGas {
  std::uint64_t contacts = 0, events = 0, certificates_max = 0;
  double certificates_mean = 0;  ///< over all contacts
  double seconds = 0;            ///< from the start to the last contact, what the bodies answer included
  std::optional<Scene> record;   ///< free of contacts: every motion gives way to the next one right before it
};

/// The shape of the bodies, of radius 1: "hexagons", "stars" of 16 vertices, "gears" of 20 teeth, or "N-gons".
Polygon gas_shape(const std::string& family);

/// A gas of so many elastic bodies of this shape that fill `fraction` of their box, until there were `contacts`
/// contacts. With `record`, all motions are kept. `at_contact`, if there is one, is called at every 64th.
SimulatedGas simulated_gas(const Polygon& shape, int bodies, double fraction, std::uint64_t contacts, bool record,
                           const std::function<void()>& at_contact = {});

}  // namespace taut::paper
