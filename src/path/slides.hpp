// How joints displace bodies that only translate: exactly, as a linear map of the joint values.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "path/exact_point.hpp"
#include "path/joint_space.hpp"

namespace taut::internal::path {

/// A vector of the plane, exactly.
struct ExactVector {
  Dyadic x, y;

  bool is_zero() const { return x.is_zero() && y.is_zero(); }
  friend bool operator==(const ExactVector& a, const ExactVector& b) { return a.x == b.x && a.y == b.y; }
};

/// A body is displaced by `offset`, and by each joint's value times its vector.
struct Slides {
  ExactVector offset;
  std::array<ExactVector, max_joints> joint;

  bool moves() const;
  /// Do both follow all joints in the same way?
  bool moves_like(const Slides& o) const { return joint == o.joint; }
};

/// Nothing if the body, or one of its parents, turns or is a link of a mechanism.
std::optional<Slides> slides_of(const Linkage& linkage, int body);

/// The displacements of what moves: by one joint, or by two whose vectors are not parallel.
class SlideMap {
 public:
  /// Nothing if it is not of this kind.
  static std::optional<SlideMap> of(const Slides& slides);

  /// In ascending order.
  const std::vector<std::size_t>& joints() const { return joints_; }
  const Slides& slides() const { return slides_; }
  ExactPoint displaced(const JointValues& values) const;
  /// The displacements of a box of joint values.
  ConvexRing displaced(const JointValues& lo, const JointValues& hi) const;
  /// The joint values of a displacement on the line or in the plane of the joints' vectors, rounded; other joints keep
  /// those of `others`. Values that are doubles are exact.
  JointValues values_at(const ExactPoint& displacement, JointValues others) const;

 private:
  const ExactVector& vector(std::size_t k) const { return slides_.joint[joints_[k]]; }

  Slides slides_;
  std::vector<std::size_t> joints_;
  Dyadic determinant_;  ///< of one joint: the vector's squared length
};

}  // namespace taut::internal::path
