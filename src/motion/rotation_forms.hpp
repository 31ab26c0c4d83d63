// What every form of rotation has to define. A program with a new form in Rotation does not compile before it
// is answered for here, in rotation_jet() (pose.hpp), in pieces.cpp and where scenes are
// read and written.
#pragma once

#include <utility>

#include "numeric/overloaded.hpp"
#include "taut/motion.hpp"

namespace taut::internal {

/// Calls visit(coefficients) for each polynomial of a rotation.
template <class Visit>
void for_each_polynomial(const Rotation& rotation, const Visit& visit) {
  std::visit(Overloaded{[](const NoRotation&) {}, [&](const AngleRotation& r) { visit(r.angle); },
                        [&](const DirectionRotation& r) {
                          visit(r.a);
                          visit(r.b);
                        },
                        [&](const HalfAngleRotation& r) { visit(r.s); }, [&](const CosineRotation& r) { visit(r.a); },
                        [](const JointFollower&) {}},
             rotation);
}
template <class Visit>
void for_each_polynomial(Rotation& rotation, const Visit& visit) {
  for_each_polynomial(std::as_const(rotation), [&](const Coefficients& c) { visit(const_cast<Coefficients&>(c)); });
}

/// The joint that the piece's body follows; null if it follows none.
inline const JointFollower* followed_joint(const MotionPiece& piece) {
  return std::get_if<JointFollower>(&piece.rotation);
}

/// Does it change with time, as far as its polynomials show?
bool varies(const Rotation& rotation);

/// Are the two given by the very same coefficients?
bool same_rotation(const Rotation& a, const Rotation& b);

}  // namespace taut::internal
