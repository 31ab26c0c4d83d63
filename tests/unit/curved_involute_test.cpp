// Flanks of gears as splines, against the involute itself: a wall that comes along the normal at the unwinding angle u
// touches the involute of a circle of radius r when it is r u away from the centre.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "taut/check.hpp"
#include "taut/error.hpp"

namespace taut {
namespace {

using Fifty = boost::multiprecision::cpp_bin_float_50;

constexpr double base_radius = 3, first_angle = 0.2, last_angle = 1.1;
constexpr int flank_pieces = 64;

/// p(u) = r (cos u + u sin u, sin u - u cos u), and p'(u) = r u (cos u, sin u).
std::array<Fifty, 2> involute_at(const Fifty& u) {
  const Fifty c = cos(u), s = sin(u);
  return {base_radius * (c + u * s), base_radius * (s - u * c)};
}

Point rounded_of(const std::array<Fifty, 2>& p) { return {static_cast<double>(p[0]), static_cast<double>(p[1])}; }

/// A tooth's side from the centre to the involute, which is Hermite's cubics through its points and tangents.
Outline flank() {
  const auto angle = [](int k) -> Fifty { return first_angle + (Fifty(last_angle) - first_angle) * k / flank_pieces; };
  const Fifty third = (angle(1) - angle(0)) / 3;
  const auto off = [&](const Fifty& u, const Fifty& by) {
    const auto p = involute_at(u);
    return rounded_of({p[0] + by * base_radius * u * cos(u), p[1] + by * base_radius * u * sin(u)});
  };
  Outline outline{{0, 0}, {LineTo{rounded_of(involute_at(angle(0)))}}};
  for (int k = 0; k < flank_pieces; ++k) {
    outline.segments.emplace_back(
        CubicTo{off(angle(k), third), off(angle(k + 1), -third), rounded_of(involute_at(angle(k + 1)))});
  }
  return outline;
}

/// How far the point is from the involute, along its normal: the tangent's length to the base circle is r times the
/// angle at which it touches there.
Fifty off_involute(const Fifty& x, const Fifty& y) {
  const Fifty distance = sqrt(x * x + y * y), r = base_radius;
  return sqrt(distance * distance - r * r) - r * (atan2(y, x) + acos(r / distance));
}

/// The most that the spline is away from the involute, at many points of each piece.
double deviation_of(const Outline& outline) {
  Fifty most = 0;
  Point from = end_of(outline.segments[0]);
  for (std::size_t k = 1; k < outline.segments.size(); ++k) {
    const auto& c = std::get<CubicTo>(outline.segments[k]);
    for (int i = 0; i <= 40; ++i) {
      const Fifty t = Fifty(i) / 40, s = 1 - t;
      const auto at = [&](double a, double b, double d, double e) -> Fifty {
        return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * d + t * t * t * e;
      };
      const Fifty away =
          abs(off_involute(at(from.x, c.first.x, c.second.x, c.to.x), at(from.y, c.first.y, c.second.y, c.to.y)));
      if (away > most) most = away;
    }
    from = c.to;
  }
  return static_cast<double>(most) * 1.05;
}

TEST(CurvedInvolute, AWallMeetsTheFlankWhereTheInvoluteIs) {
  const Outline outline = flank();
  const double away = deviation_of(outline);
  ASSERT_LT(away, 1e-9) << "the spline is near to the involute";
  for (const double u : {0.25, 0.4, 0.5, 0.625, 0.8, 0.95, 1.05}) {
    // The wall's face, 8 from the centre along the normal (sin u, -cos u), comes at speed 1.
    const double nx = std::sin(u), ny = -std::cos(u);
    Scene scene;
    scene.end = 8;
    scene.bodies.resize(2);
    scene.bodies[0].name = "tooth";
    scene.bodies[0].curves = {{outline, {}}};
    scene.bodies[1].name = "wall";
    const auto corner = [&](double along, double deep) {
      return Point{(8 + deep) * nx - along * ny, (8 + deep) * ny + along * nx};
    };
    scene.bodies[1].polygon = {corner(-6, 0), corner(-6, 1), corner(6, 1), corner(6, 0)};
    scene.bodies[1].motion.pieces.resize(1);
    scene.bodies[1].motion.pieces[0].x = {0, -nx};
    scene.bodies[1].motion.pieces[0].y = {0, -ny};
    const Answer answer = check(scene);
    ASSERT_EQ(answer.outcome, Outcome::contact) << u << ": " << answer.reason;
    const double exact = static_cast<double>(8 - Fifty(base_radius) * u), room = away + 1e-13;
    EXPECT_LE(answer.contact->time.lo, exact + room) << u;
    EXPECT_GE(answer.contact->time.hi, exact - room) << u;
    EXPECT_LE(answer.contact->time.hi - answer.contact->time.lo, 1e-8) << u;
    // And on the piece of the spline on which the angle lies, or at the end of it.
    const VertexRef& vertex = answer.contact->vertex;
    const EdgeRef& edge = answer.contact->edge;
    const int segment = vertex.body == 0 ? vertex.index : edge.index;
    const double at = (vertex.body == 0 ? vertex.parameter : edge.parameter).value_or(0.5);
    const double place = first_angle + (last_angle - first_angle) * (segment - 1 + at) / flank_pieces;
    EXPECT_NEAR(place, u, 1e-3) << u;
  }
}

}  // namespace
}  // namespace taut
