// Two involute spur gears.
#include <cmath>

#include "generators/generators.hpp"
#include "generators/involute.hpp"
#include "generators/shapes.hpp"
#include "taut/error.hpp"

namespace taut::gen {

namespace {

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
  const ToothForm form{o.module, o.pressure_angle_deg, o.backlash, o.flank_points};
  const Gear first = spur_gear(form, o.teeth_1, o.teeth_2), second = spur_gear(form, o.teeth_2, o.teeth_1);
  // A gap of the second gear faces the first tooth of the first one. It turns clockwise, so its tooth k comes to
  // face the first gear after turning by a little more than 2 pi k / teeth.
  const double total = o.turns * o.teeth_1 / o.teeth_2;
  const int thick = o.hit ? static_cast<int>(std::fmod(total / 2, 1.0) * o.teeth_2) : -1;
  const double extra = 2 * (o.backlash + 0.05) / o.teeth_2;
  Scene scene;
  scene.end = o.turns;
  const double speed = 2 * pi;
  scene.bodies = {{"wheel", gear_outline(first, 0, -1, 0), turning(0, speed)},
                  {"pinion", gear_outline(second, pi + pi / o.teeth_2, thick, extra),
                   turning(o.module * (o.teeth_1 + o.teeth_2) / 2, -speed * o.teeth_1 / o.teeth_2)}};
  return scene;
}

}  // namespace taut::gen
