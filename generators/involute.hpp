// Involute teeth.
#pragma once

#include "taut/geometry.hpp"

namespace taut::gen {

struct ToothForm {
  double module = 1, pressure_angle_deg = 20;
  double backlash = 0;  ///< along the pitch circle, in modules
  int flank_points = 2;
};

/// A toothed disc. The chords of an involute and of a circle lie inside the tooth, so the polygon lies inside the true
/// gear, which meshes with the backlash asked for.
struct Gear {
  int teeth = 0;
  double pitch = 0, base = 0, tip = 0, root = 0;  ///< radii
  double half_base_angle = 0;                     ///< half the tooth's angle where the involute starts
  int flank_points = 0;

  /// Half the angle of a tooth at a radius: the involute's polar angle grows by inv(a) = tan a - a.
  double half_angle(double radius) const;
};

/// A gear that meshes with another one of `mate` teeth. Throws InputError if its teeth would be pointed.
Gear spur_gear(const ToothForm& form, int teeth, int mate);

/// The hole of a ring gear in which a gear of `mate` teeth rolls: its "teeth" are the ring's spaces. Chords of it lie
/// in the spaces, which takes a little of the backlash away.
Gear ring_hole(const ToothForm& form, int teeth, int mate);

/// `thick`: the tooth that gets `extra` half angle; `phase`: where the first tooth stands.
Polygon gear_outline(const Gear& gear, double phase, int thick = -1, double extra = 0);

}  // namespace taut::gen
