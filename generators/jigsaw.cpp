#include <cmath>

#include "generators/generators.hpp"
#include "generators/shapes.hpp"

namespace taut::gen {

namespace {

/// Knobs stand at distance 3 on the seam y = 0.
constexpr double knob_pitch = 3;

/// A knob's outline from right to left, widened by `c`. With a neck: most of a circle on a short straight neck;
/// without: half an ellipse, which is widest at the seam.
void append_knob(Polygon& polygon, double centre, const JigsawOptions& o, double c) {
  if (!o.hit) {
    for (int i = 0; i < o.knob_points; ++i) {
      const double angle = pi * i / (o.knob_points - 1);
      // The ends exactly on the seam: the sine of pi is not 0 in floating point.
      const double y = i == 0 || i == o.knob_points - 1 ? 0 : (1.5 + c) * std::sin(angle);
      polygon.push_back({centre + (0.9 + c) * std::cos(angle), y + c});
    }
    return;
  }
  const double neck = 0.5 + c, radius = 0.9 + c, height = 1.2;
  const double from = -std::acos(neck / radius), to = pi - from;
  polygon.push_back({centre + neck, c});
  for (int i = 0; i < o.knob_points - 2; ++i) {
    const Point p = polar(radius, from + (to - from) * i / (o.knob_points - 3));
    polygon.push_back({centre + p.x, height + p.y});
  }
  polygon.push_back({centre - neck, c});
}

}  // namespace

Scene make_jigsaw(const JigsawOptions& o) {
  require_range("--knobs", o.knobs, 1, 1000000);
  require_range("--knob-points", o.knob_points, 6, 1000000);
  require_range("--clearance", o.clearance, 1e-4, 0.1);
  const double c = o.clearance, left = -knob_pitch / 2, right = left + knob_pitch * o.knobs;
  Polygon upper{{right, 5}, {left, 5}, {left, c}};
  Polygon socket;
  Polygon lower{{left, 0}, {left, -2}, {right, -2}, {right, 0}};
  for (int k = o.knobs - 1; k >= 0; --k) {
    append_knob(lower, k * knob_pitch, o, 0);
    append_knob(socket, k * knob_pitch, o, c);
  }
  upper.insert(upper.end(), socket.rbegin(), socket.rend());
  upper.push_back({right, c});
  // Down by 4 within time 1, starting and ending at rest, with a slight sideways wobble.
  Scene scene;
  scene.end = 1;
  scene.bodies = {{"socket", upper, {}}, {"knob", lower, Motion{{translation({0, c / 4, -c / 4}, {0, 0, -12, 8})}}}};
  return scene;
}

}  // namespace taut::gen
