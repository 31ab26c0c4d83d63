// What every form of rotation has to tell of itself. A program with a new form in Rotation does not compile before it
// is answered for here, in rotation_jet() (pose.hpp), in validate_motion.cpp, in the fingerprint, and where scenes are
// read and written.
#pragma once

#include "base/overloaded.hpp"
#include "taut/motion.hpp"

namespace taut {

/// Calls visit(coefficients) for each polynomial of a rotation.
template <class Visit>
void for_each_polynomial(Rotation& rotation, const Visit& visit) {
  std::visit(Overloaded{[](NoRotation&) {}, [&](AngleRotation& r) { visit(r.angle); },
                        [&](DirectionRotation& r) {
                          visit(r.a);
                          visit(r.b);
                        },
                        [&](HalfAngleRotation& r) { visit(r.s); }, [&](CosineRotation& r) { visit(r.a); }},
             rotation);
}

/// Are the two given by the very same coefficients?
bool same_rotation(const Rotation& a, const Rotation& b);

}  // namespace taut
