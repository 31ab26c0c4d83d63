// Involute spur gears. The chords of an involute and of a circle lie inside the tooth, so the polygons lie inside the
// true gears, which mesh with the backlash asked for.
#include <algorithm>
#include <cmath>

#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "taut/error.hpp"

namespace taut::gen {

namespace {

struct Gear {
  int teeth = 0;
  double pitch = 0, base = 0, tip = 0, root = 0;  ///< radii
  double half_base_angle = 0;                     ///< half the tooth's angle where the involute starts
  int flank_points = 0;

  /// Half the angle of a tooth at a radius: the involute's polar angle grows by inv(a) = tan a - a.
  double half_angle(double radius) const {
    const double a = std::acos(std::min(1.0, base / radius));
    return half_base_angle - (std::tan(a) - a);
  }
};

Gear design(const GearOptions& o, int teeth, int mate) {
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

/// `thick`: the tooth that gets `extra` half angle; `phase`: where the first tooth stands.
Polygon outline(const Gear& gear, double phase, int thick, double extra) {
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

Motion turning(double x, double radians_per_time) {
  MotionPiece piece = translation({}, {});
  if (x != 0) piece.x = {x};
  piece.rotation = AngleRotation{{0, radians_per_time}};
  return Motion{{piece}};
}

}  // namespace

Scene make_gears(const GearOptions& o) {
  require_range("--teeth1", o.teeth_1, 8, 100000);
  require_range("--teeth2", o.teeth_2, 8, 100000);
  require_range("--module", o.module, 1e-100, 1e100);
  require_range("--pressure-angle", o.pressure_angle_deg, 10, 30);
  require_range("--backlash", o.backlash, 0.001, 0.5);
  require_range("--flank-points", o.flank_points, 2, 1000000);
  require_range("--turns", o.turns, 0.001, 1e6);
  const Gear first = design(o, o.teeth_1, o.teeth_2), second = design(o, o.teeth_2, o.teeth_1);
  // A gap of the second gear faces the first tooth of the first one. It turns clockwise, so its tooth k comes to
  // face the first gear after turning by a little more than 2 pi k / teeth.
  const double total = o.turns * o.teeth_1 / o.teeth_2;
  const int thick = o.hit ? static_cast<int>(std::fmod(total / 2, 1.0) * o.teeth_2) : -1;
  const double extra = 2 * (o.backlash + 0.05) / o.teeth_2;
  Scene scene;
  scene.end = o.turns;
  const double speed = 2 * pi;
  scene.bodies = {{"wheel", outline(first, 0, -1, 0), turning(0, speed)},
                  {"pinion", outline(second, pi + pi / o.teeth_2, thick, extra),
                   turning(o.module * (o.teeth_1 + o.teeth_2) / 2, -speed * o.teeth_1 / o.teeth_2)}};
  return scene;
}

}  // namespace taut::gen
