#include "generators/involute.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "generators/shapes.hpp"
#include "taut/error.hpp"

namespace taut::gen {

double Gear::half_angle(double radius) const {
  const double a = std::acos(std::min(1.0, base / radius));
  return half_base_angle - (std::tan(a) - a);
}

Gear spur_gear(const ToothForm& o, int teeth, int mate) {
  Gear gear;
  const double alpha = o.pressure_angle_deg * pi / 180;
  gear.teeth = teeth;
  gear.pitch = o.module * teeth / 2;
  gear.base = gear.pitch * std::cos(alpha);
  gear.root = gear.pitch - 1.25 * o.module;
  // Where the mate's involute begins: a longer tooth would dig into its foot.
  const double centre_distance = o.module * (teeth + mate) / 2;
  const double limit = std::hypot(gear.base, centre_distance * std::sin(alpha));
  gear.tip = std::min(gear.pitch + o.module, 0.998 * limit);
  const double half_pitch_angle = (pi / 2 - o.backlash / 2) / teeth;
  gear.half_base_angle = half_pitch_angle + std::tan(alpha) - alpha;
  gear.flank_points = o.flank_points;
  if (gear.half_angle(gear.tip) <= 0) {
    throw InputError("gears", "the teeth are pointed", "more teeth, or a smaller pressure angle");
  }
  return gear;
}

Gear ring_hole(const ToothForm& o, int teeth, int mate) {
  Gear hole;
  const double alpha = o.pressure_angle_deg * pi / 180;
  hole.teeth = teeth;
  hole.pitch = o.module * teeth / 2;
  hole.base = hole.pitch * std::cos(alpha);
  hole.tip = hole.pitch + 1.25 * o.module;
  // Where the mate's involute begins: a longer tooth of the ring would dig into its foot.
  const double centre_distance = o.module * (teeth - mate) / 2;
  const double limit = std::hypot(hole.base, centre_distance * std::sin(alpha));
  hole.root = std::max(hole.pitch - o.module, 1.002 * limit);
  const double half_pitch_angle = (pi / 2 + o.backlash / 2) / teeth;
  hole.half_base_angle = half_pitch_angle + std::tan(alpha) - alpha;
  hole.flank_points = o.flank_points;
  return hole;
}

Polygon gear_outline(const Gear& gear, double phase, int thick, double extra) {
  Polygon polygon;
  const double foot = std::max(gear.base, gear.root);
  for (int tooth = 0; tooth < gear.teeth; ++tooth) {
    const double centre = phase + 2 * pi * tooth / gear.teeth;
    const double more = tooth == thick ? extra : 0;
    std::vector<std::pair<double, double>> flank;  // radius, half angle
    if (gear.root < gear.base) flank.emplace_back(gear.root, gear.half_angle(foot) + more);
    for (int i = 0; i < gear.flank_points; ++i) {
      const double radius = foot + (gear.tip - foot) * i / (gear.flank_points - 1);
      flank.emplace_back(radius, gear.half_angle(radius) + more);
    }
    for (auto p = flank.begin(); p != flank.end(); ++p) polygon.push_back(polar(p->first, centre - p->second));
    for (auto p = flank.rbegin(); p != flank.rend(); ++p) polygon.push_back(polar(p->first, centre + p->second));
  }
  return polygon;
}

}  // namespace taut::gen
