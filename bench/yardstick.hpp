// What the certified engines are measured against: the strongest simple search for the first contact in plain doubles.
#pragma once

#include "taut/scene.hpp"

namespace taut::bench {

struct YardstickAnswer {
  bool contact = false;
  double time = 0;
};

/// The first contact of two bodies that are apart at the start. Nothing is certified: rounding may hide a contact or
/// invent one. Bodies move along polynomials and turn by an angle; other forms of rotation throw
/// std::invalid_argument. Joints between pieces are taken as exact.
YardstickAnswer yardstick(const Scene& scene);

}  // namespace taut::bench
